// a ball cut by slabs and cones; the solid grows by a loop that declares it anew
#version 3.7;
#include "colors.inc"
global_settings { assumed_gamma 1.0 }
#declare Near_View = true;
camera { #if (Near_View) orthographic right 3.4*4/3*x up 3.4*y #else right 4/3*x angle 30 #end location <1,3,-7> look_at 0 }
background { Black }
light_source { 0 rgb 1 translate <-20,40,-40> }
light_source { 0 rgb .4 translate <60,10,-30> }
#declare Gap = .03;
#declare Ways = array[7] { x, y, z, <1,1,1>, <-1,1,1>, <1,-1,1>, <1,1,-1> }
#declare Paint = array[4] { color Orange, color Turquoise, color Green, color Yellow }
#macro Unit(List)
  #local k = 0;
  #while (k < dimension_size(List,1)) #declare List[k] = vnormalize(List[k]); #local k = k+1; #end
#end
Unit(Ways)
#macro Cutter(Way, Kind)
  #switch (Kind)
    #range (0,2) cylinder { Way*(.4-Gap), Way*(.4+Gap), 2 } #break
    #else difference { cone { 0, 0, Way*2, 1.5 } cone { Way*Gap*3, 0, Way*(2+Gap*3), 1.5 } }
  #end
#end
#declare Solid = object { sphere { 0, 1.4 } pigment { White } finish { phong .3 } }
#declare k = 0;
#while (k < 7)
  #local Cut = Cutter(Ways[k], k)
  #declare Solid = difference { object { Solid } object { Cut pigment { Paint[mod(k,4)] } } };
  #declare k = k+1;
#end
object { Solid rotate <-12,24,8> }
