// a plant of rewritten strings: F forward, + - turn, [ ] branch
#version 3.5;
#include "colors.inc"
#declare Rule = "F[+F]F[-F]F";
#macro Rewrite(S)
  #local R = ""; #local I = 1;
  #while (I <= strlen(S))
    #local Ch = substr(S,I,1);
    #if (strcmp(Ch,"F") = 0) #local R = concat(R,Rule); #else #local R = concat(R,Ch); #end
    #local I = I+1;
  #end
  R
#end
#declare Plant = Rewrite(Rewrite(Rewrite("F")))
#debug concat("length ", str(strlen(Plant),0,0), "\n")
#declare Px = array[12]; #declare Pa = array[12];
#declare P = <0,0,0>; #declare A = 0; #declare Top = 0; #declare I = 1;
union {
#while (I <= strlen(Plant))
  #switch (asc(substr(Plant,I,1)))
    #case (70) #declare Q = P + .12*<sin(A),cos(A),.3*sin(I)>; cylinder { P, Q, .022 pigment { rgb <.3,.5-.02*Top,.1> } } #declare P = Q; #break
    #case (43) #declare A = A+.45; #break
    #case (45) #declare A = A-.42; #break
    #case (91) #declare Px[Top] = P; #declare Pa[Top] = A; #declare Top = Top+1; #break
    #case (93) sphere { P, .05 pigment { color (mod(I,3)=0 ? Pink : LimeGreen) } } #declare Top = Top-1; #declare P = Px[Top]; #declare A = Pa[Top]; #break
  #end
  #declare I = I+1;
#end
translate -1.6*y }
camera { location <0,0,-5.2> look_at 0 angle 42 }
light_source { <-5,9,-9> White } background { rgb <.9,.95,1> }
plane { y,-1.6 pigment { Tan } }
