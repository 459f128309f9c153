#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
#include "finish.inc"
#include "metals.inc"
#include "golds.inc"
#include "glass.inc"
#include "colors.inc"
#declare F = array[10];
#declare F[0] = finish { Phong_Shiny } #declare F[1] = finish { specular albedo .3 roughness .03 diffuse albedo .6 }
#declare F[2] = finish { brilliance 4 metallic specular .6 } #declare F[3] = finish { irid { .4 thickness .3 turbulence .2 } }
#declare F[4] = finish { reflection { .1, .9 fresnel on falloff 2 exponent .8 metallic } conserve_energy }
#declare F[5] = finish { emission .5 diffuse 0 } #declare F[6] = finish { diffuse .5, .4 } #declare F[7] = finish { F_MetalD }
#declare F[8] = finish { ambient rgb <.3,0,0> diffuse .7 phong .5 phong_size 5 } #declare F[9] = finish { Mirror }
#for (i,0,9)
  sphere { <mod(i,5)*1.3-2.6, 1.9-div(i,5)*1.4, 0>, .55 pigment { rgb <.8,.5+.04*i,.3> } finish { F[i] } interior { ior 1.5 } }
#end
sphere { <-2.4,-.9,-1>,.5 texture { T_Dark_Green_Glass } interior { I_Glass } } sphere { <-1,-.9,-1>,.5 texture { T_Gold_5E } } sphere { <.4,-.9,-1>,.5 texture { T_Silver_3D } }
sphere { <1.8,-.9,-1>,.5 hollow texture { pigment { rgbf .9 } finish { F_Glass2 } } interior { I_Glass_Dispersion1 } }
box { <-4,-1.5,-3>,<4,-1.4,3> pigment { checker Gray30 Gray80 } } plane { z,3 pigment { gradient y color_map { [0 Navy][1 SkyBlue] } scale 4 } }
light_source { <-5,7,-9> rgb 1.1 } camera { location <0,1,-8.5> look_at <0,.4,0> angle 46 right x*image_width/image_height }
