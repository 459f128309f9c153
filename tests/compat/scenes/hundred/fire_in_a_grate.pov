// media in a hollow container, grain and a jittering lamp: random numbers everywhere
#include "colors.inc"
camera { location <0,2,-7> look_at <0,1.2,0> angle 48 }
light_source { <-6,8,-7> Gray70 area_light <1.5,0,0>,<0,1.5,0>,4,4 jitter }
cone { 0,1.1,3.2*y,0 hollow pigment { rgbt 1 }
  interior { media { emission <1.6,.7,.15> intervals 4 samples 4,8
    density { cylindrical turbulence <.3,.6,.3> color_map { [0 rgb 0][.4 rgb .3][1 rgb 1] } scale <1,3,1> } } } }
#declare i = 0;
#while (i < 7) cylinder { <-1.2,.2,i*.3-.9>,<1.2,.2,i*.3-.9>,.06 pigment { Gray25 } } #declare i = i+1; #end
cylinder { <-1,.45,-.4>,<1,.5,.5>,.25 pigment { DarkBrown } normal { bumps .8 scale .15 } }
plane { y,0 pigment { Gray60 } finish { crand .06 } } plane { z,2.5 pigment { brick Gray50 Firebrick scale .12 } finish { ambient .2 } }
