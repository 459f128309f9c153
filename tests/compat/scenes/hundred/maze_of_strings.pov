// a labyrinth drawn by strings; a walker finds its way by trace() and turns at walls
#include "colors.inc"
#declare Plan = array[8] { "XXXXXXXXXX", "X   X    X", "X X X XX X", "X X   X  X", "X XXXXX XX", "X     X  X", "XXX X   XX", "XXXXXXXXXX" };
#declare Far_Off = function(ax,az,bx,bz) { sqrt(pow(ax-bx,2)+pow(az-bz,2)) }
#declare Hedge = union {
  #declare Row = 0;
  #while (Row < dimension_size(Plan,1))
    #declare Col = 0;
    #while (Col < strlen(Plan[Row]))
      #if (asc(substr(Plan[Row],Col+1,1)) = 88) box { <Col,0,-Row>, <Col+1,.7,-Row-1> } #end
      #declare Col = Col+1;
    #end
    #declare Row = Row+1;
  #end
};
object { Hedge pigment { bozo color_map { [0 ForestGreen] [1 LimeGreen] } scale .1 } normal { bumps .6 scale .08 } }
#declare Here = <1.5,.25,-1.5>; #declare Heading = 90; #declare Moves = 0;
#while (Moves < 30)
  #declare Fwd = vrotate(x, Heading*y); #declare Wall = <0,0,0>;
  #declare Stop = trace(Hedge, Here, Fwd, Wall);
  #if (vlength(Wall) > 0 & vlength(Stop-Here) < .75)
    #declare Heading = Heading-90;
    sphere { Stop, .08 pigment { Red } }
  #else
    #declare Here = Here+Fwd;
    cone { Here-.2*Fwd, .16, Here+.25*Fwd, 0 pigment { rgb <1-Moves/30, Moves/30, 1> } }
  #end
  #declare Moves = Moves+1;
#end
#if (Far_Off(Here.x,Here.z,1.5,-1.5) > 1) torus { .3,.06 translate Here pigment { Yellow } } #end
#warning concat("the walker stands at ", vstr(3, Here, ", ", 0, 1), "\n")
plane { y,0 pigment { Tan } }
camera { location <5,10.5,-10> look_at <5,0,-4.2> angle 48 }
light_source { <-6,15,-9> rgb 1 }
