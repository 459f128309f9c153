// polygons of a computer algebra program, z up, exponents everywhere
global_settings { assumed_gamma 1. }
camera { location <2.1E+0,-3.8e0,2.4> right <-1.3333,0.,0.> up <0.,0.,1.> sky <0.,0.,1.> direction <0,1.8,0> look_at <0.,0.,0.> }
light_source { <1.E1,-8.,6.E+0> color rgb <.9,.9,.9> }
light_source { <-1.E1,-1.,8.> color rgb <.4,.4,.5> shadowless }
background { color rgb <1.,1.,1.> }
#declare S1 = texture { pigment { color rgb <.87,.94,1.> } finish { ambient .3 diffuse .6 specular .2 } }
#declare S2 = texture { pigment { color rgbt <1.,.5,.5,.35> } finish { ambient .3 diffuse .6 } }
polygon { 5, <-7.0710678e-1,-7.0710678e-1,-7.071e-1>, <7.0710678e-1,-7.0710678e-1,-7.071e-1>, <7.0710678e-1,7.0710678e-1,-7.071e-1>, <-7.0710678e-1,7.0710678e-1,-7.071e-1>, <-7.0710678e-1,-7.0710678e-1,-7.071e-1> texture { S1 } }
polygon { 4, <-.70710678,-.70710678,-.707107>, <.70710678,-.70710678,-.707107>, <0,0,1.>, <-.70710678,-.70710678,-.707107> texture { S2 } }
polygon { 4, <.70710678,-.70710678,-.707107>, <.70710678,.70710678,-.707107>, <0,0,1.>, <.70710678,-.70710678,-.707107> texture { S2 } }
polygon { 4, <.70710678,.70710678,-.707107>, <-.70710678,.70710678,-.707107>, <0,0,1.>, <.70710678,.70710678,-.707107> texture { S2 } }
polygon { 4, <-.70710678,.70710678,-.707107>, <-.70710678,-.70710678,-.707107>, <0,0,1.>, <-.70710678,.70710678,-.707107> texture { S2 } }
polygon { 11, <1.,0,-.5>, <.3090,.2245,-.5>, <.3090,.9511,-.5>, <-.1180,.3633,-.5>, <-.8090,.5878,-.5>, <-.3820,0,-.5>, <-.8090,-.5878,-.5>, <-.1180,-.3633,-.5>, <.3090,-.9511,-.5>, <.3090,-.2245,-.5>, <1.,0,-.5> texture { S1 } scale <1.6,1.6,1.> }
#declare edge = texture { pigment { color rgb <0.,0.,0.> } }
cylinder { <-.70710678,-.70710678,-.707107>, <0,0,1.>, 1.5e-2 texture { edge } }
cylinder { <.70710678,-.70710678,-.707107>, <0,0,1.>, 1.5e-2 texture { edge } }
cylinder { <.70710678,.70710678,-.707107>, <0,0,1.>, 1.5e-2 texture { edge } }
cylinder { <-.70710678,.70710678,-.707107>, <0,0,1.>, 1.5e-2 texture { edge } }
sphere { <0,0,1.>, 6.e-2 texture { pigment { color rgb <1.,0.,0.> } finish { phong 1. } } }
