#include "colors.inc"
#include "metals.inc"
camera { location <0,2,-6> look_at <0,.1,0> angle 48 }
light_source { <-5,8,-6> White }
background { Gray20 }
julia_fractal { <-0.083,0.0,-0.83,-0.025> quaternion sqr max_iteration 8 precision 15 pigment { Orange } finish { phong .7 } rotate -30*y translate -1.6*x }
julia_fractal { <-.162,.163,.56,-.599> hypercomplex cube max_iteration 6 precision 30 slice <0,0,0,1>, 0.1 texture { T_Brass_2B } scale .9 rotate <20,40,0> translate 1.4*x }
plane { y,-1.4 pigment { julia <.36,.25>, 40 interior 1, 1 exterior 2, .5 color_map { [0 Navy] [.3 SkyBlue] [1 White] } rotate 90*x scale 1.6 } finish { ambient .3 } }
box { <-3,-1.4,2>,<3,2,2.1> pigment { magnet 1 mandel 40 color_map { [0 Black] [.2 Red] [1 Yellow] } scale .8 } finish { ambient .4 } }
