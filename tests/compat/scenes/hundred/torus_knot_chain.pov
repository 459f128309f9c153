#include "colors.inc"
#declare P = 2; #declare Q = 5; #declare STEPS = 90;
#macro Knot(a) <(2+.7*cos(Q*a))*cos(P*a), .7*sin(Q*a), (2+.7*cos(Q*a))*sin(P*a)> #end
union {
#declare K = 0;
#while (K < STEPS)
  #declare A = Knot(K*2*pi/STEPS); #declare B = Knot((K+1)*2*pi/STEPS);
  cylinder { A, B, .22 } sphere { A, .22 }
  #declare K = K+1;
#end
texture { pigment { wood turbulence .1 color_map { [0 Copper][1 Gold] } } finish { phong .6 } } rotate -50*x translate <-1.6,2.4,0>
}
#declare Link = union { torus { .5,.13 clipped_by { plane { x,0 } } translate -.3*x } torus { .5,.13 clipped_by { plane { -x,0 } } translate .3*x }
  cylinder { <-.3,0,.5>,<.3,0,.5>,.13 } cylinder { <-.3,0,-.5>,<.3,0,-.5>,.13 } }
#declare K = 0;
#while (K < 6) object { Link rotate K*90*x translate <-3+K*1.3,.3,-2.6> pigment { Gray70 } finish { specular .7 metallic } } #declare K = K+1; #end
plane { y,-.6 pigment { rgb <.5,.55,.5> } }
camera { location <0,4.5,-10> look_at <0,1.4,0> angle 48 } light_source { <-9,12,-9> White }
