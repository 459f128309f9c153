// a ring of brass on a page with its caustic
#version 3.5;
#include "colors.inc"
global_settings { assumed_gamma 1.0 photons { count 20000 autostop 0 } }
light_source { <-4,5,-3>, rgb 1.2 photons { refraction on reflection on } }
difference { cylinder { 0, .7*y, 1.6 } cylinder { -.1*y, .8*y, 1.5 }
  pigment { rgb <.9,.7,.3> } finish { reflection .8 ambient 0 diffuse .2 metallic } photons { target reflection on refraction off } }
sphere { <2.6,.7,-.8>,.7 pigment { rgbf .95 } finish { reflection .05 diffuse 0 } interior { ior 1.5 } photons { target 1.0 refraction on reflection off collect off } }
plane { y,0 pigment { rgb .9 } finish { diffuse .7 ambient .05 } }
camera { location <1,5,-6> look_at <.6,.1,0> angle 44 }
