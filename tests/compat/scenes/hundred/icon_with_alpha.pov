// an icon: orthographic, transparent ground, outline by a bigger black copy behind
#version 3.7;
global_settings { assumed_gamma 2.2 }
#include "colors.inc"
background { color rgbt <1,1,1,1> }
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
light_source { <-10,14,-20> rgb 1 shadowless }
#declare Drop = union { sphere { 0, .8 } cone { <0,.35,0>, .72, <0,1.35,0>, 0 } };
object { Drop pigment { gradient y color_map { [0 srgb <.1,.3,.8>] [1 srgb <.6,.85,1>] } translate -.8*y scale 2.2 } finish { ambient .4 diffuse .5 specular .6 } translate <-.9,-.2,0> }
object { Drop scale <1.08,1.06,1> pigment { Black } finish { ambient 0 diffuse 0 } translate <-.9,-.22,1> }
difference { torus { .7, .22 rotate 90*x } box { <0,-.15,-1>, <2,.15,1> rotate 20*z } pigment { srgbt <1,.5,0,.3> } finish { ambient .5 diffuse .5 } translate <.9,0,0> }
text { ttf "crystal.ttf" "pov" .1, 0 pigment { color srgb <.1,.1,.1> } finish { ambient 1 diffuse 0 } scale .55 translate <.45,-1.3,-1> }
