#include "colors.inc"
// summer things on a beach; no version; normals and finishes stand outside the textures
camera { location <5, 5, -8> look_at <0, 0.7, 0> angle 50 }
light_source { <9, 14, -7> color White }
#declare Weave = texture { pigment { marble color_map { [0.2 rgb <0.62, 0.45, 0.16>] [0.7 rgb <0.97, 0.84, 0.45>] } frequency 9 } }
union {
  intersection {
    sphere { 0, 2 scale <1, 0.8, 1.15> }
    plane { -y, 0 }
    texture { Weave rotate 90*z }
    normal { dents 0.5 scale 0.3 }
    finish { phong 0.1 roughness 1 }
  }
  torus { 2.6, 0.9 scale <1, 0.06, 1.1> texture { Weave } normal { dents 0.4 scale 0.3 } finish { specular 0.1 } }
  cylinder { 0.05*y, 0.55*y, 2.03 scale <1, 1, 1.15> pigment { Firebrick } finish { specular 0.4 } }
  transform { rotate <0, 25, 6> translate <-0.8, 0.2, 0> }
}
difference { sphere { <2.6, 0.8, -1.6>, 0.8 } sphere { <2.6, 1.2, -2.1>, 0.7 } pigment { Orange } normal { leopard 0.4 scale 0.1 } }
plane { y, 0 pigment { color rgb <0.9, 0.8, 0.55> } normal { bumps 0.8 scale 0.15 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 SkyBlue] } } }
