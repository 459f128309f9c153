// three fractal carpets on a floor of boards
camera {
    location <0, 5, -4>
    look_at <0, 0, 0.3>
    angle 52
  }
light_source{<-6,11,-5> rgb 1}
#declare Dyes = color_map { [0.02 rgb <0.9,0.8,0.6>] [0.15 rgb <0.6,0.1,0.1>] [0.5 rgb <0.1,0.1,0.3>] [1 rgb 0] }
#declare Set_A = pigment { mandel 50 color_map { Dyes } translate 0.6*x scale 0.8 rotate 90*x }
#declare Set_B = pigment { julia <-0.75, 0.11>, 40 exterior 1, 1.2 color_map { Dyes } scale 0.7 rotate 90*x }
#declare Set_C = pigment { magnet 2 julia <0.5, 0.9>, 30 interior 2, 1 color_map { Dyes } scale 0.5 rotate 90*x }
box { <-1.1,0,-1>,<1.1,.05,1> texture { Set_A } }
box { <-1,0,-1>,<1,.05,1> texture { Set_B } translate <-2.4,0,0.4> }
cylinder { 0, .05*y, 1 texture { Set_C } translate <2.4,0,0.5> }
plane { y, 0 pigment { gradient x color_map { [0 rgb <.5,.35,.2>] [.95 rgb <.45,.3,.15>] [.95 rgb .1] } scale .5 } }
