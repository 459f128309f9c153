// a clock: hands by the clock value, ticks by mod, numerals as text
#include "colors.inc"
#include "golds.inc"
#declare Stunde = 10; #declare Minute = 8 + 60*clock;
camera { orthographic location <0,0,-10> look_at <0,0,0> right 8*x up 6*y }
light_source { <-8,10,-20> White }
#declare W = 0;
#while (W < 60)
  box { <-.03,2.5,-.1>, <.03,2.5+(mod(W,5)=0 ? .3 : .15),0> rotate -W*6*z pigment { color (mod(W,15)=0 ? Red : Black) } }
  #if (mod(W,5)=0)
    #declare Zahl = text { ttf "timrom.ttf" str((W=0 ? 12 : W/5),0,0) .1, 0 };
    object { Zahl translate -(min_extent(Zahl)+max_extent(Zahl))/2 scale .5 translate <2.15*sin(radians(W*6)), 2.15*cos(radians(W*6)), -.1> texture { T_Gold_3C } }
  #end
  #declare W = W + 1;
#end
cylinder { 0, .2*z, 2.95 pigment { onion color_map { [0 White] [1 Wheat] } scale 3 } }
torus { 2.95,.15 rotate 90*x texture { T_Gold_1A } }
prism { linear_sweep linear_spline -.05,.05,5 <-.08,-.3><.08,-.3><.03,1.4><-.03,1.4><-.08,-.3> rotate -90*x rotate -(Stunde+Minute/60)*30*z translate -.2*z pigment { Black } }
prism { linear_sweep linear_spline -.05,.05,5 <-.06,-.4><.06,-.4><.02,2.3><-.02,2.3><-.06,-.4> rotate -90*x rotate -Minute*6*z translate -.35*z pigment { Black } }
sphere { -.3*z,.14 texture { T_Gold_2B } }
background { ForestGreen }
