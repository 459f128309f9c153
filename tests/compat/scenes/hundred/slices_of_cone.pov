//conic sections and slicing; change CASE
#include "colors.inc"
#declare CASE = 2;
camera { sky z right <-4/3,0,0> location <9,5,4> look_at <0,0,.3> angle 26 }
light_source { <12,3,9> White*1.2 }
background { White }
#declare doublecone = union { cone { 0,0,<0,0,1.5>,1.2 open } cone { 0,0,<0,0,-1.5>,1.2 open } }
object { doublecone pigment { color rgbt <.3,.5,1,.55> } }
#switch (CASE)
  #case (1) #declare A = 0; #break
  #case (2) #declare A = 30; #break
  #range (3,5) #declare A = 51.34; #break
  #else #declare A = 80;
#end
box { <-1.6,-1.6,-.01>,<1.6,1.6,.01> pigment { color rgbt <1,.9,.2,.4> } rotate A*y translate .6*z }
intersection { object { doublecone } box { <-3,-3,-.04>,<3,3,.04> rotate A*y translate .6*z } pigment { Red } finish { ambient .6 } }
#declare n = 0;
#while (n < 12) cylinder { <-1.6+n*.12,2,-1+n*.15>,<-1.6+n*.12,2,-.9+n*.15>, 1.2-abs(n-6)*.12 pigment { rgb <n/12,.4,1-n/12> } scale <.4,1,1> } #declare n = n+1; #end
