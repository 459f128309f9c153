// A plane behind the sheet under a mosaic of small occluders, for the paper's regime: neighbours in a
// column of pixels mostly share an occluder, neighbours in a row seldom, pixels of one view never.
//   Declare=Size=60     percent of the plane that lies in shadow (default 60)
//   Declare=Depth=13    of the plane behind the sheet
//   Declare=Wide=0.45 Declare=High=2   of a tile with its share of light
//   Declare=Lights=1    over one another, far away: more of the work is shadow rays
// In mm; 15 square pixels a lens; the tiles hang 1 mm before the plane and are not seen.
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Size) #declare Size = 60; #end
#ifndef (Depth) #declare Depth = 13; #end
#ifndef (Wide) #declare Wide = 0.45; #end
#ifndef (High) #declare High = 2; #end
#ifndef (Lights) #declare Lights = 1; #end

#declare Pitch = 1.124;
#declare Across = image_width*Pitch/15;
#declare Upwards = image_height*Pitch/15;

camera {
  lenticular
  location 0 direction z right Across*x up Upwards*y
  lens_pitch Pitch lens_focal_length 3.03 lens_ior 1.6 lens_pixels 15
  view_distance 0 lens_model pinhole
}

#for (I, 1, Lights)
  light_source { <0, (I - 1)*2e4, -1e6> rgb 1/Lights }
#end
plane { -z, -Depth pigment { rgb 1 } finish { ambient 0 diffuse 1 } }

// The lenses look aside as far as Depth is deep.
#declare Columns = ceil((Across/2 + Depth)/Wide);
#declare Rows = ceil(Upwards/2/High);
#for (I, -Columns, Columns)
  #for (J, -Rows, Rows)
    box {
      <I*Wide, J*High, Depth - 1.1>, <(I + Size/100)*Wide, (J + 1)*High, Depth - 1>
      pigment { rgb 0 } no_image
    }
  #end
#end
