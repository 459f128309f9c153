#include "colors.inc"
camera { location <2.2,1.9,-3.6> look_at <0,.15,0> angle 38 }
light_source { <6,9,-9> White }
light_source { <-9,3,-4> Gray40 shadowless }
#macro Tet(A,B,C,D,L)
  #if (L=0)
    triangle{A,B,C} triangle{A,B,D} triangle{A,C,D} triangle{B,C,D}
  #else
    Tet(A,(A+B)/2,(A+C)/2,(A+D)/2,L-1)
    Tet(B,(A+B)/2,(B+C)/2,(B+D)/2,L-1)
    Tet(C,(C+B)/2,(A+C)/2,(C+D)/2,L-1)
    Tet(D,(D+B)/2,(D+C)/2,(A+D)/2,L-1)
  #end
#end
mesh { Tet(<-1,-.6,-.7>,<1,-.6,-.7>,<0,-.6,1>,<0,1,0>,5) pigment { gradient y color_map {[0 Red][.5 Yellow][1 Blue]} scale 2 translate -.7*y } }
plane { y,-.65 pigment { Gray80 } }
