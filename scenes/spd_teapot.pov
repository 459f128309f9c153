// "teapot" of the Standard Procedural Databases (E. Haines, data in the public domain): M. Newell's
// teapot of 1975 as smooth triangles over a board of as many squares as a patch has.
//   Declare=Size=6                squares along an edge of a patch (default 6: 2256 triangles)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 6; #end

#declare Eye = <4.86, 7.2, 5.4>;
#declare Goal = <0, 0, 0>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

#declare Light = rgb 1/sqrt(2);
light_source { <-3.1, 9.8, 12.1> Light }
light_source { <11.3, 5.1, 8.8> Light }

#macro Square(I, K)
  #local A = <8*I/Size - 4, 8*K/Size - 4, 0>;
  #local S = 8/Size;
  polygon { 5, A, A + S*x, A + S*(x + y), A + S*y, A }
#end
#for (Odd, 0, 1)
  union {
    #for (I, 0, Size - 1)
      #for (K, 0, Size - 1)
        #if (mod(I + K, 2) = Odd) Square(I, K) #end
      #end
    #end
    pigment { rgb 0.5 + 0.5*Odd }
    finish { ambient 0 diffuse 0.5 phong 0.5 phong_size 30 reflection 0.5 }
  }
#end

// Bernstein polynomials of degree 3 and their derivatives: the weights of four points.
#macro Weights(T) array[4] { pow(1-T, 3), 3*T*pow(1-T, 2), 3*T*T*(1-T), T*T*T } #end
#macro Slopes(T) array[4] { -3*pow(1-T, 2), 3*(1-T)*(1-3*T), 3*T*(2-3*T), 3*T*T } #end

#macro Mixed(Net, A, B)
  #local Sum = <0, 0, 0>;
  #for (R, 0, 3)
    #for (C, 0, 3) #local Sum = Sum + A[R]*B[C]*Net[R][C]; #end
  #end
  Sum
#end

#macro On_Axis(P) (abs(P.x) < 1e-4 & abs(P.y) < 1e-4) #end

// Two triangles for each square of a patch; those with an edge of no length are left out. On the
// axis the patches have no normal: there it points up or down.
#macro Patch(Net)
  #local Points = array[Size + 1][Size + 1];
  #local Normals = array[Size + 1][Size + 1];
  #for (I, 0, Size)
    #for (K, 0, Size)
      #local S = Weights(I/Size)
      #local T = Weights(K/Size)
      #local DS = Slopes(I/Size)
      #local DT = Slopes(K/Size)
      #local P = Mixed(Net, S, T);
      #local N = vcross(Mixed(Net, S, DT), Mixed(Net, DS, T));
      #if (On_Axis(P)) #local N = (P.z > 1.5 ? z : -z); #end
      #local Points[I][K] = P;
      #local Normals[I][K] = vnormalize(N);
    #end
  #end
  #macro Corner(I, K) Points[I][K], Normals[I][K] #end
  #macro Half(I1, K1, I2, K2, I3, K3)
    #if (On_Axis(Points[I1][K1]) + On_Axis(Points[I2][K2]) + On_Axis(Points[I3][K3]) < 2)
      smooth_triangle { Corner(I1, K1), Corner(I2, K2), Corner(I3, K3) }
    #end
  #end
  #for (I, 0, Size - 1)
    #for (K, 0, Size - 1)
      Half(I, K, I, K + 1, I + 1, K + 1)
      Half(I + 1, K + 1, I + 1, K, I, K)
    #end
  #end
#end

// A quarter turn of a profile of four rings <radius, height>, four times. Round[R] is how far the
// inner points of a ring's quarter stand out, as a part of its radius.
#macro Turned(Rings, Round)
  #for (Q, 0, 3)
    #local Net = array[4][4];
    #for (R, 0, 3)
      #local A = Rings[R].u;
      #local H = Rings[R].v;
      #local Net[R][0] = vrotate(<A, 0, H>, -90*Q*z);
      #local Net[R][1] = vrotate(<A, -A*Round[R], H>, -90*Q*z);
      #local Net[R][2] = vrotate(<A*Round[R], -A, H>, -90*Q*z);
      #local Net[R][3] = vrotate(<0, -A, H>, -90*Q*z);
    #end
    Patch(Net)
  #end
#end

// A bow between two curves in the plane y = 0, points <x, z>, Wide[R] to either side.
#macro Bow(Inner, Outer, Wide)
  #for (Side, -1, 1, 2)
    #local Net = array[4][4];
    #for (R, 0, 3)
      // The second half goes on where the first one ends, around the bow.
      #local A = (Side < 0 ? Inner[R] : Outer[R]);
      #local B = (Side < 0 ? Outer[R] : Inner[R]);
      #local Net[R][0] = <A.u, 0, A.v>;
      #local Net[R][1] = <A.u, Side*Wide[R], A.v>;
      #local Net[R][2] = <B.u, Side*Wide[R], B.v>;
      #local Net[R][3] = <B.u, 0, B.v>;
    #end
    Patch(Net)
  #end
#end

#declare Usual = array[4] { 0.56, 0.56, 0.56, 0.56 };

union {
  // rim, body, lid, bottom
  Turned(array[4] { <1.4, 2.4>, <1.3375, 2.53125>, <1.4375, 2.53125>, <1.5, 2.4> }, Usual)
  Turned(array[4] { <1.5, 2.4>, <1.75, 1.875>, <2, 1.35>, <2, 0.9> }, Usual)
  Turned(array[4] { <2, 0.9>, <2, 0.45>, <1.5, 0.225>, <1.5, 0.15> }, Usual)
  Turned(array[4] { <0, 3.15>, <0.8, 3.15>, <0, 2.85>, <0.2, 2.7> },
         array[4] { 0.56, 0.5625, 0.56, 0.56 })
  Turned(array[4] { <0.2, 2.7>, <0.4, 2.55>, <1.3, 2.55>, <1.3, 2.4> }, Usual)
  Turned(array[4] { <0, 0>, <1.425, 0>, <1.5, 0.075>, <1.5, 0.15> }, Usual)
  // handle, spout
  Bow(array[4] { <-1.6, 2.025>, <-2.3, 2.025>, <-2.7, 2.025>, <-2.7, 1.8> },
      array[4] { <-1.5, 2.25>, <-2.5, 2.25>, <-3, 2.25>, <-3, 1.8> },
      array[4] { 0.3, 0.3, 0.3, 0.3 })
  Bow(array[4] { <-2.7, 1.8>, <-2.7, 1.575>, <-2.5, 1.125>, <-2, 0.9> },
      array[4] { <-3, 1.8>, <-3, 1.35>, <-2.65, 0.9375>, <-1.9, 0.6> },
      array[4] { 0.3, 0.3, 0.3, 0.3 })
  Bow(array[4] { <1.7, 1.425>, <2.6, 1.425>, <2.3, 2.1>, <2.7, 2.4> },
      array[4] { <1.7, 0.6>, <3.1, 0.825>, <2.4, 2.025>, <3.3, 2.4> },
      array[4] { 0.66, 0.66, 0.25, 0.25 })
  Bow(array[4] { <2.7, 2.4>, <2.8, 2.475>, <2.9, 2.475>, <2.8, 2.4> },
      array[4] { <3.3, 2.4>, <3.525, 2.49375>, <3.45, 2.5125>, <3.2, 2.4> },
      array[4] { 0.25, 0.25, 0.15, 0.15 })
  pigment { rgb <1, 0.5, 0.1> }
  finish { ambient 0 diffuse 0.75 phong 0.25 phong_size 37 reflection 0.25 }
}
