// a room: difference of boxes, window, wall paper, lamp that looks like a ball
#version 3.6;
#include "colors.inc"
#include "woods.inc"
#include "textures.inc"
global_settings { assumed_gamma 1.8 ambient_light rgb <0.9, 0.95, 1.2> }
#declare Tapete = texture {
  pigment { gradient x color_map { [0.0 rgb <0.8,0.75,0.6>] [0.45 rgb <0.8,0.75,0.6>] [0.5 rgb <0.6,0.5,0.35>] [0.95 rgb <0.6,0.5,0.35>] [1 rgb <0.8,0.75,0.6>] } scale 0.5 }
  finish { ambient 0.25 diffuse 0.6 }
}
#declare Zimmer = difference {
  box { <-4.2,-0.2,-6>, <4.2,3.2,4.2> }
  box { <-4,0,-5.8>, <4,3,4> }
  box { <1,1,3.5>, <3,2.5,5> }
  texture { Tapete }
}
object { Zimmer hollow }
union {
  box { <1,1.7,4.05>, <3,1.76,4.15> }
  box { <1.97,1,4.05>, <2.03,2.5,4.15> }
  difference { box { <0.9,0.9,3.95>, <3.1,2.6,4.1> } box { <1,1,3>, <3,2.5,5> } }
  pigment { White }
}
box { <-4,0,-5.8>, <4,0.01,4> texture { T_Wood10 scale 0.7 rotate 90*y } }
union {
  box { <-3,0.7,1>, <-0.5,0.76,2.5> }
  cylinder { <-2.9,0,1.1>, <-2.9,0.7,1.1>, 0.05 } cylinder { <-0.6,0,1.1>, <-0.6,0.7,1.1>, 0.05 }
  cylinder { <-2.9,0,2.4>, <-2.9,0.7,2.4>, 0.05 } cylinder { <-0.6,0,2.4>, <-0.6,0.7,2.4>, 0.05 }
  texture { T_Wood23 }
}
light_source { <0,2.4,0.5>, rgb <1,0.95,0.8> fade_distance 3 fade_power 2
  looks_like { sphere { 0, 0.15 pigment { White } finish { ambient 1 } } } }
cylinder { <0,2.5,0.5>, <0,3,0.5>, 0.015 pigment { Gray30 } }
light_source { <8,9,20>, rgb <0.9,0.9,0.7> parallel point_at <0,0,0> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8,0.9,1>] [1 rgb <0.3,0.5,0.9>] } } }
camera { location <-1,1.7,-5.5> look_at <0.2,1.2,2> angle 66 }
