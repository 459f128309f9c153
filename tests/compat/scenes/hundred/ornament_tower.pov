/* homework 3: constructive geometry. Nothing declared that could be repeated */
#include "colors.inc"
background { color rgb<0.5,0.7,0.9> }
camera { location <8,6,-12> look_at <0,4,0> angle 55 }
light_source { <20,30,-20> color rgb <1,1,1> }
light_source { <-20,10,-20> color rgb <0.4,0.4,0.4> }
difference {
  union {
    cylinder { <0,0,0>, <0,6,0>, 2 }
    cylinder { <0,6,0>, <0,6.6,0>, 2.4 }
    cylinder { <0,6.6,0>, <0,7.4,0>, 2.4 }
  }
  cylinder { <0,1,0>, <0,8,0>, 1.7 }
  box { <-3,6.9,-0.3>, <3,8,0.3> }
  box { <-3,6.9,-0.3>, <3,8,0.3> rotate <0,45,0> }
  box { <-3,6.9,-0.3>, <3,8,0.3> rotate <0,90,0> }
  box { <-3,6.9,-0.3>, <3,8,0.3> rotate <0,135,0> }
  union { box { <-0.5,0,-3>, <0.5,1.5,0> } cylinder { <0,1.5,-3>, <0,1.5,0>, 0.5 } rotate <0,-20,0> }
  union { box { <-0.2,3,-3>, <0.2,4,0> } cylinder { <0,4,-3>, <0,4,0>, 0.2 } rotate <0,-60,0> }
  union { box { <-0.2,4,-3>, <0.2,5,0> } cylinder { <0,5,-3>, <0,5,0>, 0.2 } rotate <0,10,0> }
  texture { pigment { brick color rgb <0.85,0.8,0.7>, color rgb <0.65,0.55,0.45> brick_size <0.6,0.3,0.6> mortar 0.04 }
            normal { brick 0.3 brick_size <0.6,0.3,0.6> mortar 0.04 } finish { ambient 0.2 diffuse 0.8 } }
}
cone { <0,7.4,0>, 0.3, <0,9.5,0>, 0 pigment { color Red } }
union {
  box { <0,0,-0.3>, <7,3,0.3> } box { <0,3,-0.3>, <0.5,3.5,0.3> } box { <1,3,-0.3>, <1.5,3.5,0.3> }
  box { <2,3,-0.3>, <2.5,3.5,0.3> } box { <3,3,-0.3>, <3.5,3.5,0.3> } box { <4,3,-0.3>, <4.5,3.5,0.3> }
  translate <1.9,0,0> rotate <0,-30,0>
  pigment { color rgb <0.7,0.65,0.6> }
}
plane { y,0 pigment { color rgb<0.3,0.6,0.2> } normal { bumps 1 scale 0.2 } }
