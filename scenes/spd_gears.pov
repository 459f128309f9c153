// "gears" of the Standard Procedural Databases (E. Haines, data in the public domain): a block of
// gears that mesh, their faces concave polygons of 144 vertices, every fifth of glass.
//   Declare=Size=4                gears along an edge of the block (default 4: 64 gears)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 4; #end

#declare Eye = <-1.1, -2.1, 2.6>;
#declare Goal = <0, 0, 0>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

#declare Light = rgb 1/sqrt(5);
light_source { <2, 4, 4> Light }
light_source { <-2, 4, 3> Light }
light_source { <2, -2.5, 2.5> Light }
light_source { <-1, -4, 2> Light }
light_source { <-1.111, -2.121, 2.626> Light }

polygon {
  5, <-2, -2, 0>, <2, -2, 0>, <2, 2, 0>, <-2, 2, 0>, <-2, -2, 0>
  pigment { rgb <1, 0.85, 0.7> }
  finish { ambient 0 diffuse 0.3 phong 0.6 phong_size 37 reflection 0.3 }
}

#declare Teeth = 36;
#declare Outer = 1/(Size - (Size - 1)*0.05);
#declare Spacing = 1.9*Outer;
#declare Thick = min(0.1, 1/(2*Size));
#declare Tooth = 2*pi/Teeth;

// The outline of a gear about the origin: four corners a tooth, turned by Phase.
#macro Outline(Phase)
  #local Corners = array[4*Teeth + 1];
  #local Angles = array[4] { -0.19, 0.19, 0.3, 0.7 };
  #local Radii = array[4] { 0.995*Outer, 0.995*Outer, 0.9*Outer, 0.9*Outer };
  #for (T, 0, Teeth - 1)
    #for (C, 0, 3)
      #local A = (T + Angles[C])*Tooth + Phase;
      #local Corners[4*T + C] = <Radii[C]*cos(A), Radii[C]*sin(A), 0>;
    #end
  #end
  #local Corners[4*Teeth] = Corners[0];
  Corners
#end

#macro Face(Corners, Shift)
  polygon {
    4*Teeth + 1
    #for (C, 0, 4*Teeth) , Corners[C] + Shift #end
  }
#end

#macro Gear(Corners, Top)
  Face(Corners, Top)
  Face(Corners, Top - Thick*z)
  #for (C, 0, 4*Teeth - 1)
    #local P = Corners[C] + Top;
    #local Q = Corners[C + 1] + Top;
    polygon { 5, P, Q, Q - Thick*z, P - Thick*z, P }
  #end
#end

#declare Straight = Outline(0)
#declare Half_Turned = Outline(Tooth/2)

#for (IX, 0, Size - 1)
  #for (IY, 0, Size - 1)
    #for (IZ, 0, Size - 1)
      #local Top = <-1 + Outer + IX*Spacing, -1 + Outer + IY*Spacing, 1 - IZ/Size>;
      #local Sevenths = <mod(3*IX + 2*IY + IZ, 7), mod(IX + 3*IY + 2*IZ, 7), mod(2*IX + IY + 3*IZ, 7)>;
      #local Shade = (<1, 1, 1> + Sevenths)/7;
      union {
        #if (mod(IX + IY + IZ, 2) = 0)
          Gear(Straight, Top)
        #else
          Gear(Half_Turned, Top)
        #end
        #if (mod(4*IX + 2*IY + IZ, 5) = 0)
          pigment { rgb Shade transmit 0.8 }
          finish { ambient 0 diffuse 0.2 phong 0.5 phong_size 37 reflection 0.1 }
          interior { ior 1.1 }
        #else
          pigment { rgb Shade }
          finish { ambient 0 diffuse 0.7 phong 0.3 phong_size 37 reflection 0.2 }
        #end
      }
    #end
  #end
#end
