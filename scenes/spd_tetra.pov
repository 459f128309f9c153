// "tetra" of the Standard Procedural Databases (E. Haines, data in the public domain): a
// tetrahedron of four of half its size, each of which is one of four ...
//   Declare=Size=6                levels (default 6: 4096 triangles)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 6; #end

#declare Eye = <1.022846, -3.177154, -2.174512>;
#declare Goal = <-0.004103, -0.004103, 0.216539>;
#declare Sky = <-0.816497, -0.816497, 0.816497>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

light_source { <2, -18, -5> rgb 1 }

// Every second corner of a cube about the middle.
#declare Corners = array[4] { <-1, -1, 1>, <-1, 1, -1>, <1, -1, -1>, <1, 1, 1> };

#macro Tetra(Depth, Middle, Half)
  #if (Depth <= 1)
    #for (Face, 0, 3)
      triangle {
        Middle + Half*Corners[Face], Middle + Half*Corners[mod(Face + 1, 4)],
        Middle + Half*Corners[mod(Face + 2, 4)]
      }
    #end
  #else
    #for (I, 0, 3)
      Tetra(Depth - 1, Middle + Half/2*Corners[I], Half/2)
    #end
  #end
#end

union {
  Tetra(Size, <0, 0, 0>, 1)
  pigment { rgb <1, 0.2, 0.2> }
  finish { ambient 0 diffuse 1 }
}
