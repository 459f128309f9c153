"""From a file to a scene that can be traced: Lentray beside stock POV-Ray, in the ways in which
people make many objects.

Whole processes at 80 x 60 pixels on one thread: CPU time (user and system), peak memory and page
faults. Both programs run in turns, and medians are compared. The scenes are made by this command.

  tests/bench/building.py [--runs N] [--scale F] [--bin FOLDER] [--json FILE] [way ...]
  tests/bench/building.py --full [way ...]     scenes as large as the stated limits, one run each
  tests/bench/building.py --stages [way ...]   instructions and bytes an object by stage (valgrind)
  tests/bench/building.py --chart FILE.json [meshes|city]   time and memory from 1e3 objects on

The last output of the first form is the table of docs/performance.md. --scale multiplies the
numbers of objects. --stages wants the `dev` build, whose functions have names.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = ["+W80", "+H60"]
HEAD = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 30, -60> look_at 0 }
light_source { <40, 90, -70> rgb 1 }
#declare R = seed(7);
"""
PLACE = "translate <rand(R)*80 - 40, rand(R)*20 - 10, rand(R)*80 - 40>"


def loop(count, body):
    return f"#for (I, 1, {count})\n{body}\n#end\n"


def textured_boxes(n):
    return loop(n, "box { 0, 1 pigment { color rgb <rand(R), rand(R), rand(R)> } finish { phong .3 }"
                   " rotate y*rand(R)*90 " + PLACE + "}")


def spheres(n):
    return loop(n, "sphere { <rand(R)*80 - 40, rand(R)*20 - 10, rand(R)*80 - 40>, .2"
                   " pigment { rgb <1, .5, .2> } }")


def textures(n):
    return (f"#declare T = array[{n}];\n" +
            loop(n, "#declare T[I - 1] = texture { pigment { rgb <rand(R), rand(R), 1> }"
                    " finish { diffuse .4 + rand(R)*.4 } };") +
            loop(n, "sphere { <rand(R)*80 - 40, rand(R)*20 - 10, rand(R)*80 - 40>, .2"
                    " texture { T[I - 1] } }"))


def lights(n):
    return ("sphere { 0, 9 pigment { rgb 1 } }\nplane { y, -10 pigment { rgb 1 } }\n" +
            loop(n, f"light_source {{ <sin(I)*40, 20 + cos(I*2)*9, sin(I*3)*40> rgb {2 / n} }}"))


def while_loop(n):
    return f"""
#declare Steel = texture {{ pigment {{ rgb .6 }} finish {{ specular .4 metallic }} }};
#declare I = 0;
#declare At = <-40, 0, 0>;
#while (I < {n})
  #declare Next = At + vrotate(<.2, rand(R) - .5, 0>, y*I*7);
  cylinder {{ At, Next, .1 texture {{ Steel }} }}
  sphere {{ Next, .12 texture {{ Steel }} }}
  #declare At = Next*.995;
  #declare I = I + 1;
#end
"""


def macro(n):
    depth = max(3, round(math.log2(n)))
    return f"""
#declare Bark = texture {{ pigment {{ rgb <.5, .3, .1> }} }};
#macro Tree(Depth, Base, Way, Size)
  #local Tip = Base + Way*Size;
  cone {{ Base, Size*.12, Tip, Size*.08 texture {{ Bark }} }}
  #if (Depth > 0)
    #local Turned = vaxis_rotate(Way, y, 100);
    Tree(Depth - 1, Tip, vnormalize(Way + x*.5 - z*.2), Size*.8)
    Tree(Depth - 1, Tip, vnormalize(Turned + y*.4), Size*.8)
  #end
#end
Tree({depth - 1}, <0, -20, 0>, y, 12)
"""


def array_of_parts(n):
    return """
#declare Parts = array[4] {
  sphere { 0, .4 pigment { rgb <1, 0, 0> } },
  box { -.3, .3 pigment { rgb <0, 1, 0> } },
  cone { 0, .4, y, 0 pigment { rgb <0, 0, 1> } },
  torus { .4, .1 pigment { rgb <1, 1, 0> } } }
""" + loop(n, "object { Parts[mod(I, 4)] rotate <rand(R), rand(R), rand(R)>*360"
              " scale .5 + rand(R) " + PLACE + "}")


