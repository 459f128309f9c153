#include "functions.inc"
#include "colors.inc"
#version 3.5;
global_settings { assumed_gamma 1.8 }
#macro SandyColor() rgb <.8,.7,.5> #end
#declare fn = function(x,z) { .5 + .25*sin(8*x)*cos(7*z) + .2*f_noise3d(x*6,0,z*6) - .1 }
height_field { function 120, 120 { fn(x,y) } smooth water_level .25
  translate <-.5,0,-.5> scale <10,2.5,10>
  texture { gradient y texture_map {
    [.2 pigment { SandyColor() }] [.45 pigment { ForestGreen } normal { bumps .4 scale .2 }] [.7 pigment { Gray50 }] [.85 pigment { White } finish { ambient .3 }] } scale 2.5 } }
plane { y,.65 pigment { rgbf <.3,.5,.8,.4> } normal { ripples .1 scale .5 } finish { reflection .2 } }
camera { location <0,5,-9> look_at <0,.6,0> angle 50 }
light_source { <-20,15,-10> White }
sky_sphere { pigment { gradient y color_map { [0 White] [.6 SkyBlue] } } }
