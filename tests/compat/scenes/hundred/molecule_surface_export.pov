#version 3.6;
camera {direction<0.0,0.0,  -2.747>
 location <0.0 , 0.0 , 0.0>
 right 1.333*x up y
 }
#default { texture{finish{phong    0.400 ambient    0.140 diffuse    0.450 phong_size   13.750}}}
light_source{<4000.0001,4000.0001,9999.9999>  rgb<1.0,1.0,1.0>}
light_source{<-1,2,0.5> rgb<0.4,0.4,0.4> shadowless}
plane{z , -60.0
 pigment{color rgb<0.0,0.1,0.3>}
 finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-3.1540,0.6120,-29.1910>, 1.7
pigment{color rgb<0.2000,1.0000,0.2000>}}
sphere{<-1.2040,-1.3700,-30.0910>, 1.55
pigment{color rgb<0.2000,0.2000,1.0000>}}
cylinder{<-3.1540,0.6120,-29.1910>,
<-1.2040,-1.3700,-30.0910>,
    0.4000
pigment{color rgb<1.0000,0.3000,0.3000>}}
mesh2 { vertex_vectors { 8,
<1.1,2.2,-30>, <4.4,2.6,-31>, <4.1,-2.1,-30>,
<0.9,-1.8,-29>, <2.6,0.3,-27>, <2.5,3.6,-32>,
<5.7,0.2,-32>, <2.4,-3.2,-31>,
 }
 normal_vectors { 8,
<-0.6,0.5,0.5>, <0.5,0.6,0.4>, <0.5,-0.5,0.5>,
<-0.6,-0.4,0.6>, <0,0,1>, <0,1,-0.1>,
<1,0,0>, <0,-1,0.1>,
 }
texture_list { 8,
texture { pigment{color rgb<1.0,0.0,0.0>} }
texture { pigment{color rgb<0.8,0.2,0.0>} }
texture { pigment{color rgb<0.0,0.9,0.1>} }
texture { pigment{color rgb<0.1,0.1,1.0>} }
texture { pigment{color rgb<1.0,1.0,0.3>} }
texture { pigment{color rgb<0.3,1.0,1.0>} }
texture { pigment{color rgb<1.0,0.3,1.0>} }
texture { pigment{color rgb<0.9,0.9,0.9>} }
 }
 face_indices { 8,
<0,1,4>,0,1,4 <1,2,4>,1,2,4 <2,3,4>,2,3,4 <3,0,4>,3,0,4
<0,5,1>,0,5,1 <1,6,2>,1,6,2 <2,7,3>,2,7,3 <0,3,7>,0,3,7
 }
}
