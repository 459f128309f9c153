#include "colors.inc"
camera { location <0,2,-9> look_at <0,-.4,0> angle 42 }
light_source { <-8,10,-10> White }
light_source { <6,2,-8> Gray40 shadowless }
background { SkyBlue }
#declare W = 4*pi;
mesh {
  #declare du = W/48; #declare dv = 2*pi/16;
  #macro PT(uu,vv) #local e = exp(uu/6/pi); <2*(1-e)*cos(uu)*cos(vv/2)*cos(vv/2), 1-exp(uu/3/pi)-sin(vv)+e*sin(vv), 2*(-1+e)*sin(uu)*cos(vv/2)*cos(vv/2)> #end
  #declare uu = 0; #while (uu < W-du/2) #declare vv = 0; #while (vv < 2*pi-dv/2)
    triangle { PT(uu,vv), PT(uu+du,vv), PT(uu+du,vv+dv) }
    triangle { PT(uu,vv), PT(uu+du,vv+dv), PT(uu,vv+dv) }
  #declare vv = vv+dv; #end #declare uu = uu+du; #end
  pigment { gradient y triangle_wave color_map { [0 Wheat] [.6 Tan] [1 Firebrick] } scale .35 }
  finish { specular .3 } translate <0,1.2,0> scale .55 rotate <0,20,0>
}
parametric {
  function { cos(u)*(1.2+.4*cos(v)) } function { .4*sin(v)+.25*sin(2*u) } function { sin(u)*(1.2+.4*cos(v)) }
  <0,0>, <2*pi,2*pi> contained_by { box { -2, 2 } } precompute 8 x,y,z accuracy .002
  pigment { YellowGreen } scale .8 rotate -30*x translate <2.5,1.2,1>
}
