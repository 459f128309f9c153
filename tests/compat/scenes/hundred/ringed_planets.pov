#include "colors.inc"
#include "stars.inc"
global_settings { ambient_light rgb .3 }
// sun outside the picture; planets by a macro, orbits as thin toruses
#macro Planet(dist, rad, day, pig, ring)
  union {
    sphere { 0, rad pigment { pig } finish { diffuse .9 } }
    #if (ring)
      disc { 0, y, rad*2.3, rad*1.3
        pigment { wood color_map { [0 rgbt 1] [.1 rgbt <.9,.8,.6,.2>] [.5 rgbt <.6,.5,.4,.6>] [.55 rgbt 1] [.6 rgbt <.9,.85,.7,.1>] [1 rgbt 1] } rotate 90*x scale rad*.7 } }
    #end
    rotate <25,0,10> translate dist*x rotate day*y
  }
  torus { dist, .01 pigment { Gray50 } finish { ambient 1 diffuse 0 } }
#end
sphere { 0, .8 pigment { Yellow } finish { ambient 4 diffuse 0 } no_shadow }
light_source { 0, rgb 1.2 }
Planet(1.8, .18, 30, pigment { Orange }, no)
Planet(2.8, .3, -70, pigment { bozo turbulence .6 color_map { [.5 Blue] [.5 ForestGreen] [.8 Tan] } scale .2 }, 0)
Planet(4.2, .55, -100, pigment { gradient y turbulence .1 color_map { [0 Wheat] [.4 Tan] [.6 Brown] [1 Wheat] } scale .3 }, yes)
Planet(5.4, .35, 60, pigment { agate color_map { [0 SkyBlue] [1 Navy] } scale .4 }, on)
sphere { 0, 900 hollow texture { Starfield1 scale 40 } }
camera { location <0,4,-9> look_at <0,-.2,0> angle 52 }
