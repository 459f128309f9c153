#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = 60;
sphere_sweep {
  cubic_spline N+3
  #for (i, -1, N+1)
    #local tt = i/N*2*pi;
    , <2*sin(3*tt), 1.5*sin(2*tt + 0.6), 2*cos(5*tt)*0.5>, 0.09 + 0.04*sin(9*tt)
  #end
  tolerance 1e-4
  pigment { gradient z color_map { [0 rgb <1,.3,.1>] [.5 rgb <.9,.9,.2>] [1 rgb <.1,.4,1>] } translate -.5*z scale 2 }
  finish { specular .5 }
}
sphere_sweep { linear_spline 4, <-2.4,-1.9,-1.4>, .1, <2.4,-1.9,-1.4>, .2, <2.4,-1.9,1.4>, .1, <-2.4,-1.9,1.4>, .05 pigment { rgb .7 } }
plane { y, -2.1 pigment { checker rgb .9 rgb .6 } }
light_source { <-4, 9, -8> rgb .9 }
camera { location <1,1.5,-8> look_at 0 angle 45 right x*image_width/image_height }
