"""How honest the progress of a picture is: the time left it tells beside the time that was left.

Ten scenes whose cost is uneven over the picture are rendered with their progress read from a pipe.
Of every line from 20 % on that came at least a second before the end, the worst factor between
both times is printed. A scene beyond the limit is repeated.

  tests/bench/progress_honesty.py [--busy] [--threads N] [--repeats N] [--lines] [name ...]

Nobody foresees what else a machine will do. With --busy the time that was left is the CPU time
that was, at the pace of the third of the run before the line.

The exit status is 1 if a scene's best run is beyond a factor of 1.5.
"""
import argparse
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
ALLOWED = 1.5
FROM_PERCENT, LEAST_SECONDS = 20, 1.0

HEAD = """#version 3.7; global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2, -8> look_at <0, 2, 0> right 4/3*x }
background { rgb <0.5, 0.7, 1> }
"""
SUN = "light_source { <20, 30, -20> rgb 1 }\n"
LAMPS = """#for (I, 0, 2) light_source { <8*I - 8, 12, -6> rgb 0.4
  area_light 3*x, 3*z, 9, 9 } #end
"""
FLOOR = "plane { y, 0 pigment { checker rgb 1, rgb 0.3 } }\n"
GLASS = """#declare Glass = texture { pigment { rgbf <0.95, 0.95, 1, 0.9> } finish { reflection 0.15 specular 0.5 } }
"""
BALLS = GLASS + """#for (I, -4, 4) #for (K, 0, 3)
  sphere { <I*0.9, 0.45 + (mod(I + K + 8, 3))*0.1, K*1.1 - 3>, 0.42 texture { Glass } interior { ior 1.5 } }
#end #end
"""
PIERCED = """#declare Pierced = difference { box { -1, 1 }
  #for (I, -4, 4) #for (K, -4, 4)
    cylinder { <I*0.22, K*0.22, -2>, <I*0.22, K*0.22, 2>, 0.09 }
    cylinder { <I*0.22, -2, K*0.22>, <I*0.22, 2, K*0.22>, 0.09 }
  #end #end pigment { rgb <0.9, 0.6, 0.3> } }
"""
HILLS = """isosurface { function { y - 1.2 - 0.5*sin(x*3 + sin(z*2)) - 0.3*sin(z*4 + 2*sin(x))
  - 0.1*sin(x*17)*sin(z*15) } max_gradient 6 accuracy 0.0005
  contained_by { box { <-1.6, 0, -1>, <1.6, 2.4, 2> } } pigment { rgb <0.4, 0.7, 0.3> } }
"""
GRASS = """#declare R = seed(3); union { #for (I, 1, 9000)
  #local P = <rand(R)*10 - 5, 0, rand(R)*7 - 4>;
  cylinder { P, P + <rand(R)*0.2 - 0.1, 0.3 + 0.4*rand(R), 0>, 0.008 } #end pigment { rgb <0.2, 0.6, 0.1> } }
"""

# name: scene text or a path in the examples, options
SCENES = {
    "glass_below": (HEAD + SUN + FLOOR + BALLS, "+W4000 +H3000 -A"),
    "glass_below_aa1": (HEAD + SUN + FLOOR + BALLS, "+W2400 +H1800 +A0.1 +AM1 +R3"),
    "glass_below_aa2": (HEAD + SUN + FLOOR + BALLS, "+W2000 +H1500 +A0.1 +AM2 +R3"),
    "glass_above": (HEAD + SUN + FLOOR + BALLS.replace("0.45 +", "2.8 +"), "+W4000 +H3000 -A"),
    "lamps_below": (HEAD + LAMPS + FLOOR + GRASS, "+W1280 +H960 -A"),
    "csg_corner": (HEAD + LAMPS + PIERCED + "object { Pierced rotate <30, 30, 0> translate <2.6, 0.2, 0> }",
                   "+W640 +H480 -A"),
    "one_object_aa1": (HEAD + LAMPS + FLOOR + HILLS, "+W640 +H480 +A0.2 +AM1 +R3"),
    "grass_aa1": (HEAD + SUN + GRASS, "+W3200 +H2400 +A0.1 +AM1 +R4"),
    "part_aa2": (HEAD + LAMPS + FLOOR + PIERCED + "object { Pierced rotate <30, 30, 0> translate <1, 1, 0> }",
                 "+W200 +H150 +A0.2 +AM2 +R3 +SR50 +ER140 +SC75 +EC200"),
    "example_chess": ("advanced/chess2.pov", "+W1600 +H1200 +A0.2 +AM1 +R3"),
}


