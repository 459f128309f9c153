// a table of patterns with warps, as textures on tiles
#version 3.5;
#include "colors.inc"
#macro Tile(n) box { <0,0,0>,<.94,.94,.1> translate <mod(n,5)-2.5,div(n,5)-2,0> } #end
#declare M = color_map { [0 rgb <.1,.1,.4>] [.4 rgb <.9,.5,.1>] [.6 rgb 1] [1 rgb <.1,.4,.2>] }
#declare D = pigment { gradient x color_map { M } scale .3 }
object { Tile(0) pigment { D warp { turbulence .4 octaves 3 } } }
object { Tile(1) pigment { D warp { black_hole <-1,-1.5,0>, .5 strength 2 falloff 1.5 } } }
object { Tile(2) pigment { boxed color_map { M } scale .4 warp { repeat x*.5 flip x } warp { repeat y*.5 offset .1*x } translate <-.3,-1.6,0> } }
object { Tile(3) pigment { D warp { cylindrical orientation z dist_exp 1 } } }
object { Tile(4) pigment { checker color Red color White scale .1 warp { spherical orientation y } } }
object { Tile(5) pigment { spiral1 3 color_map { M } scale .3 translate <-2,-.5,0> } }
object { Tile(6) pigment { spiral2 5 color_map { M } scale .3 translate <-1,-.5,0> } }
object { Tile(7) pigment { quilted control0 .2 control1 .8 color_map { M } scale .25 } }
object { Tile(8) pigment { waves frequency 4 color_map { M } } }
object { Tile(9) pigment { radial frequency 9 color_map { M } rotate 90*x translate <2,-.5,0> } }
object { Tile(10) pigment { crackle form <-1,1,0> metric 1 color_map { M } scale .2 } }
object { Tile(11) pigment { planar cubic_wave color_map { M } scale .5 translate <0,.5,0> } }
object { Tile(12) pigment { granite turbulence .2 ramp_wave frequency 2 phase .3 color_map { M } } }
object { Tile(13) pigment { leopard poly_wave 2 color_map { M } scale .06 } }
object { Tile(14) pigment { density_file df3 "spiral.df3" interpolate 1 color_map { M } scale <1,1,.2> translate <1.5,0,0> } }
object { Tile(15) pigment { White } normal { facets .4 size .3 scale .3 } finish { phong .5 } }
object { Tile(16) pigment { White } normal { quilted .8 scale .2 } }
object { Tile(17) pigment { Tan } normal { average normal_map { [1 ripples .6 scale .2] [1 bumps .6 scale .1] } } }
object { Tile(18) pigment { Tan } normal { gradient x .8 slope_map { [0 <0,1>] [.5 <1,0>] [1 <0,-1>] } scale .3 } }
object { Tile(19) texture { checker texture { pigment { Red } } texture { pigment { Gold } finish { metallic phong 1 } } scale .2 } }
camera { location <0,0,-6> look_at <0,0,0> angle 50 } light_source { <-4,6,-8> White } background { Gray50 }
