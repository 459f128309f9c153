// refraction where it stood before 3.1, and a bounded still life
#version 3.0
#include "colors.inc"
#include "glass.inc"
global_settings { max_trace_level 8 assumed_gamma 2.2 }
camera { location <0, 2.5, -6> look_at <0, .8, 0> angle 45 }
light_source { <-7, 8, -6> color White }
light_source { <7, 4, -6> color Gray40 }
#declare Old_Glass = texture { pigment { color rgbf <.95, 1, .95, .9> } finish { ambient 0 diffuse 0 reflection .1 refraction 1 ior 1.5 phong .6 phong_size 90 } }
#declare Tumbler = difference {
  cone { <0, 0, 0>, .55, <0, 1.4, 0>, .75 }
  cone { <0, .15, 0>, .47, <0, 1.5, 0>, .69 }
  bounded_by { box { <-.8, -.05, -.8>, <.8, 1.45, .8> } }
}
object { Tumbler texture { Old_Glass } translate <-1.3, 0, 0> }
sphere { <.3, .7, .4>, .7 texture { Old_Glass finish { ior 1.3 } } }
sphere { <1.7, .6, -.4>, .6 texture { T_Glass3 } }
box { <.7, 0, -1.6>, <1.3, .3, -1> pigment { color Orange } }
plane { y, 0 pigment { checker color White color NavyBlue scale .7 } finish { ambient .2 } }
plane { z, 6 pigment { brick color Gray70 color Firebrick scale .1 } finish { ambient .3 } }
