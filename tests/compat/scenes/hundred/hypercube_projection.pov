//a tesseract turned in two planes and seen in perspective from the fourth axis
#include "colors.inc"
#include "golds.inc"
camera { sky z direction -x right -4/3*x location <7,12,9> look_at 0 angle 17 }
global_settings { ambient_light White*1.2 }
light_source { <8,16,25> White*1.5 }
background { White }
#declare Corner = array[16];
#declare Alpha = .5+clock; #declare Beta = .8;
#declare N = 0;
#while (N < 16)
  #declare A = 2*mod(N,2)-1;
  #declare B = 2*mod(div(N,2),2)-1;
  #declare C = 2*mod(div(N,4),2)-1;
  #declare D = 2*div(N,8)-1;
  #declare A2 = A*cos(Alpha)-D*sin(Alpha); #declare D2 = A*sin(Alpha)+D*cos(Alpha);
  #declare B2 = B*cos(Beta)-C*sin(Beta); #declare C2 = B*sin(Beta)+C*cos(Beta);
  #declare Corner[N] = <A2,B2,C2>*3/(4-D2);
  sphere { Corner[N], .14 texture { T_Gold_3B } }
  #declare N = N+1;
#end
#macro Bit(K,P) mod(div(K,pow(2,P)),2) #end
#declare N = 0;
#while (N < 16)
  #declare P = 0;
  #while (P < 4)
    #if (Bit(N,P) = 0) cylinder { Corner[N], Corner[N+pow(2,P)], .06 texture { T_Gold_1C } } #end
    #declare P = P+1;
  #end
  #declare N = N+1;
#end
