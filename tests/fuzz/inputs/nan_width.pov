#debug str(1, 1e308*10 - 1e308*10, 0)
#debug vstr(2, x, ",", 1e308*10 - 1e308*10, 0)
