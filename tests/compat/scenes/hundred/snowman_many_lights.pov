#include "colors.inc"
#include "textures.inc"
// SNOWMAN
background{MidnightBlue}
camera{location<0,2.5,-9>look_at<0,2,0>}
light_source{<10,10,-10>White}
light_source{<-3,5,-3>color rgb<1,0,0>spotlight radius 12 falloff 18 tightness 5 point_at<-1,0,0>}
light_source{<3,5,-3>color rgb<0,0,1>spotlight radius 12 falloff 18 point_at<1.2,0,-1>}
light_source{<0,6,2>color rgb<0,1,0>spotlight radius 5 falloff 30 tightness 20 point_at<0,0,2.5>}
#declare Snow=texture{pigment{White}normal{granite .15 scale .4}finish{ambient .2}}
union{
sphere{<0,1,0>,1.2}sphere{<0,2.5,0>,.9}sphere{<0,3.7,0>,.6}
texture{Snow}
}
cone{<0,3.7,-.55>,.12,<0,3.65,-1.3>,0 pigment{Orange}}
sphere{<-.2,3.9,-.55>,.08 pigment{Black}finish{phong 1}}
sphere{<.2,3.9,-.55>,.08 pigment{Black}finish{phong 1}}
#declare n=0;
#while(n<3)
sphere{<0,2.9-n*.35,-.85+abs(n-1)*.08>,.09 pigment{Black}}
#declare n=n+1;
#end
cylinder{<.7,2.7,0>,<1.9,3.4,-.3>,.06 pigment{DarkBrown}}
cylinder{<-.7,2.7,0>,<-1.9,2.3,-.6>,.06 pigment{DarkBrown}}
cylinder{<0,4.15,0>,<0,4.2,0>,.75 pigment{Gray20}}
cylinder{<0,4.2,0>,<0,5,0>,.45 pigment{Gray20}}
torus{.46,.06 translate 4.3*y pigment{Red}}
torus{.62,.15 translate<0,3.15,0> pigment{gradient x color_map{[.5 Red][.5 Green]}scale .3}}
plane{y,0 texture{Snow scale 2}}
