// sixteen bit heights, slope decides the texture, sun low
#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Fels = texture { pigment { rgb <.45,.38,.33> } normal { wrinkles .5 scale .05 } };
#declare Gras = texture { pigment { rgb <.25,.42,.12> } };
height_field { png "heights16.png" smooth scale <12,2.2,12> translate <-6,0,-4>
  texture { slope { y } texture_map { [0 Fels] [.6 Fels] [.8 Gras] [1 Gras] } } }
height_field { tga "map24.tga" water_level .1 scale <3,1,3> translate <-1.5,2.4,-2> pigment { image_map { tga "map24.tga" } rotate 90*x scale 3 translate <-1.5,0,-2> } rotate 12*y }
light_source { <-30,12,-10> rgb <1.2,1.05,.8> parallel point_at 0 }
light_source { <0,100,0> rgb .25 shadowless }
fog { distance 35 rgb <.75,.8,.9> fog_type 2 fog_offset .6 fog_alt .8 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9,.8,.7>] [.3 rgb <.4,.55,.85>] } } }
camera { location <0,4.4,-9> look_at <0,1.4,1> angle 55 right x*image_width/image_height }
