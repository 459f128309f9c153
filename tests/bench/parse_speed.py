"""CPU time of reading scenes: lentray against stock POV-Ray.

One thread each, user + system time, medians of runs that take turns. The ratio is that of the
times that both report for parsing alone: text to descriptions here, text to objects there. Beside
it are whole processes, less what both need to start (an empty scene): lentray with --parse-only,
which also makes the objects, to check them, and arranges meshes; stock, which cannot stop after
reading, renders one pixel at quality 0 without bounding (-MB).

  tests/bench/parse_speed.py [--runs N] [--bin FOLDER] [--json FILE] [loop|macro|strings|mesh ...]
"""
import argparse
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n"
TAIL = '#debug concat("Result: ", {}, "\\n")\n'

EMPTY = HEAD + TAIL.format('"nothing"')

LOOP = HEAD + """
#declare P = <0, 0, 0>;
#declare V = <1, .5, .25>;
#declare N = 0;
#declare I = 0;
#while (I < 1000000)
  #declare P = P + V*0.001 - vcross(V, <I, 1, 2>)*1e-9;
  #if (P.x > 1)
    #declare P = <P.x - 1, P.y*.5, P.z>;
    #declare N = N + 1;
  #end
  #declare I = I + 1;
#end
""" + TAIL.format('str(N,0,0), " ", vstr(3, P, " ", 0, 6)')

MACRO = HEAD + """
#declare Made = 0;
#macro Tree(Depth, Base, Way, Size)
  #local Tip = Base + Way*Size;
  sphere { Base, Size*.2 pigment { rgb <1, .5, 0> } }
  cylinder { Base, Tip, Size*.1 }
  #declare Made = Made + 2;
  #if (Depth > 0)
    #local Turned = vaxis_rotate(Way, y, 120);
    Tree(Depth - 1, Tip, vnormalize(Way + x*.5), Size*.7)
    Tree(Depth - 1, Tip, vnormalize(Turned + y*.5), Size*.7)
  #end
#end
Tree(15, <0, 0, 0>, y, 1)
Tree(14, <5, 0, 0>, y, 1)
Tree(10, <9, 0, 0>, y, 1)
""" + TAIL.format('str(Made,0,0)')

STRINGS = HEAD + """
#declare Turns = 100000;
#fopen Out "numbers.txt" write
#for (I, 1, Turns)
  #declare Name = concat("point_", str(I, -6, 0), chr(65 + mod(I, 26)));
  #write (Out, "\\"", Name, "\\", ", I/3, ", ", vstr(3, <I, sin(I), -I>, ", ", 0, 4), ",\\n")
#end
#fclose Out
#fopen In "numbers.txt" read
#declare Sum = 0;
#declare Count = 0;
#declare Letters = "";
#while (defined(In))
  #read (In, Name, A, B, C, D)
  #declare Sum = Sum + A + B + C + D;
  #if (mod(Count, 5000) = 0)
    #declare Letters = concat(Letters, substr(strupr(Name), strlen(Name), 1));
  #end
  #declare Count = Count + 1;
#end
""" + TAIL.format('str(Count,0,0), " ", str(Sum,0,3), " ", Letters')


def mesh():
    """A mesh2 of 500 x 500 squares, two triangles each, as modellers write them."""
    side = 500
    vertices = ",\n".join(
        f"<{x / side:.6f}, {0.1 * math.sin(x * .1) * math.cos(y * .07):.6f}, {y / side:.6f}>"
        for y in range(side + 1) for x in range(side + 1))
    faces = []
    for y in range(side):
        for x in range(side):
            a = y * (side + 1) + x
            b = a + side + 1
            faces.append(f"<{a}, {a + 1}, {b}>, <{a + 1}, {b + 1}, {b}>")
    return (HEAD + f"mesh2 {{\n vertex_vectors {{ {(side + 1) ** 2},\n{vertices}\n }}\n"
            f" face_indices {{ {2 * side * side},\n" + ",\n".join(faces) +
            "\n }\n pigment { rgb 1 }\n}\n" + TAIL.format('"mesh"'))


SCENES = {"loop": lambda: LOOP, "macro": lambda: MACRO, "strings": lambda: STRINGS, "mesh": mesh}
SAID = {"loop": "1e6 turns of a loop, vector arithmetic, #if",
        "macro": "recursive macro, about 200,000 objects",
        "strings": "strings built, written and read back",
        "mesh": "mesh2 of 500,000 triangles"}


def run(command, folder):
    """CPU seconds, and what it said; stops on failure."""
    before = os.times()
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    after = os.times()
    said = done.stdout.decode(errors="replace")
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{said[-3000:]}")
    return (after.children_user - before.children_user + after.children_system -
            before.children_system), said


def result_of(said):
    found = re.search(r"Result: (.*)", said)
    return found.group(1).strip() if found else "none"


def stock_parse_time(said):
    """What stock reports for parsing alone; 0 where it is too short for a report."""
    found = re.search(r"Parse Time:.*?\n\s*using \d+ thread\(s\) with ([\d.]+) CPU-seconds", said)
    return float(found.group(1)) if found else 0.0


def our_parse_time(said):
    found = re.search(r"Parsed: .* ([\d.]+) s", said)
    return float(found.group(1))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--bin", default=str(ROOT / "build" / "release" / "bin"))
    parser.add_argument("--json")
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    args = parser.parse_args()
    program = pathlib.Path(args.bin).resolve() / "lentray"
    ways = {"lentray": [program, "scene.pov", "--parse-only", "+W1", "+H1", "+V"],
            "stock": ["povray", "+Iscene.pov", "-F", "+W1", "+H1", "-Q0", "-D", "-A", "-MB", "+WT1"]}
    names = ["empty"] + args.scenes
    times = {(name, way): [] for name in names for way in ways}
    parsing = {(name, way): [] for name in names for way in ways}
    with tempfile.TemporaryDirectory() as temporary:
        folders = {}
        for name in names:
            folders[name] = pathlib.Path(temporary) / name
            folders[name].mkdir()
            text = EMPTY if name == "empty" else SCENES[name]()
            (folders[name] / "scene.pov").write_text(text)
        for _ in range(args.runs):
            for name in names:
                results = {}
                for way, command in ways.items():
                    seconds, said = run(command, folders[name])
                    times[name, way].append(seconds)
                    results[way] = result_of(said)
                    own = stock_parse_time if way == "stock" else our_parse_time
                    parsing[name, way].append(own(said))
                if results["lentray"] != results["stock"]:
                    sys.exit(f"{name}: not the same result: {results}")
    whole = {key: statistics.median(values) for key, values in times.items()}
    reading = {key: statistics.median(values) for key, values in parsing.items()}
    print(f"CPU seconds, medians of {args.runs}; start-up taken off whole processes: lentray "
          f"{whole['empty', 'lentray']:.3f}, stock {whole['empty', 'stock']:.3f}")
    out = []
    for name in args.scenes:
        ours, theirs = reading[name, "lentray"], reading[name, "stock"]
        all_ours, all_theirs = (whole[name, way] - whole["empty", way] for way in ways)
        print(f"  {name:<8} lentray {ours:6.3f}  stock {theirs:6.3f}  stock / lentray = "
              f"{theirs / max(ours, 1e-3):5.1f}   whole processes {all_ours:6.3f} {all_theirs:6.3f}"
              f"   {SAID[name]}")
        out.append({"scene": name, "lentray": ours, "stock": theirs,
                    "lentray_process": all_ours, "stock_process": all_theirs})
    if args.json:
        pathlib.Path(args.json).write_text(json.dumps(out, indent=2) + "\n")


if __name__ == "__main__":
    main()
