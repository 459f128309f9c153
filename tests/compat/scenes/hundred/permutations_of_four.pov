#version 3.6;
global_settings { assumed_gamma 1.0 }
#default { finish { ambient .15 diffuse .8 conserve_energy } }
#include "colors.inc"
// a graph on an octahedron: arrays in arrays, labels centred by their extent
#declare Eye = <-3, 5, -11>;
camera { location Eye right x*image_width/image_height angle 26 look_at 0 }
light_source { <-90, 120, -80> color White shadowless }
light_source { Eye color rgb <.8, .9, 1>*.2 shadowless }
sky_sphere { pigment { White } }
#declare Knots = array[6] { x*2, -x*2, y*2, -y*2, z*2, -z*2 };
#declare Rings = array[3] { array[5] { 0, 2, 1, 3, 0 }, array[5] { 0, 4, 1, 5, 0 }, array[5] { 2, 4, 3, 5, 2 } };
#declare Tints = array[3] { srgb <230, 160, 40>/255, srgb <60, 190, 90>/255, srgb <70, 110, 240>/255 };
union {
  #for (R, 0, 2)
    #local Ring = Rings[R];
    #for (K, 0, dimension_size(Ring, 1)-2)
      cylinder { Knots[Ring[K]], Knots[Ring[K+1]], .05 pigment { color Tints[R] } }
    #end
  #end
  #for (F, 0, 7)
    polygon { 4, Knots[mod(F,2)], Knots[2+mod(div(F,2),2)], Knots[4+div(F,4)], Knots[mod(F,2)] pigment { color rgbt <1, 1-F/8, .6, .7> } }
  #end
  #for (K, 0, 5)
    sphere { Knots[K], .25 pigment { rgb .1 } }
    #local Label = text { ttf "timrom.ttf", concat(str(K,0,0), chr(97+K)), .05, 0 scale .34 };
    object { Label translate -(max_extent(Label)+min_extent(Label))/2 pigment { White } translate Knots[K]*1.03 - .3*z }
  #end
  rotate <0, 22, 5>
}
