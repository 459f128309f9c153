"""Scenes of tests/stability/shapes.py: a shape in a hard setting, and what the picture should be.

A case is (shape, group, setting, scene, truth). The truth is a list of easy scenes that differ by a
millionth (lentray renders them; where they do not agree on a pixel there is no truth), or a function
(column, row) -> colour, None where there is no truth.
"""
import collections

from shape_list import CLOSED, REACH, SHAPES

Case = collections.namedtuple("Case", "shape group setting scene truth")

SIZE = 65  # odd: the middle row and column of an orthographic camera lie in its axes
WHITE, BLACK, RED = (255, 255, 255), (0, 0, 0), (255, 0, 0)
HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
BRIGHT = "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }"


NEAR_LIGHTS = "light_source { <-4,7,-6>*S + O, rgb 1 } light_source { <5,3,-2>*S + O, rgb .3 }\n"
FAR_LIGHTS = ("light_source { <-4,7,-6>*100*max(S,1), rgb 1 shadowless }"
              " light_source { <5,3,-2>*100*max(S,1), rgb .3 shadowless }\n")


def lit(sdl, camera, scale="1", offset="0", lights=NEAR_LIGHTS):
    """The shape under two lights, everything scaled and then moved."""
    return (HEAD + f"#declare S = {scale}; #declare O = {offset};\n" + camera + lights +
            "object { " + sdl + " pigment { rgb <.9,.5,.3> } finish { ambient .2 diffuse .7 }"
            " scale S translate O }\n")


def flat(objects, camera):
    return HEAD + camera + objects + "\n"


def perspective(location="<2.2,2.6,-4>", look_at="0", shift="0"):
    return (f"camera {{ location {location}*S + O + {shift}*S look_at {look_at}*S + O + {shift}*S"
            " angle 42 right x up y }\n")


def along(location, sky="y", width=3.25, shift="0"):
    """Orthographic, towards the origin."""
    return (f"camera {{ orthographic location {location} + {shift} sky {sky} right {width}*x up {width}*y"
            f" look_at {shift} }}\n")


SHIFTS = ["0", "<1e-6,2e-6,-1.5e-6>", "<-1e-6,-2e-6,1.5e-6>", "<2e-6,-1e-6,1e-6>", "<-2e-6,1e-6,-1e-6>"]


def scales(name, sdl):
    """The shape scaled, seen from 5 units away by an orthographic camera of its size."""
    view = "<.55,.65,-1>*4"

    def scene(scale, shift="0"):
        return lit(sdl, f"camera {{ orthographic location {view}*max(S,1) + {shift}*S look_at {shift}*S"
                   " right 3.25*x*S up 3.25*y*S }\n", scale, lights=FAR_LIGHTS)

    for scale in ("1e-6", "1e-4", "1e-2", "1e2", "1e4", "1e6"):
        yield Case(name, "scale", scale, scene(scale), [scene("1", s) for s in SHIFTS])


def whole_scenes(name, sdl):
    """Shape, camera and lights scaled alike."""
    easy = [lit(sdl, perspective(shift=s)) for s in SHIFTS]
    for scale in ("1e-5", "1e-4", "1e-2", "1e3", "1e5", "1e7"):
        yield Case(name, "scene", scale, lit(sdl, perspective(), scale), easy)
    yield Case(name, "plain", "1", lit(sdl, perspective()), easy)


def far_origins(name, sdl):
    easy = [lit(sdl, perspective(shift=s)) for s in SHIFTS]
    for far in ("1e3", "1e5", "1e7"):
        yield Case(name, "far", far, lit(sdl, perspective(), "1", f"<1,-.7,.6>*{far}"), easy)


def far_cameras(name, sdl):
    view = "<.55,.65,-1>"
    easy = [lit(sdl, along(view + "*5", shift=s)) for s in SHIFTS]
    for far in ("1e3", "1e6", "1e7"):
        yield Case(name, "camera", far, lit(sdl, along(f"{view}*{far}")), easy)


