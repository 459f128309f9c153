"""The shapes that tests/stability/shapes.py tries: SDL of about unit size about the origin.

CLOSED holds a point within, for shapes that enclose one. REACH says how far along x a round or flat
shape reaches, where its silhouette seen along z is upright.
"""

PATCH = ("bicubic_patch { type 1 u_steps 3 v_steps 3 <-1.2,-.5,-1>,<-.5,.8,-1.2>,<.5,-.6,-1>,<1.2,.4,-1>,"
         "<-1.2,.3,-.4>,<-.5,-.5,-.3>,<.5,1.5,-.4>,<1.2,0,-.2>,<-1.2,-.4,.4>,<-.4,.9,.3>,<.4,-.8,.5>,"
         "<1.2,.7,.4>,<-1.2,.5,1.1>,<-.5,-.2,1>,<.5,.6,1.2>,<1.2,-.3,1> }")
OUTLINE = "<-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1>"
CURVED = "<0,1>,<-1,-1>,<1,-1>,<1,.4>,<0,1>,<-1,-1>,<1,-1>"


def octahedron(steps):
    """mesh2 of a sphere: an octahedron whose faces are cut into steps^2 triangles."""
    points, faces = {}, []

    def index(p):
        size = sum(c * c for c in p) ** 0.5
        return points.setdefault(tuple(c / size for c in p), len(points))

    for sx in (1, -1):
        for sy in (1, -1):
            for sz in (1, -1):
                def corner(i, j):
                    return index((sx * i, sy * j, sz * (steps - i - j)))

                for i in range(steps):
                    for j in range(steps - i):
                        faces.append((corner(i, j), corner(i + 1, j), corner(i, j + 1)))
                        if i + j < steps - 1:
                            faces.append((corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)))
    vertices = ",".join("<%.17g,%.17g,%.17g>" % p for p in points)
    triangles = ",".join("<%d,%d,%d>" % f for f in faces)
    return ("mesh2 { vertex_vectors { %d, %s } face_indices { %d, %s } }"
            % (len(points), vertices, len(faces), triangles))


SHAPES = {
    "sphere": "sphere { 0, 1 }",
    "box": "box { -1, 1 }",
    "cylinder": "cylinder { -y, y, .8 }",
    "cylinder_open": "cylinder { -y, y, .8 open }",
    "cone": "cone { -y, 1, y, .3 }",
    "cone_point": "cone { -y, 1, y, 0 }",
    "torus": "torus { .9, .3 }",
    "torus_thin": "torus { 1, .04 }",
    "disc": "disc { 0, y, 1.2, .4 }",
    "plane": "plane { y, 0 clipped_by { box { -1, 1 } } }",
    "triangle": "triangle { <-1,-.4,-1>, <1.2,0,-.3>, <0,.8,1> }",
    "smooth_triangle": "smooth_triangle { <-1,-.4,-1>, y, <1.2,0,-.3>, <1,1,0>, <0,.8,1>, <0,1,1> }",
    "mesh2": octahedron(6),
    "polygon": "polygon { 10, <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> <-.3,-.7>,<.3,-.7>,<.2,.2>,<-.2,.1>,"
               "<-.3,-.7> rotate 50*x }",
    "bicubic_patch": PATCH,
    "quadric": "quadric { <1,2,1.5>, <.2,.1,0>, <0,.1,0>, -1 }",
    "quadric_hyperboloid": "quadric { <1,-1,1>, 0, 0, -.3 clipped_by { box { -1, 1 } } }",
    "quartic": "quartic { <1,0,0,0,2,0,0,2,0,-2.32,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.68,0,0,0,0,"
               "1,0,-2.32,0,.7056> }",
    "cubic": "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0,0,-.3,0,0> clipped_by { sphere { 0, 1.3 } } }",
    "blob": "blob { threshold .5 sphere { <.4,0,0>, 1, 1 } cylinder { <-1,-.2,0>, <.5,.9,.2>, .6, 1.1 } "
            "sphere { <0,.5,-.5>, .5, -.8 } }",
    "superellipsoid": "superellipsoid { <.3,.5> }",
    "superellipsoid_sharp": "superellipsoid { <1.8,.2> }",
    "ovus": "ovus { .8, .45 translate -.3*y }",
    "lathe_linear": "lathe { 5 <0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }",
    "lathe_cubic": "lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }",
    "sor": "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }",
    "prism_linear": "prism { -.5, .7, 6 " + OUTLINE + " }",
    "prism_cubic": "prism { cubic_spline -.5, .6, 7 " + CURVED + " }",
    "prism_conic": "prism { conic_sweep linear_spline .2, 1, 5 <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> "
                   "translate -.6*y }",
    "sphere_sweep": "sphere_sweep { linear_spline 4 <-1,-.6,0>,.3 <0,.8,-.3>,.15 <.9,-.4,.4>,.4 "
                    "<1.1,.6,0>,.1 }",
    "sphere_sweep_cubic": "sphere_sweep { cubic_spline 5 <-2,0,0>,.2 <-1,-.6,0>,.3 <0,.8,-.3>,.15 "
                          "<.9,-.4,.4>,.4 <1.2,.6,0>,.1 tolerance 1e-5 }",
    "isosurface": "isosurface { function { x*x + y*y*2 + z*z - 1 + .1*sin(x*15)*sin(z*14) } "
                  "max_gradient 6 contained_by { box { -1.2, 1.2 } } }",
    "height_field": "height_field { function 40, 30 { .5 + .4*sin(x*9)*cos(y*8) } "
                    "scale <2.4,1.2,2.4> translate <-1.2,-.6,-1.2> }",
    "julia_fractal": "julia_fractal { <-.083,0,-.83,-.025> quaternion sqr max_iteration 6 "
                     "precision 100 scale .8 }",
    "parametric": "parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) } "
                  "<0,0>, <pi,2*pi> contained_by { box { -1.1, 1.1 } } accuracy .01 max_gradient 6 "
                  "precompute 14, x, y, z }",
    "text": "text { ttf \"cyrvetic.ttf\" \"R&g\" .4, 0 scale 1.3 translate <-1.1,-.4,-.2> }",
    "difference": "difference { box { -1, 1 } sphere { 0, 1.3 } cylinder { -2*y, 2*y, .4 } }",
}

CLOSED = {"sphere": "0", "box": "0", "cylinder": "0", "cone": "0", "cone_point": "-.3*y",
          "torus": "<.9,.05,.1>", "torus_thin": "<1,0,0>", "mesh2": "0", "quadric": "0",
          "quartic": "<1,.05,.1>", "blob": "<.3,.1,.1>", "superellipsoid": "0", "superellipsoid_sharp": "0", "ovus": "0",
          "lathe_linear": "<.05,.02,.01>", "lathe_cubic": "<.05,.02,.01>", "sor": "<.05,.02,.01>",
          "prism_linear": "<.1,.1,-.2>", "prism_cubic": "<.1,.1,-.2>", "prism_conic": "0",
          "sphere_sweep": "<0,.8,-.3>", "sphere_sweep_cubic": "<0,.8,-.3>", "isosurface": "0",
          "julia_fractal": "0", "parametric": "0", "difference": "<.95,.95,.95>"}

REACH = {"sphere": 1.0, "box": 1.0, "cylinder": 0.8, "torus": 1.2, "torus_thin": 1.04,
         "superellipsoid": 1.0, "quartic": 1.4}
