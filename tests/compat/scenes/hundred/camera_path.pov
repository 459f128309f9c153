#include "colors.inc"
#include "finish.inc"
// a film without frame numbers when it is rendered as a still; camera and aim on splines
#declare With_Mist = false; #declare With_Lamps = true;
#if (clock_on) #declare Now = frame_number/final_frame; #else #declare Now = .35; #end
#declare Fly = function { spline { natural_spline 0, <9,5,-10> .4, <2,3,-8> 1, <-9,7,-8> } }
#declare Aim = function { spline { cubic_spline -.2, <0,0,0> 0, <0,1,1> 1, <0,2,3> 1.2, <0,3,3> } }
camera { location Fly(Now) look_at Aim(Now) angle 52 }
#macro Panel(Word, Wide)
  #local n=0; #local Len=strlen(Word);
  union {
    box { <-Wide/2,0,.1>,<Wide/2,2.4,.3> pigment { Gray25 } finish { Dull } }
    #while (n<Len)
      cylinder { 0,-.1*z,.12 translate <-Wide/2+.3+n*(Wide-.6)/max(Len-1,1),.5+mod(asc(substr(Word,n+1,1)),6)*.3,.1>
        pigment { rgb <mod(n,3)/2,1-n/Len,.6> } finish { Luminous } }
      #local n=n+1;
    #end
  }
#end
object { Panel("travelling light", 6) translate <0,.4,3> }
#declare Gate = union { cylinder { 0,3*y,.2 } sphere { 3.2*y,.35 } pigment { Scarlet } finish { Shiny } }
object { Gate translate <-3.6,0,1> } object { Gate translate <3.6,0,1> }
#if (With_Mist) fog { distance 15 Gray80 } #end
#if (With_Lamps)
light_source { <600,900,-800> color rgb .7 }
light_source { <0,8,-4> color rgb .3 media_interaction off shadowless }
#end
plane { y,0 pigment { checker DimGray SlateBlue scale 1.5 } finish { Dull } }
