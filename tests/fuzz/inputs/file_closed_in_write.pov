#fopen F "t.txt" write #write (F, 1 #fclose F, 2)
#macro M(A) #read (A, B #fclose A, C) #end
#fopen G "t.txt" read M(G)
