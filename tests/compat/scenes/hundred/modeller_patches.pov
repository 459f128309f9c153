// from a modeller of 1998; textures first, then objects by layer
#include "colors.inc"
#include "textures.inc"
global_settings { adc_bailout 0.003922 ambient_light <1.0,1.0,1.0> assumed_gamma 1.9 hf_gray_16 off max_trace_level 5 }
background { color <0.0,0.0,0.0> }
camera { //  Camera Camera01
  location  < -5.0, -9.0, 5.5 >
  sky       < 0.0, 0.0, 1.0 > // Use right handed-system!
  up        < 0.0, 0.0, 1.0 > // Where Z is up
  right     < 1.3333333, 0.0, 0.0 > // Aspect Ratio
  angle     36.0
  look_at   < 0.0, 0.0, 0.6 >
}
light_source { //  Light1
  <-9.6, -14.2, 17.4>
  color <1.000, 1.000, 1.000>
}
#declare Lacquer =
  material  // Lacquer
  {
    texture
    {
      pigment { agate agate_turb 0.8 color_map { [ 0.0 rgbft <0.7, 0.2, 0.1, 0.0, 0.0> ] [ 0.6 rgbft <0.9, 0.6, 0.2, 0.0, 0.0> ] [ 1.0 rgbft <0.3, 0.1, 0.1, 0.0, 0.0> ] } }
      finish { ambient 0.1 phong 0.7 phong_size 60.0 }
    }
  }
union {  // Cushion
  #declare S = -1;
  #while (S <= 1)
  bicubic_patch { type 1 flatness 0.0100 u_steps 3 v_steps 3,
    <-1.0, -1.0, 0.0>, <-0.3, -1.2, 0.3*S>, <0.3, -1.2, 0.3*S>, <1.0, -1.0, 0.0>,
    <-1.2, -0.3, 0.3*S>, <-0.3, -0.3, 1.2*S>, <0.3, -0.3, 1.2*S>, <1.2, -0.3, 0.3*S>,
    <-1.2, 0.3, 0.3*S>, <-0.3, 0.3, 1.2*S>, <0.3, 0.3, 1.2*S>, <1.2, 0.3, 0.3*S>,
    <-1.0, 1.0, 0.0>, <-0.3, 1.2, 0.3*S>, <0.3, 1.2, 0.3*S>, <1.0, 1.0, 0.0>
  }
  #declare S = S + 2;
  #end
  material { Lacquer }
  scale <1.3, 1.3, 0.9> rotate <0.0, 0.0, 25.0> translate  <-1.2, 0.0, 0.7>
}
cone { // Cone001
  <0,0,0>, 1.0, <0,0,1>, 0.4
  material { Lacquer scale 0.5 }
  scale <0.8, 0.8, 2.0> translate  <1.9, 0.4, 0.0>
}
object { // CSG001
  difference {
    sphere { <0,0,0>,1 }
    cylinder { <0,0,1>, <0,0,0>, 1 scale <0.45, 0.45, 3.0> translate  -1.5*z }
    texture { Chrome_Texture }
  }
  scale 0.7 rotate <35.0, 10.0, 0.0> translate  <0.9, -2.2, 0.7>
}
plane { // Ground
  z,0
  texture { pigment { checker color rgb <0.8,0.8,0.75> color rgb <0.35,0.4,0.45> scale 1.5 } }
}
