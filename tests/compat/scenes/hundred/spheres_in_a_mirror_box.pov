// mirror walls, recursion of pictures; max_trace_level alone limits it
#include "colors.inc"
global_settings { max_trace_level 7 }
#declare M = finish { reflection 0.75 ambient 0 diffuse 0.15 };
box { <-3,-2,-4> <3,2,4> hollow texture { pigment { SteelBlue } finish { M } } }
#declare i = 0;
#while (i < 5)
  sphere { <-2+i, -1.4+0.3*sin(i*2), 1.5*cos(i)>, 0.5
    texture { pigment { color rgb <i/4, 1-i/4, 0.4> } finish { phong 1 reflection 0.2 } } }
  #declare i = i+1;
#end
torus { 1.1,0.15 rotate 65*x translate <0,0.6,2> pigment { Gold } finish { metallic specular 0.7 roughness 0.01 } }
light_source { <0,1.8,-1> color White }
light_source { <-2.5,1.5,3> color Gray30 }
camera { location <0,0.3,-3.7> look_at <0,-0.2,2> angle 75 }
