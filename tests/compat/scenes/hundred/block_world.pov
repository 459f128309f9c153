#version 3.7;
// blocks on a grid from strings of digits; faces with uv-mapped pictures
global_settings { assumed_gamma 1.0 }
#declare World = array[8] { "11223321", "11222211", "11121111", "00111100", "00011000", "01111100", "12221100", "23331000" }
#declare Gras = texture { uv_mapping pigment { image_map { png "map.png" } } finish { ambient .2 } };
#declare Erde = texture { pigment { bozo color_map { [.4 rgb <.4,.25,.1>] [.4 rgb <.5,.3,.15>] } scale .12 } finish { ambient .2 } };
#declare Stein = texture { pigment { cells color_map { [0 rgb .35] [1 rgb .65] } scale .125 } finish { ambient .2 } };
#for (Z,0,7)
  #for (X,0,7)
    #local Top = val(substr(World[Z],X+1,1));
    #for (Y,0,Top)
      box { 0, 1 #if (Y = Top & Top > 0) texture { Gras } #else #if (Y < 2) texture { Stein } #else texture { Erde } #end #end
        translate <X-4,Y,4-Z> }
    #end
  #end
#end
box { <-4,0,-4>, <5,.8,5> pigment { rgbt <.2,.4,.9,.5> } finish { reflection .15 } translate <-.0003,0,.0003> }
light_source { <-30,40,-20> rgb 1.1 } light_source { <30,20,-40> rgb .3 shadowless }
sky_sphere { pigment { rgb <.6,.75,1> } }
camera { location <-8,9.2,-10> look_at <.5,.9,0> angle 42 right x*image_width/image_height }
