// water, stairs, columns; 3.1 interior, fog, old style of normals with layered foam
#version 3.1;
#include "colors.inc"
#include "stones.inc"
#include "textures.inc"
global_settings { max_trace_level 9 assumed_gamma 2.2 }
#declare Column = union {
  difference { cylinder { <0,0,0>,<0,4,0>,.4 } #declare k=0; #while (k<12) cylinder { <.42,.2,0>,<.42,3.8,0>,.07 rotate k*30*y } #declare k=k+1; #end }
  box { <-.6,-.2,-.6>,<.6,0,.6> } box { <-.6,4,-.6>,<.6,4.3,.6> } torus { .42,.1 translate 3.9*y }
  texture { T_Stone9 }
}
#declare i=-1; #while (i<=1) object { Column translate <i*2.6,0,3> } #declare i=i+1; #end
box { <-4,4.3,2.2>,<4,4.8,3.8> texture { T_Stone9 } }
prism { linear_sweep linear_spline 2.3,3.7,4,<-4.2,0>,<4.2,0>,<0,1.4>,<-4.2,0> rotate -90*x scale <1,1,-1> translate 4.8*y texture { T_Stone13 } }
#declare i=0; #while (i<5) box { <-4,-.3-i*.25,2-i*.4>,<4,-.05-i*.25,6> texture { T_Stone6 scale .5 } } #declare i=i+1; #end
plane { y,-.5 texture { pigment { rgbf <.7,.9,1,.85> } normal { waves .08 frequency 2 scale .6 } finish { reflection .25 phong .6 ambient 0 diffuse .1 } } interior { ior 1.33 } }
plane { y,-2.5 pigment { checker rgb <.2,.5,.6> rgb <.8,.9,.9> scale .8 } }
fog { distance 60 color rgb <.7,.75,.8> } sky_sphere { pigment { gradient y color_map { [0 rgb <.7,.75,.8>][1 rgb <.3,.4,.8>] } } }
light_source { <-15,20,-18> White } camera { location <1,2,-8> look_at <0,1.6,3> angle 58 }