def unions(n):
    rows = max(1, round(n ** (1 / 3)))
    return f"""
#declare Row = union {{ #for (I, 1, {rows}) box {{ -.2, .2 translate x*I*.5 }} #end }}
union {{
  #for (K, 1, {rows})
    union {{
      #for (J, 1, {rows}) object {{ Row translate z*J*.5 }} #end
      translate y*K*.5
    }}
  #end
  pigment {{ rgb <.4, .7, 1> }}
  translate -<10, 10, 10>
}}
"""


def big_union(n):
    return ("union {\n" +
            loop(n, "sphere { <rand(R)*80 - 40, rand(R)*20 - 10, rand(R)*80 - 40>, .3"
                    " pigment { rgb <rand(R), 1, 0> } }") + "rotate y*20 }\n")


def copies(n):
    return """
#declare Wood = texture { pigment { wood turbulence .1 scale .2
  color_map { [0 rgb <.6, .4, .2>] [1 rgb <.3, .2, .1>] } } finish { specular .2 } };
#declare Leg = cylinder { 0, y, .08 };
#declare Chair = union {
  object { Leg } object { Leg translate x } object { Leg translate z } object { Leg translate x + z }
  box { <-.1, 1, -.1>, <1.1, 1.1, 1.1> }
  difference { box { <-.1, 1.1, 1>, <1.1, 2, 1.1> } cylinder { <.5, 1.6, .9>, <.5, 1.6, 1.2>, .3 } }
  texture { Wood }
};
""" + loop(n, "object { Chair rotate y*rand(R)*360 " + PLACE + "}")


def mesh_copies(n):
    triangles = " ".join(
        f"triangle {{ <{math.cos(a * .3):.3f}, {a * .01:.3f}, {math.sin(a * .3):.3f}>,"
        f" <{math.cos(a * .3 + .3):.3f}, {a * .01:.3f}, {math.sin(a * .3 + .3):.3f}>,"
        f" <0, {a * .01 + 1:.3f}, 0> }}" for a in range(200))
    return (f"#declare Plant = mesh {{ {triangles} pigment {{ rgb <.2, .8, .2> }} }}\n" +
            loop(n, "object { Plant rotate y*rand(R)*360 scale .5 + rand(R) " + PLACE + "}"))


def mesh2(n):
    side = max(2, round(math.sqrt(n / 2)))
    vertices = ",\n".join(
        f"<{x * 80 / side - 40:.4f}, {4 * math.sin(x * .1) * math.cos(y * .07):.4f},"
        f" {y * 80 / side - 40:.4f}>" for y in range(side + 1) for x in range(side + 1))
    faces = ",\n".join(
        f"<{a}, {a + 1}, {a + side + 1}>, <{a + 1}, {a + side + 2}, {a + side + 1}>"
        for y in range(side) for a in range(y * (side + 1), y * (side + 1) + side))
    return (f"mesh2 {{ vertex_vectors {{ {(side + 1) ** 2},\n{vertices} }}\n"
            f"face_indices {{ {2 * side * side},\n{faces} }}\npigment {{ rgb 1 }} }}\n")


def mesh_loop(n):
    return ("#macro P(U, V) <U*80 - 40, 5*sin(U*20)*cos(V*17), V*80 - 40> #end\n"
            "#macro N(U, V) <sin(U*9), 3, cos(V*8)> #end\n"
            f"#declare S = {max(2, round(math.sqrt(n / 2)))};\n" + """
mesh {
  #for (I, 0, S - 1) #for (J, 0, S - 1)
    #local A = I/S; #local B = J/S; #local C = (I + 1)/S; #local D = (J + 1)/S;
    smooth_triangle { P(A, B), N(A, B), P(C, B), N(C, B), P(C, D), N(C, D) }
    smooth_triangle { P(A, B), N(A, B), P(C, D), N(C, D), P(A, D), N(A, D) }
  #end #end
  pigment { rgb <.3, .9, .5> }
}
""")


