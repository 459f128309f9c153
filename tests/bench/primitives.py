"""CPU time of lentray against stock POV-Ray, one scene a primitive.

Each scene shows one kind of shape on a floor under two lights: 15 x 15 of it, each turned another
way, or one that is complex. Whole processes, one thread each, user + system time less what both
need for an empty scene; each scene's runs take turns, medians are compared. Once a scene the two
pictures are compared too (lentray-diff).

  tests/bench/primitives.py [--runs N] [--size WxH] [--bin FOLDER] [--json FILE] [scene ...]
  tests/bench/primitives.py --json FILE --table      # writes docs/performance.md's table from FILE

FILE keeps the results of earlier calls: scenes can be measured a few at a time.
"""
import argparse
import json
import math
import pathlib
import random
import re
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "docs" / "performance.md"
BEGIN, END = "<!-- primitives -->", "<!-- /primitives -->"

STAGE = """#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0, 9, -13> look_at <0, -.3, .4> angle 42 }
light_source { <-20, 30, -25>, 1 }
light_source { <25, 20, -10>, .4 }
plane { y, -1 pigment { checker rgb .9 rgb .6 scale 2 } }
#default { pigment { rgb <.9, .6, .3> } finish { specular .3 } }
"""
EMPTY = '#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n'

MANY = """
#declare S = %s
#declare R = seed(4);
#for (I, 0, 14) #for (J, 0, 14)
  object { S scale .42 rotate <rand(R), rand(R), rand(R)>*360 translate <I - 7, 0, J - 7> }
#end #end
"""
FEW = MANY.replace("14) #for (J, 0, 14)", "4) #for (J, 0, 4)").replace(".42", "1.3").replace(
    "<I - 7, 0, J - 7>", "<I*3 - 6, .6, J*3 - 6>")

PATCH = ("<-1.4,-.5,-1>,<-.5,.8,-1.2>,<.5,-.6,-1>,<1.4,.4,-1>,<-1.5,.3,-.4>,<-.5,-.5,-.3>,<.5,1.9,-.4>,"
         "<1.5,0,-.2>,<-1.3,-.4,.4>,<-.4,.9,.3>,<.4,-.8,.5>,<1.4,.7,.4>,<-1.4,.5,1.1>,<-.5,-.2,1>,"
         "<.5,.6,1.3>,<1.3,-.3,1>")
OUTLINE = "<0,1>,<-1,-1>,<1,-1>,<1.2,.4>,<0,1>,<-1,-1>,<1,-1>"
POLY6 = ("1,0,0,0,3,0,0,3,0,0,0,0,0,0,0,0,0,0,0,0,3,0,0,-12,0,0,0,0,0,0,3,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,"
         "0,0,0,0,0,0,0,0,0,0,1,0,0,3,0,0,0,0,0,0,3,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,-1")


def mesh(side, height):
    """mesh2 of 2 side^2 triangles, 14 units wide."""
    def row(z):
        return ",\n".join(
            f"<{14 * x / side - 7:.5f}, {height * math.sin(x * 40 / side) * math.cos(z * 33 / side):.5f}, "
            f"{14 * z / side - 7:.5f}>" for x in range(side + 1))
    faces = []
    for z in range(side):
        for x in range(side):
            a = z * (side + 1) + x
            b = a + side + 1
            faces.append(f"<{a}, {a + 1}, {b}>, <{a + 1}, {b + 1}, {b}>")
    return (f"mesh2 {{ vertex_vectors {{ {(side + 1) ** 2},\n" + ",\n".join(row(z) for z in range(side + 1)) +
            f"\n }}\n face_indices {{ {2 * side * side},\n" + ",\n".join(faces) + "\n } }\n")


def letters():
    text = random.Random(2)
    lines = ["".join(text.choice("abcdefghijklmnopqrstuvwxyzABCDEFGHJKLMNPQRSTUVWXYZ&@$") for _ in range(50))
             for _ in range(40)]
    return "".join(f'text {{ internal 1 "{line}" .2, 0 rotate 90*x scale <.5,1,.55> '
                   f"translate <-7, -.7, {7 - .36 * i}> }}\n" for i, line in enumerate(lines))


