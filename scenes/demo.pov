// Lentray's demonstration: glass, metal and dice on a polished board, some before and some behind
// the plane of the lens sheet, which stands where the camera looks (the red die's place).
//   lentray scenes/demo.pov +W900 +H675                       an ordinary picture
//   lentray scenes/demo.pov +W900 +H675 Lenticular=On         the same as an integral image
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera {
  perspective
  location <0.4, 3.1, -8.2>
  right 4/3*x
  angle 36
  look_at <0.15, 0.75, 0>
}

// A warm lamp with soft shadows, and a cool one from the side.
light_source {
  <-5, 8, -5> rgb <1, 0.92, 0.8>*0.95
  area_light <1.2, 0, -0.9>, <0, 1.5, 0>, 5, 5 adaptive 1 circular orient
}
light_source { <7, 5, -6> rgb <0.28, 0.36, 0.5> }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.35 rgb <0.20, 0.13, 0.10>]
      [0.50 rgb <0.78, 0.60, 0.46>]
      [0.58 rgb <0.40, 0.42, 0.52>]
      [0.80 rgb <0.08, 0.12, 0.28>]
    }
    scale 2
    translate -y
  }
}

// The board: a round table top of inlaid hexagons, polished.
cylinder {
  <0.4, -0.5, 0.6>, <0.4, 0, 0.6>, 6.2
  pigment {
    hexagon
      rgb <0.62, 0.44, 0.28>,
      rgb <0.20, 0.11, 0.07>,
      rgb <0.45, 0.26, 0.14>
    scale 0.55
  }
  finish { ambient 0.04 diffuse 0.65 specular 0.3 roughness 0.02 reflection { 0.02, 0.35 fresnel } }
  interior { ior 1.45 }
}

#declare Glass = material {
  texture {
    pigment { rgb <0.96, 0.99, 1> filter 0.95 }
    finish {
      ambient 0 diffuse 0.02 specular 0.8 roughness 0.002
      reflection { 0.02, 0.9 fresnel } conserve_energy
    }
  }
  interior { ior 1.5 }
}

#declare Gold = texture {
  pigment { rgb <0.95, 0.66, 0.25> }
  finish {
    ambient 0.05 diffuse 0.35 brilliance 2 metallic
    specular 0.7 roughness 0.02 reflection { 0.45 metallic }
  }
}

#declare Chrome = texture {
  pigment { rgb <0.9, 0.92, 0.95> }
  finish { ambient 0.02 diffuse 0.15 specular 0.9 roughness 0.005 reflection 0.75 }
}

#macro Lacquer(Shade)
  texture {
    pigment { rgb Shade }
    finish { ambient 0.05 diffuse 0.75 phong 0.6 phong_size 60 reflection 0.06 }
  }
#end

// A die of half-side 0.5: a cube, rounded by a sphere, with its spots cut out.
#macro Spot(U, V, Turn)
  sphere { <U, V, -0.56>, 0.13 rotate Turn }
#end
#macro Die(Shade, Spots)
  difference {
    intersection {
      box { -0.5, 0.5 }
      sphere { 0, 0.72 }
      Lacquer(Shade)
    }
    union {
      Spot(0, 0, <0, 0, 0>)
      Spot(-0.24, -0.24, <90, 0, 0>) Spot(0.24, 0.24, <90, 0, 0>) Spot(0, 0, <90, 0, 0>)
      Spot(-0.24, 0.24, <90, 0, 0>) Spot(0.24, -0.24, <90, 0, 0>)
      Spot(-0.24, -0.24, <0, 90, 0>) Spot(0.24, 0.24, <0, 90, 0>)
      Spot(-0.24, -0.26, <0, -90, 0>) Spot(-0.24, 0, <0, -90, 0>) Spot(-0.24, 0.26, <0, -90, 0>)
      Spot(0.24, -0.26, <0, -90, 0>) Spot(0.24, 0, <0, -90, 0>) Spot(0.24, 0.26, <0, -90, 0>)
      Lacquer(Spots)
    }
  }
#end

// A pawn, 1.5 high, of one piece.
#declare Pawn = merge {
  cylinder { <0, 0, 0>, <0, 0.12, 0>, 0.48 }
  torus { 0.42, 0.1 translate 0.14*y }
  cone { <0, 0.12, 0>, 0.38, <0, 1.0, 0>, 0.13 }
  torus { 0.16, 0.06 translate 0.98*y }
  sphere { <0, 1.22, 0>, 0.28 }
}

// All things stand a hair above the board: surfaces that coincide have no order in depth.
#declare Hair = 0.004*y;

// In the plane of the sheet.
object { Die(<0.72, 0.03, 0.04>, <0.95, 0.93, 0.88>) rotate 24*y translate <-0.05, 0.5, 0> + Hair }

// Before it: these reach out towards the viewer.
sphere { <1.05, 0.55, -1.9>, 0.55 material { Glass } }
object { Die(<0.93, 0.91, 0.85>, <0.05, 0.05, 0.06>) scale 0.7 rotate -35*y translate <-1.15, 0.35, -1.7> + Hair }
difference {
  cylinder { <0, 0, 0>, <0, 0.09, 0>, 0.42 }
  cylinder { <0, -1, 0>, <0, 1, 0>, 0.2 }
  torus { 0.31, 0.05 translate 0.1*y }
  texture { Gold }
  translate <-0.15, 0, -2.35> + Hair
}

// Behind it.
object { Pawn texture { Gold } translate <-1.75, 0, 1.5> + Hair }
object { Pawn material { Glass } scale 1.15 translate <1.6, 0, 1.1> + Hair }
sphere { <0.25, 0.95, 2.9>, 0.95 texture { Chrome } }
object { Pawn Lacquer(<0.04, 0.12, 0.32>) scale 1.5 translate <-2.9, 0, 4.2> + Hair }
torus {
  0.75, 0.14
  texture { Gold }
  rotate <-68, 35, 0>
  translate <2.9, 0.78, 3.6> + Hair
}
// A bowl: half a hollow ball, open to the top.
sphere {
  0, 0.8
  clipped_by { plane { y, 0.15 } }
  Lacquer(<0.05, 0.32, 0.22>)
  translate <4.1, 0.8, 5.8> + Hair
}
