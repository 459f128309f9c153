#declare P = pigment { #default { pigment { rgb 1 } } rgb 0 }
#declare N = normal { #default { normal { bumps 1 } } dents 1 }
#declare F = finish { #default { finish { ambient 1 } } diffuse 0 }
#declare T = texture { #default { texture { pigment { rgb 1 } normal { waves 1 } finish { phong 1 } } } pigment { rgb 0 } normal { #default { normal { bumps 1 } } dents 1 } finish { #default { finish { ambient 1 } } diffuse 0 } }
sphere { 0, 1 #default { texture { pigment { rgb 1 } } } pigment { #default { pigment { rgb .5 } } rgb 0 } }
#default { pigment { #default { pigment { rgb .2 } } rgb .3 } }
