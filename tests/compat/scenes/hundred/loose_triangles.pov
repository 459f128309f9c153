// faces without a mesh, names of materials with underscores, long numbers
#version 3.5;
global_settings { assumed_gamma 2.2 }
#declare MAT_ROOF_01 = texture { pigment { color rgb<0.588235294118,0.196078431373,0.176470588235> } finish { ambient 0.3 diffuse 0.7 } };
#declare MAT_WALL_02 = texture { pigment { color rgb<0.921568627451,0.886274509804,0.8> } finish { ambient 0.3 diffuse 0.7 } };
#declare MAT_GLAS_03 = texture { pigment { color rgbf<0.4,0.6,0.8,0.5> } finish { ambient 0.1 diffuse 0.3 reflection 0.3 } };
camera { location<-14.5,7.25,-17.125> direction<0,0,1.6> up<0,1,0> right<1.33333333,0,0> look_at<0.5,2.5,0> }
light_source { <-30,40,-25> color rgb<1,1,1> }
light_source { <40,20,-10> color rgb<0.3,0.3,0.35> }
union {
triangle { <-4,0,-3>,<4,0,-3>,<4,4.00000001,-3> texture { MAT_WALL_02 } }
triangle { <-4,0,-3>,<4,4.00000001,-3>,<-4,4.00000001,-3> texture { MAT_WALL_02 } }
triangle { <4,0,-3>,<4,0,3>,<4,4,3> texture { MAT_WALL_02 } }
triangle { <4,0,-3>,<4,4,3>,<4,4,-3> texture { MAT_WALL_02 } }
triangle { <-4,0,3>,<-4,0,-3>,<-4,4,-3> texture { MAT_WALL_02 } }
triangle { <-4,0,3>,<-4,4,-3>,<-4,4,3> texture { MAT_WALL_02 } }
triangle { <-4,4,-3>,<-4,4,3>,<-4,6.5,1.2E-17> texture { MAT_WALL_02 } }
triangle { <4,4,-3>,<4,4,3>,<4,6.5,0> texture { MAT_WALL_02 } }
triangle { <-4.5,3.7,-3.4>,<4.5,3.7,-3.4>,<4.5,6.6,0> texture { MAT_ROOF_01 } }
triangle { <-4.5,3.7,-3.4>,<4.5,6.6,0>,<-4.5,6.6,0> texture { MAT_ROOF_01 } }
triangle { <-4.5,3.7,3.4>,<4.5,6.6,0>,<4.5,3.7,3.4> texture { MAT_ROOF_01 } }
triangle { <-4.5,3.7,3.4>,<-4.5,6.6,0>,<4.5,6.6,0> texture { MAT_ROOF_01 } }
triangle { <-3,1.2,-3.01>,<-1,1.2,-3.01>,<-1,2.8,-3.01> texture { MAT_GLAS_03 } }
triangle { <-3,1.2,-3.01>,<-1,2.8,-3.01>,<-3,2.8,-3.01> texture { MAT_GLAS_03 } }
triangle { <1.5,0,-3.01>,<3,0,-3.01>,<3,2.6,-3.01> texture { MAT_ROOF_01 } }
triangle { <1.5,0,-3.01>,<3,2.6,-3.01>,<1.5,2.6,-3.01> texture { MAT_ROOF_01 } }
triangle { <0,0,0>,<0,0,0>,<1,1,1> texture { MAT_ROOF_01 } }
}
plane { <0,1,0>,-0.001 texture { pigment { color rgb<0.35,0.5,0.25> } finish { ambient 0.3 diffuse 0.7 } } }
