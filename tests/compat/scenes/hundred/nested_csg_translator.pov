#version 3.7;
// a CSG tree of another language, one object and one matrix a node; z is up
global_settings { assumed_gamma 1.8 }
#default { texture { pigment { rgb <0.98,0.83,0.17> } finish { ambient 0.2 diffuse 0.8 } } }
background { rgb <1,1,0.9> }
#declare view_turn = <55,0,25>; #declare view_far = 140;
#macro view_angle(wide,high) (12*sqrt(wide/high)) #end
camera { perspective location <0,0,view_far> right <-4/3,0,0> up <0,1,0> angle view_angle(4,3)*1.7 look_at <0,0,0> rotate view_turn translate <0,0,5> }
light_source { <-1,1.2,1>*view_far color rgb 1 rotate view_turn }
light_source { <1,-1,-1>*view_far color rgb 0.6 rotate view_turn }
difference {
  union {
    object { // hull of six sides
      intersection { plane { x, 12 } plane { x, 12 rotate <0,0,60> } plane { x, 12 rotate <0,0,120> } plane { x, 12 rotate <0,0,180> } plane { x, 12 rotate <0,0,240> } plane { x, 12 rotate <0,0,300> } plane { z, 8 } plane { -z, 0 } }
      matrix <1,0,0,0,1,0,0,0,1,0,0,0>
    }
    object { object { cone { <0,0,0>,7<0,0,14>,5 } matrix <1,0,0,0,1,0,0,0,1,0,0,0> } matrix <1,0,0,0,1,0,0,0,1,0,0,2> }
    object { box { <-16,-2,0>,<16,2,4> } matrix <0.866025,0.5,0,-0.5,0.866025,0,0,0,1,0,0,0> }
  }
  object { cone { <0,0,-1>,3<0,0,20>,3 } matrix <1,2.2e-016,0,-2.2e-016,1,0,0,0,1,0,0,0> }
  object {
    union {
      object { object { sphere { <0,0,0>, 2.5 } matrix <1,0,0,0,1,0,0,0,1,9,0,8.5> } matrix <1,0,0,0,1,0,0,0,1,0,0,0> }
      object { object { sphere { <0,0,0>, 2.5 } matrix <1,0,0,0,1,0,0,0,1,9,0,8.5> } matrix <-0.5,0.866025,0,-0.866025,-0.5,0,0,0,1,0,0,0> }
      object { object { sphere { <0,0,0>, 2.5 } matrix <1,0,0,0,1,0,0,0,1,9,0,8.5> } matrix <-0.5,-0.866025,0,0.866025,-0.5,0,0,0,1,0,0,0> }
    }
    matrix <1,0,0,0,1,0,0,0,1,0,0,0>
  }
  object { box { <-30,-1,9>,<30,1,11> } matrix <0.5,0.866025,0,-0.866025,0.5,0,0,0,1,0,0,0> }
}
