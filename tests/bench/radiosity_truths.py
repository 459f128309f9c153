"""Indirect light beside truths that need no renderer, by the number of rays a sample.

  python3 tests/bench/radiosity_truths.py [--no-docs]      chart: docs/radiosity_truths.png; a table

furnace   a ball from within that glows with e = 0.25 and reflects p = 0.5: e (1 + p + .. + p^bounces)
square    the form factor of the square -1 .. 1 at height 1, straight above the point: 0.554126; the root of the mean
          square over six turns of the square, for its edges meet each turn's directions anew
patches   two such squares that face each other, the lower one grey and glowing, the upper one red. What returns to
          the lower one is its form factor to each point of the upper one, in closed form, times the form factor
          back, integrated over the upper one by Gauss's rule of 16 x 16 points; relative, over 18 x 18 points

The exit status is 1 where lentray is farther from a truth than stock POV-Ray with as many rays.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402
from support.pictures import read_png  # noqa: E402

COUNTS = (35, 50, 100, 200, 400, 800, 1600)
TURNS = (0, 15, 30, 45, 60, 75)
ROUNDING = 1 / 65535
SIZE = 18
HEAD = """#version 3.7; global_settings { assumed_gamma 1 radiosity { count %d SETTINGS } }
#default { finish { ambient 0 diffuse 1 } }
#declare Patch = polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> rotate 90*x }
"""
FURNACE = HEAD.replace("SETTINGS", "recursion_limit %d") + """camera { location 0 direction z }
sphere { 0, 10 pigment { rgb 1 } finish { emission 0.25 diffuse 0.5 } }
"""
SQUARE = HEAD.replace("SETTINGS", "error_bound 0.1 recursion_limit 1 pretrace_start 0.5 pretrace_end 0.125 "
                      "minimum_reuse 0.001") + """
camera { orthographic location 0.5*y direction -0.5*y up 0.02*z right 0.02*x }
plane { y, 0 pigment { rgb 1 } }
object { Patch rotate %d*y translate y pigment { rgb 1 } finish { emission 1 diffuse 0 } }
"""
PATCHES = HEAD.replace("SETTINGS", "error_bound 0.3 recursion_limit 2 pretrace_start 0.25 pretrace_end 0.0625 "
                       "minimum_reuse 0.01") + """
camera { orthographic location 0.5*y direction -0.5*y up 1.8*z right 1.8*x }
object { Patch pigment { rgb 0.5 } finish { emission 1 } }
object { Patch translate y pigment { rgb <0.9, 0.3, 0.1> } }
"""
ABOVE = (0.9, 0.3, 0.1)


def corner(a, b):
    p, q = math.hypot(1, a), math.hypot(1, b)
    return (a / p * math.atan(b / p) + b / q * math.atan(a / q)) / (2 * math.pi)


def factor(x, z):
    return corner(1 - x, 1 - z) + corner(1 - x, 1 + z) + corner(1 + x, 1 - z) + corner(1 + x, 1 + z)


def gauss(points):
    """Places and weights on -1 .. 1: zeros of Legendre's polynomial by Newton's method."""
    out = []
    for i in range(points):
        t = math.cos(math.pi * (i + 0.75) / (points + 0.5))
        for _ in range(50):
            before, here = 1.0, t
            for k in range(2, points + 1):
                before, here = here, ((2 * k - 1) * t * here - (k - 1) * before) / k
            slope = points * (t * here - before) / (t * t - 1)
            t -= here / slope
        out.append((t, 2 / ((1 - t * t) * slope * slope)))
    return out


def returned():
    """Of the lower patch's light, for reflectances of 1, at the middles of SIZE x SIZE pixels."""
    rule = gauss(16)
    above = [(s, t, u * v * factor(s, t) / math.pi) for s, u in rule for t, v in rule]
    places = [((i + 0.5) / SIZE - 0.5) * 1.8 for i in range(SIZE)]
    return [[sum(w / (1 + (x - s) ** 2 + (z + t) ** 2) ** 2 for s, t, w in above) for x in places] for z in places]


