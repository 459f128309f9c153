#version 3.6;
global_settings { assumed_gamma 1.3 max_trace_level 6 }
#include "colors.inc"
#include "transforms.inc"
// a truncated cube of thin prisms; cells side by side by a macro that takes an object
camera { location <5,6,-9> angle 30 right x*image_width/image_height look_at <.9,0,0> }
light_source { <-120,180,-150> rgb <1,1,.95> }
light_source { <140,60,-100> rgb <.3,.3,.4> shadowless }
#declare Octagon = prism { linear_sweep linear_spline -.04, .04, 9, #for (k,0,7) <cos(radians(22.5+45*k)), sin(radians(22.5+45*k))>, #end <cos(radians(22.5)), sin(radians(22.5))> }
#declare Triangle = prism { linear_sweep linear_spline -.04, .04, 4, #for (k,0,3) <.44*cos(radians(120*k)), .44*sin(radians(120*k))> #if (k<3) , #end #end }
#declare Corners = array[4] { <1,1,1>, <-1,1,1>, <1,1,-1>, <-1,1,-1> }
#declare Shell = union {
  #for (k,0,3) object { Octagon translate .924*y rotate k*90*x } #end
  object { Octagon translate .924*y rotate 90*z } object { Octagon translate .924*y rotate -90*z }
  #for (k,0,3) object { Triangle translate 1.2*y Reorient_Trans(y, Corners[k]) } object { Triangle translate 1.2*y Reorient_Trans(y, -Corners[k]) } #end
}
#macro Row(Cell, Count)
  #for (k,0,Count-1) object { Cell translate 1.93*k*x } #end
#end
#declare Pierced = difference { object { Shell } cylinder { -3*z, 3*z, .5 } cylinder { -3*x, 3*x, .4 } }
union { Row(Pierced, 2) texture { pigment { Gray70 } finish { specular .4 } } }
sphere { 0, .4 pigment { Orange } }
