#version 3.7;
#include "colors.inc"
//// parts first, then materials, then their marriage, global_settings last
#declare Leg_Shape = lathe { cubic_spline 8, <1.4,-1>, <1.4,0>, <.7,2>, <1.1,5>, <.5,9>, <.8,14>, <.6,17>, <.6,18> }
#declare Plate_Shape = cylinder { 0, y, 16 }
#declare M_Clear = material {
  texture { pigment { White*.98+Green*.02 filter .97 } normal { bumps .05 scale 2 }
    finish { ambient 0 diffuse 0 specular .3 roughness .003 reflection { .03, .8 fresnel } conserve_energy } }
  interior { ior 1.45 fade_distance 4 fade_power 1001 fade_color <.1,.5,.3> }
}
#declare Leg = object { Leg_Shape pigment { Gray30 } finish { specular .6 } }
union {
  object { Plate_Shape scale <0,.8,0> translate 17*y material { M_Clear } }
  object { Leg translate <-9,0,-7> } object { Leg translate <9,0,-7> }
  object { Leg translate <-9,0,8> } object { Leg translate <9,0,8> }
  torus { 14,.7 translate .7*y pigment { Copper } }
}
sphere { <3,20.9,-2>, 3 pigment { Orange } finish { phong .6 } }
plane { y,0 pigment { checker Khaki Sienna scale 7 } }
background { <.5,.6,.8> }
camera { right x*image_width/image_height up y location <14,34,-44> look_at <0,11,0> angle 50 }
light_source { <-40,70,-50> rgb .8 }
light_source { <60,40,-60> rgb .4 }
global_settings { assumed_gamma 1.0 max_trace_level 10 }
