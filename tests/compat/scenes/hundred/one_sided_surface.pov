// Kleinsche Flasche als Schlauch aus Kugeln, die Farbe folgt dem Weg
#include "colors.inc"
#include "math.inc"
camera { location <2,5,-9> look_at <0,1,0> angle 42 }
light_source { <12,30,-18> White }
light_source { <-20,10,-20> Gray40 shadowless }
plane { y, -2.6 pigment { checker YellowGreen ForestGreen } }
#declare Schritte = 46; #declare Ring = 18;
#declare a = 0;
#while (a < Schritte)
  #declare W = 360*a/Schritte;
  #declare b = 0;
  #while (b < Ring)
    #declare R = 360*b/Ring;
    // figure-eight section, half a turn a round
    #declare Q = vrotate(<1.1*sind(R), .8*sind(2*R), 0>, z*W/2);
    sphere { vrotate(Q+2.4*x, y*W)+y, .16
      texture { pigment { rgb <a/Schritte, .3, 1-a/Schritte> } finish { phong .7 phong_size 30 } } }
    #declare b = b+1;
  #end
  #declare a = a+1;
#end
