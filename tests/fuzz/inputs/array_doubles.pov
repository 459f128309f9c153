#declare A = array[2] {1, 2}
#while (1) #declare A = array[2] {A, A} #end
