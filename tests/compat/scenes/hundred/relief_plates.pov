// plates with bump maps and normal patterns, lit from the side; a frame mitred with clipped boxes
#include "colors.inc"
#include "woods.inc"
camera { location <0,1.2,-8> look_at <0,.2,0> angle 46 }
light_source { <-14,6,-5> White }
light_source { <4,2,-12> Gray30 shadowless }
#macro Plate(P, N) box { <0,0,0>,<1.4,1.4,.1> pigment { Tan } normal { N } finish { phong .4 ambient .1 } translate P } #end
Plate(<-2.4,.4,0>, normal { bump_map { tga "map24.tga" bump_size 2 interpolate 2 } scale 1.4 })
Plate(<-.7,.4,0>, normal { bump_map { png "bumpmap_.png" use_index bump_size 4 } })
Plate(<1,.4,0>, normal { marble .7 turbulence .6 scale .4 })
Plate(<-2.4,-1.3,0>, normal { function { .5+.5*sin(9*x)*sin(9*y) } .6 })
Plate(<-.7,-1.3,0>, normal { dents 1.2 scale .2 })
Plate(<1,-1.3,0>, normal { crackle .8 scale .25 accuracy .01 bump_size .9 })
#declare Bar = box { <-3,1.95,-.1>,<3,2.2,.15> clipped_by { plane { <1,1,0>,2.8 rotate 0 } } texture { T_Wood3 rotate 90*y } }
object { Bar } object { Bar rotate 180*z }
cylinder { <-2.8,-2,0>,<-2.8,2,0>,.12 texture { T_Wood5 rotate 90*x } }
plane { z,.5 pigment { Gray70 } normal { quilted .5 scale .3 } }
