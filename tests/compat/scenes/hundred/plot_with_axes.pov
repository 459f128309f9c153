// a function of two variables with axes, ticks and labels
#include "colors.inc"
#include "math.inc"
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6,-8,6> sky z right -9.5*x up 7.1*z look_at <0.2,0.2,0.2> }
light_source { <3,-10,14> rgb 1 }
light_source { <10,2,6> rgb .4 shadowless }
background { White }
#declare f = function(x,y) { 1.6*sin(x*x + y*y)/(1 + x*x + y*y) }
#declare n = 22; #declare lim = 3;
#macro Pt(i,j)
  #local a = -lim + 2*lim*i/n; #local b = -lim + 2*lim*j/n;
  <a, b, f(a,b)>
#end
#macro Col(h) rgb <clip(0.5+h,0,1), 1-abs(h), clip(0.5-h,0,1)> #end
mesh {
#for (i,0,n-1) #for (j,0,n-1)
  #local A=Pt(i,j); #local B=Pt(i+1,j); #local C=Pt(i+1,j+1); #local D=Pt(i,j+1);
  #local T1 = texture { pigment { Col((A.z+B.z+C.z)/3) } finish { ambient .25 diffuse .7 } }
  triangle { A B C texture { T1 } }
  #local T1 = texture { pigment { Col((A.z+C.z+D.z)/3) } finish { ambient .25 diffuse .7 } }
  triangle { A C D texture { T1 } }
#end #end
}
#macro Axis(dir,len,lab)
  cylinder { 0, dir*len, 0.03 pigment { Black } }
  cone { dir*len, 0.1, dir*(len+0.3), 0 pigment { Black } }
  text { ttf "timrom.ttf", lab, 0.01, 0 pigment { Black } scale 0.5 rotate 90*x rotate 37*z translate dir*(len+0.45) }
  #for (tick,1,len) sphere { dir*tick, 0.06 pigment { Red } }
    text { ttf "cyrvetic.ttf", str(tick,0,1), 0.01, 0 pigment { Gray30 } scale 0.3 rotate 90*x rotate 37*z translate dir*tick - 0.4*z }
  #end
#end
union { Axis(x,6,"x") Axis(y,6,"y") Axis(z,2,"f(x,y)") translate <-3,-3,-0.7> }