def triangles(n):
    return loop(n, "#local A = <rand(R)*80 - 40, rand(R)*20 - 10, rand(R)*80 - 40>;\n"
                   "triangle { A, A + x + y*rand(R), A + z pigment { rgb <rand(R), 1, 1> } }")


def blobs(n):
    return loop(n, "blob { threshold .5 sphere { 0, 1, 1 } sphere { x*.6, .8, 1 }"
                   " cylinder { 0, y, .5, 1 } sphere { y, .7, 1 }"
                   " pigment { rgb <1, rand(R), 0> } rotate y*rand(R)*360 " + PLACE + "}")


def texts(n):
    return loop(n, 'text { ttf "crystal.ttf" concat("Number ", str(I, 0, 0)) .2, 0'
                   " pigment { rgb <1, .8, .2> } " + PLACE + "}")


def csg(n):
    return loop(n, "difference { box { -.5, .5 pigment { rgb <rand(R), 0, 0> } }"
                   " sphere { 0, .6 pigment { rgb <0, rand(R), 0> } finish { phong 1 } }"
                   " rotate y*rand(R)*90 " + PLACE + "}")


def woods(n):
    return ('#include "woods.inc"\n' +
            loop(n, "box { <-.5, -.2, -.5>, <.5, .2, .5> texture { T_Wood1"
                    " translate <rand(R), I, rand(R)> rotate x*90 scale .07 }"
                    " rotate y*rand(R)*90 " + PLACE + "}"))


def prisms(n):
    return loop(n, "prism { linear_sweep linear_spline 0, 1 + rand(R), 7, <0, 1>, <.9, .5>,"
                   " <.9, -.5>, <0, -1>, <-.9, -.5>, <-.9, .5>, <0, 1>"
                   " pigment { rgb <.5, rand(R), 1> } " + PLACE + "}")


def exported(n):
    """What a modeller writes: no loop, every number in the file."""
    out = ["#declare Mat_1 = texture { pigment { rgb <0.8, 0.8, 0.6> } finish { diffuse 0.7 } }"]
    for i in range(n):
        a, b, c = (math.sin(i * k) * 40 for k in (1.1, 1.7, 2.3))
        out.append(f"cylinder {{\n  <{a:.6f}, {b / 4:.6f}, {c:.6f}>,"
                   f" <{a + .7:.6f}, {b / 4 + .1:.6f}, {c:.6f}>, 0.150000\n"
                   f"  texture {{ Mat_1 }}\n  matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, {i % 3}, 0, 0>\n}}")
    return "\n".join(out) + "\n"


def traced(n):
    return """
#declare Ground = union { sphere { <-15, -20, 0>, 24 } sphere { <18, -20, 5>, 22 } plane { y, -10 }
  pigment { rgb <.4, .3, .2> } };
object { Ground }
#declare Tuft = union { cone { 0, .2, y, 0 } cone { 0, .2, <.4, .8, 0>, 0 }
  cone { 0, .2, <0, .8, .4>, 0 } pigment { rgb <.1, .7, .1> } };
""" + loop(n, "#local Up = y;\n"
              "#local At = trace(Ground, <rand(R)*80 - 40, 50, rand(R)*80 - 40>, -y, Up);\n"
              "object { Tuft scale .5 + rand(R) rotate y*rand(R)*360 translate At }")


def city(n):
    side = max(1, round(math.sqrt(n)))
    return f"""
#for (I, 0, {side - 1}) #for (J, 0, {side - 1})
  box {{ <0, -10, 0>, <.7, -9.5 + rand(R)*4, .7>*<1, 1, 1> pigment {{ rgb .4 + rand(R)*.5 }}
    scale <80/{side}, 1, 80/{side}> translate <I*80/{side} - 40, 0, J*80/{side} - 40> }}
#end #end
"""


