#declare O = sphere { 0, 1 }
#while (1) #declare O = union { object { O } object { O } } #end