def axes(name, sdl):
    for axis, location, sky in (("x", "5*x", "y"), ("y", "5*y", "z"), ("z", "-5*z", "y")):
        turned = [lit(sdl, along(f"{location} + {s}*.001", sky, shift=t))
                  for s in SHIFTS[1:3] for t in SHIFTS]
        yield Case(name, "axis", axis, lit(sdl, along(location, sky)), turned)


def in_planes(name, sdl):
    for setting, location, look_at in (("y = 0", "<3,0,-4>", "0"), ("y = 1", "<3,1,-4>", "y"),
                                       ("x = 1", "<1,3,-4>", "x")):
        easy = [lit(sdl, perspective(location, look_at, s)) for s in SHIFTS[1:]]
        yield Case(name, "plane", setting, lit(sdl, perspective(location, look_at)), easy)


def inside(name, sdl):
    """All around from within a closed shape nothing but the shape is seen."""
    if name not in CLOSED:
        return
    camera = f"camera {{ spherical location {CLOSED[name]} look_at {CLOSED[name]} + z angle 360 180 }}\n"
    yield Case(name, "inside", "all around", flat(f"object {{ {sdl} {BRIGHT} }}", camera),
               lambda column, row: WHITE)


def on_surface(name, sdl):
    """From a point of the surface outwards and inwards; the truth starts beside it."""
    if name == "smooth_triangle":  # its normal does not say where out is
        return
    find = (f"#declare Thing = object {{ {sdl} }};\n#declare N = <0,0,0>;\n"
            "#declare P = trace(Thing, <2.2,2.6,-4>, <-.5,-.6,1>*.97 - <.02,.01,.03>, N);\n"
            "#if (vlength(N) = 0) #declare P = trace(Thing, <2.2,2.6,-4>, <-3,-2.8,3.7>, N); #end\n"
            "#if (vlength(N) = 0) #declare P = trace(Thing, <2.2,2.6,-4>, <-1.2,-2.65,4.05>, N); #end\n"
            "#if (vdot(N, <2.2,2.6,-4>) < 0) #declare N = -N; #end\n")

    def scene(side, away):
        return (HEAD + find + f"camera {{ location P + {away}*N look_at P + {away}*N + {side}*N"
                " angle 80 right x up y }\n object { Thing " + BRIGHT + " }\n")

    for setting, side, moved in (("outwards", "1", ("3e-4", "1e-3", "2e-3")),
                                 ("inwards", "-1", ("-3e-4", "-1e-3", "-2e-3"))):
        yield Case(name, "surface", setting, scene(side, "0"), [scene(side, m) for m in moved])


def coincident(name, sdl):
    """A green copy a little further from the eye must not show."""
    view = "<.55,.65,-1>"
    red = f"object {{ {sdl} pigment {{ rgb x }} finish {{ ambient 0 diffuse 0 emission 1 }} }}"
    easy = [flat(red, along(view + "*5", shift=s)) for s in SHIFTS]
    for gap in ("1e-3", "1e-5", "1e-7", "1e-9"):
        green = (f"object {{ {sdl} pigment {{ rgb y }} finish {{ ambient 0 diffuse 0 emission 1 }}"
                 f" translate -{gap}*vnormalize({view}) }}")
        yield Case(name, "gap", gap, flat(green + red, along(view + "*5")), easy)


