// ball and stick, written by a viewer; primitives are macros that may be clipped
#if (version < 3.5)
#error "too old\n"
#end
#declare cut_on = array[2] { 1, 0 };
#declare cut = array[2];
#declare cut[0] = plane { <0.3,0.2,-1>, 0.7 }
#declare wire = 0.0150;
#default { texture { finish { ambient 0.05 diffuse 0.7 phong 0.2 phong_size 30.0 specular 0.3 } } }
#macro Ball (Pos, Rad, Col)
  sphere { Pos, Rad texture { pigment { Col } } #if (cut_on[0]) clipped_by { cut[0] } #end no_shadow }
#end
#macro Stick (From, To, Rad, Col, Bare)
  #if (cut_on[1])
  intersection { cylinder { From, To, Rad texture { pigment { Col } } } cut[1] }
  #else
  cylinder { From, To, Rad #if (Bare) open #end texture { pigment { Col } } #if (cut_on[0]) clipped_by { cut[0] } #end no_shadow }
  #end
#end
#macro Wire (From, To, Col)
  cylinder { From, To, wire pigment { Col } finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } no_shadow }
#end
camera { orthographic location <0.0,0.0,-4.0> look_at <0.0,0.0,4.0> up <0.0,3.0,0.0> right <4.0,0.0,0.0> }
light_source { <-0.5,0.7,-1.0> color rgb<1.000,1.000,1.000> parallel point_at <0.0,0.0,0.0> }
light_source { <1.0,0.3,-0.8> color rgb<0.400,0.400,0.400> parallel point_at <0.0,0.0,0.0> }
background { color rgb<0.950,0.950,1.000> }
#declare n = 0;
#while (n < 6)
  #declare A = vrotate(<0.9000,0,0>, <0,20,60*n>); #declare B = vrotate(<0.9000,0,0>, <0,20,60*n+60>);
  Ball(A,0.2200,rgbt<0.300,0.300,0.350,0.000>)
  Stick(A,B 0.0800,rgbt<0.700,0.700,0.700,0.000>,1)
  Stick(A,A*1.45 0.0600,rgbt<0.900,0.200,0.200,0.300>,0)
  Ball(A*1.5,0.1400,rgbt<0.950,0.950,0.900,0.000>)
  #declare n = n+1;
#end
Wire(<-1.8,-1.35,0>,<1.8,-1.35,0>,rgbt<0,0,1,0>)
Wire(<-1.8,-1.35,0>,<-1.8,1.35,0.4>,rgbt<1,0,0,0>)
