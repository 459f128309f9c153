#include "colors.inc"
#include "shapes.inc"
#declare G = (1+sqrt(5))/2;
#declare V = array[12] { <0,1,G>,<0,1,-G>,<0,-1,G>,<0,-1,-G>,<1,G,0>,<1,-G,0>,<-1,G,0>,<-1,-G,0>,<G,0,1>,<G,0,-1>,<-G,0,1>,<-G,0,-1> }
#macro Strut(A,B,L)
  #if (L=0)
    cylinder { A, B, .035 pigment { Gray60 } } sphere { A, .06 pigment { Red } } sphere { B, .06 pigment { Red } }
  #else
    #local M = vnormalize(A+B)*3; Strut(A,M,L-1) Strut(M,B,L-1)
  #end
#end
#macro Pane(A,B,C)
  #local AB = vnormalize(A+B)*3; #local BC = vnormalize(B+C)*3; #local CA = vnormalize(C+A)*3;
  triangle { A AB CA } triangle { AB B BC } triangle { CA BC C } triangle { AB BC CA }
  cylinder { AB BC .03 } cylinder { BC CA .03 } cylinder { CA AB .03 }
#end
union {
#declare i=0; #while(i<12) #declare j=i+1; #while(j<12)
  #if (vlength(V[i]-V[j]) < 2.1) Strut(vnormalize(V[i])*3, vnormalize(V[j])*3, 1) #end
  #declare k=j+1; #while(k<12)
    #if (vlength(V[i]-V[j])+vlength(V[i]-V[k])+vlength(V[j]-V[k]) < 6.3)
      union { Pane(vnormalize(V[i])*3, vnormalize(V[j])*3, vnormalize(V[k])*3) pigment { rgbt <.7,.9,1,.7> } finish { phong .5 } }
    #end
  #declare k=k+1; #end
#declare j=j+1; #end #declare i=i+1; #end
clipped_by { plane { -y, -.05 } } }
plane { y,0 pigment { Wheat } }
cone { 0, .8, 1.9*y, 0 pigment { Firebrick } }
camera { location <0,3,-10> look_at <0,1.1,0> angle 42 } light_source { <-9,14,-9>, White } background { SkyBlue }
