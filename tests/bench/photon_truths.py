"""Light of photons beside truths that need no renderer.

  python3 tests/bench/photon_truths.py [--no-docs]      chart: docs/photon_truths.png; tables

slab      parallel light through a flat pane of glass: what the floor below gets, over the light without the pane; 1.
          The mean of the floor's middle
energy    parallel light through a ball of glass: all that comes down on a large floor, over the light that meets the
          ball and is not bent beyond the floor's rim; 1
focus     a thin beam through the middle of a ball: where it is narrowest, from the middle, over n r / (2 (n - 1));
          1. From its width on two floors, before and behind
profile   the caustic of a ball on a floor, by distance from the axis: Snell's law for 20,000 rings of the beam,
          integrated over the disc that the renderer gathers

The exit status is 1 where lentray at the finest spacing is farther than 1 % from one of the first three.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.pictures import read_png  # noqa: E402


IOR = 1.5
SPACINGS = (1 / 32, 1 / 64, 1 / 128, 1 / 256)  # powers of two: eight bits hold a photon's power without a loss
MOST = 0.01
SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 photons {{ spacing {spacing} gather 0, 1000000 radius {gathered} {settings} }} }}
camera {{ orthographic location <0, {floor} + 0.01, 0> direction -0.01*y up {width}*z right {width}*x }}
light_source {{ 20*y rgb {light} parallel point_at 0 {beam} }}
plane {{ y, {floor} pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}
{glass} pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ ior {ior} }}
  photons {{ target refraction on reflection off collect off }} }}
"""
BALL = "sphere { 0, 1"
PANE = "box { <-2, 0, -2>, <2, 0.3, 2>"


def render(program, size, **scene):
    scene = {"settings": "", "beam": "cylinder radius 1 falloff 1 tightness 0", "ior": IOR, **scene}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.pov").write_text(SCENE.format(**scene))
        subprocess.run([program, "+Iscene.pov", "+Opicture.png", "+FN16", "File_Gamma=1", f"+W{size}", f"+H{size}", "-A",
                        "-D", "-V", "-GA", "+WT1"], cwd=folder, check=True, capture_output=True)
        rows, _ = read_png((folder / "picture.png").read_bytes())
        return [[pixel[0] / 65535 for pixel in row] for row in rows]


def mean(rows):
    return sum(map(sum, rows)) / sum(map(len, rows))


def places(size, width):
    """Squared distances of pixels from the middle."""
    axis = [((i + 0.5) / size - 0.5) * width for i in range(size)]
    return [[x * x + z * z for x in axis] for z in axis]


def landing(offset, floor):
    """Where a ray so far off the axis lands, with its side; nan: it does not."""
    outer, inner = math.asin(offset), math.asin(offset / IOR)
    bent = 2 * (outer - inner)                    # in all
    around = 2 * inner - outer                    # of the exit, beyond the lower pole
    if bent >= math.pi / 2:
        return math.nan
    x, y = math.sin(around), -math.cos(around)
    return x - (y - floor) * math.tan(bent)


def rings(floor, count=20000):
    """Area of each ring of the beam, and where it lands."""
    for i in range(count):
        offset = (i + 0.5) / count
        place = landing(offset, floor)
        if not math.isnan(place):
            yield 2 * math.pi * offset / count, abs(place)


def slab(program, spacing):
    light = 0.5
    rows = render(program, 64, spacing=spacing, gathered=8 * spacing, floor=-1, width=1, light=light, beam="", glass=PANE)
    return mean(rows) / light


def energy(program, spacing):
    """Light that comes flatter than a cosine of 0.1 counts less; it lands beyond the floor's rim."""
    floor, width, size, light, gathered = -2.5, 8, 200, 1 / 64, 0.12
    rows = render(program, size, spacing=spacing, gathered=gathered, floor=floor, width=width, light=light, glass=BALL)
    reach = (width / 2 - 2 * gathered) ** 2
    seen = sum(value for line, squares in zip(rows, places(size, width)) for value, square in zip(line, squares)
               if square < reach) * (width / size) ** 2 / light
    caught = sum(area for area, place in rings(floor) if place * place < reach)
    return seen / caught


def width_of(rows, width, gathered):
    """Root of the mean square distance from the axis, without what the gathered disc adds."""
    total = spread = 0.0
    for line, squares in zip(rows, places(len(rows), width)):
        for value, square in zip(line, squares):
            total += value
            spread += value * square
    return math.sqrt(max(0.0, spread / total - gathered ** 2 / 2))


def focus(program, spacing):
    thin, truth = 0.1, IOR / (2 * (IOR - 1))
    beam = f"cylinder radius {thin} falloff {thin} tightness 0"
    floors, widths = (1.25, 1.75), []
    for floor in floors:
        gathered = 0.004
        rows = render(program, 100, spacing=spacing / 8, gathered=gathered, floor=-floor, width=0.08, light=1 / 64,
                      beam=beam, glass=BALL)
        widths.append(width_of(rows, 0.08, gathered))
    before, behind = widths
    return (floors[0] + (floors[1] - floors[0]) * before / (before + behind)) / truth


