// spheres between two splines make the blade of a leaf
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }
#declare Rib = spline { cubic_spline -.1,<-3.2,0,0> 0,<-3,0,0> .3,<-1,.5,.1> .7,<1,.6,.1> 1,<3,0,0> 1.1,<3.3,-.2,0> }
#declare Rim = spline { natural_spline 0,<-3,0,0>, .25,<-1.8,.1,1.2>, .6,<.5,.3,1.6>, .85,<2,.1,.8>, 1,<3,0,0> }
#macro Blade(sgn)
  #for (k,0,24)
    #local tt = k/24; #local a = Rib(tt); #local b = Rim(tt)*<1,1,sgn>;
    #for (j,0,7) sphere { a+(b-a)*j/7 + .12*y*sin(j), .3, 1 } #end
  #end
#end
blob { threshold .55 Blade(1) Blade(-1) scale <1,.5,1>
  pigment { gradient z triangle_wave color_map { [0 rgb <.5,.7,.2>] [.05 rgb <.2,.5,.1>] [1 rgb <.3,.6,.15>] } scale 3 } finish { specular .2 } }
#declare Path = spline { quadratic_spline 0,<-3,.1,0>, 1,<-4,-.1,.2>, 2,<-5,.5,0>, 3,<-6,1.6,0> }
#for (k,0,20) sphere { Path(k/10), .09-.002*k pigment { rgb <.4,.3,.1> } } #end
plane { y,-.8 pigment { rgb <.8,.78,.7> } }
light_source { <-5,9,-7> rgb 1 }
camera { location <-.6,6,-6> look_at <-.6,0,0> angle 55 right x*image_width/image_height }
