"""What radiosity costs where many views share one pass: processor time beside that of one view with as many pixels.

  python3 tests/bench/radiosity_sharing.py [SCENE...] [--runs N] [--no-docs]    chart: docs/radiosity_sharing.png; a table

For N = 1, 3, 7 and 15 a sheet of 1200 x 900 pixels with N pixels a lens, and N pictures of views with as many
pixels together, in one run. Each is beside one picture of 1200 x 900 by the scene's own camera. Runs alternate, the
median counts. The exit status is 1 where either takes more than 1.3 times as long.
"""
import argparse
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SCENES = ("radiosity/radiosity_37.pov",)
WIDTH, HEIGHT, COUNTS, MOST = 1200, 900, (1, 3, 7, 15), 1.3


def seconds(program, scene, words):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, f"+I{scene}", f"+O{folder}/picture.png", "-A", "-D", "-V", "+WT1",
                   "Scene_Writes=memory", *words]
        child = subprocess.Popen(command, cwd=scene.parent, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            sys.exit(f"status {child.returncode}: {command}")
        return usage.ru_utime + usage.ru_stime


def ways():
    """Names, options, and pixels in all."""
    out = {("picture", 1): ([f"+W{WIDTH}", f"+H{HEIGHT}"], WIDTH * HEIGHT)}
    for n in COUNTS:
        sheet = ["Lenticular=On", f"Lens_Pixels={n}", f"+W{WIDTH}", f"+H{HEIGHT}"]
        width, height = (round(side / math.sqrt(n)) for side in (WIDTH, HEIGHT))
        out["sheet", n] = (sheet, WIDTH * HEIGHT)
        out["views", n] = ([*sheet, f"Views={n}", f"View_Size={width}x{height}"], n * width * height)
    return out


def measure(program, scene, runs):
    """Of each way its time a pixel, by that of one picture."""
    times = {way: [] for way in ways()}
    for _ in range(runs):
        for way, (words, pixels) in ways().items():
            times[way].append(seconds(program, scene, words) / pixels)
    medians = {way: statistics.median(all_runs) for way, all_runs in times.items()}
    base = medians["picture", 1]
    return base * WIDTH * HEIGHT, {way: median / base for way, median in medians.items()}


def chart(results, path):
    blocks, lines = [], []
    for name, (_, ratios) in results.items():
        for way, style in (("sheet", "pt 7"), ("views", "pt 4 dashtype 2")):
            lines.append(f"'data' index {len(blocks)} with linespoints lc {len(blocks) // 2 + 1} {style} "
                         f"title '{name}, {way}' noenhanced")
            blocks.append("\n".join(f"{n} {ratios[way, n]}" for n in COUNTS))
    gnuplot("800,440", "set key outside\n"
            f"set xtics ({', '.join(map(str, COUNTS))})\nset xlabel 'views'\nset yrange [0:*]\n"
            "set ylabel 'processor time, by that of one picture'\n"
            f"plot [0:16] {MOST} with lines lc 'black' dashtype 3 title '{MOST}', " + ", ".join(lines), blocks, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path, default=[EXAMPLES / scene for scene in SCENES])
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--no-docs", action="store_true")
    args = parser.parse_args()
    results, worst = {}, 0.0
    print("| scene | one picture |", *(f"{way}, {n} |" for way in ("sheet", "views") for n in COUNTS))
    print("|---|--:|" + "--:|" * (2 * len(COUNTS)))
    for scene in args.scenes:
        base, ratios = results[scene.stem] = measure(args.bin.resolve() / "lentray", scene.resolve(), args.runs)
        print(f"| {scene.stem} | {base:.1f} s |", *(f"{ratios[way, n]:.2f} |" for way in ("sheet", "views")
                                                    for n in COUNTS), flush=True)
        worst = max(worst, *ratios.values())
    if not args.no_docs:
        chart(results, ROOT / "docs" / "radiosity_sharing.png")
    sys.exit(0 if worst <= MOST else 1)


if __name__ == "__main__":
    main()
