// maps with two colours an entry; layered sky; old names
#version 2.0
#include "colors.inc"
#declare Sky_Layer = texture {
  pigment { bozo turbulence 0.4 octaves 4 omega 0.5 lambda 2.1
    color_map {
      [0.0 0.4 color red 0.3 green 0.4 blue 0.9 color red 0.35 green 0.5 blue 0.95]
      [0.4 0.7 color red 0.35 green 0.5 blue 0.95 color White]
      [0.7 1.001 color White color Gray75]
    }
    scale <600, 100, 600>
  }
  finish { ambient 1 diffuse 0 }
}
sphere { <0, 0, 0> 1500 texture { Sky_Layer } inverse }
camera { location <0, 3, -14> direction <0, 0, 1> up <0, 1, 0> right <1.333, 0, 0> look_at <0, 3.5, 0> }
light_source { <-60, 80, -70> color rgb 0.9 }
plane { <0, 1, 0> 0
  texture { pigment { gradient <1, 0, 0> color_map { [0 .5 color ForestGreen color YellowGreen] [.5 1 color YellowGreen color ForestGreen] } scale 4 turbulence .8 }
    normal { bumps .5 scale .3 } finish { ambient .2 diffuse .7 } }
  texture { pigment { bozo color_map { [0 .5 color Clear color Clear] [.5 1 color Clear color red .6 green .5 blue .2 alpha .3] } scale 6 } }
}
#declare Stripe = pigment { gradient y color_map { [0 .5 color Red color Red] [.5 1 color White color White] } scale .8 }
cylinder { <0 0 0> <0 6 0> .4 pigment { Stripe rotate <20 0 0> } finish { phong .8 } translate <-3 0 0> }
sphere { <-3 6.4 0> .7 pigment { color Gold } finish { phong 1 metallic } }
cone { <3 0 1> 2 <3 5 1> 0 texture { pigment { marble turbulence 1 color_map { [0 .8 color Gray90 color Gray50] [.8 1 color Gray50 color Gray20] } } } }
