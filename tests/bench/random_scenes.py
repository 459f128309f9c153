"""Random scenes of everything that lentray renders, for same_pictures.py.

  python3 tests/bench/random_scenes.py SEED [NUMBER]     prints a scene, the one that same_pictures.py renders

scene(r) is a scene's text; `r` is a random.Random that chooses everything, so that a seed always gives the same. Solids
are about as large as a ball of radius 1 about 0, and stand on a floor between -4 and 4 before a camera.
"""
import random
import sys


def num(r, low, high, digits=3):
    return f"{r.uniform(low, high):.{digits}g}"


def vec(r, low, high):
    return "<" + ", ".join(num(r, low, high) for _ in range(3)) + ">"


def rgb(r):
    return "rgb <" + ", ".join(num(r, 0.05, 1) for _ in range(3)) + ">"


def maybe(r, chance, *texts):
    """One of the texts at times, else nothing."""
    return r.choice(texts) if r.random() < chance else ""


# Shapes: the text of one up to where its looks stand, without the last brace.

CUT = "clipped_by { sphere { 0, 1 } } bounded_by { clipped_by }"


def sphere(r):
    return f"sphere {{ {vec(r, -.3, .3)}, {num(r, .6, 1)} {maybe(r, .3, f'scale <1, {num(r, .4, 1.2)}, .8>')}"


def box(r):
    return f"box {{ {vec(r, -1, -.4)}, {vec(r, .4, 1)}"


def cylinder(r):
    return f"cylinder {{ {vec(r, -.9, -.3)}, {vec(r, .3, .9)}, {num(r, .2, .7)} {maybe(r, .2, 'open')}"


def cone(r):
    return f"cone {{ -.9*y, {num(r, .3, .9)}, {num(r, .3, 1)}*y, {num(r, 0, .5)} {maybe(r, .2, 'open')}"


def torus(r):
    return f"torus {{ {num(r, .5, .8)}, {num(r, .1, .4)} {maybe(r, .2, 'sturm')}"


def superellipsoid(r):
    return f"superellipsoid {{ <{num(r, .2, 1.5)}, {num(r, .2, 1.5)}> scale .85"


def quadric(r):
    return (f"quadric {{ <1, {r.choice(['-.4', '.6', '0'])}, {num(r, .5, 1.5)}>, <0, 0, {num(r, -.3, .3)}>, "
            f"<0, {num(r, -.5, .5)}, 0>, {num(r, -.4, -.1)} {CUT}")


def polynomial(r):
    return r.choice([
        f"cubic {{ <1,0,0,0,0,0,0,0,0,0,0,0,{num(r, -1.3, -.7)},0,0,0,0,{num(r, -.4, -.1)},0,0> {CUT}",
        f"quartic {{ <1,0,0,0,2,0,0,2,0,-1.405,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.155,0,0,0,0,1,0,-1.405,0,"
        f"{num(r, .3, .4)}> {maybe(r, .3, 'sturm')} bounded_by {{ box {{ -1.3, 1.3 }} }}",
        f"poly {{ 4, <1,0,0,0,0,0,0,0,0,{num(r, -1, -.5)},0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,-.7,0,0,0,0,1,0,-.6,0,"
        f"{num(r, .02, .1)}> sturm bounded_by {{ sphere {{ 0, 1.8 }} }}",
    ])


def blob(r):
    parts = []
    for k in range(r.randint(2, 5)):
        strength = num(r, .6, 1.5) if k else "1.5"
        part = r.choice([f"sphere {{ {vec(r, -.5, .5)}, {num(r, .6, 1)}, {strength}",
                         f"cylinder {{ {vec(r, -.6, .1)}, {vec(r, .1, .6)}, {num(r, .4, .7)}, {strength}"])
        parts.append(f"{part} {maybe(r, .3, pigment_text(r), 'scale <1, .7, 1.1>', 'rotate 30*z')} }}")
    return f"blob {{ threshold {num(r, .3, .7)} {' '.join(parts)} {maybe(r, .2, 'sturm', 'hierarchy off')}"