def profile_truth(gathered, distance, beam):
    """Light at a distance from the axis: the share of each ring that lies in the disc about it."""
    light = 0.0
    for area, place in beam:
        if abs(place - distance) >= gathered:
            continue
        if place + distance <= gathered:
            light += area
            continue
        cosine = (place ** 2 + distance ** 2 - gathered ** 2) / (2 * place * distance)
        light += area * math.acos(max(-1.0, min(1.0, cosine))) / math.pi
    return light / (math.pi * gathered ** 2)


def profile(programs, spacing=SPACINGS[-1]):
    """Rows of distance, truth and what the programs give, means over rings of pixels."""
    floor, width, size, gathered, light, bins = -1.3, 1.2, 120, 0.02, 1 / 512, 29
    beam = list(rings(floor))
    pictures = [render(p, size, spacing=spacing, gathered=gathered, floor=floor, width=width, light=light, glass=BALL)
                for p in programs]
    sums = [[0.0] * (2 + len(programs)) for _ in range(bins)]
    for row, squares in enumerate(places(size, width)[:size // 2]):  # a quarter has all distances
        for column, square in enumerate(squares[:size // 2]):
            distance = math.sqrt(square)
            number = int(distance / (width / 2) * (bins + 1))
            if number >= bins:
                continue
            corners = [(r, c) for r in (row, size - 1 - row) for c in (column, size - 1 - column)]
            values = [sum(picture[r][c] for r, c in corners) / 4 / light for picture in pictures]
            for i, value in enumerate([1, profile_truth(gathered, distance, beam), *values]):
                sums[number][i] += value
    return [[(number + 0.5) / (bins + 1) * width / 2] + [v / s[0] for v in s[1:]] for number, s in enumerate(sums)]


def chart(results, rows, programs, path):
    styles = {"povray": "pt 4 ps 1.5", "lentray": "pt 7 ps 0.8"}
    blocks, plots = [], []
    for name, title in (("slab", "pane of glass"), ("energy", "energy of a ball"), ("focus", "focus of a ball")):
        lines = ["1 with lines dashtype 2 linecolor 'black' title 'truth'"]
        for program in programs:
            lines.append(f"'data' index {len(blocks)} with linespoints {styles[program]} title '{program}'")
            blocks.append("\n".join(f"{s} {v}" for s, v in zip(SPACINGS, results[name, program])))
        plots.append(f"set title '{title}'\nset logscale x 2\nset xlabel 'spacing'\n"
                     f"plot [0.003:0.04] [0.94:1.02] " + ", ".join(lines))
    lines = [f"'data' index {len(blocks)} using 1:2 with lines linecolor 'black' title 'truth'"]
    lines += [f"'data' index {len(blocks)} using 1:{3 + i} with points {styles[p]} title '{p}'"
              for i, p in enumerate(programs)]
    blocks.append("\n".join(" ".join(map(str, row)) for row in rows))
    plots.append("set title 'caustic of a ball: light by distance'\nunset logscale x\nset logscale y\n"
                 "set xlabel 'from the axis, radii'\nplot [0:0.6] [0.1:500] " + ", ".join(lines))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "data").write_text("\n\n\n".join(blocks) + "\n")
        (folder / "script").write_text("set terminal pngcairo size 1400,380 font 'sans,10'\nset output 'chart'\n"
                                       "set grid\nset multiplot layout 1,4\n" + "\n".join(plots) + "\n")
        subprocess.run(["gnuplot", "script"], cwd=folder, check=True)
        path.write_bytes((folder / "chart").read_bytes())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--no-docs", action="store_true")
    args = parser.parse_args()
    programs, results = {"povray": "povray", "lentray": args.bin.resolve() / "lentray"}, {}
    print("| truth | |", *(f"{s:g} |" for s in SPACINGS), "\n|---|---|" + "--:|" * len(SPACINGS))
    farther = 0
    for measure in (slab, energy, focus):
        for name, program in programs.items():
            values = results[measure.__name__, name] = [measure(program, s) for s in SPACINGS]
            print(f"| {measure.__name__} | {name} |", *(f"{v:.4f} |" for v in values), flush=True)
            farther += name == "lentray" and abs(values[-1] - 1) > MOST
    rows = profile(programs.values())
    print("\n| distance | truth |", *(f"{p} |" for p in programs), "\n|--:|--:|" + "--:|" * len(programs))
    for row in rows:
        print("|", *(f"{v:.3f} |" for v in row))
    for i, name in enumerate(programs):
        off = math.sqrt(sum((r[2 + i] / r[1] - 1) ** 2 for r in rows) / len(rows))
        print(f"{name}: {off:.2%} from the truth, root of the mean square over {len(rows)} rings")
    if not args.no_docs:
        chart(results, rows, programs, ROOT / "docs" / "photon_truths.png")
    sys.exit(1 if farther else 0)


if __name__ == "__main__":
    main()
