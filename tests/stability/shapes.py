"""The rate of wrong pixels of every shape in hard settings, stock POV-Ray's beside lentray's.

  python3 tests/stability/shapes.py                   all; writes docs/stability/shapes.png, prints the tables
  ... shapes.py --no-docs torus,box gap               the named shapes, groups or settings
  ... shapes.py --no-docs --csv a.csv torus           a part; then --read a.csv b.csv ... joins the parts
  ... shapes.py --check ...                           exit status 1 where lentray is worse than stock

Both render live, 65 x 65, no antialiasing. A pixel is wrong if it differs by more than 12/255 from
the truth (shape_scenes.py); where there is none, because the ray just grazes, it is not counted.
"""
import argparse
import collections
import concurrent.futures
import csv
import pathlib
import subprocess
import sys
import tempfile

from pictures import Renderer
from shape_scenes import SIZE, Case, all_cases

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOLERANCE = 12
SLACK = 3.0 / (SIZE * SIZE)  # up to three pixels more than stock's are no shortfall
GROUPS = ["plain", "scale", "scene", "far", "camera", "axis", "plane", "inside", "surface", "gap", "grazing",
          "thin", "degenerate"]


def differ(a, b):
    return max(abs(x - y) for x, y in zip(a, b)) > TOLERANCE


def wrong_share(picture, truth):
    """Of the pixels for which there is a truth; 1 for a picture that is not there."""
    if isinstance(picture, str):
        return 1.0
    wrong = counted = 0
    for y in range(SIZE):
        for x in range(SIZE):
            colours = {truth(x, y)} if callable(truth) else {t[y][x] for t in truth}
            if None in colours or len(colours) > 1 and any(
                    differ(a, b) for a in colours for b in colours):
                continue
            counted += 1
            wrong += picture[y][x] not in colours and all(differ(picture[y][x], c) for c in colours)
    return wrong / counted


def examine(case, ours, stock):
    """(case, stock's share, ours, why there is no picture)"""
    truth = case.truth
    if not callable(truth):
        truth = [ours.picture(scene) for scene in truth]
        for picture in truth:
            if isinstance(picture, str):
                sys.exit(f"{case.shape}, {case.setting}: no truth: {picture}")
    pictures = [stock.picture(case.scene), ours.picture(case.scene)]
    notes = [p for p in pictures if isinstance(p, str)]
    return case, wrong_share(pictures[0], truth), wrong_share(pictures[1], truth), "; ".join(notes)


class Csv:
    """Shares as they come: a run that is stopped keeps what it has."""

    def __init__(self, path):
        self.file = open(path, "w", newline="")
        self.rows = csv.writer(self.file)
        self.rows.writerow(["shape", "group", "setting", "stock", "lentray", "note"])

    def write(self, result):
        case, stock, ours, note = result
        self.rows.writerow([case.shape, case.group, case.setting, f"{stock:.5f}", f"{ours:.5f}", note])
        self.file.flush()


def read_csv(path):
    with open(path, newline="") as file:
        return [(Case(r["shape"], r["group"], r["setting"], "", None), float(r["stock"]),
                 float(r["lentray"]), r["note"]) for r in csv.DictReader(file)]


def merged(paths):
    """Of several runs, in the order of the cases; of a case that was run twice the last."""
    rows = {row[0][:3]: row for path in paths for row in read_csv(path)}
    return [rows[case[:3]] for case in all_cases() if case[:3] in rows]


def means(results):
    """{(shape, group): (stock, lentray)}, means over the settings."""
    sums = collections.defaultdict(lambda: [0.0, 0.0, 0])
    for case, stock, ours, _ in results:
        entry = sums[case.shape, case.group]
        entry[0] += stock
        entry[1] += ours
        entry[2] += 1
    return {key: (s / n, o / n) for key, (s, o, n) in sums.items()}


def percent(share):
    return "0" if share == 0 else f"{100 * share:.2f}" if share < 0.1 else f"{100 * share:.0f}"