def isosurface(r):
    function, gradient = r.choice([
        (f"x*x + y*y*{num(r, 1, 2)} + z*z - .6 + {num(r, .02, .1)}*sin(x*15)*sin(z*14)", 5),
        (f"sqrt(x*x + y*y + z*z) - .8 + f_noise3d(x*3, y*3, z*3)*{num(r, .1, .3)}", 3),
        (f"f_torus(x, y, z, .6, {num(r, .15, .3)})", 2),
        (f"f_rounded_box(x, y, z, {num(r, .05, .3)}, .7, .5, .6)", 2),
        (f"sin(x*{num(r, 3, 6)}) + cos(y*5) + sin(z*4) - {num(r, -.5, .5)}", 10),
        (f"f_heart(x*1.4, y*1.4, z*1.4, -1)*{num(r, .05, .1)}", 8)])
    container = r.choice(["box { -1, 1 }", "sphere { 0, 1 }"])
    return (f"isosurface {{ function {{ {function} }} contained_by {{ {container} }} max_gradient {gradient} "
            f"accuracy .002 {maybe(r, .3, 'open', 'all_intersections', 'max_trace 3')}")


def julia(r):
    return "julia_fractal {{ {} max_iteration 6 precision {} scale .7".format(r.choice([
        f"<-.083, 0, {num(r, -.85, -.75)}, -.025> quaternion",
        f"<-.16, .16, {num(r, .3, .5)}, -.3> hypercomplex sqr",
        f"<{num(r, -.3, .1)}, .3, .1, 0> quaternion cube",
        f"<-.6, {num(r, .1, .3)}, .2, .1> hypercomplex exp slice <.2, 0, 0, 1>, .1"]), r.randint(15, 40))


def lathe(r):
    kind = r.choice(["linear_spline 6", "quadratic_spline 6", "cubic_spline 6"])
    if r.random() < .25:
        return (f"lathe {{ bezier_spline 8 <0, -1>, <{num(r, .4, .9)}, -1>, <.9, -.4>, <.4, 0>, <.4, 0>, <.1, .4>, "
                f"<{num(r, .4, .9)}, .6>, <0, 1> {maybe(r, .3, 'sturm')}")
    points = ", ".join(f"<{num(r, .2, .9)}, {y}>" for y in (-.9, -.4, .1, .6))
    return f"lathe {{ {kind} <.1, -1>, {points}, <.1, 1> {maybe(r, .3, 'sturm')}"


def prism(r):
    corner = f"<{num(r, -.9, -.4)}, {num(r, -.9, -.4)}>"
    ring = f"{corner}, <.7, -.8>, <{num(r, .4, .9)}, .6>, <0, {num(r, .1, .4)}>, <-.8, .7>, {corner}"
    hole = "<-.2, -.4>, <.2, -.4>, <0, -.1>, <-.2, -.4>"
    sweep, low = r.choice([("linear_sweep", "-.5"), ("conic_sweep", ".2")])
    return r.choice([
        f"prism {{ {sweep} linear_spline {low}, 1, 6, {ring} {maybe(r, .3, 'open')}",
        f"prism {{ {sweep} linear_spline {low}, 1, 10, {ring}, {hole}",
        f"prism {{ {sweep} quadratic_spline {low}, 1, 7, <-.8, .7>, {ring}",
        f"prism {{ {sweep} cubic_spline {low}, 1, 8, <-.8, .7>, {ring}, <.7, -.8> {maybe(r, .3, 'sturm')}",
        f"prism {{ {sweep} bezier_spline {low}, 1, 8, <-.8, 0>, <-.8, .8>, <.8, .8>, <.8, 0>, <.8, 0>, "
        f"<.7, {num(r, -.9, -.4)}>, <-.6, -.8>, <-.8, 0>"])


def turned(r):
    return r.choice([f"sor {{ 6 <0, -1.2>, <{num(r, .4, .8)}, -.9>, <{num(r, .2, .9)}, -.2>, <.3, .3>, "
                     f"<{num(r, .3, .7)}, .8>, <.1, 1.1> {maybe(r, .3, 'open', 'sturm')}",
                     f"ovus {{ {num(r, .6, .8)}, {num(r, .3, .55)} translate -.4*y"])


def sphere_sweep(r):
    kind, count = r.choice([("linear_spline", 3), ("cubic_spline", 5), ("b_spline", 5)])
    balls = ", ".join(f"<{-1 + 2*k/(count - 1):.2g}, {num(r, -.5, .5)}, {num(r, -.4, .4)}>, {num(r, .1, .3)}"
                      for k in range(count))
    return f"sphere_sweep {{ {kind} {count}, {balls}"


