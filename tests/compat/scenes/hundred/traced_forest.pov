// des arbres posent leur pied sur un terrain, trouve par trace
#include "colors.inc"
camera { location <-20, 26, -90> look_at <0, 4, 0> angle 42 }
light_source { <-80, 120, -60> White }
background { LightBlue }
#declare terrain = height_field {
  function 48, 48 { .4 + .3*sin(9*x+1)*sin(6*y) + .1*cos(20*x*y) }
  smooth translate <-.5, -.2, -.5> scale <140, 14, 140>
  pigment { gradient y color_map { [.1 Khaki] [.5 YellowGreen] } scale 12 }
};
object { terrain }
#declare arbre = union {
  cylinder { -.1*y, .3*y, .06 pigment { DarkBrown } }
  sphere { .55*y, .3 scale <.8,1,.8> pigment { HuntersGreen } normal { bumps .8 scale .08 } }
};
#declare gx = -5;
#while (gx <= 5)
  #declare gz = -5;
  #while (gz <= 5)
    #declare pente = <0,0,0>;
    #declare pied = trace(terrain, <gx*11+3*sin(gz*2), 60, gz*11+3*cos(gx*3)>, -y, pente);
    #if (vlength(pente) > 0)
      #if (pente.y > .8) object { arbre scale 9+mod(gx*gz,3) translate pied }
      #else box { -1,1 rotate 45*gz*y translate pied pigment { Gray50 } } #end
    #end
    #declare gz = gz+1;
  #end
  #declare gx = gx+1;
#end
