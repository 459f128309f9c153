// "mount" of the Standard Procedural Databases (E. Haines, data in the public domain): a fractal
// mountain after L. Carpenter, midpoints of squares moved up and down, and four balls of glass.
// The heights repeat, because the numbers that choose them do; so it is published.
//   Declare=Size=6                levels, at most 7 (default 6: 8192 triangles)
//   Declare=Lenticular_Camera=1   the lens sheet of the benchmarks in the place of the camera
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }

#ifndef (Size) #declare Size = 6; #end

#declare Eye = <-1.6, 1.6, 1.7>;
#declare Goal = <0, 0, 0>;
#include "spd_camera.inc"

background { rgb <0.078, 0.361, 0.753> }

light_source { <-100, -100, 100> rgb 1 }

// A tetrahedron of balls that touch one another.
#declare Balls = <-0.8, 0.8, 1>;
#declare Radius = 0.17;
#declare Top = Radius*sqrt(3/2)*z;
#declare Low = vaxis_rotate(Top, <1, 1, 0>, degrees(acos(-1/3)));
union {
  sphere { Balls + Top, Radius }
  #for (I, 0, 2)
    sphere { Balls + vrotate(Low, 120*I*z), Radius }
  #end
  pigment { rgb 1 transmit 0.9 }
  finish { ambient 0 diffuse 0.1 phong 0.4 phong_size 6.7 reflection 0.1 }
  interior { ior 1.5 }
}

// Of the normal distribution, as "Numerical Recipes" makes one of two equal ones: the polar method
// with a congruential generator of 134456 numbers.
#macro Normal(Seed)
  #local Number = Seed;
  #local R = 1;
  #while (R >= 1)
    #local First = mod(28411 + Number*8121, 134456);
    #local Number = mod(28411 + First*8121, 134456);
    #local V = 2*First/134456 - 1;
    #local R = V*V + pow(2*Number/134456 - 1, 2);
  #end
  (V*sqrt(-2*ln(R)/R))
#end

#declare Points = pow(2, Size);
#declare Rough = sqrt(pow(2/pow(2, 1/1.2), 2) - 1);  // of the fractal dimension 2.2

// The move at a point of the lattice, in units of the step's height.
#macro Move(X, Y)
  Normal(21 + mod(X*pow(2, 23 - Size) + Y*pow(2, 15 - Size) + X*pow(2, 7 - Size), 65536))
#end

// Heights over the lattice, level after level: corners are known, middles are found.
#declare Heights = array[Points + 1][Points + 1];
#for (X, 0, 1) #for (Y, 0, 1) #declare Heights[X*Points][Y*Points] = 0; #end #end
#declare Step = Points;
#while (Step > 1)
  #declare Half = Step/2;
  #declare Rise = 2*Half/Points*Rough;
  #for (X, 0, Points - 1, Step)
    #for (Y, 0, Points - 1, Step)
      #declare LL = Heights[X][Y];
      #declare LR = Heights[X + Step][Y];
      #declare UR = Heights[X + Step][Y + Step];
      #declare UL = Heights[X][Y + Step];
      #declare Heights[X + Half][Y] = (LL + LR)/2 + Rise*Move(X + Half, Y);
      #declare Heights[X + Step][Y + Half] = (LR + UR)/2 + Rise*Move(X + Step, Y + Half);
      #declare Heights[X + Half][Y + Step] = (UR + UL)/2 + Rise*Move(X + Half, Y + Step);
      #declare Heights[X][Y + Half] = (UL + LL)/2 + Rise*Move(X, Y + Half);
      #declare Heights[X + Half][Y + Half] =
        (LL + LR + UR + UL)/4 + 1.4142136*Rise*Move(X + Half, Y + Half);
    #end
  #end
  #declare Step = Half;
#end

#macro Place(X, Y) <2*(X)/Points - 1, 2*(Y)/Points - 1, Heights[X][Y]> #end
union {
  #for (X, 0, Points - 1)
    #for (Y, 0, Points - 1)
      triangle { Place(X, Y), Place(X + 1, Y), Place(X + 1, Y + 1) }
      triangle { Place(X + 1, Y + 1), Place(X, Y + 1), Place(X, Y) }
    #end
  #end
  pigment { rgb <0.5, 0.45, 0.35> }
  finish { ambient 0 diffuse 1 }
}