def text(r):
    word = r.choice(["Lens", "POV", "a&b", "R2", "%gO"])
    font = r.choice(["timrom.ttf", "cyrvetic.ttf", "crystal.ttf"])
    return f'text {{ ttf "{font}" "{word}" {num(r, .2, .6)}, {num(r, 0, .1)} translate <-.8, -.3, -.2>'


def height_field(r):
    heights = f".5 + .2*sin(x*{num(r, 5, 20)})*cos(y*9) + .2*f_noise3d(x*8, y*8, 1)"
    return (f"height_field {{ function 24, 24 {{ {heights} }} {maybe(r, .5, 'smooth')} "
            f"{maybe(r, .3, 'water_level .3')} translate <-.5, -.5, -.5> scale <2, {num(r, .6, 1.4)}, 2>")


def pyramid(r):
    """A solid of triangles, in both kinds of meshes."""
    top = f"<{num(r, -.3, .3)}, 1, {num(r, -.3, .3)}>"
    if r.random() < .5:
        corners = ["<-.8, -.7, -.8>", "<.8, -.7, -.8>", "<.8, -.7, .8>", "<-.8, -.7, .8>"]
        sides = " ".join(f"triangle {{ {top}, {corners[k]}, {corners[(k + 1) % 4]} }}" for k in range(4))
        return (f"mesh {{ {sides} triangle {{ {corners[0]}, {corners[1]}, {corners[2]} }} "
                f"triangle {{ {corners[0]}, {corners[2]}, {corners[3]} }} inside_vector <.1, 1, .2> "
                f"{maybe(r, .2, 'hierarchy off')}")
    return (f"mesh2 {{ vertex_vectors {{ 5, <-.8,-.7,-.8>, <.8,-.7,-.8>, <.8,-.7,.8>, <-.8,-.7,.8>, {top} }} "
            f"{maybe(r, .5, 'normal_vectors { 5, <-1,-.5,-1>, <1,-.5,-1>, <1,-.5,1>, <-1,-.5,1>, y }')} "
            "uv_vectors { 5, <0,0>, <1,0>, <1,1>, <0,1>, <.5,.5> } "
            "face_indices { 6, <0,1,4>, <1,2,4>, <2,3,4>, <3,0,4>, <0,1,2>, <0,2,3> } inside_vector y")


def sheet_shape(r):
    """What has no inside."""
    corner = f"<{num(r, .2, .9)}, {num(r, .2, .9)}, 0>"
    nets = ",".join(f"<{x}, {z}, {num(r, -.6, .6)}>" for z in (-.9, -.3, .3, .9) for x in (-.9, -.3, .3, .9))
    return r.choice([
        f"disc {{ 0, {vec(r, .1, 1)}, {num(r, .6, 1)}, {num(r, 0, .4)}",
        f"triangle {{ <-1, -.6, 0>, <1, {num(r, -.8, 0)}, .2>, {corner}",
        f"smooth_triangle {{ <-1, -.6, 0>, <-1, 0, -3>, <1, -.6, 0>, <1, 0, -3>, {corner}, <0, 1, -3>",
        f"polygon {{ 9, <-1,-1>, <1,-1>, {corner}, <-1,1>, <-1,-1>, <-.4,-.6>, <.4,-.6>, <0,-.1>, <-.4,-.6>",
        f"bicubic_patch {{ type {r.randint(0, 1)} flatness .01 u_steps 3 v_steps 3 {nets}",
        f"parametric {{ function {{ u*cos(v) }}, function {{ {num(r, .3, .8)}*u*u }}, function {{ u*sin(v) }} "
        f"<.2, 0>, <1, 2*pi> contained_by {{ box {{ -1.05, 1.05 }} }} max_gradient 2 accuracy .02 "
        f"{maybe(r, .5, 'precompute 6 x, y, z')}"])


SOLIDS = [sphere, box, cylinder, cone, torus, superellipsoid, quadric, polynomial, blob, isosurface, julia, lathe,
          prism, turned, sphere_sweep, text, height_field, pyramid]


