// recursion with objects that are declared again and again
#version 3.5;
#declare Hole = union { box{<-1,-1,-4><1,1,4>} box{<-1,-4,-1><1,4,1>} box{<-4,-1,-1><4,1,1>} }
#declare Holes = object { Hole scale 1/3 }
#declare S = 1/9;
#declare Level = 1;
#while (Level < 3)
  #declare Fine = union {
    #declare N = pow(3,Level);
    #declare I = 0;
    #while (I < N)
      #declare J = 0;
      #while (J < N)
        #declare P = <(I+.5)/N*2-1, (J+.5)/N*2-1, 0>;
        box { P+<-S,-S,-2>, P+<S,S,2> }
        box { P+<-S,-S,-2>, P+<S,S,2> rotate 90*x }
        box { P+<-S,-S,-2>, P+<S,S,2> rotate 90*y }
        #declare J = J+1;
      #end
      #declare I = I+1;
    #end
  }
  #declare Holes = union { object { Holes } object { Fine } }
  #declare S = S/3;
  #declare Level = Level+1;
#end
difference { box { -1, 1 } object { Holes } pigment { rgb <.8,.6,.3> } finish { ambient .15 } rotate 28*y }
camera { location <0.4,2.2,-4.2> look_at 0 angle 40 }
light_source { <-5,8,-7> rgb 1 }
light_source { <7,1,-7> rgb .3 }