def run(program, scene, options, threads):
    """[(time, CPU time, percent, seconds left)], one a line; the last one is the end."""
    text, size = SCENES[scene]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        path, here = folder / "scene.pov", folder
        if text.endswith(".pov"):
            path, here = EXAMPLES / text, (EXAMPLES / text).parent
        else:
            path.write_text(text)
        command = [program, f"+I{path}", f"+O{folder}/a.png", "+FN8", "-D", "+V", f"+WT{threads}",
                   *shlex.split(size), *options]
        lines = []
        with subprocess.Popen(command, cwd=here, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, errors="replace") as process:
            first = time.monotonic()
            for line in process.stderr:
                now = time.monotonic() - first
                if found := re.match(r"Rendering: (\d+)%(?:, (.*) left)?", line):
                    lines.append((now, cpu_seconds(process.pid), int(found.group(1)),
                                  seconds(found.group(2) or "0 s")))
        if process.returncode != 0:
            sys.exit(f"{scene}: lentray failed")
    return lines


def cpu_seconds(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def times_left(lines, busy):
    """[(percent, told, left)] of lines before the end."""
    end, cpu_end = lines[-1][:2]
    out = []
    for now, cpu, percent, told in lines[:-1]:
        left = end - now
        if busy:
            before, cpu_before = next(((t, c) for t, c, *_ in reversed(lines) if t <= now * 2 / 3), (0.0, 0.0))
            left = (cpu_end - cpu) * (now - before) / max(cpu - cpu_before, 0.01)
        out.append((percent, told, left))
    return out


def seconds(text):
    unit = {"h": 3600.0, "min": 60.0, "s": 1.0}
    return sum(float(n) * unit[u] for n, u in re.findall(r"([\d.]+) (h|min|s)\b", text))


def factor(told, left):
    return math.inf if told <= 0.0 else max(told / left, left / told)


def worst(left):
    """The worst factor, at what percentage, and how many lines were judged."""
    judged = [(factor(told, true), percent) for percent, told, true in left
              if percent >= FROM_PERCENT and true >= LEAST_SECONDS]
    return *max(judged, default=(1.0, 100)), len(judged)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="name", help="of scenes; none: all")
    parser.add_argument("--busy", action="store_true", help="the machine does other work too")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--repeats", type=int, default=3, help="at most, of a scene beyond the limit")
    parser.add_argument("--arguments", default="", help="further options of lentray")
    parser.add_argument("--lines", action="store_true", help="show every line")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    args = parser.parse_args()

    failed = False
    for name in args.names or SCENES:
        for _ in range(args.repeats):
            lines = run(args.bin.resolve() / "lentray", name, shlex.split(args.arguments), args.threads)
            left = times_left(lines, args.busy)
            most, percent, count = worst(left)
            print(f"{name:18} {lines[-1][0]:6.1f} s, CPU {lines[-1][1]:5.1f} s  "
                  f"worst factor {most:5.2f} at {percent:3} %, {count:2} lines", flush=True)
            if args.lines:
                for at, told, true in left:
                    print(f"  {at:3} %  told {told:6.1f} s  left {true:6.1f} s")
            if most <= ALLOWED:
                break
        failed = failed or most > ALLOWED
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