def transform(r):
    """Of a part: it stays about as large and where it is."""
    return " ".join(r.choice([f"rotate {vec(r, -180, 180)}", f"scale {num(r, .6, 1.1)}",
                              f"scale <1, {num(r, .6, 1.3)}, {num(r, .6, 1.1)}>", f"translate {vec(r, -.3, .3)}",
                              f"matrix <1, {num(r, -.3, .3)}, 0, {num(r, -.3, .3)}, 1, 0, 0, {num(r, -.3, .3)}, 1, "
                              "0, 0, 0>",
                              f"transform {{ rotate {num(r, 0, 90)}*x inverse }}"])
                    for _ in range(r.randint(0, 2)))


def closed(r, shape, own_look):
    """A part of CSG, now and then with a look of its own."""
    look = maybe(r, .3, texture(r, 0)) if own_look else ""
    return f"{shape} {look} {transform(r)} }}"


def csg(r, depth):
    """A solid of solids, open like a shape; sheets are parts of unions only."""
    kind = r.choice(["union", "merge", "intersection", "difference", "difference"])
    parts = [csg(r, depth - 1) if depth > 0 and r.random() < .3 else r.choice(SOLIDS)(r)
             for _ in range(r.randint(2, 4))]
    if kind == "union" and depth > 0 and r.random() < .4:
        parts.append(sheet_shape(r))
    if kind in ("intersection", "difference") and r.random() < .4:
        parts.append(f"plane {{ {vec(r, -1, 1)}, {num(r, .1, .5)}")
    own_look = kind != "merge" and r.random() < .6
    words = maybe(r, .3, "cutaway_textures") if own_look and kind != "union" else ""
    words += maybe(r, .2, " split_union off") if kind == "union" else ""
    return f"{kind} {{ {' '.join(closed(r, part, own_look) for part in parts)} {words}"


# Looks.

PATTERNS = ["agate agate_turb .6", "boxed", "bozo", "bumps", "cells", "crackle", "crackle solid",
            "crackle form <-1, 1, 0> metric 1.5", "cylindrical", "dents", "gradient <1, .5, 0>", "granite", "julia "
            "<.35, .3>, 25 interior 1, 1", "leopard", "magnet 1 mandel 20", "mandel 30 exterior 2, .5", "marble",
            "onion", "planar", "quilted control0 .3 control1 .7", "radial frequency 5", "ripples", "spherical",
            "spiral1 3", "spiral2 4", "spotted", "waves", "wood", "wrinkles", "slope { y }", "aoi",
            "function { sin(x*6)*.5 + .5*f_noise3d(x*4, y*4, z*4) }",
            "pigment_pattern { checker rgb 0 rgb 1 scale .3 }"]
LISTS = [("checker", 2), ("brick", 2), ("hexagon", 3), ("square", 4), ("triangular", 6), ("cubic", 6)]


def modifiers(r):
    return " ".join([
        maybe(r, .35, f"turbulence {num(r, .1, .8)}", f"turbulence {vec(r, 0, .6)} octaves 4 omega .6 lambda 2.2"),
        maybe(r, .3, "frequency 2", "phase .3", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave",
              "poly_wave 2"),
        maybe(r, .25, "warp { repeat x flip y }", "warp { turbulence .4 octaves 3 }", "warp { planar }",
              "warp { spherical }", "warp { cylindrical }", "warp { toroidal major_radius .5 }",
              f"warp {{ black_hole {vec(r, -.4, .4)}, .7 strength .8 falloff 2 }}"),
        f"scale {num(r, .2, 1)}", maybe(r, .5, f"rotate {vec(r, 0, 90)}"), maybe(r, .3, f"translate {vec(r, -1, 1)}")])


def colour(r, clear):
    if not clear:
        return rgb(r)
    return rgb(r) + r.choice([f" filter {num(r, .3, .9)}", f" transmit {num(r, .3, .9)}"])


def colour_map(r, clear):
    places = sorted(r.uniform(.1, .9) for _ in range(r.randint(0, 3)))
    return "color_map { " + " ".join(f"[{place:.3g} {colour(r, clear and r.random() < .6)}]"
                                     for place in [0, *places, 1]) + " }"


