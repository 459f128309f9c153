// No commas, quadrics and quartics as lists, inverse solids
#version 3.0
#include "shapes.inc"
#include "colors.inc"
#include "shapesq.inc"
camera { location <0 3, -12> direction <0 0 1.5> up <0 1 0> right <1.33 0 0> look_at <0 1 0> }
light_source { <-10 15, -10> color White }
light_source { <12 5, -8> color Gray30 }
#declare Dish = quadric { <1 0 1> <0 0 0> <0, -1.5 0> 0 clipped_by { plane { <0 1 0> 1.2 } } }
object { Dish pigment { color red 0.8 green 0.4 blue 0.1 } finish { phong 1 } translate <-3.2 0 0> }
intersection {
  quadric { <1, -0.6 1> <0 0 0> <0 0 0> 0-0.35 }
  plane { <0 1 0> 1.2 }
  plane { <0, -1 0> 1.2 }
  pigment { color Gold }
  finish { reflection .2 phong .7 }
  translate <-0.6 1.2 0>
}
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.36, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.28, 0, 0, 0, 0, 1, 0, -1.36, 0, 0.4096>
  sturm pigment { color SkyBlue } finish { specular .6 } rotate <60 20 0> translate <1.8 1.2 0> }
cubic { <0 0 0 0 0 0 0 0 1 0 0 0 0 0 0, -1 0 0 0 0>
  clipped_by { box { <-1, -1, -1> <1 1 1> } } pigment { color Orchid } rotate <0 30 0> translate <4 1 1> }
object { Paraboloid_Y scale <.3 .5 .3> clipped_by { plane { y 1.4 } } pigment { Coral } translate <3.3 0, -3> }
difference { plane { y 0 } sphere { <0 .2, -3> 1 } pigment { checker White Gray60 } }
