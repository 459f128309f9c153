#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "colors.inc"
#include "sunpos.inc"
#declare Sun = vnormalize(<-.4,.35,-1>);
light_source { Sun*1e4, rgb 1.1 parallel point_at 0 }
sphere { <-1.6,1.4,-1>, .8 pigment { Gray30 } }
sphere { <0,1,1.5>, 1 pigment { rgb <.9,.7,.5> } normal { bumps .4 scale .2 } }
rainbow { angle 42 width 6 distance 1.0e7 arc_angle 200 falloff_angle 120 direction -Sun up y jitter 0
  color_map { [0 color rgbt <.8,.1,.1,1>] [.2 color rgbt <1,.4,0,.8>] [.4 color rgbt <1,1,.1,.75>] [.6 color rgbt <.1,.9,.2,.75>] [.8 color rgbt <.1,.3,1,.8>] [1 color rgbt <.4,0,.6,1>] } }
fog { fog_type 2 distance 60 fog_offset 0 fog_alt 3 color rgb <.7,.75,.85> }
plane { y,0 pigment { checker rgb <.3,.5,.2>, rgb <.4,.55,.25> scale 2 } }
#for (i,-3,3) cylinder { <i*4,0,14>, <i*4,3+mod(i*i,4),14>, .5 pigment { Tan } } cone { <i*4,2,14>,1.8,<i*4,6+mod(i*i,4),14>,0 pigment { ForestGreen } } #end
sky_sphere { pigment { gradient y color_map { [0 rgb <.55,.6,.7>] [1 rgb <.25,.3,.45>] } } }
camera { location <0,2,-9> look_at <0,2.4,5> angle 65 right x*image_width/image_height }
