// an egg of a sphere and half an ellipsoid; in an egg cup from a sor
#include "colors.inc"
camera { location <0,3,-7> look_at <0,1.3,0> right 4/3*x }
light_source{<5,9,-7> White}
light_source{<-9,3,-5> Gray30}
#declare Unten = difference { sphere {0,1} plane {-y,0} }
#declare Oben = intersection { sphere {0,1 scale <1,1.45,1>} plane {-y,0.0001} }
#declare Ei = merge { object{Unten} object{Oben} }
#declare EiTextur = texture {
 pigment { spotted color_map { [0 rgb <.9,.75,.6>] [.35 rgb <.95,.83,.7>] [1 rgb <1,.88,.75>] } scale .1 }
 finish { phong .3 phong_size 15 }
}
object { Ei texture {EiTextur} scale .8 translate <0,1.9,0> }
sor {
 8,
 <0.00,-0.1> <0.8,0> <0.55,0.15> <0.2,0.45> <0.25,0.8> <0.7,1.2> <0.82,1.55> <0.8,1.8>
 open
 texture { pigment {Aquamarine} finish {specular .6 roughness .01 reflection .05} }
}
object { Ei scale .7 rotate 80*z rotate 30*y translate <2.3,.7,-.5> texture {EiTextur} }
object { Unten pigment{White} scale .7 rotate <20,0,200> translate <-2.2,.7,-1> }
plane { y,0 pigment { checker rgb<.9,.9,1>, rgb<.75,.8,1> scale .6 } }
