#include "functions.inc"
#debug str(f_ridged_mf(1,2,3,1,2,1e10,1,2,2),0,3)
#debug str(f_hetero_mf(1,2,3,1,2,1e10,1,1e9,2),0,3)
