"""What a print shows of the example scenes, and whether anything in it jumps (docs/depth.md).

  python3 tests/bench/composition.py                    all examples
  python3 tests/bench/composition.py woodbox glass      those whose path contains a word
  python3 tests/bench/composition.py --table FILE       also writes them as a page

For each example the first command of README without antialiasing, three questions:
  its own picture   the middle one of 15 views (Views=15, 160 x 120) beside stock's ordinary picture of the same
                    camera and size, and Lentray's ordinary picture beside it: grades of docs/compare.md
  jumps             every pixel of the whole sheet, by eyes and projections of lentray-dense-depth's own: the most that
                    anything moves from one view to the next, the background included, in pixels of a view
  depth             (largest - smallest parallax) / 3: how much of 1.5 pixels both ways is used, by all and by the middle nine
                    tenths of the pixels; what stays unused where the plane is in the middle is none of the sheet's
and what the survey costs: CPU seconds that Depth=print takes more than Depth=viewer, without a picture.
The exit status is 1 if anything jumps or is cut, or a view is not the scene's picture where that is exact or a match, but
for what KNOWN names with its reason.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import pictures

SCENES = pathlib.Path("/usr/share/doc/povray/examples")
PRINT = ["Lenticular=On", "Lens_Sheet=40lpi", "Sheet_Width=100mm", "Sheet_Height=75mm", "View_Distance=40cm", "-A"]
WIDTH, HEIGHT = 160, 120
# Scenes whose print is known to be less, and why.
RADIOSITY = "radiosity: its samples are those of the whole sheet, which all views share"
SLIVER = "a sliver of a far edge between the rays of the survey"
KNOWN = {
    "advanced/isocacti.pov": SLIVER, "objects/superel1.pov": SLIVER, "objects/superel2.pov": SLIVER,
    "objects/superel3.pov": SLIVER,
    "interior/media/media1.pov": "the camera stands in the plane of a wall, which is at no distance from the eyes",
    "animations/camera2/camera2.pov": "the camera's `normal`, which sheets leave out",
    "camera/normal.pov": "the camera's `normal`, which sheets leave out",
    "language/image_size.pov": "it shows the size of the picture, which is the sheet's",
    "objects/fractal2.pov": "pixels of the fractal's edge, by rounding",
}
QUIET = ["-D", "-V", "-P", "+GA", "-GR", "-GS"]
BUDGET = 1.5
COLUMNS = ["scene", "own", "view", "most", "background", "used", "used90", "factor", "survey_s", "said", "reason"]


def run(words, folder, limit):
    try:
        done = subprocess.run([str(w) for w in words], cwd=folder, capture_output=True, text=True, errors="replace",
                              timeout=limit)
        return done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        return None, "time limit"


def cpu_of(words, folder, limit):
    """CPU seconds of a process alone: children of this one are counted together, so it has a shell's own count."""
    status, text = run(["/usr/bin/env", "bash", "-c", 'TIMEFORMAT="%U %S"; time "$@" >/dev/null 2>&1', "x", *words],
                       folder, limit)
    figures = text.split()
    return sum(map(float, figures[-2:])) if status is not None and len(figures) >= 2 else None


def grade(a, b):
    """docs/compare.md: exact, match, or differs."""
    if not a.exists() or not b.exists():
        return "none"
    rows_a, _ = pictures.read_png(a.read_bytes())
    rows_b, _ = pictures.read_png(b.read_bytes())
    worst, squares, samples = [], 0, 0
    for row_a, row_b in zip(rows_a, rows_b):
        for p, q in zip(row_a, row_b):
            apart = [abs(x - y) for x, y in zip(p[:3], q[:3])]
            worst.append(max(apart))
            squares += sum(d * d for d in apart)
            samples += 3
    within = lambda level: sum(d <= level for d in worst) / len(worst)
    psnr = math.inf if squares == 0 else 10 * math.log10(255 ** 2 * samples / squares)
    if within(1) >= 0.999:
        return "exact"
    return "match" if within(2) >= 0.99 and psnr >= 40 else f"{psnr:.0f} dB"


