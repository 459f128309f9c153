// Toy bricks; y down, as the format has it
#ifndef (Q) #declare Q = 3; #end	// 0=boxes, 1=no refraction, 2=normal, 3=studs
#ifndef (SW) #declare SW = 0.5; #end	// seam between two bricks
#declare AMB = 0.4;
#declare DIF = 0.4;
#declare SWT = (SW ? SW : 0.001);
#declare NB = normal { bumps 0.01 scale 20 }
#declare Color4 = texture { pigment { rgb <0.7,0.04,0.04> } finish { ambient AMB diffuse DIF phong 0.5 phong_size 40 } #if (Q>1) normal { NB } #end }
#declare Color14 = texture { pigment { rgb <0.95,0.8,0.05> } finish { ambient AMB diffuse DIF phong 0.5 phong_size 40 } }
#declare Color41 = texture { pigment { rgbf <0.4,0.6,1,0.8> } finish { ambient AMB diffuse DIF } }
#declare Stud = #if (Q=0) box { <-6,-4,-6>, <6,0,6> } #else cylinder { <0,-4,0>, <0,0,0>, 6 } #end
#macro Brick(NX,NZ)
union {
  difference {
    box { <-NX*10,0,-NZ*10>, <NX*10,24,NZ*10> }
    box { <-NX*10+4,4,-NZ*10+4>, <NX*10-4,25,NZ*10-4> }
  }
  #local I = 0;
  #while (I < NX)
    #local J = 0;
    #while (J < NZ)
      object { Stud translate <(I-(NX-1)/2)*20,0,(J-(NZ-1)/2)*20> }
      #local J = J + 1;
    #end
    #local I = I + 1;
  #end
}
#end
#declare _3001_dot_dat = Brick(4,2)
#declare _3003_dot_dat = Brick(2,2)
object { _3001_dot_dat
  matrix <1-SW/80,0,0,0,1-SW/28,0,0,0,1-SW/40,0,SW/28,0>
  matrix <1,0,0,0,1,0,0,0,1,0,0,0> texture { Color4 } }
object { _3001_dot_dat matrix <0,0,1,0,1,0,-1,0,0,-20,-24,20> texture { Color14 } }
object { _3003_dot_dat
  matrix <1-SWT/40,0,0,0,1-SWT/28,0,0,0,1-SWT/40,0,SWT/28,0>
  matrix <1,0,0,0,1,0,0,0,1,40,-24,0> texture { Color41 } #if (Q>1) interior { ior 1.25 } #end }
object { _3003_dot_dat matrix <0.866025,0,-0.5,0,1,0,0.5,0,0.866025,90,0,-40> texture { Color14 } }
plane { y, 24 pigment { rgb <0.3,0.45,0.3> } finish { ambient AMB diffuse DIF } }
background { rgb <0.3,0.5,0.7> }
light_source { <0,-180,-190> color rgb <1,1,1> }
light_source { <-141,-180,116> color rgb <1,1,1> }
camera { location <110,-150,-210> sky -y right -4/3*x look_at <10,-10,0> angle 45 }
