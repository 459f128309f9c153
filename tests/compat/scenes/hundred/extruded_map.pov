// provinces as prisms, the height a figure of a table; focal_point and aperture, but no blur_samples
/* global_settings { radiosity { count 50 } } */
#declare Tallest = 20;
camera { location <-30, 110, -120> right 4/3*x up y look_at <4, 0, 4> angle 36 aperture 0.4 focal_point <0, 5, 0> }
light_source { <-120, 240, -60> color rgb <1.0 1.0 1.0> }
light_source { <160, 120, -100> color rgb 0.4 shadowless }
#macro Tint(h) texture { pigment { color rgb <h/Tallest, 0.75-0.6*h/Tallest, 0.25> } finish { ambient .25 diffuse .7 specular .2 } } #end
// coast
prism { linear_spline -1, 0.5, 9, <-52,-18>, <-30,-40>, <8,-36>, <44,-30>, <58,4>, <40,38>, <2,44>, <-44,26>, <-52,-18> pigment { rgb <.85,.8,.65> } }
prism { linear_spline 0, 14.25, 7, <-46.5,-16>, <-28.125,-34.5>, <-4,-30>, <-8.2,-6>, <-24,2.75>, <-41,-1>, <-46.5,-16> Tint(14.25) }
prism { linear_spline 0, 7, 6, <-2,-30>, <38,-25.5>, <44,-8>, <14,-2>, <-6,-6>, <-2,-30> Tint(7) }
// a province with an enclave
prism { linear_spline 0, 3.5, 12, <-38,4>, <-22,6>, <-5,0>, <12,4>, <8,36>, <-36,22>, <-38,4>,  <-14,12>, <-2,12>, <-4,24>, <-16,22>, <-14,12> Tint(3.5) }
prism { linear_spline 0, 18, 5, <-13.5,12.5>, <-2.5,12.5>, <-4.5,23.5>, <-15.5,21.5>, <-13.5,12.5> Tint(18) }
prism { linear_spline 0, 11, 6, <15,2>, <46,-4>, <52,8>, <36,33>, <11,36>, <15,2> Tint(11) }
plane { y, -0.5 pigment { color rgb <.55,.7,.9> } finish { ambient .2 diffuse .6 specular .6 roughness .002 reflection { .12 } } }
