// coloured panes before a lamp, the way of 1994: filter in the colour, clear lead
#version 2.2
#include "colors.inc"
#declare Pane = box { <0 0 0> <.9 .9 .06> }
#declare Lead = texture { pigment { color rgb <.2 .2 .22> } finish { phong .4 } }
camera { location <1 4 -9> look_at <0 1.6 0> }
light_source { <3 7 9> color rgb <1.3 1.3 1.2> }
light_source { <-6 6 -9> color rgb .4 }
union {
  object { Pane pigment { color rgbf <1 .1 .1 .8> } translate <-2 0 0> }
  object { Pane pigment { color rgbf <.1 .9 .2 .8> } translate <-1 0 0> }
  object { Pane pigment { color rgbf <.2 .3 1 .8> } translate <0 0 0> }
  object { Pane pigment { color rgbf <1 .9 .1 .8> } translate <1 0 0> }
  object { Pane pigment { color red 1 green .5 blue .1 filter .7 } translate <-2 1 0> }
  object { Pane pigment { color Clear } translate <-1 1 0> }
  object { Pane pigment { color rgbf <.8 .2 .9 .8> } translate <0 1 0> }
  object { Pane pigment { color rgbf .9 } translate <1 1 0> }
  object { Pane pigment { gradient x color_map { [0 color rgbf <1 0 0 .8>] [1 color rgbf <0 0 1 .8>] } } translate <-1 2 0> }
  object { Pane pigment { wood color_map { [0 color rgbf <1 1 0 .8>] [.5 color rgbf <0 1 1 .8>] [1 color rgbf <1 1 0 .8>] } scale .3 } translate <0 2 0> }
  finish { ambient .1 diffuse .3 phong .5 }
}
union {
  box { <-2.1 -.1 0> <-2 2 .1> } box { <-1.1 -.1 0> <-1 3 .1> } box { <-.1 -.1 0> <0 3 .1> } box { <.9 -.1 0> <1 3 .1> } box { <1.9 -.1 0> <2 2 .1> }
  box { <-2.1 -.1 0> <2 0 .1> } box { <-2.1 .9 0> <2 1 .1> } box { <-2.1 1.9 0> <2 2 .1> } box { <-1.1 2.9 0> <1 3 .1> }
  texture { Lead }
}
plane { y, -.1 pigment { color rgb <.8 .75 .7> } finish { ambient .1 diffuse .8 } }
