// lattices by macros that call macros; ghosts of neighbours fade with a number
#include "colors.inc"
global_settings { max_trace_level 24 }
camera { location <3,2.6,-7> look_at <1.3,0,0> angle 34 }
light_source { <-8,20,-20> White }
light_source { <12,4,-14> Gray40 shadowless }
background { rgb <.96,.97,1> }
#macro Ion (P, R, C, Fade)
  sphere { P, R*(1-Fade*.5) texture { pigment { C transmit Fade } finish { phong .8*(1-Fade) ambient .2 } } }
#end
#macro Salt (O, Fade)
  #local i=0;
  #while (i<27)
    #local P = <mod(i,3), mod(div(i,3),3), div(i,9)>-1;
    #if (mod(i,2)=0) Ion(O+P*.5, .2, color Green, Fade) #else Ion(O+P*.5, .12, color Orchid, Fade) #end
    #local i=i+1;
  #end
#end
#macro Cage (O)
  #local k=0;
  #while (k<4)
    #local a=(mod(k,2)-.5); #local b=(div(k,2)-.5);
    cylinder { O+<-.5,a,b> O+<.5,a,b> .02 pigment { Gray50 } }
    cylinder { O+<a,-.5,b> O+<a,.5,b> .02 pigment { Gray50 } }
    cylinder { O+<a,b,-.5> O+<a,b,.5> .02 pigment { Gray50 } }
    #local k=k+1;
  #end
#end
Salt(<0,0,0>, 0) Cage(<0,0,0>)
Salt(<2,0,0>, .6) Cage(<2,0,0>)
