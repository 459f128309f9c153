#declare A = array[1e9][1e9];
