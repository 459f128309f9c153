// "rings" of the Standard Procedural Databases (E. Haines, data in the public domain): a pyramid of
// dodecahedra, each of six rings of five rods that join the middles of its edges, before a wall.
//   Declare=Size=7                layers of the pyramid (default 7: 4200 rods and 4200 balls)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 7; #end

#declare Spread = 1/sin(pi/8);
#declare Eye = <-1, -Spread, 0.5>;
// The published goal is a point between the eye and the pyramid, where a sheet would be too small:
// it stands in the last layer instead.
#ifdef (Lenticular_Camera)
  #declare Goal = Eye + Spread*(Size + 1)*y;
#else
  #declare Goal = Eye + y;
#end
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

#declare Light = rgb 1/sqrt(3);
light_source { <3, -Spread, 3> Light }
light_source { <-4, -Spread, 1> Light }
light_source { <2, -Spread, -4> Light }

// The wall fills the view, and one part in a hundred more.
#declare Wall_Y = Spread*(Size + 1);
#declare Half = 1.01*(Wall_Y - Eye.y)*tan(pi/8);
polygon {
  5, <Eye.x + Half, Wall_Y, Eye.z + Half>, <Eye.x - Half, Wall_Y, Eye.z + Half>,
  <Eye.x - Half, Wall_Y, Eye.z - Half>, <Eye.x + Half, Wall_Y, Eye.z - Half>,
  <Eye.x + Half, Wall_Y, Eye.z + Half>
  pigment { rgb 1 }
  finish { ambient 0 diffuse 1 }
}

#declare Thick = 0.07412;
#declare Colours = array[6] {
  rgb x, rgb y, rgb z, rgb <0, 1, 1>, rgb <1, 0, 1>, rgb <1, 1, 0>
};
#declare Between_Faces = degrees(2*acos(cos(pi/3)/sin(pi/5)));

// Corner K of ring R about the origin: the first lies flat, the others lean on it all around.
#macro Corner(R, K)
  #local Flat = vrotate(x/(1 + Thick), 72*K*z);
  #if (R = 0) Flat #else vrotate(vrotate(Flat, Between_Faces*x), (72*(R - 1) + 36)*z) #end
#end

#macro Ring(R)
  union {
    #for (K, 0, 4)
      cylinder { Corner(R, K), Corner(R, mod(K + 4, 5)), Thick open }
      sphere { Corner(R, K), Thick }
    #end
    pigment { Colours[R] }
    finish { ambient 0 diffuse 0.5 phong 0.3 phong_size 37 reflection 0.2 }
  }
#end

#declare Rings = union { #for (R, 0, 5) Ring(R) #end }

#for (Layer, 0, Size - 1)
  #for (IZ, 0, Layer)
    #for (IX, 0, Layer)
      object { Rings translate <2*IX - Layer, Spread*(Layer + 1), 2*IZ - Layer> }
    #end
  #end
#end
