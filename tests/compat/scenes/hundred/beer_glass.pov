#version 3.7;
#include "colors.inc"
#include "textures.inc"
#include "functions.inc"
global_settings{ assumed_gamma 1.0 max_trace_level 12 }
camera{ location<0,6,-15> look_at<0,3.2,0> angle 40 }
light_source{ <-20,25,-15> color White }
light_source{ <15,10,-20> color White*0.4 }
#declare Glass_Mat = material{ texture{ pigment{ rgbf<0.98,0.98,0.98,0.95> } finish{ specular 0.8 roughness 0.002 reflection{0.02,0.2} diffuse 0.1 ambient 0 } } interior{ ior 1.5 } }
#declare Beer_Mat = material{ texture{ pigment{ rgbf<1,0.75,0.2,0.9> } finish{ diffuse 0.2 ambient 0.05 } } interior{ ior 1.33 fade_distance 2 fade_power 2 fade_color<0.9,0.6,0.1> } }
difference{
  cone{ <0,0,0>,1.5,<0,6,0>,2.1 }
  cone{ <0,0.4,0>,1.3,<0,6.1,0>,1.95 }
  material{ Glass_Mat }
}
cone{ <0,0.401,0>,1.299,<0,4.8,0>,1.799 material{ Beer_Mat } }
isosurface{
  function{ x*x + z*z - 3.35 + 2*f_noise3d(x*3,y*3,z*3)*(y-4.7) }
  contained_by{ box{ <-2.1,4.81,-2.1>,<2.1,5.9,2.1> } }
  max_gradient 14 accuracy 0.002
  pigment{ White } finish{ ambient 0.3 diffuse 0.7 }
}
difference{
  torus{ 1.4,0.25 rotate 90*x scale<1,1.2,1> translate<2.3,3,0> }
  cone{ <0,0,0>,1.6,<0,6,0>,2.15 }
  material{ Glass_Mat }
}
box{ <-8,-0.5,-6>,<8,-0.001,6> texture{ DMFWood4 rotate 90*y scale 3 } }
sky_sphere{ pigment{ gradient y color_map{ [0 Gray70] [0.5 Gray40] } } }
