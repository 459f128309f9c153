#version 3.7;
#declare O=blob{threshold .5 sphere{0,1,2} sphere{x,1,-2}}
#fopen W "o.txt" write
#write(W,vstr(3,min_extent(O)," ",0,4)," ",vstr(3,max_extent(O)," ",0,4),"\n")