def render(program, text, size):
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "scene.pov").write_text(text)
        subprocess.run([program, "+Iscene.pov", "+Opicture.png", "+FN16", "File_Gamma=1", f"+W{size}", f"+H{size}", "-A",
                        "-D", "-V", "-GA", "+WT1"], cwd=where, check=True, capture_output=True)
        return [[[v / 65535 for v in pixel[:3]] for pixel in row] for row in
                read_png((where / "picture.png").read_bytes())[0]]


def furnace(program, count, bounces):
    truth = 0.25 * sum(0.5 ** i for i in range(bounces + 1))
    picture = render(program, FURNACE % (count, bounces), 8)
    return max(abs(v - truth) for row in picture for pixel in row for v in pixel)


def square(program, count):
    truth, squares = factor(0, 0), []
    for turn in TURNS:
        for row in render(program, SQUARE % (count, turn), 4):
            squares += [(pixel[0] - truth) ** 2 for pixel in row]
    return math.sqrt(sum(squares) / len(squares))


def patches(program, count, truth):
    picture, off, all_light = render(program, PATCHES % count, SIZE), 0.0, 0.0
    for row, light in zip(picture, truth):
        for pixel, back in zip(row, light):
            for value, reflectance in zip(pixel, ABOVE):
                wanted = 0.25 * reflectance * back
                off += (value - 0.5 - wanted) ** 2
                all_light += wanted ** 2
    return math.sqrt(off / all_light)


def measure(programs):
    back = returned()
    cases = [(f"furnace, {n} bounce{'s' if n > 1 else ''}", lambda p, c, n=n: furnace(p, c, n)) for n in (1, 2, 3)]
    cases += [("square", square), ("patches", lambda p, c: patches(p, c, back))]
    results = {}
    for name, error in cases:
        for program in programs:
            results[name, program] = [error(programs[program], count) for count in COUNTS]
    return [name for name, _ in cases], results


def chart(results, path):
    blocks, plots = [], []
    for name, title in (("furnace, 3 bounces", "white furnace, 3 bounces"), ("square", "form factor, square overhead"),
                        ("patches", "two facing patches, relative")):
        lines = []
        for program, style in (("povray", "pt 4 ps 2"), ("lentray", "pt 7")):
            lines.append(f"'data' index {len(blocks)} with linespoints {style} title '{program}'")
            blocks.append("\n".join(f"{n} {max(e, 1e-7)}" for n, e in zip(COUNTS, results[name, program])))
        if name != "furnace, 3 bounces":
            lines.append(f"{results[name, 'lentray'][0] * math.sqrt(COUNTS[0])}/sqrt(x) with lines dashtype 2 "
                         "linecolor 'black' title '1/sqrt(n)'")
        reach = "[1e-7:1e-3]" if name.startswith("furnace") else "[1e-4:0.3]"
        plots.append(f"set title '{title}'\nplot [25:2200] {reach} " + ", ".join(lines))
    gnuplot("1200,420", "set logscale xy\nset format y '%.0e'\nset xlabel 'rays a sample'\n"
            "set ylabel 'error'\nset multiplot layout 1,3\n" + "\n".join(plots), blocks, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--no-docs", action="store_true")
    args = parser.parse_args()
    names, results = measure({"povray": "povray", "lentray": args.bin.resolve() / "lentray"})
    print("| truth | |", *(f"{n} |" for n in COUNTS), "\n|---|---|" + "--:|" * len(COUNTS))
    farther = 0
    for name in names:
        for program in ("povray", "lentray"):
            print(f"| {name} | {program} |", *(f"{e:.5f} |" for e in results[name, program]))
        farther += sum(ours > stock + ROUNDING * (20 if name == "patches" else 1)
                       for stock, ours in zip(results[name, "povray"], results[name, "lentray"]))
    if not args.no_docs:
        chart(results, ROOT / "docs" / "radiosity_truths.png")
    sys.exit(1 if farther else 0)


if __name__ == "__main__":
    main()
