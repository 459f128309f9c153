#include "colors.inc"
// blossoms of clipped parts in a bed; petals by degrees that do not divide evenly
#declare Petal = sphere { 0, 1 scale <.9,.12,.4> translate .95*x clipped_by { plane { y, .02 } }
  texture { pigment { wood rotate 90*x color_map { [0 Yellow] [.3 Orchid] [1 White] } scale 2 } normal { ripples .3 scale .2 } } };
#macro Bloom(Leaves, Lean)
  union {
    #local g = 0;
    #while (g < 360)
      object { Petal rotate 20*z rotate g*y }
      #local g = g + 360/Leaves;
    #end
    sphere { .12*y, .36 scale <1,.6,1> pigment { leopard color_map { [0 Gold] [1 Brown] } scale .05 } }
    rotate Lean*x
  }
#end
#macro Stalk(Height)
  cylinder { 0, Height*y, .05 pigment { MediumForestGreen } }
  disc { <.3,Height*.4,0>, <-.5,1,0>, .4 pigment { LimeGreen } normal { gradient z .4 scale .1 } scale <1,1,.5> }
#end
#declare n = 0;
#while (n < 7)
  union { Stalk(1.4+.3*mod(n*n,3)) object { Bloom(5+n, -25-n*5) scale .55 translate (1.4+.3*mod(n*n,3))*y } translate <n*1.1-3.3,0,mod(n*3,4)-1.5> }
  #declare n = n + 1;
#end
plane { y,0 pigment { granite color_map { [0 rgb <.15,.08,.02>] [1 rgb <.4,.25,.1>] } } normal { granite .6 scale .3 } }
sky_sphere { pigment { gradient y color_map { [0 LightBlue] [.7 SteelBlue] } } }
camera { location <0,3.2,-7> look_at <0,1.1,0> angle 54 }
light_source { <-9,13,-8> White }
