#include "colors.inc"
#include "woods.inc"
#include "stones.inc"
// steps, posts and a hand rail by one loop
camera { location <9,9,-12> look_at <0,4.2,0> angle 46 }
light_source { <-14,12,-8> White*1.4 }
light_source { <12,16,-10> White*0.3 shadowless }
#declare Steps=20; #declare Rise=.42; #declare Turn=24;
#declare k=0;
#while (k<Steps)
    object {
        prism { linear_spline 0, .18, 5, <.4,-.15>, <3,-.65>, <3,.65>, <.4,.15>, <.4,-.15> }
        texture { T_Wood4 scale .6 }
        translate k*Rise*y rotate k*Turn*y
    }
    object { cylinder { <2.8,.15,0>, <2.8,1.3,0>, .06 } pigment { Gray40 } translate k*Rise*y rotate k*Turn*y }
    #if (k>0)
        object { cylinder { vrotate(<2.8,1.3+(k-1)*Rise,0>,(k-1)*Turn*y), vrotate(<2.8,1.3+k*Rise,0>,k*Turn*y), .1 } texture { T_Wood20 } }
    #end
    #declare k=k+1;
#end
object { cylinder { 0, Steps*Rise*y, .4 } texture { T_Wood16 rotate 90*x } }
object { plane { y, 0 } texture { T_Wood6 rotate 90*y scale 2 } }
object { plane { z, 9 } pigment { Wheat } }
object { plane { x, -9 } pigment { LightSteelBlue } }
