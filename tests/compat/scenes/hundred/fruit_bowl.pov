#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "colors.inc"
#include "transforms.inc"
camera { location <0, 5, -9> look_at <0, 1, 0> angle 45 right x*image_width/image_height }
light_source { <-8, 10, -5> color rgb <1, 0.95, 0.85> }
light_source { <5, 6, -10> color rgb 0.3 shadowless }
#macro Stem(h)
  sphere_sweep { b_spline 6, <0, -0.2, 0>, 0.06, <0, 0, 0>, 0.05, <0.02, h*0.4, 0>, 0.04, <0.1, h*0.8, 0.05>, 0.04, <0.2, h, 0.1>, 0.06, <0.3, h*1.2, 0.1>, 0.06
    pigment { rgb <0.25, 0.15, 0.05> } }
#end
#declare Apple = union {
  lathe { bezier_spline 8, <0, -0.75>, <0.3, -0.95>, <0.9, -0.8>, <1, 0>, <1, 0>, <1.1, 0.75>, <0.3, 1.1>, <0, 0.6>
    pigment { gradient y color_map { [0 rgb <0.75, 0.6, 0.1>] [0.4 rgb <0.8, 0.1, 0.05>] [1 rgb <0.6, 0.02, 0.02>] } translate -0.5*y scale 2 turbulence 0.2 }
    finish { specular 0.6 roughness 0.02 } }
  object { Stem(0.6) translate 0.6*y }
}
#declare Pear = blob { threshold 0.5
  sphere { <0, 0, 0>, 1.5, 1 } sphere { <0, 1.0, 0>, 1.0, 0.8 } cylinder { <0, 0, 0>, <0, 1, 0>, 0.6, 0.4 }
  pigment { bozo color_map { [0 rgb <0.6, 0.7, 0.1>] [1 rgb <0.8, 0.75, 0.15>] } scale 0.3 } finish { phong 0.4 } }
#declare Orange_Fruit = sphere { 0, 0.9 pigment { rgb <0.95, 0.45, 0.02> } normal { dents 0.6 scale 0.08 } finish { specular 0.3 roughness 0.05 } }
#declare Banana = union { #for (i, -8, 8) sphere { vrotate(<3, 0, 0>, i*4*z), 0.38 - 0.003*i*i } #end pigment { rgb <0.9, 0.75, 0.1> } }
#declare Bowl = difference { sphere { 0, 3 } sphere { 0, 2.85 } plane { -y, 1 } clipped_by { plane { y, -0.7 } } pigment { rgb <0.3, 0.4, 0.6> } finish { specular 0.5 reflection 0.05 } }
object { Bowl scale <1.1, 0.9, 1.1> translate 2.6*y }
object { Apple translate <-1.1, 1.6, -0.3> }
object { Orange_Fruit translate <0.9, 1.5, -0.6> }
object { Pear scale 0.9 rotate -60*z rotate 30*y translate <0.2, 1.6, 1> }
object { Banana rotate -90*x Axis_Rotate_Trans(<1, 1, 0>, 20) translate <-2.5, 2.3, 0.2> }
object { Apple scale 0.9 rotate 20*x translate <3.7, 0.75, -1.5> }
plane { y, 0 pigment { rgb <0.4, 0.25, 0.15> } finish { reflection 0.06 } }
