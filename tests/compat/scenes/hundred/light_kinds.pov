// all kinds of lamps over a row of posts: groups, projected, cylinder, fading, looks_like
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }
#default { finish { ambient .05 diffuse .8 } }
#declare Post = union { cylinder { 0,1.2*y,.25 } sphere { 1.4*y,.35 } pigment { Gray80 } }
light_source { <-4,4,-2> rgb <1,.6,.3> cylinder point_at <-3,0,0> radius .8 falloff 1.4 tightness 2 }
light_source { <-1,4,-2> rgb <.5,1,.5> spotlight point_at <-1,0,0> radius 8 falloff 20 tightness 10 fade_distance 5 fade_power 2 }
light_source { <2.2,3.2,0> rgb 1.5 projected_through { torus { .4,.12 translate <1.6,2.4,0> } } }
light_source { <3.5,2.4,-1> rgb <.6,.7,1> fade_distance 1.5 fade_power 2 looks_like { sphere { 0,.12 pigment { White } finish { emission 1 } } } }
light_group {
  light_source { <0,6,-8> rgb <1,0,0> }
  object { Post translate <0,0,1.6> }
  global_lights off
}
light_source { <0,9,-9> rgb .25 area_light 2*x,2*y,3,3 area_illumination on }
#for (i,-3,3) #if (i != 0) object { Post translate i*1.2*x } #end #end
object { Post translate <4.4,0,1> no_shadow no_reflection }
plane { y,0 pigment { checker rgb .9 rgb .6 } finish { reflection .1 } } plane { z,3 pigment { rgb .7 } }
camera { location <0,3.4,-8> look_at <0,.7,0> angle 58 right x*image_width/image_height }
