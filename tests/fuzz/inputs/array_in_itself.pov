#declare A = array[1]
#while (1) #declare A[0] = A; #end
