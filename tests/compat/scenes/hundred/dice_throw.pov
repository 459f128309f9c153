#include "colors.inc"
#include "shapes.inc"
#declare Die_Body = intersection { box { -1,1 } sphere { 0,1.42 } };
#declare Pip = sphere { 0,.22 scale <1,1,.5> translate -z*1.02 };
#macro Face(n)
  union {
    #if (mod(n,2)=1) object { Pip } #end
    #if (n>1) object { Pip translate <-.5,.5,0> } object { Pip translate <.5,-.5,0> } #end
    #if (n>3) object { Pip translate <.5,.5,0> } object { Pip translate <-.5,-.5,0> } #end
    #if (n=6) object { Pip translate <-.5,0,0> } object { Pip translate <.5,0,0> } #end
  }
#end
#macro Die(c1,c2,fil)
  difference {
    object { Die_Body pigment { color c1 filter fil } }
    union { object{Face(1)} object{Face(6) rotate 180*y} object{Face(2) rotate 90*y} object{Face(5) rotate -90*y} object{Face(3) rotate 90*x} object{Face(4) rotate -90*x} pigment { c2 } }
    finish { phong .8 reflection .05 } interior { ior 1.3 }
  }
#end
object { Die(Red,White,0) rotate 25*y translate <-2.2,1,0> }
object { Die(White,Black,0) rotate <45,35.26,0> rotate 45*z translate <.5,1.4,1.5> }
object { Die(Green,Yellow,.6) rotate -38*y translate <2.2,1,-1.2> }
object { Round_Box(<-.7,0,-.7>,<.7,1.4,.7>,.2,yes) pigment { Blue } translate <-.2,0,-2.3> }
plane { y,0 texture { pigment { ForestGreen } normal { bumps .3 scale .02 } } }
camera { location <0,6,-9> look_at <0,.7,0> angle 42 } light_source { <-7,12,-9> White spotlight point_at 0 radius 25 falloff 45 }