Way = collections.namedtuple("Way", "scene count says")
WAYS = {
    "textured_boxes": Way(textured_boxes, 60000, "boxes with textures of their own, turned"),
    "spheres": Way(spheres, 200000, "spheres in a loop"),
    "textures": Way(textures, 40000, "textures in an array, each on a sphere"),
    "lights": Way(lights, 2000, "lights"),
    "while_loop": Way(while_loop, 60000, "turns of #while, a cylinder and a sphere each"),
    "macro": Way(macro, 65536, "cones of a recursive macro"),
    "array_of_parts": Way(array_of_parts, 40000, "objects out of an array, placed"),
    "unions": Way(unions, 64000, "boxes in unions of unions"),
    "big_union": Way(big_union, 60000, "spheres with pigments in one union, turned"),
    "copies": Way(copies, 6000, "copies of a declared chair of 6 parts"),
    "mesh_copies": Way(mesh_copies, 20000, "copies of a declared mesh"),
    "mesh2": Way(mesh2, 200000, "triangles of a mesh2"),
    "mesh_loop": Way(mesh_loop, 40000, "smooth triangles that macros make in a mesh"),
    "triangles": Way(triangles, 60000, "triangles with pigments of their own"),
    "blobs": Way(blobs, 10000, "blobs of 4 parts"),
    "texts": Way(texts, 1500, "texts"),
    "csg": Way(csg, 15000, "differences with two textures"),
    "woods": Way(woods, 8000, "boxes of woods.inc's wood, each moved"),
    "prisms": Way(prisms, 15000, "prisms"),
    "exported": Way(exported, 40000, "cylinders written out, without a loop"),
    "traced": Way(traced, 8000, "tufts placed with trace()"),
}
FULL = {"spheres": WAYS["spheres"]._replace(count=2000000),
        "textures": WAYS["textures"]._replace(count=200000),
        "lights": WAYS["lights"]._replace(count=10000),
        "mesh2": WAYS["mesh2"]._replace(count=5000000),
        "city": Way(city, 1000000, "boxes of a city with pigments of their own")}
CHARTS = {"meshes": Way(mesh2, 5000000, "triangles of a mesh2"),
          "city": FULL["city"]}
STAGES = {"descriptions": "read_descriptions", "compiled": "build_scene",
          "hierarchy": "core::Scene::Scene(", "light buffers": "build_light_buffers"}

Cost = collections.namedtuple("Cost", "seconds bytes faults")


def run(command, folder):
    """What a process takes; stops on failure."""
    with open(folder / "said", "wb") as said:
        process = subprocess.Popen(command, cwd=folder, stdout=said, stderr=said)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        text = (folder / "said").read_text(errors="replace")
        sys.exit(f"failed: {' '.join(map(str, command))}\n{text[-3000:]}")
    return Cost(used.ru_utime + used.ru_stime, used.ru_maxrss * 1024, used.ru_minflt)


def median(costs):
    return Cost(*(statistics.median(values) for values in zip(*costs)))


def commands(program):
    return {"lentray": [program, "+Iscene.pov", "+Oours.png", *SIZE, "-D", "-A", "+WT1"],
            "stock": ["povray", "+Iscene.pov", "+Ostock.png", *SIZE, "-D", "-A", "+WT1"]}


def write(folder, way, scale):
    count = max(1, round(way.count * scale))
    (folder / "scene.pov").write_text(HEAD + way.scene(count))
    return count


def compare(program, ways, scale, runs, folder):
    """Costs of both programs by way, medians of runs that take turns."""
    out = {}
    for name, way in ways.items():
        count = write(folder, way, scale)
        costs = {key: [] for key in commands(program)}
        for _ in range(runs):
            for key, command in commands(program).items():
                costs[key].append(run(command, folder))
        out[name] = {"count": count} | {key: median(all_)._asdict() for key, all_ in costs.items()}
        ours, stock = (Cost(**out[name][key]) for key in ("lentray", "stock"))
        print(f"{name:15} {ours.seconds:7.2f} {stock.seconds:7.2f} s "
              f"{ours.bytes / 1e6:7.0f} {stock.bytes / 1e6:7.0f} MB", file=sys.stderr, flush=True)
    return out


