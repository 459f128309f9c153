// a ball of two halves with a button, mirrored in a tray
#include "colors.inc"
#declare R = 2;
#declare gloss = finish { phong 0.9 phong_size 80 reflection { 0.02, 0.25 } ambient 0.25 };
#declare ball = union {
   intersection { sphere { 0, R } plane { -y, -0.12 } pigment { color rgb <0.9, 0.1, 0.1> } }
   intersection { sphere { 0, R } plane { y, -0.12 } pigment { color White } }
   sphere { 0, R*0.97 pigment { color Black } }
   difference {
      cylinder { <0,0,-R*0.9>, <0,0,-R*1.02>, 0.55 }
      torus { 0.4, 0.05 rotate x*90 translate -z*R*1.02 }
      pigment { radial color_map { [0.5 White] [0.5 Gray80] } frequency 6 rotate x*90 }
   }
   finish { gloss }
};
object { ball rotate <-15, 25, 8> translate y*R }
object { ball scale 0.45 rotate <10, -60, 0> translate <-3.4, 0.9, -1> }
object { ball scale 0.3 rotate <80, 0, 30> translate <2.9, 0.6, -2.6> }
difference {
   box { <-6, -0.4, -5>, <6, 0.3, 5> }
   box { <-5.7, 0, -4.7>, <5.7, 1, 4.7> }
   pigment { color SteelBlue } finish { reflection 0.3 ambient 0.1 }
}
camera { location <0, 5, -12> look_at <-0.2, 1.6, 0> angle 42 }
light_source { <7, 12, -9> color White }
light_source { <-10, 4, -6> color Gray40 }
sky_sphere { pigment { gradient y pigment_map { [0 color Gray90] [1 bozo color_map { [0 SkyBlue] [1 White] } scale 0.2 ] } } }
