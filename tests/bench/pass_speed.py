"""What radiosity_speed.py and photon_speed.py share: arguments, whole pictures beside stock's, a pass on two threads."""
import argparse
import json
import pathlib
import statistics
import tempfile

import two_builds
from compare import cpu_seconds
from two_builds import ROOT

PICTURE = ["+W160", "+H120", "-A", "-D", "-V", "-P"]


def parser_of(description):
    """The command line that both have; the parser is among its arguments."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3, metavar="N", help="of each program and scene (default 3)")
    parser.add_argument("--bin", default=ROOT / "build" / "release", metavar="FOLDER",
                        help="with bin/lentray in it (default build/release)")
    parser.add_argument("--match", default="", metavar="WORD", help="only scenes whose name contains WORD")
    parser.add_argument("--threads", action="store_true", help="one thread and two instead of stock")
    args = parser.parse_args()
    args.parser = parser
    return args


def lentray(program, name, scene, folder, threads=1):
    """CPU seconds of the picture and of the pass of that name, and the pass's wall time."""
    facts = folder / "facts.json"
    cpu = cpu_seconds([program, f"+I{scene.name}", f"+O{folder / 'a.png'}", *PICTURE, f"+WT{threads}",
                       f"Statistics_File={facts}"], scene.parent)
    done = next(done for done in json.loads(facts.read_text())["passes"] if done["name"] == name)
    return cpu, done["cpu_s"], done["wall_s"]


def stock(scene, folder):
    return cpu_seconds(["povray", f"+I{scene.name}", f"+O{folder / 'b.png'}", *PICTURE, "+WT1", "-GA"], scene.parent)


def beside_stock(program, name, scenes, args, folder):
    ratios = []
    print(f"{'scene':40}{'stock s':>9}{'lentray':>9}{'its pass':>9}{'ratio':>7}")
    for title, scene in scenes:
        runs = [(stock(scene, folder), *lentray(program, name, scene, folder)) for _ in range(args.runs)]
        theirs, ours, its_pass, _ = map(statistics.median, zip(*runs))
        ratios.append(theirs / ours)
        print(f"{title:40}{theirs:9.2f}{ours:9.2f}{its_pass:9.2f}{theirs / ours:7.2f}", flush=True)
    print(f"stock / lentray: median {statistics.median(ratios):.2f}, least {min(ratios):.2f}")
    return statistics.median(ratios) >= 3.0 and min(ratios) >= 1.0


def two_threads(program, name, scenes, args, folder):
    ratios = []
    print(f"{'scene':40}{'one thread s':>13}{'two':>7}{'ratio':>7}")
    for title, scene in scenes:
        one, two = (min(times) for times in zip(*[[lentray(program, name, scene, folder, threads)[2]
                                                   for threads in (1, 2)] for _ in range(args.runs)]))
        ratios.append(one / two)
        print(f"{title:40}{one:13.2f}{two:7.2f}{one / two:7.2f}", flush=True)
    print(f"one / two threads: median {statistics.median(ratios):.2f}")
    return statistics.median(ratios) >= 1.5


def measure(name, scenes, args):
    """The exit status. `scenes`: titles and files."""
    program = two_builds.program(args.parser, args.bin)
    with tempfile.TemporaryDirectory() as folder:
        way = two_threads if args.threads else beside_stock
        return 0 if way(program, name, scenes, args, pathlib.Path(folder)) else 1
