"""What a pixel of an integral image costs, and what that depends on.

  python3 tests/bench/pixel_cost.py [--runs N] [--bin FOLDER] [--no-docs] [SERIES ...]

pixels    pixels a lens, for a fixed number of lenses and of rows
size      the picture's width, for 15 pixels a lens
objects   spheres in the scene
lights    lights in the scene
threads   threads of one process

Microseconds of processor time a pixel while rendering (`time.render_cpu_s` of the statistics): reading, building and
writing are apart. The scene is made by this command: spheres on a plane, some of them mirrors, some of glass. All
pictures of a series are made in turns; medians. Tables go to the terminal, the chart to docs/pixel_cost.png.

The exit status is 1 where a pixel costs over 5 % more at the most pixels a lens than at the fewest.
"""
import argparse
import collections
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402

LENSES = 40
MOST = 1.05
Case = collections.namedtuple("Case", "width height lens objects lights threads",
                              defaults=(1200, 900, 15, 10_000, 2, 1))
SERIES = {
    "pixels": ("pixels a lens", [(n, Case(width=LENSES * n, height=480, lens=n)) for n in (4, 6, 10, 15, 30, 60)]),
    "size": ("pixels a row", [(w, Case(width=w, height=w * 3 // 4)) for w in (240, 480, 960, 1920, 3840)]),
    "objects": ("objects", [(n, Case(objects=n)) for n in (1_000, 10_000, 100_000, 1_000_000)]),
    "lights": ("lights", [(n, Case(lights=n)) for n in (1, 2, 4, 8, 16, 32)]),
    "threads": ("threads", [(n, Case(threads=n)) for n in (1, 2, 4)]),
}
SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 max_trace_level 5 }}
camera {{ location <0, 14, -26> right 4/3*x up y look_at <0, 1, 0> angle 40 }}
#for (I, 1, {lights})
  light_source {{ <20*sin(I*2.4), 25, 20*cos(I*2.4)> rgb {brightness} }}
#end
plane {{ y, 0 pigment {{ checker rgb 0.9 rgb 0.4 }} }}
#declare R = seed(3);
#declare Size = 0.12*sqrt(10000/{objects});
#for (I, 1, {objects})
  sphere {{
    <rand(R)*24 - 12, Size + rand(R)*3, rand(R)*24 - 12>, Size*(0.5 + rand(R))
    #switch (mod(I, 8))
      #case (0) pigment {{ rgb 0.1 }} finish {{ reflection 0.7 }} #break
      #case (1) pigment {{ rgbf <0.9, 1, 0.9, 0.8> }} interior {{ ior 1.3 }} #break
      #else pigment {{ rgb <rand(R), rand(R), rand(R)> }} finish {{ phong 0.5 }}
    #end
  }}
#end
"""


def cost(program, folder, case):
    """Microseconds a pixel."""
    scene = folder / f"{case.objects}_{case.lights}.pov"
    if not scene.exists():
        scene.write_text(SCENE.format(objects=case.objects, lights=case.lights, brightness=1 / case.lights))
    subprocess.run([program, f"+I{scene}", "+Opicture.png", "Lenticular=On", f"Lens_Pixels={case.lens}",
                    f"+W{case.width}", f"+H{case.height}", "-A", "-D", "-V", f"+WT{case.threads}",
                    "Statistics_File=statistics.json"], cwd=folder, check=True, capture_output=True)
    time = json.loads((folder / "statistics.json").read_text())["time"]
    return time["render_cpu_s"] * 1e6 / (case.width * case.height)


def measure(program, names, runs):
    results = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for series in names:
            cases = SERIES[series][1]
            costs = {at: [] for at, _ in cases}
            for _ in range(runs):
                for at, case in cases:
                    costs[at].append(cost(program, folder, case))
            results[series] = [(at, statistics.median(costs[at])) for at, _ in cases]
            print(f"| {SERIES[series][0]} |", *(f"{at:,} |" for at, _ in results[series]))
            print("|---|" + "--:|" * len(cases))
            print("| microseconds a pixel |", *(f"{us:.2f} |" for _, us in results[series]), "\n", flush=True)
    return results


def chart(results, path):
    blocks = ["\n".join(f"{at} {us}" for at, us in points) for points in results.values()]
    plots = [f"set xlabel '{SERIES[name][0]}'\nplot 'data' index {i} with linespoints pt 7"
             for i, name in enumerate(results)]
    gnuplot(f"{300 * len(results)},330", "unset key\nset logscale x\nset yrange [0:*]\nset format x '%.0s%c'\n"
            "set ylabel 'microseconds a pixel'\n"
            f"set multiplot layout 1,{len(results)}\n" + "\n".join(plots), blocks, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--no-docs", action="store_true", help="no chart")
    parser.add_argument("series", nargs="*", metavar="SERIES", help=", ".join(SERIES))
    args = parser.parse_args()
    for name in args.series:
        if name not in SERIES:
            parser.error(f"no series '{name}': {', '.join(SERIES)}")
    results = measure(args.bin.resolve() / "lentray", args.series or list(SERIES), args.runs)
    if not args.no_docs and not args.series:
        chart(results, ROOT / "docs" / "pixel_cost.png")
    if "pixels" in results:
        (_, fewest), (_, most) = results["pixels"][0], results["pixels"][-1]
        if most > MOST * fewest:
            sys.exit(f"{most:.2f} microseconds a pixel instead of {fewest:.2f}")


if __name__ == "__main__":
    main()
