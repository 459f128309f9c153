#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "colors.inc"
#include "metals.inc"
camera { perspective angle 50 location <1.5, 1, -10> look_at <0, 0, 0> right x*image_width/image_height }
light_source { <-6, 3, -7> color White }
light_source { <5, 6, -9> color Gray40 }
// a macro gives back a whole object; the filter stands behind a colour of four parts
#macro Signal(Farbe, Form)
	difference {
		sphere { 0, 0.9
			texture { pigment { color Farbe filter 0.85 } finish { ambient 0.05 phong 0.9 phong_size 70 } }
			interior { ior 2.2 }
		}
		#switch (Form)
			#case (1) superellipsoid { <0.3, 0.1> scale <0.6, 0.15, 1> translate -z } #break
			#case (2) cylinder { -2*z, -0.4*z, 0.35 } #break
			#else cone { -1.2*z, 0.6, 0, 0 }
		#end
	}
#end
difference {
	superellipsoid { <0.1, 0.05> scale <4.4, 1.6, 1> texture { T_Chrome_2A normal { bumps -0.3 scale <2, 0.05, 1> } finish { phong .5 } } }
	#for (i, -1, 1) sphere { <i*2.6, 0, -1.2>, 1 } #end
	translate 0.9*z
}
object { Signal(<1, 0.1, 0, 0>, 1) translate -2.6*x }
object { Signal(<1, 0.6, 0, 1>, 2) }
object { Signal(<0, 0.9, 0.3, 1>, 3) translate 2.6*x }
