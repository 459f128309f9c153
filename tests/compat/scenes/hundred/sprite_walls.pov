// wall tiles; which neighbours exist is a number from the clock's bits
#ifndef (Tile_North) #declare Tile_North	= 1; #end
#declare Tile_East	= 1;			// ...
#declare Tile_South	= 0;
#declare Tile_West	= 1;
#declare W = 2; #declare H = 1.6; #declare T = .3;
#declare Left_Vector	= vnormalize(<-1,0,1>)*3.2;
#declare Up_Vector	= y*2.6;
camera { orthographic location <20,16.33,-20> look_at <0,1.9,0> up 7.2*y right 9.6*x }
light_source { <20,40,5> rgb 1 parallel point_at 0 }
light_source { <0,20,-40> rgb .5 parallel point_at 0 shadowless }
background { rgb <.4,.4,.5> }
#macro Wall(N,E,S,West,pig)
  union {
    box { <-T,0,-T>, <T,H,T> }
    #if (N) box { <-T,0,0>, <T,H,W/2> } #end
    #if (E) box { <0,0,-T>, <W/2,H,T> } #end
    #if (S) box { <-T,0,-W/2>, <T,H,0> } #end
    #if (West) box { <-W/2,0,-T>, <0,H,T> } #end
    texture { pig }
  }
#end
#macro Pipe(N,E,S,West)
  union { sphere { H/2*y, T } #if (N) cylinder { H/2*y, <0,H/2,W/2>, T } #end #if (E) cylinder { H/2*y, <W/2,H/2,0>, T } #end
  #if (S) cylinder { H/2*y, <0,H/2,-W/2>, T } #end #if (West) cylinder { H/2*y, <-W/2,H/2,0>, T } #end
  pigment { rgb <.8,.3,.3> } normal { gradient x .6 sine_wave scale .15 } finish { phong .5 } }
#end
object { Wall(Tile_North,Tile_East,Tile_South,Tile_West, texture { pigment { brick rgb .8, rgb <.6,.3,.2> scale .08 } }) translate Left_Vector }
object { Wall(0,1,1,0, texture { pigment { crackle turbulence .2 color_map { [0 rgb .2] [.1 rgb .6] [1 rgb .75] } scale .3 } }) }
object { Wall(1,1,1,1, texture { pigment { gradient y color_map { [.5 rgb <.7,.6,.3>] [.5 rgb <.5,.4,.2>] } scale .4 } }) translate -Left_Vector }
object { Pipe(Tile_North,Tile_East,Tile_South,Tile_West) translate Left_Vector*.5+Up_Vector }
object { Pipe(1,0,1,0) translate -Left_Vector*.5+Up_Vector }