def table(results):
    print("| scene | CPU time, stock / Lentray | peak memory, Lentray / stock "
          "| page faults, Lentray / stock |")
    print("|---|---:|---:|---:|")
    rows = []
    for name, found in results.items():
        ours, stock = Cost(**found["lentray"]), Cost(**found["stock"])
        rows.append((stock.seconds / ours.seconds, ours.bytes / stock.bytes,
                     ours.faults / stock.faults))
        print(f"| {found['count']:,} {(WAYS | FULL)[name].says} | {rows[-1][0]:.1f} | {rows[-1][1]:.2f} "
              f"| {rows[-1][2]:.2f} |")
    speeds, memories, faults = zip(*rows)
    print(f"\n{len(rows)} scenes: speed median {statistics.median(speeds):.1f}, least "
          f"{min(speeds):.1f}; memory median {statistics.median(memories):.2f}, most "
          f"{max(memories):.2f}; page faults median {statistics.median(faults):.2f}.")


def instructions(program, folder):
    """Of the stages, by callgrind."""
    run(["valgrind", "--tool=callgrind", "--callgrind-out-file=calls", program,
         *commands(program)["lentray"][1:]], folder)
    said = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "calls"],
                          cwd=folder, capture_output=True, text=True, check=True).stdout
    out = dict.fromkeys(STAGES, 0)
    for line in said.splitlines():
        for stage, function in STAGES.items():
            found = re.match(r"\s*([\d,]+)", line)
            if found and function in line:
                out[stage] = max(out[stage], int(found.group(1).replace(",", "")))
    return out


def heap(program, folder):
    """Bytes by stage at the moment when most is held, by massif."""
    run(["valgrind", "--tool=massif", "--massif-out-file=heap", "--depth=60", "--threshold=0.1",
         program, *commands(program)["lentray"][1:]], folder)
    snapshots = (folder / "heap").read_text().split("#-----------\nsnapshot=")
    peak = next(text for text in snapshots if "heap_tree=peak" in text)
    out = dict.fromkeys(STAGES, 0)

    def add(nodes, stage):
        """Reads one node and what is below it; its bytes go to the stage nearest to the root."""
        parts, size, where = re.match(r"\s*n(\d+): (\d+) (.*)", next(nodes)).groups()
        for name, function in STAGES.items():
            if stage is None and function.removesuffix("(") in where:
                stage, out[name] = name, out[name] + int(size)
        for _ in range(int(parts)):
            add(nodes, stage)

    add(iter(peak.split("heap_tree=peak\n")[1].splitlines()), None)
    return out


def stages(program, ways, scale, folder):
    print("| scene | objects | what | " + " | ".join(STAGES) + " |")
    print("|---|---:|---|" + "---:|" * len(STAGES))
    for name, way in ways.items():
        count = write(folder, way, scale)
        for what, by_stage in (("instructions", instructions(program, folder)),
                               ("bytes at the peak", heap(program, folder))):
            print(f"| {way.says} | {count:,} | {what} | " +
                  " | ".join(f"{by_stage[stage] / count:,.0f}" for stage in STAGES) + " |",
                  flush=True)


def chart(program, names, runs, folder):
    out = {}
    for name in names:
        way, rows, count = CHARTS[name], [], 1000
        while count <= way.count:
            found = compare(program, {name: way._replace(count=count)}, 1, runs, folder)[name]
            rows.append(found)
            count = count * 10 if count * 10 <= way.count or count == way.count else way.count
        out[name] = rows
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, help="5; with --full 1")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--bin", default=str(ROOT / "build" / "release" / "bin"))
    parser.add_argument("--json")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--stages", action="store_true")
    parser.add_argument("--chart", metavar="FILE")
    parser.add_argument("ways", nargs="*")
    args = parser.parse_args()
    program = pathlib.Path(args.bin).resolve() / "lentray"
    runs = args.runs or (1 if args.full else 5)
    known = CHARTS if args.chart else FULL if args.full else WAYS
    for name in args.ways:
        if name not in known:
            sys.exit(f"no scene '{name}': one of {', '.join(known)}")
    ways = {name: known[name] for name in args.ways or known}
    folder = pathlib.Path(tempfile.mkdtemp())
    try:
        if args.chart:
            pathlib.Path(args.chart).write_text(
                json.dumps(chart(program, ways, runs, folder), indent=2) + "\n")
        elif args.stages:
            stages(program, ways, args.scale, folder)
        else:
            results = compare(program, ways, args.scale, runs, folder)
            table(results)
            if args.json:
                pathlib.Path(args.json).write_text(json.dumps(results, indent=2) + "\n")
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
