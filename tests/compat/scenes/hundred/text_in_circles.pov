#include "shapes.inc"
#include "colors.inc"
#include "strings.inc"
camera { location <0,2,-9> look_at <0,.3,0> angle 48 }
light_source { <-6,9,-12> White }
background { rgb <.15,.1,.2> }
object { Circle_Text("timrom.ttf", "Circles of letters", .6, .05, .3, 2.2, no, Align_Center, 90) pigment { Gold } finish { phong .6 } }
object { Circle_Text("cyrvetic.ttf", "from below", .45, 0, .2, 2.1, yes, Align_Center, -90) pigment { Coral } }
#declare T = text { ttf "crystal.ttf" concat("n=", str(7,4,1), " ", vstr(3, <1,2,3>, "/", 0, 0)) .2, 0 };
object { T scale .6 translate -x*.3*(max_extent(T).x-min_extent(T).x) pigment { SkyBlue } }
text { ttf "timrom.ttf", strupr("upper"), .3, <.08,0,0> pigment { Green } scale .5 translate <-1,-.8,0> }
text { ttf "timrom.ttf" strlwr("LOWER") .3, 0 pigment { Red } scale .5 rotate -20*y translate <-.6,.8,0> }
object { Bevelled_Text("timrom.ttf", "B", 6, 35, .05, .4, .1, 0) pigment { White } translate <1,-1.6,-1> }
text { ttf "timrom.ttf" "AVAVA To \"q\" \\" .1, 0 pigment { Orange } scale .4 translate <-2.8,-1.7,0> }
