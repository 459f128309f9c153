#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare NU = 60; #declare NV = 4;
#macro M(i,j) #local a = 2*pi*i/NU; #local s = (j/NV-.5)*1.1; vrotate(<2+s*cos(a/2), s*sin(a/2), 0>, degrees(a)*y) #end
mesh2 {
  vertex_vectors { (NU+1)*(NV+1) #for (i,0,NU) #for (j,0,NV) , M(i,j) #end #end }
  uv_vectors { (NU+1)*(NV+1) #for (i,0,NU) #for (j,0,NV) , <i/NU, j/NV> #end #end }
  face_indices { 2*NU*NV
    #for (i,0,NU-1) #for (j,0,NV-1) #local k = i*(NV+1)+j; , <k, k+1, k+NV+2>, <k, k+NV+2, k+NV+1> #end #end }
  uv_mapping pigment { checker rgb <.9,.2,.1>, rgb <.95,.9,.8> scale <1/24,1/4,1> }
  finish { specular .3 } rotate 40*x
}
sphere { 0, .7 pigment { onion color_map { [0 rgb <.2,.5,.3>] [1 rgb 1] } scale .1 } }
light_source { <-4,8,-9> rgb 1 } light_source { <6,-3,-9> rgb .35 shadowless }
background { rgb <.12,.12,.2> }
camera { location <0,1.5,-8> look_at 0 right x*image_width/image_height angle 45 }
