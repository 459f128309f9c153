#declare Checker = function { pattern { checker } }
#declare Brick = function { pattern { brick } }
#debug concat(str(Checker(.5, .2, 1e20), 0, 6), str(Checker(-1e300, 1e300, -1e20), 0, 6), str(Brick(1e20, -1e20, .5), 0, 6))
