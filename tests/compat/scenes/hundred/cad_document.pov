// written by a CAD workbench, one object a body
#version 3.6;
global_settings { assumed_gamma 1.0 ambient_light color rgb <1.0,1.0,1.0> }
#default {finish{ambient rgb 0.2 diffuse 0.9}}
#declare CamUp = < 0, 0, 120 >;
#declare CamRight = < 160, 0, 0 >;
#declare CamRotation = < -35.2643897, 0.0, 45.0 >;
#declare CamPosition = < 60.0, -60.0, 70.0 >;
camera {
	orthographic
	location < 0, 0, 0 >
	direction < 0, 1, 0 >
	up CamUp
	right CamRight
	rotate < -35.2643897, 0.00000143, 45.0 >
	translate < -90.0, -90.0, 110.0 >
}
light_source { < -90, -120, 200 > color rgb < 0.9, 0.9, 0.9 > }
background { color rgb < 0.7, 0.72, 0.8 > }
//----- Body Cut -----
#declare Cut_material = texture { pigment { color rgb < 0.8, 0.8, 0.8 > } finish { specular 0.3 roughness 0.05 } }
#declare Box = box { < 0,0,0 >, < 60.0, 40.0, 20.0 > }
#declare Cylinder = cylinder { < 0, 0, 0 >, < 0, 0, 30.0 >, 8.0 translate < 20.0, 20.0, -5.0 > }
#declare Cylinder001 = cylinder { < 0, 0, 0 >, < 0, 0, 30.0 >, 5.0 translate < 45.0, 20.0, -5.0 > }
#declare Fusion = union { object { Cylinder } object { Cylinder001 } }
#declare Cut = difference { object { Box } object { Fusion } texture { Cut_material } translate < -30.0, -20.0, 0.0 > }
object { Cut }
//----- Cone -----
#declare Cone = cone { < 0, 0, 0 >, 12.0, < 0, 0, 24.0 >, 3.0
  pigment { color rgb < 1.0, 0.667, 0.0 > }
  rotate < 0.0, 0.0, 0.0 >
  translate < 30.0, 40.0, 0.0 > }
object { Cone }
//----- Torus -----
object { torus { 14.0, 4.0 rotate < 90, 0, 0 > } pigment { color rgb < 0.2, 0.4, 0.9 > } translate < -35.0, -35.0, 10.0 > }
//----- Wedge -----
prism { linear_sweep linear_spline 0, 12, 5, < 0, 0 >, < 20, 0 >, < 20, 6 >, < 8, 16 >, < 0, 0 >
  matrix < 1,0,0, 0,0,1, 0,1,0, 10,-45,2 > pigment { color rgb < 0.3, 0.7, 0.3 > } }
plane { z, -0.5 pigment { color rgb < 0.5, 0.55, 0.6 > } }
