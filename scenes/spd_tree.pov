// "tree" of the Standard Procedural Databases (E. Haines, data in the public domain), grown by the
// rules of M. Aono and T. L. Kunii, "Botanical Tree Image Generation", 1984: each branch, a cone
// with a ball at its end, bears two. Seven lights.
//   Declare=Size=11               levels (default 11: 4095 cones and 4095 balls)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 11; #end

#declare Eye = <4.5, 0.4, 2>;
#declare Goal = <0, 0, 1.5>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

#declare Light = rgb 1/sqrt(7);
light_source { <-5, 5, 50> Light }
light_source { <30, -30, 30> Light }
light_source { <-40, -30, 20> Light }
light_source { <10, 30, 40> Light }
light_source { <-30, 40, 10> Light }
light_source { <50, 25, 20> Light }
light_source { <-10, -60, 30> Light }

polygon {
  5, <50, 50, 0>, <-50, 50, 0>, <-50, -50, 0>, <50, -50, 0>, <50, 50, 0>
  pigment { rgb <0.2, 0.7, 0.2> }
  finish { ambient 0 diffuse 1 }
}

// How the two branches of a branch stand on it: leaning, turned, shorter.
#declare Lean = array[2] { 40, 25 };
#declare Turned = array[2] { 90, 230 };
#declare Shorter = array[2] { 0.65, 0.70 };
#declare Thinner = 0.67;

// A branch from Foot on; Across, Beside and Along are its axes, Along as long as it is.
#macro Branch(Depth, Foot, Across, Beside, Along, Thick)
  cone { Foot, Thick, Foot + Along, Thick*Thinner open }
  sphere { Foot + Along, Thick*Thinner }
  #if (Depth > 0)
    #for (I, 0, 1)
      #local X = vrotate(vrotate(x, Lean[I]*x), Turned[I]*z)*Shorter[I];
      #local Y = vrotate(vrotate(y, Lean[I]*x), Turned[I]*z)*Shorter[I];
      #local Z = vrotate(vrotate(z, Lean[I]*x), Turned[I]*z)*Shorter[I];
      Branch(Depth - 1, Foot + Along,
             X.x*Across + X.y*Beside + X.z*Along, Y.x*Across + Y.y*Beside + Y.z*Along,
             Z.x*Across + Z.y*Beside + Z.z*Along, Thick*Thinner)
    #end
  #end
#end

union {
  Branch(Size, <0, 0, 0>, x, y, z, 0.15)
  pigment { rgb <0.55, 0.4, 0.2> }
  finish { ambient 0 diffuse 1 }
}
