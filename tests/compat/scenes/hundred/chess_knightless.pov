// pieces as sor and lathe, a row of them
#version 3.5;
#include "colors.inc"
#include "functions.inc"
#declare Bauer = sor { 9, <0.9,-0.1> <0.95,0.0> <0.9,0.25> <0.45,0.5> <0.3,1.2> <0.55,1.5> <0.3,1.58> <0.5,2.0> <0.1,2.35> }
#declare Turm = difference {
  lathe { linear_spline 12, <0,0>, <1,0>, <1,.3>, <.7,.6>, <.55,2>, <.9,2.2>, <.9,2.9>, <.7,2.9>, <.7,2.5>, <0,2.5>, <0,0>, <0,0> }
  #declare k=0; #while(k<3) box { <-1.2,2.65,-.15>, <1.2,3,.15> rotate k*60*y } #declare k=k+1; #end
}
#declare Laeufer = difference {
  lathe { quadratic_spline 10, <0,-.1>, <1,0>, <.9,.3>, <.5,.6>, <.35,1.8>, <.7,2.1>, <.35,2.3>, <.6,2.8>, <.05,3.5>, <0,3.6> }
  box { <-1,-.06,-1>, <1,.06,0> rotate 40*x translate <0,3,0> }
}
#declare Hell = texture { pigment { Wheat } finish { specular .4 roughness .02 } }
#declare Dunkel = texture { pigment { rgb <.2,.1,.05> } finish { specular .4 roughness .02 reflection .08 } }
object { Turm texture { Hell } translate <-4,0,0> }
object { Laeufer texture { Hell } rotate -30*y translate <-1.3,0,0> }
object { Bauer texture { Hell } translate <1.3,0,-1> }
object { Bauer texture { Dunkel } translate <3.6,0,.6> }
object { Turm texture { Dunkel } rotate 25*y translate <1.9,0,3> }
plane { y,0 pigment { checker rgb .85 rgb .25 scale 2.6 translate -1.3 } finish { reflection .1 } }
camera { location <0,5,-11> look_at <0,1.2,0> angle 50 }
light_source { <-10,14,-9> rgb 1 }
light_source { <9,7,-9> rgb .4 shadowless }
