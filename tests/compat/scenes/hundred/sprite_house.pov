// a tile of a game: dimetric view, seasons and global light by switches
#version 3.7; // 3.6 too
#declare Season = 1; // 0 summer, 1 autumn, 2 winter
#declare Soft_Light = 0;
#if (Soft_Light)
global_settings { assumed_gamma 1 radiosity { count 40 error_bound .7 } }
#else
global_settings { assumed_gamma 1.1 }
#default { finish { ambient .25 diffuse .85 } }
#end
#include "colors.inc"
#include "textures.inc"
#include "woods.inc"
#declare View_Game = camera { orthographic location <40,32.66,-40> look_at <0,4,0> right 32*x up 24*y }
#declare View_Front = camera { perspective angle 60 location <0,6,-40> look_at <0,5,0> }
camera { View_Game }
light_source { <-500,900,-700> rgb <1,.94,.85> }
light_source { <20,12,-40> rgb .25 shadowless }
#declare Rail = texture_map { [0 T_Wood3] [.55 T_Wood18] [.55 pigment { color Clear }] [1 pigment { color Clear }] }
#declare Roof_Tex = texture { pigment { gradient x color_map { [.85 color (Season = 2 ? White : Firebrick)] [.85 Gray20] } } finish { ambient .15 } }
#declare Frame_Win = union { box { <.1,.1,.1>, <1.9,2.4,.15> texture { Glass } }
  difference { box { 0, <2,2.5,.25> } box { <.2,.2,-1>, <1.8,2.3,1> } } box { <.9,0,.05>, <1.1,2.5,.2> } pigment { White } }
union {
  difference { box { <-8,0,-5>, <8,7,5> pigment { Wheat } normal { cells .2 scale .1 } } box { <-7.7,.2,-4.7>, <7.7,8,4.7> pigment { Gray50 } }
    #for (k,0,2) box { <-6+k*5,2,-6>, <-4+k*5,4.5,-4> pigment { White } } #end }
  #for (k,0,2) object { Frame_Win translate <-6+k*5,2,-5.05> } #end
  prism { -9,9,4, <-6,0>, <6,0>, <0,5.5>, <-6,0> rotate -90*x rotate 90*y scale <1,1,1> translate 7*y texture { Roof_Tex } }
  box { <-3,4.8,-7>, <3,6,-6.9> texture { gradient x texture_map { Rail } scale .6 } }
  box { <-3,4.6,-7>, <3,4.8,-5> texture { T_Wood3 } }
  rotate 0*y
}
plane { y,-.01 pigment { color rgb (Season = 2 ? <.95,.95,.95> : <.45,.5,.2>) } }
