// a library macro with optional parts by #ifdef, undefined again behind
#include "colors.inc"
#include "transforms.inc"
#declare Axes_Size = 3; #declare Axes_Ticks = on;
#macro Axes_Arrow(V, C, Name)
  #local L = vlength(V);
  union {
    cylinder { 0, y*L, .04 } cone { y*L, .12, y*(L+.35), 0 }
    #ifdef (Axes_Ticks) #local I = 1; #while (I < L) torus { .08, .02 translate I*y } #local I = I+1; #end #end
    pigment { C } Reorient_Trans(y, V)
  }
  object { text { ttf "cyrvetic.ttf" Name .1, 0 } scale .4 translate V*1.2 + <-.1,-.1,0> pigment { C } no_shadow }
#end
Axes_Arrow(x*Axes_Size, Red, "x")
Axes_Arrow(y*Axes_Size, Green, "y")
Axes_Arrow(z*Axes_Size, Blue, "z")
#undef Axes_Ticks
union { Axes_Arrow(<-1,1,-1>*1.2, Gray50, "n") }
#declare Obj = box { -.4,.4 pigment { rgb <.9,.8,.5> } }
object { Obj Shear_Trans(<1,.4,0>, <0,1,.3>, <0,0,1>) translate <2,.5,1> }
object { Obj Matrix_Trans(<.5,0,.5>, <0,1,0>, <-.5,0,.5>, <1,.5,2.5>) }
object { Obj Point_At_Trans(<1,1,1>) translate <2.5,.5,2.6> }
object { Obj Center_Trans(Obj, x+y+z) translate .5*y Spline_Trans(spline { linear_spline 0, <-2,0,0> 1, <-2,0,3> }, .5, y, .1, .5) }
plane { y,-.001 pigment { checker White Gray80 } }
camera { location <4,4,-7> look_at <.6,.9,.6> angle 44 } light_source { <10,20,-10> White } light_source { <-10,6,-10> Gray40 shadowless }
