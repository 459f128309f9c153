#version 3.6;
// colours by macros and functions; pigments that call pigments
#include "colors.inc"
#include "functions.inc"
global_settings { assumed_gamma 1.4 }
#declare P1 = pigment { wrinkles scale .3 } #declare FP = function { pigment { P1 } }
#declare Waves = function(x,y,z,k) { .5+.5*sin(k*x)*cos(k*y) }
#declare Sel = function(x) { select(x,0,.5,1) }
#declare h = 0;
#while (h < 12)
  sphere { vrotate(<0,1.6,0>,h*30*z), .36 pigment { color CHSL2RGB(<h*30,.8,.5>) } finish { phong .4 } }
  box { <-.12,-.12,-.1>,<.12,.12,.1> rotate h*15*z translate vrotate(<0,2.3,0>,h*30*z) pigment { color CHSV2RGB(<h*30,1,.4+h*.05>) } }
  #declare h = h+1;
#end
sphere { 0,1.1 pigment { function { Waves(x,y,z,7)*FP(x,y,z).gray } color_map { [0 rgb <.1,0,.3>] [.5 rgb <1,.5,0>] [1 rgb 1] } } }
plane { z,1.5 pigment { average pigment_map { [1 function { mod(abs(x*2),1) } color_map { [0 rgb .3] [1 rgb .8] }] [2 function { Sel(sin(y*3)) } color_map { [0 rgb .6] [1 rgb <.5,.7,.6>] }] } } }
light_source { <-5,8,-9> rgb 1 } camera { location -7*z look_at 0 angle 50 }
