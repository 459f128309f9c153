// A windmill for flips and animation sheets: its sails turn once a quarter while the clock runs from 0 to 1, so that the
// last phase goes on with the first; Declare=Night=1 is the same place by night.
//   lentray scenes/mill.pov +W900 +H675                      by day
//   lentray scenes/mill.pov +W900 +H675 Declare=Night=1      by night
//   lentray scenes/mill.pov +W900 +H675 +KFI1 +KFF12 +KC     twelve phases
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Night) #declare Night = 0; #end

camera {
  location <-3.2, 2.1, -11.5>
  right x*image_width/image_height
  angle 36
  look_at <0.1, 2.15, 0>
}

#if (Night)
  #declare Sky = color_map { [0.0 rgb <0.10, 0.12, 0.28>] [0.6 rgb <0.01, 0.02, 0.08>] }
  light_source { <-6, 9, -8> rgb <0.16, 0.20, 0.36> }
  light_source { <0, 1.9, 0.2> rgb <1.0, 0.7, 0.3>*0.6 fade_distance 2 fade_power 2 }
#else
  #declare Sky = color_map { [0.0 rgb <0.75, 0.85, 0.95>] [0.6 rgb <0.25, 0.5, 0.9>] }
  light_source { <-6, 9, -8> rgb <1, 0.96, 0.88> }
#end
sky_sphere { pigment { gradient y color_map { Sky } } }

plane {
  y, 0
  pigment { bozo scale 0.7 color_map { [0.3 rgb <0.22, 0.45, 0.14>] [0.7 rgb <0.34, 0.56, 0.18>] } }
}

// The tower, with a door and a window that is lit by night.
cone { 0, 1.0, <0, 2.6, 0>, 0.62 pigment { rgb <0.90, 0.86, 0.76> } }
cone { <0, 2.6, 0>, 0.72, <0, 3.3, 0>, 0.05 pigment { rgb <0.55, 0.20, 0.13> } }
box { <-0.22, 0, -1.02>, <0.22, 0.75, -0.6> pigment { rgb <0.36, 0.22, 0.12> } }
box {
  <-0.16, 1.45, -0.85>, <0.16, 1.85, -0.5>
  pigment { rgb #if (Night) <1, 0.8, 0.35> #else <0.2, 0.25, 0.3> #end }
  finish { ambient rgb Night*0.9 emission rgb Night*0.8 }
}

#if (Night)
  #declare Star = seed(7);
  #for (I, 1, 60)
    sphere {
      <-9 + 18*rand(Star), 1.5 + 7*rand(Star), 14>, 0.02 + 0.03*rand(Star)
      pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }
    }
  #end
  sphere { <3.4, 5.4, 12>, 0.55 pigment { rgb <1, 0.97, 0.85> } finish { ambient 0 diffuse 0 emission 1 } }
#end

// Four sails: a quarter turn brings each to the next one's place.
#declare Sail = union {
  box { <-0.035, 0, -0.02>, <0.035, 1.75, 0.02> pigment { rgb <0.42, 0.28, 0.16> } }
  box { <0.035, 0.35, -0.01>, <0.36, 1.72, 0.01> pigment { rgb <0.95, 0.93, 0.88> } }
}
union {
  #for (I, 0, 3) object { Sail rotate z*90*I } #end
  sphere { 0, 0.12 pigment { rgb <0.42, 0.28, 0.16> } }
  rotate -z*90*clock
  translate <0, 2.55, -0.95>
}
