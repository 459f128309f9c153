// tufts of bent blades in a mesh, stones as squashed isosurfaces
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
#include "rand.inc"
#declare R = seed(4711);
#declare Tuft = mesh {
  #for (k,0,25)
    #local d = vrotate(x,360*rand(R)*y); #local h = .5+.5*rand(R); #local b = .1+.4*rand(R); #local w = .03*vcross(d,y);
    triangle { -w, w, d*b*.3+y*h*.6 }
    triangle { w*.7+d*b*.2+y*h*.4, -w*.7+d*b*.2+y*h*.4, d*b+y*h }
  #end
}
#for (i,1,70)
  object { Tuft rotate 360*rand(R)*y scale .7+.6*rand(R) translate <RRand(-4,4,R), 0, RRand(-3,4,R)>
    pigment { rgb <.2+.2*rand(R), .4+.3*rand(R), .1> } finish { diffuse .8 ambient .1 } double_illuminate }
#end
#declare Rock = isosurface { function { sqrt(x*x+y*y+z*z) - .8 - .5*f_noise3d(x*2,y*2,z*2) }
  contained_by { sphere { 0, 1.4 } } max_gradient 2.2 }
object { Rock scale <1,.7,1> translate <-1.4,.2,0> pigment { granite color_map { [0 rgb .3] [1 rgb .7] } } }
object { Rock rotate 70*z scale <.6,.4,.7> translate <1.6,.1,-1.4> pigment { rgb <.5,.45,.4> } normal { granite .4 scale .4 } }
plane { y,0 pigment { bozo color_map { [0 rgb <.3,.25,.1>] [1 rgb <.25,.35,.1>] } scale .5 } }
camera { location <0,2.4,-7> look_at <0,.5,0> angle 50 }
light_source { <-8,9,-6> rgb 1.1 } sky_sphere { pigment { rgb <.7,.85,1> } }
