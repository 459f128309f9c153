#include "colors.inc"
#include "textures.inc"
// z zeigt nach oben: sky und ein negatives right
#declare Groesse=12;
camera { location <2*Groesse, -3*Groesse, 0.9*Groesse> sky z right -x*image_width/image_height look_at <0,0,0.55*Groesse> angle 28 }
light_source { <30,-40,50> White }
light_source { <-50,-30,20> rgb .4 }
background { rgb <.95,.97,1> }
#declare Baum=union {
  cylinder { -z, 2*z, .8 texture { DMFWood1 } }
  #declare Etage=0;
  #while (Etage<4)
    #declare Breit=4.4-Etage;
    #declare Z0=2+Etage*2.4;
    difference {
      cone { <0,0,Z0> Breit <0,0,Z0+3.4> .3 pigment { ForestGreen } }
      #declare Kerbe=0;
      #while (Kerbe<14)
        sphere { <Breit,0,Z0> .5 rotate z*Kerbe*360/14 pigment { DarkGreen } }
        #declare Kerbe=Kerbe+1;
      #end
    }
    #declare Kugel=0;
    #while (Kugel<7)
      sphere { <Breit*.9,0,Z0-.1> .32 rotate z*(Kugel*360/7+Etage*20) pigment { color (mod(Kugel,2)*Red+mod(Kugel+1,2)*Gold) } finish { diffuse 8 } }
      #declare Kugel=Kugel+1;
    #end
    #declare Etage=Etage+1;
  #end
  cone { 12.5*z .1 13.6*z .5 pigment { Yellow } }
}
object { Baum }
plane { z,-1 pigment { White } }