def pigment(r, depth=1, clear=False):
    """The words within pigment { }."""
    way = r.random()
    if way < .3:
        return colour(r, clear)
    if way < .45:
        if r.random() < .1:
            return f"object {{ sphere {{ 0, .8 }} {colour(r, clear)}, {colour(r, clear)} }} translate .2*x"
        name, count = r.choice(LISTS)
        return f"{name} {', '.join(colour(r, clear) for _ in range(count))} scale {num(r, .15, .5)}"
    pattern = r.choice(PATTERNS)
    if way < .6 and depth > 0:
        return f"{pattern} pigment_map {{ [.2 {pigment(r, 0, clear)}] [.7 {pigment(r, 0, clear)}] }} {modifiers(r)}"
    if way < .65 and depth > 0:
        return f"average pigment_map {{ [1 {pigment(r, 0, clear)}] [{num(r, .5, 3)} {pigment(r, 0, clear)}] }}"
    if way < .7:
        picture = "function 16, 16 { pigment { bozo color_map { [0 rgb x] [.5 rgb <1, 1, 0>] [1 rgb z] } scale .2 } }"
        return (f"image_map {{ {picture} map_type {r.choice([0, 1, 2, 5])} interpolate {r.choice([0, 2, 4])} "
                f"{maybe(r, .3, 'once')} }} translate -.5 scale 2")
    return f"{pattern} {colour_map(r, clear)} {modifiers(r)}"


def pigment_text(r, clear=False):
    return f"pigment {{ {maybe(r, .1, 'uv_mapping')} {pigment(r, 1, clear)} }}"


def normal(r):
    patterns = [p for p in PATTERNS if not p.startswith(("aoi", "slope", "pigment_pattern"))]
    pattern = r.choice(patterns)
    if " " not in pattern:
        pattern += " " + num(r, .1, .8)
    way = r.random()
    if way < .1:
        return f"normal {{ facets {num(r, .1, .4)} coords {num(r, .2, .6)} }}"
    if way < .25:
        return f"normal {{ gradient x .4 slope_map {{ [0 <0, 1>] [.5 <1, 0>] [1 <0, -1>] }} scale {num(r, .1, .4)} }}"
    if way < .4:
        return f"normal {{ bozo normal_map {{ [.3 {pattern} scale .2] [.7 bumps .4 scale .1] }} scale .5 }}"
    return f"normal {{ {pattern} {modifiers(r)} {maybe(r, .2, 'no_bump_scale', 'accuracy .005')} }}"


def finish(r):
    shine = r.choice(["", f"phong {num(r, .2, 1)} phong_size {r.randint(5, 80)}",
                      f"specular {num(r, .2, 1)} roughness {num(r, .005, .1)}", f"specular albedo {num(r, .1, .4)}"])
    mirror = maybe(r, .35, f"reflection {num(r, .05, .5)}", f"reflection {{ {num(r, 0, .2)}, {num(r, .3, .8)} }}",
                   f"reflection {{ {rgb(r)}*.4 exponent {num(r, .7, 1.5)} metallic }}",
                   "reflection { .05, .9 fresnel } conserve_energy", "reflection { .1, .6 falloff 2 }")
    rest = " ".join([maybe(r, .2, "metallic", "metallic .5"), maybe(r, .2, f"brilliance {num(r, .5, 4)}"),
                     maybe(r, .1, f"irid {{ {num(r, .1, .4)} thickness .6 turbulence .3 }}"),
                     maybe(r, .05, f"crand {num(r, .02, .2)}"), maybe(r, .1, f"emission {num(r, .05, .3)}")])
    diffuse = num(r, .4, .9) + maybe(r, .1, ", .3")
    return f"finish {{ ambient {num(r, 0, .3)} diffuse {diffuse} {shine} {mirror} {rest} }}"


def plain_texture(r, clear=False):
    return f"texture {{ {pigment_text(r, clear)} {maybe(r, .35, normal(r))} {finish(r)} }}"


def texture(r, depth=1, clear=False):
    way = r.random()
    if depth == 0 or way < .6:
        return plain_texture(r, clear)
    if way < .75:
        return plain_texture(r, clear) + " " + plain_texture(r, True)
    if way < .9:
        pattern = r.choice(["bozo", "gradient y", "crackle", "radial", "marble turbulence .4"])
        maps = " ".join(f"[{place} {plain_texture(r, clear)[len('texture {'):-1]}]" for place in (.25, .75))
        return f"texture {{ {pattern} texture_map {{ {maps} }} scale {num(r, .3, 1)} }}"
    return f"texture {{ checker {plain_texture(r)} {plain_texture(r)} scale {num(r, .2, .5)} }}"


