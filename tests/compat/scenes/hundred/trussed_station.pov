// spacecraft from macros: trusses, tanks, panels; components switched by flags
#version 3.5;
#include "colors.inc"
#include "metals.inc"
#declare SHOW_PANELS = true; #declare SHOW_SPIN = 1;
#macro Truss(n, w)
  union {
    #local i = 0;
    #while (i < n)
      #local k = 0;
      #while (k < 4)
        cylinder { <-w,i*2*w,-w>, <w,i*2*w,-w>, w/10 rotate k*90*y }
        cylinder { <-w,i*2*w,-w>, <-w,(i+1)*2*w,-w>, w/8 rotate k*90*y }
        cylinder { <-w,i*2*w,-w>, <w,(i+1)*2*w,-w>, w/14 rotate k*90*y }
        #local k = k+1;
      #end
      #local i = i+1;
    #end
    texture { pigment { Gray70 } finish { F_MetalA } }
  }
#end
object { Truss(12, .3) rotate -90*z translate -3.6*x }
#if (SHOW_SPIN)
  torus { 1.6, .25 rotate 90*z texture { T_Chrome_3B } }
  #declare k = 0; #while (k < 3) cylinder { -1.6*y, 1.6*y, .1 rotate k*60*x pigment { Gray50 } } #declare k = k+1; #end
#end
#if (SHOW_PANELS)
  box { <-3.2,-.02,.5>, <-1.8,.02,3> pigment { checker Navy SteelBlue scale .2 } finish { reflection .2 } }
  box { <-3.2,-.02,-3>, <-1.8,.02,-.5> pigment { checker Navy SteelBlue scale .2 } finish { reflection .2 } }
#end
#declare k = 0; #while (k < 4) merge { sphere { 0, .4 } cylinder { 0, 1.1*x, .4 } sphere { 1.1*x, .4 } translate <2,.6,0> rotate k*90*x texture { T_Copper_2B } } #declare k = k+1; #end
cone { <3.6,0,0>, .2, <4.6,0,0>, .8 open texture { T_Brass_3A } }
camera { location <4,4,-9> look_at 0 angle 46 } light_source { <20,30,-20>, 1 } light_source { <-20,-10,-20>, .2 }
