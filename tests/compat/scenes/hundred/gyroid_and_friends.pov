#version 3.6;
#include "functions.inc"
#include "colors.inc"
global_settings { assumed_gamma 1.0 }
camera { location <0,2.5,-8> look_at <0,.6,0> angle 46 }
light_source { <-6,9,-7> White } light_source { <7,3,-6> Gray30 }
isosurface { function { abs(sin(x*4)*cos(y*4)+sin(y*4)*cos(z*4)+sin(z*4)*cos(x*4)) - .35 }
  contained_by { sphere { 0, 1 } } max_gradient 9 accuracy .001 pigment { Coral } translate <-2,1,0> }
isosurface { function { f_torus(x,y,z,.7,.25) + .1*sin(atan2(z,x)*8) }
  contained_by { box { <-1.2,-.5,-1.2>, <1.2,.5,1.2> } } max_gradient 4 pigment { SteelBlue } rotate -35*x translate <.3,1.1,0> }
#declare F = function(x,y,z,r) { x*x + y*y + z*z - r*r }
isosurface { function { min(F(x,y,z,.5), max(abs(x)-.8, abs(y)-.12, abs(z)-.12), f_rounded_box(x,y-.6,z,.1,.4,.2,.4)) }
  contained_by { box { -1, 1 } } evaluate 3, 1.2, .9 pigment { YellowGreen } rotate 25*y translate <2.3,.7,-.5> }
isosurface { function { y - .25*f_ridged_mf(x*1.3,0,z*1.3,1,2,4,.9,1.8,3) + .2 }
  contained_by { box { <-6,-.4,-4>, <6,1,6> } } max_gradient 3 pigment { gradient y color_map { [0 ForestGreen] [1 Tan] } scale .5 } }
