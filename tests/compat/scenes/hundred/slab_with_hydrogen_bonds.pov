#version 3.7;
global_settings {
  assumed_gamma 1.0
  ambient_light rgb <1, 1, 1>
  max_trace_level 12
}
camera {
  orthographic
  right <12.8, 0, 0>
  up <0, 2.48069469, 9.27098321>
  location <3.5, -26.4, 9.1>
  look_at <3.5, 3.3, 1.15>
  sky <0, 0, 1>
}
background { color rgbf <1, 1, 1, 0> }
fog { fog_type 1 distance 180 color rgbf <0.9, 0.95, 1, 0> }
light_source { <-18.2, -30.5, 44.1> color rgb <0.9, 0.9, 0.9>
  area_light <3, 0, 0>, <0, 2.2, 2.1>, 3, 3
  adaptive 1
}
light_source { <22, -30, 10> color rgb <0.35, 0.35, 0.38> shadowless }
#declare i = 0;
#while (i < 4)
#declare j = 0;
#while (j < 3)
sphere { <i*2.3, j*2.1, 0>, 0.86 pigment { color rgb <0.72, 0.45, 0.2> } finish { ambient 0.12 emission 0.04 diffuse 0.65
 phong 0.35 phong_size 60 specular 0.1 } }
sphere { <i*2.3+1.1, j*2.1+0.9, 1.05>, 0.62 pigment { color rgbt <0.85, 0.08, 0.05, 0.15> } finish { ambient 0.12 emission
 0.04 diffuse 0.65 phong 0.35 phong_size 60 specular 0.1 } }
cylinder { <i*2.3, j*2.1, 0>, <i*2.3+1.1, j*2.1+0.9, 1.05>, 0.14 pigment { color rgb <0.5, 0.5, 0.5> } finish {
 ambient 0.12 emission 0 diffuse 0.65 phong 0.1 phong_size 20 specular 0 } }
#declare j = j+1;
#end
#declare i = i+1;
#end
// hydrogen bonds: dashes
#declare k = 0;
#while (k < 5)
cylinder { <1.1, 0.9, 1.7+k*0.3>, <1.15, 0.95, 1.85+k*0.3>, 0.07 pigment { color rgbft <0.1, 0.1, 0.8, 0.2, 0.1> } finish {
 ambient 0.3 emission 0.1 diffuse 0.5 phong 0 phong_size 1 specular 0 } }
#declare k = k+1;
#end
sphere { <1.2, 1.0, 3.4>, 0.45 pigment { color rgb <0.9, 0.9, 0.95> } finish { ambient 0.12 emission 0 diffuse 0.65 phong
 0.35 phong_size 60 specular 0.1 } }
text { ttf "cyrvetic.ttf" "H2O" 0.05, 0 pigment { color rgb <0, 0, 0> } finish { ambient 0 emission 0 diffuse 1 phong 0
 phong_size 1 specular 0 } scale 0.9 matrix <1, 0, 0, 0, 0, 1, 0, -1, 0, 1.9, 0.5, 3.3> }
