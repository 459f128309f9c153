// cells of overlapping balls, case by case with bits
#include "colors.inc"
camera { location <6,7,-12> look_at 0 angle 27 }
light_source { <20,30,-20> White } light_source { <-20,10,-30> Gray50 shadowless }
background { White }
#declare C = array[4] { <1,1,1>*.6, <-1,-1,1>*.6, <-1,1,-1>*.6, <1,-1,-1>*.6 }
#declare Col = array[4] { Red, Yellow, Green, Blue }
#macro Cell(n)
  intersection {
    #local k = 0; #local cc = rgb 0; #local m = 0;
    #while (k < 4)
      #if (mod(div(n,pow(2,k)),2)=1)
        sphere { C[k], 1.25 } #local cc = cc + Col[k]; #local m = m+1;
      #else
        sphere { C[k], 1.25 inverse }
      #end
      #local k = k+1;
    #end
    pigment { color cc/m } finish { phong .4 ambient .2 }
    translate vlength(<1,1,1>)*0
  }
#end
union { Cell(1) Cell(2) Cell(3) Cell(6) Cell(9) Cell(12) Cell(15) clipped_by { plane { <.3,.5,-1>, .5 } } }