def measure(scene, args):
    row = dict.fromkeys(COLUMNS, "")
    row["scene"] = str(scene.relative_to(SCENES)) if scene.is_relative_to(SCENES) else str(scene)
    with tempfile.TemporaryDirectory() as temporary:
        out = pathlib.Path(temporary)
        lentray = [args.bin / "lentray", f"+I{scene.name}", "+WT1", *QUIET[:3]]
        sheet = [*lentray, *PRINT, f"Print_DPI={args.dpi}"]
        view = [*sheet, "Views=15", "View=7", f"View_Size={WIDTH}x{HEIGHT}", f"+O{out / 'view.png'}",
                f"Statistics_File={out / 'view.json'}"]
        status, text = run(view, scene.parent, args.limit)
        if status != 0:
            reason = re.search(r"(?:error: |warning: not )([^\n]*)", text)
            row["reason"] = reason[1] if reason else "time limit" if status is None else text.strip()[-80:]
            return row
        row["said"] = " ".join(sorted(set(re.findall(r"warning: (jumps|cut|flat|reversed):", text))))
        size = [f"+W{WIDTH}", f"+H{HEIGHT}", "-A"]
        run([*lentray, *size, f"+O{out / 'own.png'}"], scene.parent, args.limit)
        run(["povray", f"+I{scene.name}", *size, "-D", "-V", "-P", "+FN", "+WT1", f"+O{out / 'stock.png'}"],
            scene.parent, args.limit)
        row["own"] = grade(out / "own.png", out / "stock.png")
        row["view"] = grade(out / "view.png", out / "stock.png")
        statistics = json.loads((out / "view.json").read_text())
        row["factor"] = statistics["lens"]["depth_factor"]
        # The dense survey is of the whole sheet: its size stands in the lens's own figures.
        status, text = run([args.bin / "lentray-dense-depth", scene.name, out / "view.json"], scene.parent, args.limit)
        if status == 0:
            seen = json.loads(text.strip().splitlines()[-1])
            points = seen["rays"] > seen["background"]
            steps = [seen["least"], seen["most"]] if points else []
            middle = [seen["low"], seen["high"]] if points else []
            sky = seen["background"] > 0 and seen["sky"] != 0
            row["background"] = f"{seen['sky']:.3f}" if sky else "with the eye" if seen["background"] else ""
            if sky:
                steps.append(seen["sky"])
                if seen["background"] > 0.05 * seen["rays"]:
                    middle.append(seen["sky"])
            if steps:
                row["most"] = f"{max(map(abs, steps)):.3f}"
            if points:
                row["used"] = f"{(max(steps) - min(steps)) / (2 * BUDGET):.2f}"
            if middle:
                row["used90"] = f"{(max(middle) - min(middle)) / (2 * BUDGET):.2f}"
        else:
            row["reason"] = text.strip()[-80:]
        if args.cost:
            times = [cpu_of([*sheet, "--explain", mode], scene.parent, args.limit)
                     for mode in ("Depth=print", "Depth=viewer")]
            if None not in times:
                row["survey_s"] = f"{times[0] - times[1]:.2f}"
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin", metavar="FOLDER")
    parser.add_argument("--dpi", default="599.7", help="default 599.7: the sheet has 4:3 pixels then, as the views have, "
                        "and scenes that ask for the picture's shape are told the same; 299.35 does too")
    parser.add_argument("--limit", type=float, default=600, metavar="SECONDS")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--cost", action="store_true", help="also what the survey costs")
    parser.add_argument("--csv", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--table", type=pathlib.Path, metavar="FILE")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    scenes = [s for s in sorted(SCENES.rglob("*.pov")) if not args.words or any(w in str(s) for w in args.words)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(lambda s: measure(s, args), scenes):
            rows.append(row)
            print("\t".join(str(row[c]) for c in COLUMNS), flush=True)
            if args.csv:
                with args.csv.open("w", newline="") as file:
                    writer = csv.DictWriter(file, COLUMNS)
                    writer.writeheader()
                    writer.writerows(rows)
    return report(rows, args)


def report(rows, args):
    good = ("exact", "match")
    seen = [r for r in rows if r["view"]]
    jump = [r for r in seen if r["most"] and float(r["most"]) > BUDGET]
    cut = [r for r in seen if "cut" in r["said"]]
    worse = [r for r in seen if r["own"] in good and r["view"] not in good]
    little = [r for r in seen if r["used"] and float(r["used"]) < 0.8 and float(r["factor"]) < 1]
    print(f"\n{len(rows)} scenes, {len(seen)} have a sheet; {len(seen) - len(jump)} within {BUDGET} pixels a view, "
          f"{len(cut)} cut; {sum(r['own'] in good for r in seen)} own pictures are exact or match, "
          f"{sum(r['own'] in good and r['view'] in good for r in seen)} middle views too; "
          f"{len(little)} use less than 0.8 of the depth")
    for name, some in (("jumps", jump), ("cut", cut), ("view differs", worse), ("little depth", little)):
        for r in some:
            print(f"{name}: {r['scene']}: most {r['most']}, used {r['used']}, own {r['own']}, view {r['view']}: {known(r)}")
    costs = sorted(float(r["survey_s"]) for r in seen if r["survey_s"])
    if costs:
        print(f"survey: median {costs[len(costs) // 2]} s of CPU, {sum(c <= 0.3 for c in costs)} of {len(costs)} within 0.3 s, "
              f"at most {costs[-1]} s")
    if args.table:
        args.table.write_text(page(rows, seen, jump, cut, worse, args))
    return 1 if any(not known(r) for r in [*jump, *cut, *worse]) else 0


def known(row):
    """Why a scene's print is less; empty: nobody knows."""
    if row["scene"] in KNOWN:
        return KNOWN[row["scene"]]
    text = re.sub(r"//[^\n]*", "", (SCENES / row["scene"]).read_text(errors="replace"))
    return RADIOSITY if re.search(r"\bradiosity\s*\{", text) else ""


def page(rows, seen, jump, cut, worse, args):
    good = ("exact", "match")
    lines = ["# Prints of the examples", "",
             "For those who print scenes that they have: what does a print show of each example of POV-Ray, and does anything in it "
             "jump?", "",
             f"Written by `python3 tests/bench/composition.py --dpi {args.dpi} --table docs/depth/prints.md`; do not edit. What the "
             "columns are: [depth.md](../depth.md#prints-of-the-examples).", "",
             f"Of {len(rows)} scenes {len(seen)} have a camera for a lens sheet, and a picture. Nothing is cut in "
             f"{len(seen) - len(cut)} of them, nothing moves by more than {BUDGET} pixels a view in {len(seen) - len(jump)}. "
             f"{sum(r['own'] in good for r in seen)} own pictures are exact or match, and "
             f"{sum(r['own'] in good and r['view'] in good for r in seen)} of these middle views.", ""]
    for name, some in (("Moves by more", jump), ("Is cut", cut), ("The middle view is less than its own picture", worse)):
        reasons = {}
        for r in some:
            reasons.setdefault(known(r), []).append(r["scene"])
        lines += [f"- {name}: {', '.join(scenes)}: {reason}." for reason, scenes in reasons.items()]
    lines += ["", "| scene | own picture | middle view | moves at most | background | depth used | middle 90 % | of the true depth |",
              "|---|---|---|---|---|---|---|---|"]
    lines += [f"| {r['scene']} | {r['own']} | {r['view']} | {r['most']} | {r['background']} | {r['used']} | "
              f"{r['used90']} | {100 * float(r['factor']):.3g} % |" for r in seen]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.exit(main())
