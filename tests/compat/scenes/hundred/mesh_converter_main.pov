// the main file of a converter: it keeps the version that was in force outside
#local Outer_Version = version;
#version 3.7;
// faces: 8, vertices: 6, uv: 6, materials: 2
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 0.004 }
#declare Mat_Hull_ = material { texture { uv_mapping pigment { checker rgbft <0.8,0.82,0.85,0,0> rgbft <0.35,0.4,0.5,0,0> scale 0.125 }
  finish { ambient rgb <0.03,0.03,0.04> diffuse 0.75 specular 0.35 roughness 0.03 } } }
#declare Mat_Band_ = material { texture { pigment { rgbft <0.9,0.25,0.1,0,0> } finish { ambient 0.05 diffuse 0.8 } } interior { ior 1 } }
#declare gem_ = mesh2 {
  vertex_vectors { 6, <0,1.2,0>, <1,0,0>, <0,0,1.00000012>, <-1,-1.1920929E-07,0>, <0,0,-1>, <0,-1.2,0> }
  normal_vectors { 6, <0,1,0>, <1,0,0>, <0,0,1>, <-1,0,0>, <0,0,-1>, <0,-1,0> }
  uv_vectors { 6, <0.5,1>, <0,0.5>, <0.25,0.5>, <0.5,0.5>, <0.75,0.5>, <0.5,0> }
  face_indices { 8, <0,1,2>, <0,2,3>, <0,3,4>, <0,4,1>, <5,2,1>, <5,3,2>, <5,4,3>, <5,1,4> }
  normal_indices { 8, <0,1,2>, <0,2,3>, <0,3,4>, <0,4,1>, <5,2,1>, <5,3,2>, <5,4,3>, <5,1,4> }
  material { Mat_Hull_ }
}
camera { perspective up <0,1,0> right -x*image_width/image_height location <0,7.77156117237610E-16,9.24> look_at <0,7.77156117237610E-16,8.24>
  angle 29.5 rotate <0,0,4> rotate <-18,0,0> rotate <0,-32,0> translate <0.05,0.02,-0.11> }
light_source { <0,0,9> color rgb <1,1,1>*1.4 parallel point_at <0,0,0> rotate <-40,0,0> rotate <0,15,0> }
background { color srgb <0.82,0.88,0.95> }
object { gem_ }
torus { 1.3,0.09 material { Mat_Band_ } rotate <12,0,0> }
#version Outer_Version;
