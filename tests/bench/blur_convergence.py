"""How focal blur converges: the error of n rays a sample beside the picture of 1,000 rays.

  tests/bench/blur_convergence.py [--no-docs]      chart: docs/blur_convergence.png

Each program is compared with its own 1,000 rays, and with the other's. Independent rays would have an
error in proportion to 1/sqrt(n). The slope is that of a straight line through the logarithms, for n from
10 to 320: n and 1,000 rays share no more than the rule that chooses them, so that the error of the
1,000 is taken off. The exit status is 1 if lentray's slope is flatter than -0.45 in a scene.
"""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402

RAYS, REFERENCE = (10, 20, 40, 80, 160, 320), 1000
FLATTEST = -0.45
STAGE = """#version 3.7; global_settings { assumed_gamma 1 }
light_source { <1, 6, -3>, 1 }
sphere { <0, 0, 3>, 0.8 pigment { rgb <0.9, 0.2, 0.2> } finish { phong 0.8 } }
cylinder { <1.4, -1, 2>, <1.4, 2, 2>, 0.3 pigment { rgb <0.2, 0.9, 0.2> } }
sphere { <-0.9, 0.5, -0.5>, 0.25 pigment { rgb 0.9 } finish { phong 1 reflection 0.3 } }
box { <-2.6, -1, 5>, <-1.4, 2.5, 5.4> pigment { rgb <0.9, 0.5, 0.9> } }
plane { y, -1 pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.2, 0.3, 0.7> scale 0.7 } }
camera { location <0, 0.5, -3> look_at z*2 right 4/3*x aperture APERTURE focal_point z*2
  blur_samples Rays, Rays variance 0 }
"""
SCENES = {"stage, aperture 0.3": STAGE.replace("APERTURE", "0.3"),
          "stage, aperture 0.9": STAGE.replace("APERTURE", "0.9")}
PAIRS = (("lentray", "lentray"), ("povray", "povray"), ("lentray", "povray"))


def render(program, name, scene, rays, where):
    picture = where / f"{name}{rays}.png"
    # 16 bits of linear light: the error is of the rays alone.
    subprocess.run([program, f"+I{scene}", f"Declare=Rays={rays}", f"+O{picture}", "+FN16", "File_Gamma=1",
                    "+W96", "+H72", "-D", "-V", "-GA"], check=True, capture_output=True)
    return picture


def error(diff, a, b, where):
    """Root of the mean square, as a share of the whole range."""
    figures = where / "figures.json"
    subprocess.run([diff, a, b, "--no-pictures", "--json", figures], capture_output=True, check=False)
    return 10.0 ** (-json.loads(figures.read_text())["whole"]["psnr"] / 20.0)


def slope(errors):
    points = [(math.log(n), math.log(e / math.sqrt(1.0 + n / REFERENCE))) for n, e in zip(RAYS, errors)]
    return statistics.linear_regression(*zip(*points)).slope


def measure(args, where):
    programs = {"lentray": args.bin / "lentray", "povray": "povray"}
    results = {}
    for title, text in SCENES.items():
        scene = where / "scene.pov"
        scene.write_text(text)
        pictures = {name: {n: render(program, name, scene, n, where) for n in (*RAYS, REFERENCE)}
                    for name, program in programs.items()}
        for one, other in PAIRS:
            errors = [error(args.bin / "lentray-diff", pictures[one][n], pictures[other][REFERENCE], where)
                      for n in RAYS]
            results[title, one, other] = errors
            print(f"{title}: {one:8} beside {other}'s {REFERENCE} rays: "
                  + " ".join(f"{e:.5f}" for e in errors) + f"  slope {slope(errors):.2f}", flush=True)
    return results


def chart(results, path):
    blocks, plots = [], []
    for index, title in enumerate(SCENES):
        commands = []
        for one, other in PAIRS:
            commands.append(f"'data' index {len(blocks)} with linespoints pt {5 + 2 * PAIRS.index((one, other))} "
                            f"title \"{one}, beside {other}'s 1,000 rays\"")
            blocks.append("\n".join(f"{n} {e}" for n, e in zip(RAYS, results[title, one, other])))
        start = results[title, "lentray", "lentray"][0] * math.sqrt(RAYS[0])
        commands.append(f"{start}/sqrt(x) with lines dashtype 2 linecolor 'black' title '1/sqrt(n)'")
        plots.append(f"set title '{title}'\nplot [8:400] " + ", \\\n  ".join(commands))
    gnuplot("1100,480", "set logscale xy\nset xlabel 'rays a sample'\n"
            "set ylabel 'error, rms, share of the range'\nset multiplot layout 1,2\n" + "\n".join(plots), blocks, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--no-docs", action="store_true")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    with tempfile.TemporaryDirectory() as folder:
        results = measure(args, pathlib.Path(folder))
    if not args.no_docs:
        chart(results, ROOT / "docs" / "blur_convergence.png")
    sys.exit(0 if all(slope(results[title, "lentray", "lentray"]) <= FLATTEST for title in SCENES) else 1)


if __name__ == "__main__":
    main()
