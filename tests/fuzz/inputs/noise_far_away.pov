#include "functions.inc"
#debug str(f_hetero_mf(-1e308, 0, 0, 1, 0.5, 1e308, 0.8, 0.3, 3), 0, 3)
#debug str(f_ridged_mf(1e308, -1e308, 0, 1, 2, 6, 0.8, 0.3, 1), 0, 3)
#debug str(f_noise_generator(1e300, 0, -1e308, 2), 0, 3) #debug str(f_noise_generator(1e300, 0, -1e308, 3), 0, 3) #debug str(f_noise_generator(1e300, 0, -1e308, 1), 0, 3)
