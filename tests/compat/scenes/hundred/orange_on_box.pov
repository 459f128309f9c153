#include "colors.inc"
#include "textures.inc"

camera{
  location <-2.5, 3.5, -5>
  look_at <0, 1, 0>
}
light_source{ <-3, 6, -4> color White }

// first try of normals
sphere{
  <0.2, 2.1, 0>, 0.9
  pigment{ color Coral }
  normal{ crackle 0.8 scale 0.2 }
}
cylinder{
  <0, 0, 0>, <0, 1.2, 0>, 1.3
  pigment{ color Aquamarine }
}
box{
  <2, 0, 0>, <3, 1, 1>
  texture{ Blood_Marble }
}
plane{ y, 0 pigment{ Gray85 } }