def table(results):
    """Markdown: a row a group and setting, means over the shapes."""
    groups = collections.defaultdict(list)
    for case, stock, ours, _ in results:
        setting = case.setting if case.group not in ("thin", "degenerate") else "all"
        groups[case.group, setting].append((stock, ours))
    lines = ["| setting | | shapes | stock, % wrong | lentray, % wrong | stock's worst | lentray's worst |",
             "|---|---|---|---|---|---|---|"]
    for (group, setting), values in sorted(groups.items(), key=lambda g: GROUPS.index(g[0][0])):
        stock, ours = zip(*values)
        lines.append(f"| {group} | {setting} | {len(values)} | {percent(sum(stock) / len(stock))} | "
                     f"{percent(sum(ours) / len(ours))} | {percent(max(stock))} | {percent(max(ours))} |")
    return "\n".join(lines)


CHART = """set terminal pngcairo enhanced size 1100,900 font 'Sans,10' background rgb 'white'
set output 'chart'
set encoding utf8
set multiplot layout 1,2
set palette maxcolors 6 defined (0 '#f4f4f4', 1 '#cfe8cf', 2 '#ffe08a', 3 '#ff9f4a', 4 '#e0442a', 5 '#6a0d0d')
set cbrange [-0.5:5.5]
set cbtics ('none' 0, 'to 0.1 %%%%' 1, 'to 1 %%%%' 2, 'to 10 %%%%' 3, 'to 50 %%%%' 4, 'more' 5)
set yrange [%(rows)s - 0.5:-0.5]
set xrange [-0.5:%(columns)s - 0.5]
set tics scale 0
set xtics rotate by 60 right (%(xtics)s)
set ytics (%(ytics)s)
set title 'stock'
unset colorbox
plot 'data' index 0 using 1:2:3 with image notitle
set title 'lentray'
set colorbox
plot 'data' index 1 using 1:2:3 with image notitle
"""


def level(share):
    return next((i for i, top in enumerate((0.0, 1e-3, 1e-2, 0.1, 0.5)) if share <= top), 5)


def draw(results, path):
    values = means(results)
    shapes = list(dict.fromkeys(shape for shape, _ in values))
    groups = [g for g in GROUPS if any(g == group for _, group in values)]
    blocks = []
    for which in (0, 1):
        lines = []
        for y, shape in enumerate(shapes):
            for x, group in enumerate(groups):
                mean = values.get((shape, group))
                lines.append(f"{x} {y} {level(mean[which]) if mean else 'NaN'}")
        blocks.append("\n".join(lines))

    def tics(names):
        return ", ".join('"%s" %d' % (name.replace("_", " "), i) for i, name in enumerate(names))

    script = CHART % {"rows": len(shapes), "columns": len(groups), "xtics": tics(groups),
                      "ytics": tics(shapes)}
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "data").write_text("\n\n\n".join(blocks) + "\n")
        (where / "script").write_text(script)
        subprocess.run(["gnuplot", "script"], cwd=where, check=True)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes((where / "chart").read_bytes())


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("words", nargs="*", help="names, with commas where any of them will do")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--csv", type=pathlib.Path, help="where the shares go")
    parser.add_argument("--read", type=pathlib.Path, nargs="+", help="earlier shares; nothing is run")
    parser.add_argument("--no-docs", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--jobs", type=int, default=6, help="stock mostly waits")
    return parser.parse_args()


def measure(args):
    cases = [c for c in all_cases() if all(set(w.split(",")) & set(c[:3]) for w in args.words)]
    if not cases:
        sys.exit("no case has these names")
    ours, stock = Renderer(args.bin / "lentray", SIZE), Renderer("povray", SIZE)
    results, rows = [], Csv(args.csv) if args.csv else None
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for result in pool.map(lambda case: examine(case, ours, stock), cases):
            results.append(result)
            if rows:
                rows.write(result)
    return results


def main():
    args = arguments()
    results = merged(args.read) if args.read else measure(args)
    worse = [r for r in results if r[2] > r[1] + SLACK]
    if not args.no_docs:
        draw(results, ROOT / "docs" / "stability" / "shapes.png")
    print(table(results))
    for case, before, after, note in results:
        if note:
            print(f"{case.shape}, {case.group} {case.setting}: {note}")
    for case, before, after, _ in worse:
        print(f"worse: {case.shape}, {case.group} {case.setting}: "
              f"stock {percent(before)} %, lentray {percent(after)} %")
    return 1 if args.check and worse else 0


if __name__ == "__main__":
    sys.exit(main())
