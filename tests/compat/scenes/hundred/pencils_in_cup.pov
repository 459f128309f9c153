#include "colors.inc"
#include "woods.inc"
#include "shapes.inc"
#declare Hexagon6 = intersection { #declare k=0; #while (k<6) plane { y,1 rotate k*60*x } #declare k=k+1; #end plane { x,1 } plane { -x,1 } }
#declare PEN = union {
  intersection { object { Hexagon6 scale <1.6,.12,.12> } cylinder { -2*x,2*x,.132 } rotate 90*z translate 1.6*y texture { pigment { Yellow } finish { phong .6 } } }
  cone { 3.2*y .115 3.55*y .02 texture { T_Wood22 scale .1 } }
  cone { 3.45*y .05 3.58*y 0 pigment { Gray10 } }
  cylinder { -.25*y 0 .1 pigment { Pink } }
}
#declare CUP = difference { cylinder { 0 2*y .8 } cylinder { .1*y 2.1*y .72 } }
object { CUP texture { pigment { leopard color_map { [0 Navy][.6 SkyBlue][1 White] } scale .06 } finish { specular .5 } } }
object { PEN rotate <8,0,-6> translate <.2,.3,0> }
object { PEN rotate <0,33,0> rotate <-9,10,5> translate <-.2,.3,.1> }
object { PEN scale <1,.8,1> rotate <3,20,9> translate <-.25,.3,-.2> }
object { PEN rotate 90*z rotate 25*y translate <3.1,.12,-1> }
box { <-5,-.2,-3>,<5,0,3> texture { T_Wood8 rotate 90*y } }
camera { location <1,3.6,-8> look_at <.3,1.6,0> angle 42 }
light_source { <-5,9,-6> White area_light <1.5,0,0>,<0,0,1.5>,4,4 adaptive 2 }
background { rgb <.75,.8,.7> }
