#declare F = function { sum(i, 1, 1e17, i) + prod(j, -1e300, 0/0, j) }
#debug str(F(1,2,3),0,0)