SPHERES = """
#declare R = seed(7);
union { #for (I, 1, 100000)
  sphere { <rand(R)*14 - 7, rand(R)*2 - .9, rand(R)*14 - 7>, .01 + .05*rand(R) }
#end }
"""
CUTS = """
#declare R = seed(9);
difference { box { <-7,-.9,-7>, <7,.6,7> }
  #for (I, 1, 999) sphere { <rand(R)*14 - 7, .6 + .2*rand(R), rand(R)*14 - 7>, .15 + .2*rand(R) } #end }
"""
LENSES = MANY % "intersection { sphere { -.5*z, 1.1 } sphere { .5*z, 1.1 } cylinder { -z, z, .8 } }"
BLOB = """
#declare R = seed(5);
blob { threshold .5 #for (I, 1, 300)
  sphere { <rand(R)*12 - 6, rand(R)*1.5 - .5, rand(R)*12 - 6>, .5 + .5*rand(R), 1 } #end }
"""

SCENES = {  # name: (text or function, what it is)
    "sphere": (MANY % "sphere { 0, 1 }", "225 spheres"),
    "ellipsoid": (MANY % "sphere { 0, 1 scale <1,.5,.7> }", "225 ellipsoids"),
    "box": (MANY % "box { -.7, .7 }", "225 boxes"),
    "cylinder": (MANY % "cylinder { -y, y, .6 }", "225 cylinders"),
    "cone": (MANY % "cone { -y, .9, y, .2 }", "225 cones"),
    "torus": (MANY % "torus { .8, .25 }", "225 tori"),
    "plane": ("#for (I, 0, 39) plane { vrotate(y, <25, I*9, 0>), -7 - I*.05 } #end", "40 planes more"),
    "disc": (MANY % "disc { 0, y, 1, .3 }", "225 discs with a hole"),
    "triangle": (MANY % "triangle { <-1,-.6,0>, <1,-.6,0>, <0,1,0> }", "225 triangles"),
    "smooth_triangle": (MANY % "smooth_triangle { <-1,-.6,0>, <-1,0,-3>, <1,-.6,0>, <1,0,-3>, <0,1,0>, <0,1,-3> }",
                        "225 smooth triangles"),
    "polygon": (MANY % ("polygon { 12, <-1,-1>,<1,-1>,<1,1>,<.2,.2>,<0,1>,<-.2,.2>,<-1,1>,<-1,-1>,"
                        "<-.3,-.7>,<.3,-.7>,<0,0>,<-.3,-.7> }"), "225 polygons with a hole"),
    "quadric": (MANY % "quadric { <1,-.4,1>, 0, 0, -.2 clipped_by { sphere { 0, 1 } } bounded_by { clipped_by } }",
                "225 hyperboloids, clipped"),
    "cubic": (MANY % ("cubic { <1,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0,0,-.3,0,0> clipped_by { sphere { 0, 1 } }"
                      " bounded_by { clipped_by } }"), "225 cubics, clipped"),
    "quartic": (MANY % ("quartic { <1,0,0,0,2,0,0,2,0,-1.405,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.155,0,0,0,0,1,0,"
                        "-1.405,0,.3335> bounded_by { box { <-1.1,-.3,-1.1>, <1.1,.3,1.1> } } rotate 90*x }"), "225 quartics"),
    "poly": (MANY % ("poly { 6, <" + POLY6 + "> bounded_by { box { -1.05, 1.05 } } }"), "225 polys of order 6"),
    "superellipsoid": (MANY % "superellipsoid { <.3,.5> scale .8 }", "225 superellipsoids"),
    "blob": (BLOB, "blob of 300 parts"),
    "blobs": (MANY % ("blob { threshold .5 sphere { <.4,0,0>, 1, 1 } cylinder { <-1,-.2,0>, <.5,.9,.2>, .6, 1.1 }"
                      " sphere { <0,.5,-.5>, .5, -.8 } }"), "225 blobs of 3 parts"),
    "bicubic_patch": (FEW % ("bicubic_patch { type 1 u_steps 4 v_steps 4 " + PATCH + " scale .7 }"),
                      "25 bicubic patches"),
    "height_field": ("height_field { function 500, 500 { .5 + .2*sin(x*40)*cos(y*33) + .2*f_noise3d(x*30, y*30, 1) }"
                     " scale <14,2,14> translate <-7,-1,-7> }", "height field of 500 x 500"),
    "height_field_smooth": ("height_field { function 500, 500 { .5 + .2*sin(x*40)*cos(y*33)"
                            " + .2*f_noise3d(x*30, y*30, 1) } smooth scale <14,2,14> translate <-7,-1,-7> }",
                            "smooth height field of 500 x 500"),
    "isosurface": (FEW % ("isosurface { function { x*x + y*y*2 + z*z - .6 + .1*sin(x*15)*sin(z*14) } max_gradient 5"
                          " contained_by { box { -1, 1 } } }"), "25 isosurfaces of polynomials and sines"),
    "isosurface_noise": ("isosurface { function { y - f_noise3d(x*2, 0, z*2)*.8 - f_noise3d(x*9, y*9, z*9)*.12 }"
                         " max_gradient 3 contained_by { box { <-7,-.9,-7>, <7,1.2,7> } } }", "isosurface with noise"),
    "isosurface_ridged": ("isosurface { function { y - f_ridged_mf(x*.4, 0, z*.4, 1, 2, 5, .9, 2, 3)*.5 }"
                          " max_gradient 4 contained_by { box { <-7,-.9,-7>, <7,1.2,7> } } }",
                          "isosurface of a ridged multifractal"),
    "julia_fractal": (FEW % "julia_fractal { <-.083,0,-.83,-.025> quaternion max_iteration 8 precision 40 scale .8 }",
                      "25 quaternion Julia sets"),
    "julia_hypercomplex": (FEW % ("julia_fractal { <-.16,.16,.4,-.3> hypercomplex max_iteration 8 precision 40"
                                  " scale .8 }"), "25 hypercomplex Julia sets"),
    "julia_exp": (FEW % "julia_fractal { <-.6,.2,.2,.1> hypercomplex exp max_iteration 6 precision 20 scale .4 }",
                  "25 Julia sets of exp"),
    "lathe": (MANY % "lathe { cubic_spline 7 <.3,-1>,<0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9>,<.2,1> }",
              "225 cubic lathes"),
    "lathe_linear": (MANY % "lathe { 5 <0,-.9>,<.9,-.6>,<.4,0>,<1,.7>,<0,.9> }", "225 linear lathes"),
    "prism": (MANY % ("prism { cubic_spline -.4, .4, 7 " + OUTLINE + " scale .9 }"), "225 cubic prisms"),
    "prism_linear": (MANY % "prism { -.4, .4, 6 <-1,-1>,<1,-1>,<1,1>,<0,.2>,<-1,1>,<-1,-1> scale .8 }",
                     "225 linear prisms"),
    "prism_conic": (MANY % ("prism { conic_sweep cubic_spline .2, 1, 7 " + OUTLINE + " }"), "225 conic prisms"),
    "sor": (MANY % "sor { 7 <0,-1>,<.5,-.9>,<.9,-.3>,<.3,.2>,<.6,.8>,<.2,1>,<0,1.1> }", "225 sors"),
    "ovus": (MANY % "ovus { .8, .45 }", "225 ovus"),
    "sphere_sweep": (MANY % ("sphere_sweep { linear_spline 4 <-1,-.6,0>,.3 <0,.8,-.3>,.15 <.9,-.4,.4>,.3"
                             " <1,.6,0>,.1 }"), "225 linear sphere sweeps"),
    "sphere_sweep_cubic": (FEW % ("sphere_sweep { cubic_spline 6 <-2,0,0>,.2 <-1,-.6,0>,.3 <0,.8,-.3>,.15"
                                  " <.9,-.4,.4>,.3 <1,.6,0>,.1 <2,1,0>,.2 tolerance 1e-4 }"), "25 cubic sphere sweeps"),
    "sphere_sweep_b": (FEW % ("sphere_sweep { b_spline 6 <-2,0,0>,.2 <-1,-.9,0>,.3 <0,1.4,-.3>,.25 <.9,-.8,.4>,.3"
                              " <1,.9,0>,.3 <2,1,0>,.2 tolerance 1e-4 }"), "25 B-spline sphere sweeps"),
    "parametric": ("parametric { function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) }"
                   " <0,0>, <pi,2*pi> contained_by { box { -1.01, 1.01 } } max_gradient 2 accuracy .02"
                   " scale 1.2 rotate 40*x }", "parametric surface"),
    "parametric_precompute": ("parametric { function { u*cos(v) }, function { u*u*.5 }, function { u*sin(v) }"
                              " <0,0>, <1,2*pi> contained_by { box { -1.01, 1.01 } } max_gradient 2 accuracy .02"
                              " precompute 8, x,y,z scale 2 }", "parametric surface with precompute"),
    "text": (letters, "text of 2,000 letters"),
    "mesh_small": (MANY % "mesh { #for (K, 0, 11) triangle { y, vrotate(x, y*30*K), vrotate(x, y*30*(K + 1)) } #end }",
                   "225 meshes of 12 triangles"),
    "mesh_million": (lambda: mesh(708, .5), "mesh of 1,000,000 triangles"),
    "union": (SPHERES, "union of 100,000 spheres"),
    "csg_parts": (CUTS, "difference with 1,000 parts"),
    "intersection": (LENSES, "225 intersections"),
    "difference": (MANY % "difference { box { -.7, .7 } sphere { 0, .9 } cylinder { -2*z, 2*z, .3 } }",
                   "225 differences"),
    "merge": (MANY % ("merge { sphere { -.4*x, .7 } sphere { .4*x, .7 } cylinder { -y, y, .3 }"
                      " pigment { rgbt <.9,.9,1,.5> } }"), "225 clear merges"),
    "clipped_by": (MANY % "sphere { 0, 1 clipped_by { plane { y, .3 } box { -.8, .8 } } }", "225 clipped spheres"),
    "cutaway_textures": (MANY % ("difference { union { sphere { -.3*x, .7 pigment { rgb x } } sphere { .3*x, .7"
                                 " pigment { rgb z } } } box { <-2,0,-2>, 2 } cutaway_textures }"),
                         "225 differences with cutaway_textures"),
    "interior_texture": (MANY % ("difference { cylinder { -y, y, .8 open } box { <-2,.2,-2>, <2,2,0> } pigment { rgb x }"
                                 " interior_texture { pigment { checker rgb 1 rgb z scale .2 } } }"),
                         "225 open differences with interior_texture"),
}
NAMED = ["mesh_million", "union", "csg_parts", "isosurface_noise", "text"]


