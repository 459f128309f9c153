#version 2.0
#include "colors.inc"
#include "textures.inc"
camera { location <0, 2, -6> direction <0, 0, 1.3> look_at <0, 1, 0> }
object { light_source { <-8, 9, -9> color White } }
light_source { <6, 3, -7> color Gray50 }
#declare Paper = texture { pigment { image_map { <1, -1, 0> gif "map.gif" once interpolate 2 } } }
box { <0, 0, -.02> <1, 1, .02> texture { Paper } scale <1.6, 1.6, 1> translate <-2.5, .3, 0> }
sphere { <0, 1.1, 0> 1
  texture { pigment { image_map { <1, -1, 0> tga "map24.tga" map_type 1 } } finish { ambient .3 phong .8 } } }
box { <0, 0, 0> <1, 1, .5>
  texture { pigment { color Tan } normal { bump_map { <1, -1, 0> gif "map.gif" bump_size 3 use_color } } finish { phong .5 } }
  scale <1.5, 1.5, 1> rotate <0, -25, 0> translate <1.3, .2, .3> }
cylinder { <0 0 0> <0 1 0> .6
  texture { pigment { image_map { tga "map8.tga" map_type 2 filter 3 .6 interpolate 4 } } finish { ambient .3 } }
  translate <.9, 0, -2> }
plane { y 0 texture { material_map { gif "map.gif" map_type 0
    texture { pigment { White } finish { reflection .2 } } texture { pigment { Firebrick } } texture { Jade } }
    rotate <90 0 0> scale 2 } }
