//Created by a script
//  ******************************************************
#declare Width = 160;
#declare Height = 120;
#declare showAtoms = true;
#declare showBonds = true;
#declare noShadows = true;
camera{
  orthographic
  location < 80, 60, 0>
  sky < 0, -1, 0>
  right < -160, 0, 0>
  up < 0, 120, 0 >
  look_at < 80, 60, 1000 >
}
background { color rgb < 1, 1, 1> }
light_source { <80,60,0>, rgb <1,1,1> translate <-80, -90, -400> }
#default { finish {ambient .45 diffuse .84 specular .22 roughness .04 metallic phong 0.9 phong_size 120} }
#macro check_shadow() #if (noShadows) no_shadow #end #end
#macro clip() clipped_by { box {<0,0,0>,<Width,Height,1000>} } #end
#macro a(X,Y,Z,RADIUS,R,G,B,T)
 #if (showAtoms)
 sphere{<X,Y,Z>,RADIUS pigment{rgbt<R,G,B,T>} check_shadow()}
 #end
#end
#macro b(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 #if (showBonds)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 pigment{rgbt<R,G,B,T>} check_shadow()}
 #end
#end
#macro c(X1,Y1,Z1,RADIUS1,X2,Y2,Z2,RADIUS2,R,G,B,T)
 cone{<X1,Y1,Z1>,RADIUS1,<X2,Y2,Z2>,RADIUS2 open pigment{rgbt<R,G,B,T>} clip() check_shadow()}
#end
#macro r(X1,Y1,Z1,X2,Y2,Z2,X3,Y3,Z3,R,G,B,T)
 triangle{<X1,Y1,Z1>,<X2,Y2,Z2>,<X3,Y3,Z3> pigment{rgbt<R,G,B,T>} check_shadow()}
#end
a(51,42,340,14.5,0.56,0.56,0.56,0)
a(92,37,322,14.5,0.56,0.56,0.56,0)
a(113,73,350,13,1.0,0.05,0.05,0)
a(33,76,300,8.5,1,1,1,0)
a(34,17,371,8.5,1,1,1,0)
a(104,14,289,8.5,1,1,1,0.45)
b(51,42,340,4,71.5,39.5,331,4,0.56,0.56,0.56,0)
b(71.5,39.5,331,4,92,37,322,4,0.3,0.56,0.3,0)
b(92,37,322,4,113,73,350,4,1.0,0.05,0.05,0)
b(51,42,340,4,33,76,300,3,1,1,1,0)
b(51,42,340,4,34,17,371,3,1,1,1,0)
c(92,37,322,4,104,14,289,3,0.9,0.9,1,0)
c(150,60,500,6,190,80,500,6,0,0,1,0)
r(10,100,600,150,100,600,80,115,600,1.0,0.8,0.2,0.5)
