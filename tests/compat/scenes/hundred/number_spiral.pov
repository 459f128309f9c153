#version 3.7;
global_settings { assumed_gamma 1.0 }
background { rgb .05 }
camera { location <0,14,-14> look_at <0,0,-.5> angle 45 }
light_source { <-12,20,-8> rgb 1 }
#macro IsPrime(N)
  #local R = (N > 1);
  #local D = 2;
  #while (D*D <= N & R)
    #if (mod(N,D) = 0) #local R = false; #end
    #local D = D+1;
  #end
  R
#end
#declare X = 0; #declare Z = 0; #declare DX = 1; #declare DZ = 0; #declare Run = 1; #declare Left = 1; #declare Turns = 0;
#for (N, 1, 225)
  #if (IsPrime(N))
    cylinder { <X,0,Z>, <X,.4+N/90,Z>, .35 pigment { rgb <N/225,.6,1-N/225> } finish { specular .4 } }
  #else
    sphere { <X,0,Z>, .18 pigment { rgb .5 } }
  #end
  #declare X = X+DX; #declare Z = Z+DZ; #declare Left = Left-1;
  #if (Left = 0)
    #declare T = DX; #declare DX = -DZ; #declare DZ = T;
    #declare Turns = Turns+1;
    #if (mod(Turns,2) = 0) #declare Run = Run+1; #end
    #declare Left = Run;
  #end
#end
plane { y,-.2 pigment { rgb <.1,.1,.2> } finish { reflection .2 } }
