"""What sampling for the eye (+AM3) costs and gives on prints, beside +A0.3 and beside stock's method.

  tests/bench/eye_samples.py                 24 examples, 50 x 37.5 mm, 40 lpi, 600 dpi, seen from 40 cm
  tests/bench/eye_samples.py granite mtmand  those whose path contains a word
  tests/bench/eye_samples.py --print "Lens_Sheet=60 Print_DPI=720"   another print
  tests/bench/eye_samples.py --more +R2      another setting of +AM3

CPU seconds of whole processes, one thread each, and the error that an eye sees (lentray-diff --seen: L*, RMS and 99th percentile)
against the mean of 36 samples a pixel that no other picture takes (Antialias_Grid=6). Each way is held against
its own limit: +A0.3 against means in the scene's gamma, +AM3 against means in linear light.
The exit status is 1 unless +AM3 is --median times cheaper in the median, --least times at least, and errs nowhere more.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "compat"))
from antialiasing import EXAMPLES, SCENES
from compare import cpu_seconds
from print_job import INSTEAD

PRINT = "Lens_Sheet=40lpi Sheet_Width=50mm Sheet_Height=37.5mm Print_DPI=600 View_Distance=40cm"


def render(args, scene, out, words):
    """CPU seconds, and rays a pixel."""
    about = out.with_suffix(".json")
    seconds = cpu_seconds([args.bin / "lentray", f"+I{scene.name}", f"+O{out}", "Lenticular=On", *args.print.split(), *words,
                           "+FN16", "-D", "-V", "-P", "+WT1", f"Statistics_File={about}"], scene.parent)
    told = json.loads(about.read_text())
    return seconds, told["rays"]["camera"] / (told["image"]["width"] * told["image"]["height"])


def seen(args, one, two):
    out = one.with_suffix(".seen.json")
    subprocess.run([args.bin / "lentray-diff", "--seen", one, two, "--json", out], check=False, capture_output=True)
    return json.loads(out.read_text())["l_star"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--print", default=PRINT, metavar="OPTIONS")
    parser.add_argument("--more", default="", metavar="OPTIONS")
    parser.add_argument("--grid", type=int, default=6, metavar="N", help="of the reference (default 6: 36 samples a pixel)")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", metavar="FOLDER")
    parser.add_argument("--median", type=float, default=0.0, metavar="RATIO")
    parser.add_argument("--least", type=float, default=0.0, metavar="RATIO")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    scenes = [INSTEAD.get(name, name) for name in SCENES]
    ratios, worse = [], []
    print("| scene | +A0.3, CPU s | rays | L* RMS | 99 % | +AM3, CPU s | rays | L* RMS | 99 % | cheaper | error |\n"
          "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for name in scenes:
        if args.words and not any(word in name for word in args.words):
            continue
        scene = EXAMPLES / (name + ".pov")
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            ways = {"stock": (["+A0.3", "-J"], []), "eye": (["+A0.3", "+AM3", *args.more.split()], ["+AM3"])}
            cells, figures = [], {}
            for way, (words, limit) in ways.items():
                seconds, rays = render(args, scene, folder / f"{way}.png", words)
                render(args, scene, folder / f"{way}-limit.png", [f"Antialias_Grid={args.grid}", *limit])
                error = seen(args, folder / f"{way}.png", folder / f"{way}-limit.png")
                figures[way] = seconds, error["rms"]
                cells.append(f"{seconds:.2f} | {rays:.2f} | {error['rms']:.2f} | {error['within_99']:.2f}")
            cheaper = figures["stock"][0] / figures["eye"][0]
            error = figures["eye"][1] / max(figures["stock"][1], 1e-9)
            ratios.append(cheaper)
            if error > 1.0:
                worse.append(name)
            print(f"| {name} | {cells[0]} | {cells[1]} | {cheaper:.2f} | {error:.2f} |", flush=True)
    print(f"\nmedian {statistics.median(ratios):.2f}, least {min(ratios):.2f}; larger errors: {', '.join(worse) or 'none'}")
    sys.exit(0 if not worse and statistics.median(ratios) >= args.median and min(ratios) >= args.least else 1)


if __name__ == "__main__":
    main()