def interior(r):
    fading = f"fade_distance {num(r, .5, 3)} fade_power {r.choice([1, 2, 1000])} fade_color {rgb(r)}"
    return f"interior {{ ior {num(r, 1, 1.7)} {maybe(r, .4, fading)} {maybe(r, .2, f'caustics {num(r, .1, 1)}')} }}"


def look(r, bounded):
    """Texture, interior and what else an object has; what is bounded already takes no more clips."""
    clear = r.random() < .25
    cut = "" if bounded else maybe(r, .15, f"clipped_by {{ plane {{ {vec(r, -1, 1)}, {num(r, .1, .6)} }} }}",
                                   f"clipped_by {{ box {{ -{num(r, .5, .9)}, 1 }} }}",
                                   f"clipped_by {{ sphere {{ 0, {num(r, .8, 1.1)} }} }}")
    bounds = "" if bounded else maybe(r, .1, "bounded_by { sphere { 0, 2.5 } }", "bounded_by { box { -2.5, 2.5 } }")
    words = [texture(r, 1, clear), interior(r) if clear else "",
             maybe(r, .1, "interior_texture { " + pigment_text(r) + " }"),
             maybe(r, .15, "no_shadow", "no_reflection", "no_image", "double_illuminate", "hollow", "inverse hollow"),
             cut, bounds]
    return " ".join(word for word in words if word)


def thing(r, place):
    way = r.random()
    shape = csg(r, 1) if way < .45 else sheet_shape(r) if way < .55 else r.choice(SOLIDS)(r)
    bounded = shape.startswith(("quadric", "cubic", "quartic", "poly "))
    return (f"{shape}\n  {look(r, bounded)}\n  {transform(r)} scale {num(r, .8, 1.3)} rotate {vec(r, 0, 360)} "
            f"translate {place} }}")


def flock(r, place):
    """Copies of something declared, in a loop of the scene's own."""
    return f"""#declare Part = {r.choice(SOLIDS)(r)} {transform(r)} }}
#declare Chance = seed({r.randint(1, 999)});
union {{
  #for (I, 0, {r.randint(6, 20)})
    object {{ Part scale .15 + .2*rand(Chance) rotate 360*rand(Chance)*y
      translate <rand(Chance), rand(Chance), rand(Chance)>*2 - 1
      #if (mod(I, 3) = 0) pigment {{ rgb <rand(Chance), .5, rand(Chance)> }} #end }}
  #end
  {texture(r)} translate {place}
}}"""


# What is around.

def light(r):
    place = f"<{num(r, -9, 9)}, {num(r, 5, 12)}, {num(r, -9, -3)}>"
    kind = r.choice(["", "", f"spotlight point_at 0 radius {r.randint(8, 20)} falloff {r.randint(22, 40)} tightness "
                     f"{r.randint(0, 8)}", "cylinder point_at 0 radius 3 falloff 5", "parallel point_at 0",
                     f"area_light 2*x, 2*y, {r.randint(2, 4)}, 3 {maybe(r, .5, 'adaptive 1')} {maybe(r, .5, 'jitter')} "
                     f"{maybe(r, .5, 'circular orient')}",
                     "spotlight point_at 0 radius 15 falloff 30 area_light x, z, 3, 3 adaptive 0"])
    words = " ".join([maybe(r, .25, f"fade_distance {r.randint(6, 20)} fade_power {r.choice([1, 2])}"),
                      maybe(r, .1, "shadowless"), maybe(r, .1, "looks_like { sphere { 0, .3 pigment { rgb 1 } "
                                                       "finish { emission 1 } } }")])
    return f"light_source {{ {place}, {rgb(r)} {kind} {words} }}"


def light_group(r, place):
    return (f"light_group {{\n{light(r)}\n{thing(r, place)}\n{thing(r, '<1, .5, -1>')}\n"
            f"global_lights {r.choice(['on', 'off'])} }}")


