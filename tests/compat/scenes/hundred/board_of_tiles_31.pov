#version 3.1;
// a board made by two loops; macros as soon as there were any
#include "colors.inc"
#include "stones.inc"
#include "woods.inc"
#declare Light_Tile = texture { T_Stone10 scale 2 }
#declare Dark_Tile = texture { T_Stone24 scale 2 }
#macro Tile (I, J)
  box { <I, -0.2, J>, <I + 0.98, 0, J + 0.98>
    #if (mod(I + J, 2) = 0) texture { Light_Tile } #else texture { Dark_Tile } #end
  }
#end
#macro Pawn (I, J, Tex)
  merge {
    sphere { <0, 0.75, 0>, 0.22 }
    cone { <0, 0.05, 0>, 0.3, <0, 0.72, 0>, 0.1 }
    cylinder { <0, 0, 0>, <0, 0.1, 0>, 0.36 }
    torus { 0.14, 0.05 translate 0.55*y }
    texture { Tex }
    translate <I + 0.49, 0, J + 0.49>
  }
#end
#declare I = 0;
#while (I < 8)
  #declare J = 0;
  #while (J < 8)
    Tile(I, J)
    #if (J = 1) Pawn(I, J, texture { T_Wood7 scale 0.4 }) #end
    #if (J = 5 & mod(I, 3) != 1) Pawn(I, J, texture { T_Wood12 scale 0.4 }) #end
    #declare J = J + 1;
  #end
  #declare I = I + 1;
#end
box { <-0.5, -0.3, -0.5>, <8.5, -0.05, 8.5> texture { T_Wood1 rotate 90*y } }
camera { location <1.5, 5, -5> look_at <4, 0, 3.2> }
light_source { <-6, 14, -4> color White }
light_source { <14, 9, -8> color Gray50 shadowless }
background { color SlateBlue }
