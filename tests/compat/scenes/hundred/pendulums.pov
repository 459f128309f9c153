#include "metals.inc"
// a row of pendulums of growing length; an instant of their swing by clock
camera{ location <11,-22,4> sky z up z right 4/3*x look_at <0,-5,-3.4> angle 34 }
light_source{ <40,-60,90> rgb 1 }
light_source{ <-40,-20,30> rgb .3 }
#declare seconds = 2.3 + clock;
#macro bob(len, swing)
    union{
        cylinder{ 0, -len*z, .05 texture{T_Brass_3A} }
        sphere{ -len*z, .45 texture{T_Chrome_2D} }
        torus{ .12,.04 texture{T_Copper_1A} }
        rotate swing*y
    }
#end
#declare num=0;
#while (num<12)
    #declare len = 2.2+num*.38;
    object{ bob(len, 26*cos(sqrt(98/len)*seconds)) translate -num*1.1*y }
    #declare num=num+1;
#end
cylinder{ <0,.6,0>,<0,-12.8,0>,.1 texture{T_Silver_2B} }
plane{ z,-8 pigment{ checker rgb .95 rgb .4 scale 2 } }
