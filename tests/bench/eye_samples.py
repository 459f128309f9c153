"""What sampling for the eye (+AM3) costs and gives on prints, beside stock's method (+A0.3).

  tests/bench/eye_samples.py                 24 examples: the middle third of 100 x 75 mm, 40 lpi, 600 dpi, seen from 40 cm
  tests/bench/eye_samples.py granite mtmand  those whose path contains a word; a path that ends with .pov: that scene
  tests/bench/eye_samples.py --print "Lens_Sheet=60 Sheet_Width=50mm Sheet_Height=37.5mm Print_DPI=720 View_Distance=40cm"
  tests/bench/eye_samples.py --more +R2      another setting of +AM3
  tests/bench/eye_samples.py --cost          time alone
  tests/bench/eye_samples.py --views 15      pictures of Views=15, joined to a sheet

CPU seconds of whole processes, one thread each, and the error that an eye sees (lentray-diff --seen: L*, RMS and 99th
percentile). Each way is held against its own limit, of samples that no other picture takes: +AM3 against spread samples
in linear light (Antialias_Grid), +A0.3 without and with jitter against jittered samples of every pixel in the scene's
gamma (+A0.0). `cheaper`: CPU of `+A0.3 -J` over that of +AM3; `error`: that of +AM3 over that of +A0.3 -J, and of +A0.3.
The exit status is 1 unless +AM3 is --median times cheaper in the median, --least times at least, and errs nowhere more than
`+A0.3 -J`, but for what nobody sees: 0.3.
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

PRINT = "Lens_Sheet=40lpi Sheet_Width=100mm Sheet_Height=75mm Print_DPI=600 View_Distance=40cm"
UNSEEN = 0.3  # L*


def join(args, pictures, out, width, height):
    words = dict(word.lower().split("=") for word in args.print.split())
    names = {"lens_sheet": "--lens-sheet", "print_dpi": "--dpi", "view_distance": "--view-distance"}
    subprocess.run([args.bin / "lentray-views", "--interlace", *pictures, "--size", f"{width}x{height}", "--out", out,
                    *[word for name, option in names.items() for word in (option, words[name])]], check=True, capture_output=True)


def render(args, scene, out, words, part):
    """CPU seconds, and rays a pixel. Of the file the rows that are compared stay."""
    for old in out.parent.glob(f"{out.stem}*.json"):
        old.unlink()
    about = out.with_suffix(".json")
    top, bottom = part
    picture = out
    if args.views:
        words = [*words, f"Views={args.views}"]
        picture = out.with_name(f"{out.stem}.##.png")
    seconds = cpu_seconds([args.bin / "lentray", f"+I{scene.name}", f"+O{picture}", "Lenticular=On", *args.print.split(), *words,
                           *([] if bottom - top == 1 else [f"+SR{top:g}", f"+ER{bottom:g}"]), "+FN16", "-D", "-V", "-P", "+WT1",
                           f"Statistics_File={about}"], scene.parent)
    pictures = [json.loads(file.read_text()) for file in sorted(out.parent.glob(f"{out.stem}*.json"))]
    rays = sum(one["rays"]["camera"] for one in pictures)
    width, height = pictures[0]["image"]["width"], pictures[0]["image"]["height"]
    if args.views:
        join(args, sorted(out.parent.glob(f"{out.stem}.[0-9#]*.png")), out, width, height)
    if args.seen[1] - args.seen[0] < 1:
        first = int(args.seen[0] * height) + 2
        rows = int(args.seen[1] * height) - 2 - first
        subprocess.run(["oiiotool", out, "--cut", f"{width}x{rows}+0+{first}", "-o", out], check=True, capture_output=True)
    return seconds, rays / (width * height * (bottom - top))


def seen(args, one, two):
    out = one.with_suffix(".seen.json")
    subprocess.run([args.bin / "lentray-diff", "--seen", one, two, "--json", out], check=False, capture_output=True)
    return json.loads(out.read_text())["l_star"]


def measure(args, scene, folder):
    """By way: CPU seconds, rays a pixel, error."""
    spread, stock = folder / "spread.png", folder / "stock.png"
    render(args, scene, spread, [f"Antialias_Grid={args.grid}", "+AM3"], args.seen)
    render(args, scene, stock, ["+A0.0", f"+R{args.grid}", "+J"], args.seen)
    ways = {"-J": (["+A0.3", "-J"], stock), "+J": (["+A0.3", "+J"], stock),
            "eye": (["+A0.3", "+AM3", *args.more.split()], spread)}
    figures = {}
    for way, (words, limit) in ways.items():
        picture = folder / f"{way}.png"
        figures[way] = (*render(args, scene, picture, words, args.rows), seen(args, picture, limit))
    return figures


def cost(args, scene):
    """How much cheaper +AM3 is; prints it."""
    with tempfile.TemporaryDirectory() as temporary:
        stock, eye = (render(args, scene, pathlib.Path(temporary) / "picture.png", words, args.rows)[0]
                      for words in (["+A0.3", "-J"], ["+A0.3", "+AM3", *args.more.split()]))
    print(f"| {scene.stem} | {stock:.2f} | {eye:.2f} | {stock / eye:.2f} |", flush=True)
    return stock / eye


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--print", default=PRINT, metavar="OPTIONS")
    parser.add_argument("--more", default="", metavar="OPTIONS")
    parser.add_argument("--views", type=int, default=0, metavar="N", help="pictures of so many views, joined (default: a sheet)")
    parser.add_argument("--rows", type=float, nargs=2, default=(0.3333, 0.6667), metavar=("TOP", "BOTTOM"),
                        help="parts of the height")
    parser.add_argument("--seen", type=float, nargs=2, default=(0.44, 0.56), metavar=("TOP", "BOTTOM"),
                        help="of these, those whose error is measured (of slanted lenses all: 0 1)")
    parser.add_argument("--grid", type=int, default=4, metavar="N", help="of the limits (default 4: 16 samples a pixel)")
    parser.add_argument("--cost", action="store_true", help="time alone, no errors: a quarter of the time")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin", metavar="FOLDER")
    parser.add_argument("--median", type=float, default=0.0, metavar="RATIO")
    parser.add_argument("--least", type=float, default=0.0, metavar="RATIO")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    scenes = [EXAMPLES / (INSTEAD.get(name, name) + ".pov") for name in SCENES]
    if args.words:
        scenes = [scene for scene in scenes if any(word in str(scene) for word in args.words)]
        scenes += [pathlib.Path(word).resolve() for word in args.words if word.endswith(".pov")]
    ratios, worse = [], []
    if args.cost:
        print("| scene | +A0.3 -J, CPU s | +AM3, CPU s | cheaper |\n|---|---:|---:|---:|")
    else:
        print("| scene | +A0.3 -J, CPU s | rays | L* RMS | 99 % | RMS of +A0.3 | +AM3, CPU s | rays | L* RMS | 99 % | cheaper | error |\n"
          "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for scene in scenes:
        name = scene.stem
        if args.cost:
            ratios.append(cost(args, scene))
            continue
        with tempfile.TemporaryDirectory() as temporary:
            figures = measure(args, scene, pathlib.Path(temporary))
        cell = {way: f"{seconds:.2f} | {rays:.2f} | {error['rms']:.2f} | {error['within_99']:.2f}"
                for way, (seconds, rays, error) in figures.items()}
        rms = {way: error["rms"] for way, (_, _, error) in figures.items()}
        ratios.append(figures["-J"][0] / figures["eye"][0])
        errors = [rms["eye"] / max(rms[way], 1e-9) for way in ("-J", "+J")]
        if errors[0] > 1.0 and rms["eye"] > UNSEEN:
            worse.append(name)
        print(f"| {name} | {cell['-J']} | {rms['+J']:.2f} | {cell['eye']} | {ratios[-1]:.2f} | {errors[0]:.2f}, {errors[1]:.2f} |",
              flush=True)
    print(f"\nmedian {statistics.median(ratios):.2f}, least {min(ratios):.2f}; larger errors: {', '.join(worse) or 'none'}")
    sys.exit(0 if not worse and statistics.median(ratios) >= args.median and min(ratios) >= args.least else 1)


if __name__ == "__main__":
    main()
