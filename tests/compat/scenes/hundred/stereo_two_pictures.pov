// picture in a picture: two views of one object beside each other, no_shadow and matrices
#include "colors.inc"
#declare Thing = union {
  box { -1,1 pigment { rgbt <.4,.6,1,.6> } }
  sphere { 0,.7 pigment { Orange } finish { phong .8 } }
  cylinder { -1.6*y,1.6*y,.12 pigment { Gray30 } }
  difference { sphere { <1,1,-1>,.5 } plane { z,-1 } pigment { Yellow } }
}
#macro View(Eye, Shift)
  object { Thing rotate <15,30+Eye,0> scale .9 translate Shift*x no_shadow }
#end
View(-4, -1.7)
View(4, 1.7)
box { <-.02,-2.4,-.1>,<.02,2.4,.1> pigment { Black } no_shadow }
plane { -z,-3 pigment { bozo color_map { [0 rgb .85][1 rgb .95] } scale .4 } finish { ambient .5 } }
camera { orthographic location -12*z look_at 0 up 5.4*y right 7.2*x }
light_source { <-6,9,-14> White }
