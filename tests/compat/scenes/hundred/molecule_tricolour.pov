// a surface in patches, each of which mixes the colours of its corners by mapped gradients
#declare Dull = finish { ambient 0.15 diffuse 0.75 }
// barycentric mix: in the patch's own axes x and y run along two sides
#macro Patch (A, B, C, CA, CB, CC)
  #local S = B-A; #local R = C-A; #local Q = vcross(S, R);
  triangle { A, B, C
    texture { pigment { average pigment_map {
        [1 gradient x color_map { [0 CA*1.5] [1 CB*3] }]
        [1 gradient y color_map { [0 CA*1.5] [1 CC*3] }]
        [1 gradient <1,1,0> color_map { [0 CA] [1 (CB+CC)/2] } scale 1.42]
      } scale 1.001 translate -0.0005
      matrix <S.x, S.y, S.z, R.x, R.y, R.z, Q.x, Q.y, Q.z, A.x, A.y, A.z> } finish { Dull } } no_shadow }
#end
camera { location <2,3.2,-5> look_at <0,-.1,0> right 4/3*x angle 40 }
light_source { <-5,8,-6> rgb 1 }
background { rgb <0.15,0.15,0.2> }
#declare Ht = function(a,b) { 0.6*exp(-a*a-b*b) - 0.3*exp(-pow(a-1,2)-pow(b+.8,2)) }
#macro At(i,j) <i*.4, Ht(i*.4,j*.4), j*.4> #end
#macro Hue(i,j) rgb <(i+4)/8, .3+Ht(i*.4,j*.4), (4-j)/8> #end
#declare i = -4;
#while (i < 4)
  #declare j = -4;
  #while (j < 4)
    Patch(At(i,j), At(i+1,j), At(i,j+1), Hue(i,j), Hue(i+1,j), Hue(i,j+1))
    Patch(At(i+1,j+1), At(i,j+1), At(i+1,j), Hue(i+1,j+1), Hue(i,j+1), Hue(i+1,j))
    #declare j = j+1;
  #end
  #declare i = i+1;
#end