def run(command, folder):
    """User + system seconds; stops on failure."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout.decode(errors='replace')[-3000:]}")
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def ways(binaries, width, height):
    size = [f"+W{width}", f"+H{height}", "+WT1", "-A"]
    return {"lentray": [binaries / "lentray", "+Iscene.pov", "+Oours.png", "-V", *size],
            "stock": ["povray", "+Iscene.pov", "+Ostock.png", "-V", "-D", "-P", "+FN8", *size]}


def medians(text, runs, commands, folder):
    (folder / "scene.pov").write_text(text)
    times = {way: [] for way in commands}
    for _ in range(runs):
        for way, command in commands.items():
            times[way].append(run(command, folder))
    return {way: statistics.median(seconds) for way, seconds in times.items()}


def grade(binaries, folder):
    done = subprocess.run([binaries / "lentray-diff", "ours.png", "stock.png", "--no-pictures", "--grade", "close"],
                          cwd=folder, capture_output=True, text=True, check=False)
    found = re.search(r"\b(exact|match|close|fails)\b", done.stdout)
    return found.group(1) if found else "unknown"


def measure(args, known):
    binaries = pathlib.Path(args.bin).resolve()
    width, height = (int(n) for n in args.size.split("x"))
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        start = medians(EMPTY, args.runs, ways(binaries, 1, 1), folder)
        print(f"start-up: lentray {start['lentray']:.3f} s, stock {start['stock']:.3f} s")
        for name in args.scenes or SCENES:
            text, said = SCENES[name]
            whole = medians(STAGE + (text() if callable(text) else text), args.runs,
                            ways(binaries, width, height), folder)
            ours, theirs = (whole[way] - start[way] for way in ("lentray", "stock"))
            known[name] = {"lentray": ours, "stock": theirs, "grade": grade(binaries, folder)}
            print(f"{name:<22} {ours:8.3f} {theirs:8.3f}   {theirs / ours:6.2f}   {known[name]['grade']:<6} {said}",
                  flush=True)
            if args.json:
                pathlib.Path(args.json).write_text(json.dumps(known, indent=1) + "\n")


def write_table(known):
    missing = [name for name in SCENES if name not in known]
    if missing:
        sys.exit("not measured: " + ", ".join(missing))
    rows = sorted(((known[n]["stock"] / known[n]["lentray"], n) for n in SCENES))
    median = statistics.median(ratio for ratio, _ in rows)
    lines = [BEGIN, "| scene | stock / lentray | picture |", "|---|---:|---|"]
    for ratio, name in rows:
        said = SCENES[name][1]
        lines.append(f"| {'**' + said + '**' if name in NAMED else said} | {ratio:.1f} | {known[name]['grade']} |")
    lines += ["", f"{len(rows)} scenes, median {median:.1f}.", END]
    text = TABLE.read_text()
    before, rest = text.split(BEGIN)
    TABLE.write_text(before + "\n".join(lines) + rest.split(END)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--size", default="300x300")
    parser.add_argument("--bin", default=str(ROOT / "build" / "release" / "bin"))
    parser.add_argument("--json")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("scenes", nargs="*", choices=[*SCENES, []], metavar="scene")
    args = parser.parse_args()
    known = {}
    if args.json and pathlib.Path(args.json).exists():
        known = json.loads(pathlib.Path(args.json).read_text())
    if args.table:
        write_table(known)
    else:
        measure(args, known)


if __name__ == "__main__":
    main()
