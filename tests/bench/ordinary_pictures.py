"""CPU time of ordinary pictures, beside stock POV-Ray's: Debian's povray-examples as they lie.

  tests/bench/ordinary_pictures.py                      all examples, 640 x 480, without antialiasing
  tests/bench/ordinary_pictures.py --antialiased        with +A0.3 -J
  tests/bench/ordinary_pictures.py --every 8            each eighth
  tests/bench/ordinary_pictures.py textures/            scenes whose path contains a word

Whole processes, one thread each, user + system time. The table has the scenes on which stock spends at least --from
seconds: below, what is measured is the start. A scene that takes stock more than --limit seconds, or that it does not
render, is left out and counted.

The exit status is 1 unless the median of the ratios is at least --median and none is below --least.
"""
import argparse
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

import two_builds

ROOT = pathlib.Path(__file__).resolve().parents[2]


def cpu_seconds(command, folder, limit):
    """None where the command fails or takes longer."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    resource.prlimit(process.pid, resource.RLIMIT_CPU, (limit, limit))
    if process.wait() != 0:
        return None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def pair(name, args, tree):
    """Medians of lentray and of stock, None where there is none."""
    scene = tree / (name + ".pov")
    size = [f"+W{args.width}", f"+H{args.height}", *(["+A0.3", "-J"] if args.antialiased else ["-A", "-J"]),
            f"+I{scene.name}", "-D", "-V", "-P", "+WT1"]
    ours, theirs = [], []
    for run in range(args.runs):
        theirs.append(cpu_seconds(["povray", *size, "+Ostock.png"], scene.parent, args.limit))
        if theirs[0] is None or theirs[0] < args.at_least:
            return None, theirs[0]
        ours.append(cpu_seconds([args.bin.resolve() / "lentray", *size, "+Olentray.png"], scene.parent, args.limit))
        if ours[0] is None:
            return None, theirs[0]
    return statistics.median(ours), statistics.median(theirs)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="WORD")
    parser.add_argument("--antialiased", action="store_true", help="+A0.3 -J")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="each Nth scene alone")
    parser.add_argument("--runs", type=int, default=1, metavar="N", help="of each way (default 1)")
    parser.add_argument("--width", type=int, default=640)
    parser.add_argument("--height", type=int, default=480)
    parser.add_argument("--from", dest="at_least", type=float, default=0.5, metavar="S", help="of stock (default 0.5)")
    parser.add_argument("--limit", type=int, default=300, metavar="S", help="a picture (default 300)")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin", metavar="FOLDER")
    parser.add_argument("--median", type=float, default=0.0, metavar="RATIO")
    parser.add_argument("--least", type=float, default=0.0, metavar="RATIO")
    args = parser.parse_args()
    names = [name for name, _ in two_builds.examples(parser)]
    names = [name for name in names if not args.words or any(word in name for word in args.words)][::args.every]
    if not names:
        parser.error("no scene is chosen")
    ratios, quick, without = {}, 0, []
    print("| scene | lentray, CPU s | stock, CPU s | ratio |\n|---|---:|---:|---:|")
    with tempfile.TemporaryDirectory() as temporary:
        tree = pathlib.Path(temporary) / "examples"
        shutil.copytree(two_builds.EXAMPLES, tree)
        for name in names:
            ours, theirs = pair(name, args, tree)
            if ours is None:
                quick += theirs is not None and theirs < args.at_least
                if theirs is None or theirs >= args.at_least:
                    without.append(name + (" (stock)" if theirs is None else " (lentray)"))
                continue
            ratios[name] = theirs / ours
            print(f"| {name} | {ours:.2f} | {theirs:.2f} | {ratios[name]:.2f} |", flush=True)
    print(f"\n{quick} of {len(names)} scenes take stock less than {args.at_least:g} s. Failed, or took more than "
          f"{args.limit} s: {', '.join(without) or 'none'}")
    if not ratios:
        sys.exit("no scene is left")
    median, least = statistics.median(ratios.values()), min(ratios, key=ratios.get)
    print(f"{len(ratios)} scenes: median {median:.2f}, least {ratios[least]:.2f} ({least}), "
          f"{sum(ratio < 1 for ratio in ratios.values())} slower than stock")
    sys.exit(0 if median >= args.median and ratios[least] >= args.least else 1)


if __name__ == "__main__":
    two_builds.main(main)
