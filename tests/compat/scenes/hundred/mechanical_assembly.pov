// crank, rod and piston; positions computed by the angle; threads and gears in loops
#version 3.7;
#include "metals.inc"
#include "colors.inc"
global_settings { assumed_gamma 1.0 }
#declare A = 40 + 360*clock; #declare Rc = 1; #declare Lr = 3;
#declare Pin = <Rc*cos(radians(A)), Rc*sin(radians(A)), 0>;
#declare PistonY = Pin.y + sqrt(Lr*Lr-Pin.x*Pin.x);
#declare Steel = texture { pigment { rgb .6 } finish { F_MetalB } }
difference { union { cylinder { -.3*z,-.1*z,1.5 } #for (i,0,23) box { <1.4,-.12,-.3>,<1.75,.12,-.1> rotate i*15*z } #end } #for (i,0,4) cylinder { -z,z,.3 translate .85*x rotate i*72*z } #end texture { Steel } rotate A*z translate .5*z }
union { cylinder { Pin-.25*z,Pin+.1*z,.35 } cylinder { Pin,<0,PistonY,0>,.16 } cylinder { <0,PistonY,-.25>,<0,PistonY,.25>,.3 } texture { T_Brass_3B } }
difference { cylinder { <0,PistonY-.5,0>,<0,PistonY+.7,0>,.9 } box { <-.5,-.6,-1>,<.5,.35,1> translate PistonY*y } torus { .9,.06 translate (PistonY+.5)*y } torus { .9,.06 translate (PistonY+.3)*y } texture { T_Chrome_2C } }
difference { box { <-1.4,2,-1.2>,<1.4,5.2,1.2> } cylinder { <0,1,0>,<0,5,0>,.92 } plane { z,0 } pigment { rgb <.3,.4,.5> } }
union { #for (i,0,60) sphere { <.35*cos(i*.5),i*.03,.35*sin(i*.5)>,.08 } #end cylinder { 0,1.8*y,.33 } object { cylinder { 1.8*y,2.1*y,.6 } } texture { Steel } translate <2.6,0,-.8> }
plane { y,-2 pigment { Gray40 } } plane { z,4 pigment { rgb <.75,.8,.85> } }
camera { location <5,4.5,-10> look_at <.4,1.6,0> angle 42 right x*image_width/image_height } light_source { <-9,14,-12> rgb 1 } light_source { <12,4,-8> rgb .4 }
