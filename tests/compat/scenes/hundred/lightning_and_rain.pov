#include "colors.inc"
/* storm: a bolt by halving a line, drops by a seed, rings where drops meet a hill */
background { rgb <.04,.05,.1> }
camera { location <0,2.4,-9> look_at <0,2.4,0> angle 54 }
light_source { <-2,5.5,2> rgb <.8,.85,1> }
light_source { <8,10,-10> Gray30 shadowless }
#declare luck=seed(2024);
#macro flash(p,q,fork,wide)
  #if (vlength(q-p)<.35)
    cylinder { p,q,wide }
  #else
    #local mid=(p+q)*.5+.2*vlength(q-p)*<rand(luck)*2-1,rand(luck)-.5,0>;
    flash(p,mid,fork,wide)
    flash(mid,q,fork,wide*.8)
    #if (fork & rand(luck)>.5) flash(mid,mid+<rand(luck)*3-1.5,-1.5,0>,no,wide*.5) #end
  #end
#end
union { flash(<-2,6.5,3>,<-.5,0,3>,yes,.07) pigment { rgb <.85,.9,1> } finish { ambient 2.5 diffuse 0 } no_shadow }
#declare streak=cone { 0,.03,.6*y,0 texture { pigment { gradient y color_map { [0 rgbt <.8,.9,1,.2>][1 rgbt 1] } scale .6 } finish { ambient .8 } } };
#declare hill=sphere { <2.2,-2,1>,3.2 scale <1,.9,1> }
object { hill pigment { DarkOliveGreen } normal { bumps .4 scale .2 } }
#declare k=0;
#while (k<90)
  #declare foot=<rand(luck)*9-4.5,9,rand(luck)*5-2,>;
  object { streak rotate 9*z translate foot*<1,0,1>+rand(luck)*5*y }
  #declare slant=<0,0,0>; #declare met=trace(hill,foot,-y,slant);
  #if (vlength(slant)>0 & mod(k,3)=0) torus { .15,.02 scale <1,.4,1> translate met pigment { White } } #end
  #declare k=k+1;
#end
plane { y,0 pigment { rgb .15 } normal { ripples .3 frequency 4 } finish { reflection .35 } }
