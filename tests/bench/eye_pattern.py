"""Has the error of sampling for the eye (+AM3) a pattern that an eye could find? The power spectrum of prints' errors.

  tests/bench/eye_pattern.py [WORD ...]      five examples, or those of the 24 whose path contains a word

A print's luminance less that of its limit (Antialias_Grid=5 with +AM3: 25 samples a pixel that no picture takes), as L*,
over rows and lenses, view by view, is cut into tiles of 16 x 16 pixels. The spectra of the 64 tiles that differ most,
each scaled to the same error, are averaged. The exit status is 1 if a peak is above four times the mean.
"""
import cmath
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "compat"))
from antialiasing import EXAMPLES, SCENES
from print_job import INSTEAD

FIVE = ["objects/csg/granite", "objects/lathe1a", "advanced/woodbox", "advanced/whiltile", "textures/patterns/agate"]
PRINT = ["Lenticular=On", "Lens_Sheet=40lpi", "Sheet_Width=20mm", "Sheet_Height=15mm", "Print_DPI=600", "View_Distance=40cm"]
TILE, TILES, MOST = 16, 64, 4.0
TURNS = [cmath.exp(-2j * math.pi * i / TILE) for i in range(TILE)]


def lightness(scene, out, words):
    """L* by rows, of linear light, and how many columns a lens has."""
    subprocess.run([ROOT / "build/release/bin/lentray", f"+I{scene.name}", f"+O{out}", *PRINT, *words, "+FP16", "-D", "-V",
                    "-P"], cwd=scene.parent, check=True, capture_output=True)
    data = out.read_bytes()
    size, pixels = re.search(rb"\n(\d+ \d+)\n", data)[1], re.search(rb"lens.pixels=(\S+)", data)[1]
    width, height = map(int, size.split())
    samples = memoryview(data)[len(data) - 6 * width * height:]
    table = [light(v / 65535) for v in range(65536)]
    rows = []
    for y in range(height):
        row = samples[6 * width * y:6 * width * (y + 1)]
        values = [table[row[i] << 8 | row[i + 1]] for i in range(0, 6 * width, 2)]
        rows.append([star(0.2126 * values[i] + 0.7152 * values[i + 1] + 0.0722 * values[i + 2])
                     for i in range(0, 3 * width, 3)])
    return rows, float(pixels)


def light(v):
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


def star(y):
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


def transformed(values):
    return [sum(v * TURNS[i * k % TILE] for i, v in enumerate(values)) for k in range(TILE)]


def power(tile):
    rows = [transformed(row) for row in tile]
    columns = [transformed(column) for column in zip(*rows)]
    return [abs(v) ** 2 for column in columns for v in column]


def tiles_of(error, pixels):
    """(Mean square, tile), of each view."""
    width, height = len(error[0]), len(error)
    for view in range(1, int(pixels) - 1):
        columns = [math.ceil(lens * pixels - 0.5) + view for lens in range(int(width / pixels))]
        for top in range(0, height - TILE + 1, TILE):
            for left in range(0, len(columns) - TILE + 1, TILE):
                tile = [[error[y][k] for k in columns[left:left + TILE]] for y in range(top, top + TILE)]
                mean = sum(map(sum, tile)) / TILE ** 2
                tile = [[v - mean for v in row] for row in tile]
                yield sum(v * v for row in tile for v in row), tile


def peak(error, pixels):
    """Over the mean, and its waves along a column of lenses and a row."""
    tiles = sorted(tiles_of(error, pixels), key=lambda t: -t[0])[:TILES]
    total = [0.0] * TILE ** 2
    for square, tile in tiles:
        for i, value in enumerate(power(tile)):
            total[i] += value / square if square > 0 else 0.0
    total[0] = 0.0  # the mean of a tile is taken off
    most = max(range(TILE ** 2), key=total.__getitem__)
    return total[most] / (sum(total) / (TILE ** 2 - 1)), most % TILE, most // TILE


def main():
    words = sys.argv[1:]
    names = [INSTEAD.get(n, n) for n in SCENES if any(w in INSTEAD.get(n, n) for w in words)] if words else FIVE
    worst = 0.0
    print("| scene | peak over mean | waves in 16 rows | in 16 lenses |\n|---|---:|---:|---:|")
    for name in names:
        with tempfile.TemporaryDirectory() as temporary:
            one, limit = pathlib.Path(temporary) / "one.ppm", pathlib.Path(temporary) / "limit.ppm"
            scene = EXAMPLES / (name + ".pov")
            picture, pixels = lightness(scene, one, ["+A0.3", "+AM3"])
            best, _ = lightness(scene, limit, ["Antialias_Grid=5", "+AM3"])
        ratio, down, across = peak([[a - b for a, b in zip(*rows)] for rows in zip(picture, best)], pixels)
        worst = max(worst, ratio)
        print(f"| {name} | {ratio:.2f} | {down} | {across} |", flush=True)
    sys.exit(0 if worst <= MOST else 1)


if __name__ == "__main__":
    main()
