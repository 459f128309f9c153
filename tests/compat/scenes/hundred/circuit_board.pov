// a small board; measures in mm, parts as macros without commas between vectors
#version 3.5;
#include "colors.inc"
#include "metals.inc"
#declare long_legs = off; #declare board_thick = 1.5; #declare glow = 1;
#declare tin = texture { pigment { rgb <.8,.82,.85> } finish { F_MetalB ambient .1*glow } }
#macro Leg(px,pz,len) cylinder{<px,0.4,pz><px,(long_legs ? -len : -board_thick-1),pz>.28 texture{tin}} #end
#macro Can(rad,high,word)
union{
	merge{ cylinder{<0,.6,0><0,high-.6,0>rad} torus{rad-.5,.5 translate (high-.6)*y} torus{rad-.5,.5 translate .6*y} cylinder{<0,.2,0><0,high-.1,0>rad-.5}
		pigment{radial color_map{[.15 Gray80][.15 rgb <.12,.12,.35>]} } finish{phong .5 reflection{.02,.1}} }
	intersection{ cylinder{<0,0,0><0,high,0>rad+.02} text{ttf "crystal.ttf" word 3,0 scale <1.6,1.6,1> rotate 90*z translate <1,2,-rad-1>} pigment{White} }
	Leg(-1.5,0,12) Leg(1.5,0,9)
}
#end
#macro Chip(legs,word)
union{
	difference{ box{<-legs*.7,.6,-2.4><legs*.7,3,2.4>} sphere{<-legs*.7,3,0>.8} pigment{rgb .12} finish{specular .3} }
	#local i=0; #while(i<legs) Leg((i+.5)*1.4-legs*.7,2.8,3) Leg((i+.5)*1.4-legs*.7,-2.8,3) #local i=i+1; #end
	text{ttf "cyrvetic.ttf" word .1,0 scale 1.8 rotate 90*x translate <-legs*.5,3.05,-.5> pigment{Gray80}}
}
#end
#macro Resistor() union{ sphere{<-2,1.2,0>1} sphere{<2,1.2,0>1} cylinder{<-2,1.2,0><2,1.2,0>.8} cylinder{<-3.5,1.2,0><3.5,1.2,0>.25 texture{tin}}
	pigment{gradient x color_map{[.3 Tan][.3 Brown][.5 Brown][.5 Tan][.8 Tan][.8 Red]} scale 1.3} } #end
difference{ box{<-20,-board_thick,-13><20,0,13>} cylinder{<17,-5,10><17,5,10>1.5} cylinder{<-17,-5,-10><-17,5,-10>1.5} pigment{rgb <.08,.3,.15>} finish{phong .3} }
object{Can(3,9,"47u") translate <-12,0,5>} object{Can(2.2,7,"1u") rotate 60*y translate <-4,0,8>}
object{Chip(7,"4017") translate <5,0,-3>} object{Chip(4,"386") rotate 90*y translate <-11,0,-5>}
object{Resistor() translate <8,0,6>} object{Resistor() rotate 90*y translate <15,0,2>}
camera{location <-14,24,-30> look_at <0,1,0> angle 52 right x*image_width/image_height}
light_source{<-50,90,-40> White} light_source{<60,30,-60> Gray30 shadowless} background{Gray70}
