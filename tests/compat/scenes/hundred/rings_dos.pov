#include "colors.inc"  
#include "textures.inc"
#include "stones.inc"
#version 3.1

global_settings { ambient_light rgb <.9, .8, 1.5> }

light_source { <0, 3, 0> colour White }
light_source { <-8, 2, -9> colour Gray40 }

#declare Crust =
   texture
      {
      pigment  {color SteelBlue}
      finish   {ambient .2 diffuse 0.7 phong .5}
      }
   texture
      {
      pigment  {granite color_map {[0 .4 color Clear color Clear] [.4 .7 color Clear color Gold] [.7 1 color Gold color Clear]}}
      scale <.6, .4, .6>
      }

camera
   {
   location  <0, 5, -8>
   direction <0, 0, 1.4>
   up        <0, 1, 0>
   right     <4/3, 0, 0>
   look_at   <0, 1, 0>
   }

#declare Floor=0
#while (Floor < 4)
   #declare Ang=0
   #while (Ang < 360)
      object
         {
         sphere {<2.6 - Floor*.55, 0, 0> .3}
         texture {Crust rotate <Ang, 0, Floor*30>}
         translate <0, Floor*.9, 0>
         rotate <0, Ang + Floor*12, 0>
         }
      #declare Ang = Ang + 360/(12-Floor*2)
   #end
   #declare Floor = Floor + 1
#end
plane { y, -.4 pigment { color DarkSlateGray } }