def camera(r):
    far = r.uniform(7, 10)
    where = f"location <{num(r, -4, 4)}, {num(r, 2, 5)}, {-far:.3g}> look_at <{num(r, -.5, .5)}, .6, 0>"
    near = f"location <{num(r, -1, 1)}, 2, {num(r, -4, -3)}> look_at <0, .6, 0>"
    blur = f"aperture {num(r, .2, .6)} blur_samples {r.choice([7, 12])} focal_point <0, 1, -1> variance .01"
    return "camera {{ {} }}".format(r.choice([
        f"perspective {where} angle {r.randint(35, 60)}", f"perspective {where} angle {r.randint(35, 60)}",
        f"{where} angle 45 normal {{ bumps .05 scale .2 }}", f"{where} angle {r.randint(35, 60)} {blur}",
        f"orthographic {where} right 8*x up 6*y", f"fisheye {near} angle {r.randint(120, 200)}",
        f"ultra_wide_angle {near} angle {r.randint(90, 150)}", f"omnimax {near} angle 160",
        f"panoramic {near} angle 140", f"spherical {near} angle {r.randint(150, 360)}",
        f"cylinder {r.randint(1, 4)} {near} angle {r.randint(90, 150)}",
        f"perspective {where} right -x*image_width/image_height sky <.2, 1, 0>"]))


def air(r):
    sky = "sky_sphere {{ pigment {{ {} }} }}".format(r.choice([
        f"gradient y {colour_map(r, False)}", f"bozo turbulence .5 {colour_map(r, False)} scale .4"]))
    fog = r.choice([f"fog {{ distance {r.randint(15, 60)} {rgb(r)} }}",
                    f"fog {{ fog_type 2 distance {r.randint(8, 30)} {rgb(r)} transmit .1 fog_offset 0 "
                    f"fog_alt {num(r, .4, 2)} }}",
                    f"fog {{ distance 30 {rgb(r)} filter .3 turbulence {num(r, .2, 1)} turb_depth .5 }}"])
    rainbow = ("rainbow { angle 30 width 10 distance 1e3 direction <-.2, -.3, 1> color_map { [0 rgbt <1, 0, 0, .7>] "
               "[.5 rgbt <0, 1, 0, .7>] [1 rgbt <0, 0, 1, .7>] } }")
    return "\n".join([r.choice([f"background {{ {rgb(r)} }}", sky]), maybe(r, .3, fog), maybe(r, .1, rainbow)])


def floor(r):
    return f"plane {{ y, -1 {texture(r)} {maybe(r, .2, 'hollow')} scale 2 translate y }}".replace(
        "plane { y, -1", r.choice(["plane { y, -1", "plane { y, -1", "box { <-6, -1.5, -6>, <6, -1, 6>",
                                   "disc { -y, y, 6"]))


def scene(r):
    settings = (f"assumed_gamma {r.choice(['1', '1', '2.2'])} max_trace_level {r.randint(3, 6)} "
                f"{maybe(r, .2, 'adc_bailout .02')} {maybe(r, .2, f'ambient_light {rgb(r)}')} "
                f"{maybe(r, .2, 'noise_generator 1', 'noise_generator 2')}")
    places = [f"<{x}, {num(r, 0, 1)}, {z}>" for x, z in r.sample(
        [(x, z) for x in (-2.6, -.9, .9, 2.6) for z in (-1.8, 0, 1.8)], r.randint(4, 7))]
    makers = [r.choices([thing, flock, light_group], [8, 1, 1])[0] for _ in places]
    return "\n".join([f'#version 3.7;\n#include "functions.inc"\nglobal_settings {{ {settings} }}', camera(r),
                      f"light_source {{ <{num(r, -6, 6)}, 9, -8>, {num(r, .6, 1)} }}",
                      *(light(r) for _ in range(r.randint(0, 2))), air(r), floor(r),
                      *(make(r, place) for make, place in zip(makers, places))]) + "\n"


def main():
    if len(sys.argv) not in (2, 3) or "-h" in sys.argv[1]:
        sys.exit(__doc__.strip())
    print(scene(random.Random(f"{sys.argv[1]} {sys.argv[2] if len(sys.argv) > 2 else 0}")), end="")


if __name__ == "__main__":
    main()
