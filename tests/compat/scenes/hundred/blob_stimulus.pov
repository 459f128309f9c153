  #include "colors.inc"  background{Black}  camera{ angle 17 location <0,0,-10> look_at 0 }   // stimulus no. 3
  #declare lamp_x=-5; #declare lamp_y=9; #declare lamp_z=-9;    light_source{ <lamp_x, lamp_y, lamp_z> color White }
  #declare Stim = blob{ threshold .3
    sphere{ 0,.9,1 scale <1.3,.7,.9> rotate <0,0,-20> }   sphere{ 0,.7,1 translate <.7,.5,0> }    // ears
      	sphere{ <-.6,.6,.1>,.6,1 }    cylinder{ <0,-.2,-.3>, <.2,-.9,-.5>, .5, 1 scale <1,1.1,1> }
    sphere{ <.1,.1,-.8>,.4,-.8 }    // dent
}    object{ Stim  rotate <5,-25,0>   	translate <0,-.1,0>  scale <1.1 1 1.1>   	pigment{White}    finish{ phong 0 ambient .35 //.3
       diffuse .65 }   }
  sphere{ <-1.1,-.9,0>,.15 pigment{Gray50} finish{ ambient .35 diffuse .65 } }
  box{ <.9,-1.1,-.1>,<1.2,-.8,.1> pigment{Gray50} finish{ ambient .35 diffuse .65 } rotate <0,0,0> }
