#version 3.7;
global_settings { assumed_gamma 1 }
#include "arrays.inc"
#include "math.inc"
#include "rand.inc"
#declare A = array[24]; #declare S = seed(2718);
#for (i,0,23) #declare A[i] = RRand(.2,3,S); #end
#declare B = A; Sort_Array(B)
#declare Mixed = array[5] { 3, 1, 2, 5, 4 };
Reverse_Array(Mixed)
#declare Grid = array[3][4] { {1,2,3,4}, {2,3,4,1}, {3,4,1,2} };
#for (i,0,23)
  box { <i*.3-3.6,0,0>, <i*.3-3.36,A[i],.24> pigment { rgb <.9,.4,.2> } }
  box { <i*.3-3.6,0,2>, <i*.3-3.36,B[i],2.24> pigment { rgb <.2,.5,.9> } }
#end
#for (i,0,dimension_size(Mixed,1)-1) sphere { <i-2,.3,-1.2>, .08*Mixed[i] pigment { rgb <Mixed[i]/5,.3,.5> } } #end
#for (i,0,2) #for (j,0,3) cylinder { <j*.5-.7+i*2.2-2,0,-2.4>, <j*.5-.7+i*2.2-2,Grid[i][j]*.15,-2.4>, .18 pigment { rgb <i/2,1-j/3,.4> } } #end #end
#declare M = Mean(array[4] {A[0],A[1],A[2],A[3]});
box { <-4,M,.5>, <4,M+.03,.6> pigment { rgb 0 } }
plane { y,0 pigment { rgb .8 } } light_source { <-6,12,-9> rgb 1 } sky_sphere { pigment { rgb .9 } }
camera { location <0,4.4,-8.5> look_at <0,.9,.4> angle 52 right x*image_width/image_height }
