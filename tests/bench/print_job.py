"""CPU time of integral images of ordinary scenes, as people print them, against stock POV-Ray's views of them.

  tests/bench/print_job.py                      24 examples, 1200 x 900, antialiased (+A0.3 -J)
  tests/bench/print_job.py --plain              without antialiasing
  tests/bench/print_job.py --eye                lentray samples for the eye (+A0.3 +AM3), stock as before
  tests/bench/print_job.py --eye --width 2362 --height 1772 --rows 0.3333 0.6667      the middle third of 100 x 75 mm
  tests/bench/print_job.py --runs 5 granite     scenes whose path contains a word
  tests/bench/print_job.py --before FOLDER      another build of lentray instead of stock

Lentray renders the sheet with Lenticular=On: lenses of 15 pixels, seen from the scene's camera. Stock renders the 15
views, one after the other, with the cameras that lentray-diff --write-wrappers writes: the same pixels, not yet
interlaced. Whole processes, one thread each, user + system time. All ways of a scene are run in turns, and medians
are compared. The examples are those of tests/compat/antialiasing.py, but for two whose cameras have no sheet.

The exit status is 1 unless the median of the ratios is at least --median and none is below --least.
"""
import argparse
import json
import pathlib
import shutil
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "compat"))
from antialiasing import EXAMPLES, SCENES
from compare import cpu_seconds, stock, wrappers
import two_builds

INSTEAD = {"camera/fisheye": "objects/csg/granite", "camera/cylinder3": "lights/arealit2"}
LENS = 15


def sheet(program, scene, args, folder):
    return cpu_seconds([program, f"+I{scene}", f"+O{folder / 'sheet.png'}", "Lenticular=On", f"+W{args.width}",
                        f"+H{args.height}", *args.sheets, *args.part, "-D", "-V", "-P", "+WT1"], scene.parent)


def all_views(views, scene, args, folder):
    """The last lens may be cut: the views beyond it have one pixel less a row."""
    return sum(cpu_seconds([*stock(view, len(range(j, args.width, LENS)), args.height, view.parent, 1,
                                   args.antialiasing), *args.part, f"+L{scene.parent}"], folder)
               for j, view in enumerate(views))


def measure(name, args, tree):
    scene = tree / (name + ".pov")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary) / "pictures"
        folder.mkdir()
        views = []
        if not args.before:
            wrapped = pathlib.Path(temporary) / "wrappers"
            wrapped.mkdir()
            views, _ = wrappers(scene, args.width, args.height, args.bin, wrapped, ["Lenticular=On"])
            if len(views) != LENS:
                sys.exit(f"{scene}: {len(views)} views instead of {LENS}")
        ours, theirs = [], []
        for _ in range(args.runs):
            ours.append(sheet(args.bin / "lentray", scene, args, folder))
            theirs.append(sheet(args.before, scene, args, folder) if args.before else
                          all_views(views, scene, args, folder))
    return statistics.median(ours), statistics.median(theirs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--plain", action="store_true", help="without antialiasing")
    parser.add_argument("--eye", action="store_true", help="lentray with +A0.3 +AM3")
    parser.add_argument("--runs", type=int, default=1, metavar="N", help="of each way (default 1)")
    parser.add_argument("--width", type=int, default=1200)
    parser.add_argument("--height", type=int, default=900)
    parser.add_argument("--rows", type=float, nargs=2, metavar=("TOP", "BOTTOM"), help="parts of the height (default: all)")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin", metavar="FOLDER")
    parser.add_argument("--before", metavar="FOLDER", help="with bin/lentray, instead of stock")
    parser.add_argument("--median", type=float, default=0.0, metavar="RATIO")
    parser.add_argument("--least", type=float, default=0.0, metavar="RATIO")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    args.before = args.before and two_builds.program(parser, args.before)
    args.antialiasing = ["-A", "-J"] if args.plain else ["+A0.3", "-J"]
    args.part = [f"+SR{args.rows[0]:g}", f"+ER{args.rows[1]:g}"] if args.rows else []
    args.sheets = ["+A0.3", "+AM3"] if args.eye else args.antialiasing
    scenes = [INSTEAD.get(name, name) for name in SCENES]
    scenes = [name for name in scenes if not args.words or any(word in name for word in args.words)]
    if not scenes:
        parser.error("no scene has such a word in its path")
    rows = {}
    other = "before" if args.before else "stock"
    print(f"| scene | lentray, CPU s | {other}, CPU s | ratio |\n|---|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as temporary:
        tree = pathlib.Path(temporary) / "examples"
        shutil.copytree(EXAMPLES, tree)
        for name in scenes:
            ours, theirs = measure(name, args, tree)
            rows[name] = {"lentray": ours, other: theirs, "ratio": theirs / ours}
            print(f"| {name} | {ours:.2f} | {theirs:.2f} | {theirs / ours:.2f} |", flush=True)
    ratios = [row["ratio"] for row in rows.values()]
    median, least = statistics.median(ratios), min(ratios)
    print(f"\nmedian {median:.2f}, least {least:.2f}, most {max(ratios):.2f}")
    if args.json:
        args.json.write_text(json.dumps(rows, indent=2) + "\n")
    sys.exit(0 if median >= args.median and least >= args.least else 1)


if __name__ == "__main__":
    main()
