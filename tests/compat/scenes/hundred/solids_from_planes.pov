// polyhedra as intersections of planes, normals in arrays that macros make
#version 3.5;
#include "colors.inc"
#declare phi = (1+sqrt(5))/2;
#declare Dod = array[6] { <0,1,phi>, <0,-1,phi>, <1,phi,0>, <-1,phi,0>, <phi,0,1>, <phi,0,-1> };
#macro Solid(Dirs, dist)
  intersection {
    #local n = 0;
    #while (n < dimension_size(Dirs,1))
      plane { Dirs[n], dist } plane { -Dirs[n], dist }
      #local n = n+1;
    #end
  }
#end
#declare Oct = array[4] { <1,1,1>, <-1,1,1>, <1,-1,1>, <1,1,-1> }
#declare Rho = array[6] { <1,1,0>, <1,-1,0>, <1,0,1>, <1,0,-1>, <0,1,1>, <0,1,-1> }
#declare D = Solid(Dod, 1)
object { D pigment { Red } finish { reflection .1 phong .5 } rotate <10,20,0> translate <-2.4,1,0> }
object { Solid(Oct, .8) pigment { Yellow } rotate 15*y translate <0,.9,-.8> }
object { Solid(Rho, .9) pigment { SkyBlue } rotate <0,40,10> translate <2.4,1,0> }
difference { object { D } sphere { 0, 1.15 } pigment { Gold } finish { metallic } translate <0,1.1,2.6> }
plane { y,0 pigment { hexagon Gray90 Gray70 Gray50 scale .5 } }
camera { location <0,4,-8> look_at <0,.9,0.3> angle 45 }
light_source { <-6,10,-8> White }
