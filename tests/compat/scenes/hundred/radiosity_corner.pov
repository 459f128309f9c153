#version 3.7;
global_settings { assumed_gamma 1.0 radiosity { pretrace_start .08 pretrace_end .02 count 60 nearest_count 6 error_bound .7 recursion_limit 2 } }
#default { finish { ambient 0 diffuse .8 } }
box { <-2,0,-2>,<2,3,2> hollow pigment { rgb .9 } }
box { <-1.99,0,-2>,<-1.98,3,2> pigment { rgb <.8,.1,.1> } } box { <1.98,0,-2>,<1.99,3,2> pigment { rgb <.1,.7,.1> } }
box { <-.5,2.98,-.5>,<.5,2.99,.5> pigment { rgb 1 } finish { emission 3 } }
box { <-.5,0,-.5>,<.5,1.7,.5> rotate 20*y translate <-.7,0,.6> pigment { rgb .9 } }
sphere { <.8,.5,-.4>,.5 pigment { rgb <.5,.6,.9> } }
camera { location <0,1.5,-1.95> look_at <0,1.3,2> angle 90 right x*image_width/image_height }
