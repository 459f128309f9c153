// data written and read again; then parsed by hand
#include "colors.inc"
#fopen Out "table_of_text_files_between.txt" write
#declare i = 0;
#while (i < 10)
  #write (Out, i, ",", sin(i)*1.5, ",<", cos(i), ",", i/10, ",", mod(i,3)/2, ">,\"row ", i, "\",\n")
  #declare i = i+1;
#end
#fclose Out
#fopen In "table_of_text_files_between.txt" read
#while (defined(In))
  #read (In, Number, Height, Colour, Name)
  box { <Number*.8-4,-1.7,-.3>, <Number*.8-3.4,Height,.3> pigment { rgb <abs(Colour.x),Colour.y,Colour.z> } }
  text { ttf "cyrvetic.ttf" Name .02, 0 scale .22 translate <Number*.8-4,Height+.1,-.31> pigment { Black } }
#end
plane { y,-1.7 pigment { Gray90 } } background { White }
light_source { <-6,12,-14> White } light_source { <9,4,-14> Gray40 shadowless }
camera { location <.5,2,-9> look_at <-.2,0,0> angle 50 }