def silhouette(name, sdl):
    """A view so narrow that the silhouette is a straight line through its middle."""
    if name not in REACH:
        return
    for width in ("1e-2", "1e-4", "1e-6", "1e-8"):
        camera = (f"camera {{ orthographic location <{REACH[name]},0,-5> direction z right {width}*x"
                  f" up {width}*y }}\n")

        def truth(column, row):
            if abs(column - SIZE // 2) <= 1:
                return None
            return WHITE if column < SIZE // 2 else BLACK

        yield Case(name, "grazing", width, flat(f"object {{ {sdl} {BRIGHT} }}", camera), truth)


def thin_tori():
    for minor in (1e-2, 1e-4, 1e-6):
        torus = f"object {{ torus {{ 1, {minor:g} }} {BRIGHT} }}"
        step = 4.0 * minor / SIZE

        def from_above(column, row, minor=minor, step=step):
            x = abs(column - SIZE // 2) * step
            return None if abs(x - minor) < 1.5 * step else WHITE if x < minor else BLACK

        def along_tube(column, row, minor=minor, step=step):
            x, y = (column - SIZE // 2) * step, (SIZE // 2 - row) * step
            out = abs(y) if x < 0 else (x * x + y * y) ** 0.5
            return None if abs(out - minor) < 1.5 * step else WHITE if out < minor else BLACK

        wide = f"{4.0 * minor:g}"
        for setting, view, truth in (("from above", "<1,5,0> direction -y right x*W up z*W", from_above),
                                     ("along the tube", "<1,0,-5> direction z right x*W up y*W", along_tube)):
            camera = f"camera {{ orthographic location {view.replace('W', wide)} }}\n"
            yield Case("torus", "thin", f"{minor:g} {setting}", flat(torus, camera), truth)


def slivers():
    """A square of triangles that meet in one corner, and shapes with points that coincide."""
    camera = "camera { orthographic location <.5,.5,-5> direction z right .9*x up .9*y }\n"
    for count in (10, 1000, 100000):
        square = (f"mesh {{ #local I = 0; #while (I < {count}) #local A = I/{count}; #local B = (I + 1)/{count};"
                  " triangle { 0, <1,A,0>, <1,B,0> } triangle { 0, <A,1,0>, <B,1,0> }"
                  f" #local I = I + 1; #end {BRIGHT} }}")
        yield Case("mesh", "degenerate", f"{count} slivers", flat(square, camera), lambda c, r: WHITE)
    twice = {
        "prism": ("prism { -.5, .7, 6 <-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1> }",
                  "prism { -.5, .7, 8 <-1,-1>,<1,-1>,<1,-1>,<1,1>,<0,.2>,<0,.2>,<-1,1>,<-1,-1> }"),
        "lathe": ("lathe { 4 <0,-.9>,<.9,-.6>,<.4,0>,<0,.9> }",
                  "lathe { 6 <0,-.9>,<.9,-.6>,<.9,-.6>,<.4,0>,<.4,0>,<0,.9> }"),
        "sphere_sweep": ("sphere_sweep { linear_spline 3 <-1,0,0>,.3 <0,.5,0>,.2 <1,0,0>,.3 }",
                         "sphere_sweep { linear_spline 4 <-1,0,0>,.3 <0,.5,0>,.2 <0,.5,0>,.2 <1,0,0>,.3 }"),
        "polygon": ("polygon { 5, <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> }",
                    "polygon { 7, <-1,-1>,<1,-1>,<1,-1>,<1,1>,<1,1>,<-1,1>,<-1,-1> }"),
        "triangle": ("triangle { -x, x, y }", "union { triangle { -x, x, y } triangle { -x, -x, y }"
                                              " triangle { -2*x, -2*x, -2*x } triangle { -2*x, 0, 2*x + y*1e-30 } }"),
        "mesh": ("mesh { triangle { -x, x, y } }",
                 "mesh { triangle { -x, x, y } triangle { -x, -x, y } triangle { -2*x, -2*x, -2*x } }"),
        "lathe_cubic": ("lathe { cubic_spline 6 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<0,.9>,<.2,1> }",
                        "lathe { cubic_spline 6 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,1e-12>,<0,.9>,<.2,1> }"),
        "sphere": ("sphere { 0, 1 }", "union { sphere { 0, 1 } sphere { <.3,1.5,.1>, 0 } cylinder { <.31,0,.17>, <.31,2,.17>, 0 } }"),
        "box": ("box { -1, 1 }", "union { box { -1, 1 } box { <.31,0,.17>, <.31,2,.17> } }"),
    }
    for name, (plain, doubled) in twice.items():
        easy = [lit(plain, perspective(shift=s)) for s in SHIFTS]
        yield Case(name, "degenerate", "points twice", lit(doubled, perspective()), easy)


PER_SHAPE = [whole_scenes, scales, far_origins, far_cameras, axes, in_planes, inside, on_surface, coincident, silhouette]


def all_cases():
    for name, sdl in SHAPES.items():
        for make in PER_SHAPE:
            yield from make(name, sdl)
    yield from thin_tori()
    yield from slivers()
