// a burning glass over a page: intersection of two balls, prism, ior from declared numbers
#version 3.1;
#include "colors.inc"
#include "textures.inc"
#declare Ior_Crown = 1.51673;
#declare Ior_Diamond = 2.4;
#declare Lens = intersection {
  sphere { <0, 0, -2.6>, 3 } sphere { <0, 0, 2.6>, 3 }
  texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 phong 0.3 reflection 0.04 } }
  interior { ior Ior_Crown caustics 0.8 }
}
object { Lens rotate 70*x translate <-1.2, 1.7, -1> }
torus { 1.47, 0.08 rotate -20*x translate <-1.2, 1.7, -1> texture { Brass_Metal } }
cylinder { <-2.6, 1.4, -1.8>, <-4, 0.8, -3>, 0.12 texture { Cherry_Wood } }
prism { linear_spline 0, 2.4, 4, <0, 0>, <1.2, 0>, <0.6, 1.04>, <0, 0> rotate -15*y translate <1.2, 0, -0.8>
  texture { pigment { rgbf <0.95, 1, 1, 0.9> } finish { diffuse 0.05 ambient 0 reflection 0.1 } } interior { ior Ior_Crown } }
sphere { <3.1, 0.5, -1.5>, 0.5 texture { pigment { rgbf <1, 0.9, 0.9, 0.95> } finish { diffuse 0 reflection 0.15 } } interior { ior Ior_Diamond fade_distance 1 fade_power 1 } }
plane { y, 0 pigment { checker White Gray50 scale 0.5 } }
text { ttf "timrom.ttf", "refraction", 0.02, 0 pigment { Black } rotate 90*x translate <-3.3, 0.02, 0.1> }
camera { location <0, 5, -8> look_at <-0.2, 0.6, -0.5> angle 44 }
light_source { <-6, 10, -6> White }
