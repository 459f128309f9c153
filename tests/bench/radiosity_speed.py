"""CPU time of lentray against stock POV-Ray where scenes have radiosity, and what a second thread brings.

All examples of Debian's povray-examples whose indirect light is radiosity alone, 160 x 120 without antialiasing. Whole
pictures on one thread, user + system time; the programs take turns, medians are compared. Beside them lentray's
part of it before the picture.

  tests/bench/radiosity_speed.py [--runs N] [--bin FOLDER] [--match WORD]
  tests/bench/radiosity_speed.py --threads      how much sooner two threads end the pass

Threads: the least wall time of the runs with one and with two, so that a busy machine disturbs least. A machine with
fewer than two idle processors tells nothing.

The exit status is 1 where a picture takes longer than stock's, or more than a third of its time at the median; with
--threads where two are less than 1.5 times as fast at the median.
"""
import argparse
import json
import pathlib
import statistics
import tempfile

import two_builds
from compare import cpu_seconds
from two_builds import ROOT

SCENES = [f"radiosity/{name}" for name in (
    "radiosity_36", "radiosity_37", "radiosity2", "radiosity3", "rad_def_test_36", "rad_def_test_37", "patio-radio_36",
    "patio-radio_37", "cornell")] + [f"camera/mesh_camera/{name}" for name in (
        "baking_demo", "meshcam_ortho_demo", "meshcam_ortho_demo_uv", "meshcam_persp_compare", "meshcam_persp_demo",
        "meshcam_persp_demo_uv", "meshcam_stereo_demo")] + [
            "animations/raddem/raddem", "advanced/object_pattern", "advanced/blocks/stackerday",
            "advanced/blocks/stackernight", "advanced/diffuse_back", "gamma/gamma_showcase"]
PICTURE = ["+W160", "+H120", "-A", "-D", "-V", "-P"]


def lentray(program, scene, folder, threads=1):
    """CPU seconds of the picture and of the pass, and the pass's wall time."""
    facts = folder / "facts.json"
    cpu = cpu_seconds([program, f"+I{scene.name}", f"+O{folder / 'a.png'}", *PICTURE, f"+WT{threads}",
                       f"Statistics_File={facts}"], scene.parent)
    done = json.loads(facts.read_text())["passes"][0]
    return cpu, done["cpu_s"], done["wall_s"]


def stock(scene, folder):
    return cpu_seconds(["povray", f"+I{scene.name}", f"+O{folder / 'b.png'}", *PICTURE, "+WT1", "-GA"], scene.parent)


def beside_stock(program, scenes, args, folder):
    ratios = []
    print(f"{'scene':40}{'stock s':>9}{'lentray':>9}{'its pass':>9}{'ratio':>7}")
    for name, scene in scenes:
        runs = [(stock(scene, folder), *lentray(program, scene, folder)) for _ in range(args.runs)]
        theirs, ours, its_pass, _ = map(statistics.median, zip(*runs))
        ratios.append(theirs / ours)
        print(f"{name:40}{theirs:9.2f}{ours:9.2f}{its_pass:9.2f}{theirs / ours:7.2f}", flush=True)
    print(f"stock / lentray: median {statistics.median(ratios):.2f}, least {min(ratios):.2f}")
    return statistics.median(ratios) >= 3.0 and min(ratios) >= 1.0


def two_threads(program, scenes, args, folder):
    ratios = []
    print(f"{'scene':40}{'one thread s':>13}{'two':>7}{'ratio':>7}")
    for name, scene in scenes:
        one, two = (min(times) for times in zip(*[[lentray(program, scene, folder, threads)[2] for threads in (1, 2)]
                                                  for _ in range(args.runs)]))
        ratios.append(one / two)
        print(f"{name:40}{one:13.2f}{two:7.2f}{one / two:7.2f}", flush=True)
    print(f"one / two threads: median {statistics.median(ratios):.2f}")
    return statistics.median(ratios) >= 1.5


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3, metavar="N", help="of each program and scene (default 3)")
    parser.add_argument("--bin", default=ROOT / "build" / "release", metavar="FOLDER",
                        help="with bin/lentray in it (default build/release)")
    parser.add_argument("--match", default="", metavar="WORD", help="only scenes whose name contains WORD")
    parser.add_argument("--threads", action="store_true", help="one thread and two instead of stock")
    args = parser.parse_args()
    scenes = two_builds.examples(parser, [name for name in SCENES if args.match in name])
    program = two_builds.program(parser, args.bin)
    with tempfile.TemporaryDirectory() as folder:
        measure = two_threads if args.threads else beside_stock
        return 0 if measure(program, scenes, args, pathlib.Path(folder)) else 1


if __name__ == "__main__":
    two_builds.main(main)
