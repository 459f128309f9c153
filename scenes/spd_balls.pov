// "balls" of the Standard Procedural Databases (E. Haines, data in the public domain): a ball
// that bears nine of a third of its size, each of which bears nine ...
//   Declare=Size=4                levels (default 4: 7381 spheres)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 4; #end

#declare Eye = <2.1, 1.3, 1.7>;
#declare Goal = <0, 0, 0>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

#declare Light = rgb 1/sqrt(3);
light_source { <4, 3, 2> Light }
light_source { <1, -4, 4> Light }
light_source { <-3, 1, 5> Light }

polygon {
  5, <-12, -12, -0.5>, <12, -12, -0.5>, <12, 12, -0.5>, <-12, 12, -0.5>, <-12, -12, -0.5>
  pigment { rgb <1, 0.75, 0.33> }
  finish { ambient 0.2 diffuse 0.8 }
}

#declare Ball_Texture = texture {
  pigment { rgb <1, 0.9, 0.7> }
  finish { ambient 0 diffuse 0.5 reflection 0.5 phong 0.5 phong_size 3.0827 }
}

// Directions of a ball's nine: three turned out of their plane, and those at 120 and 240 degrees.
#declare Turn_Axis = <1, -1, 0>;
#declare Turn = degrees(asin(2/sqrt(6)));
#declare Three = array[3] { vnormalize(<1, 1, 0>), vnormalize(<1, 0, -1>), vnormalize(<0, 1, -1>) };
#declare Nine = array[9];
#for (I, 0, 2)
  #local Turned = vaxis_rotate(Three[I], Turn_Axis, Turn);
  #for (K, 0, 2)
    #declare Nine[I + 3*K] = vaxis_rotate(Turned, z, 120*K);
  #end
#end

// A ball whose own z points along Out, and what it bears.
#macro Ball(Depth, Centre, Radius, Out)
  sphere { Centre, Radius }
  #if (Depth > 0)
    #for (I, 0, 8)
      // Turned as z must turn to come to Out.
      #local Axis = vcross(z, Out);
      #local Way = Nine[I];
      #if (vlength(Axis) > 1e-9)
        #local Way = vaxis_rotate(Way, Axis, degrees(acos(max(-1, min(1, Out.z)))));
      #elseif (Out.z < 0)
        #local Way = vaxis_rotate(Way, x, 180);
      #end
      Ball(Depth - 1, Centre + Way*(Radius + Radius/3), Radius/3, Way)
    #end
  #end
#end

union {
  Ball(Size, Goal, 0.5, z)
  texture { Ball_Texture }
}
