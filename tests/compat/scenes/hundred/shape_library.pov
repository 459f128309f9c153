#include "shapes.inc"
#include "shapes2.inc"
#include "shapes3.inc"
#include "colors.inc"
#version 3.7;
#default { pigment { Wheat } finish { specular .3 ambient .2 } }
object { Supercone(<0,0,0>,.7,.4,<0,1.5,0>,.3,.5) pigment { Coral } translate <-3.6,0,1> }
superellipsoid { <.3,.3> scale .6 translate <-2,.6,0> }
object { Round_Cylinder(<-.6,0,0>,<-.6,1.2,0>,.5,.15,no) pigment { SkyBlue } }
object { Round_Cone(<.9,0,0>,.6,<.9,1.4,0>,.25,.1,yes) pigment { YellowGreen } }
object { Wedge(55) pigment { Orange } translate <2,0,0> scale .9 }
object { Spheroid(<3.4,.5,0>,<.6,.5,.9>) pigment { Orchid } }
object { Wire_Box(<-3.6,0,-2.6>,<-2.4,1,-1.6>,.08,0) pigment { Red } }
object { Round_Box(<-1.6,0,-2.6>,<-.4,.8,-1.6>,.15,1) pigment { Green } }
object { Icosahedron scale .5 translate <.6,.5,-2.2> pigment { Gold } }
object { Dodecahedron scale .5 translate <2,.5,-2.2> pigment { Gray70 } }
object { Segment_of_Torus(.6,.12,-240) rotate -90*x translate <3.4,.75,-2> pigment { Blue } }
object { Tetrahedron scale .4 rotate 20*y translate <4.4,.4,-1> pigment { Magenta } }
plane { y,0 pigment { checker White Gray70 } } background { SkyBlue }
camera { location <0,5,-9> look_at <0,.4,-.6> angle 52 } light_source { <-8,12,-9> White }
