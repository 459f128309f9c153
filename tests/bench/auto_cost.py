"""Instructions that the defaults Shadow_Cache=auto and Pixel_Order=auto cost beside off and rows.

Each scene is rendered twice under callgrind, one thread, and the instructions of rendering alone
(render_frame and what it calls) are compared: counts, so the machine may be busy.

  tests/bench/auto_cost.py [--every N] [--size WxH] [--arguments "..."] [--seconds S] [word ...]

Scenes: those of Debian's povray-examples, each from its own folder (of a copy) and as they lie, and
the project's SPD scenes; with words only those whose path has one; --every 8 takes each eighth.
The exit status is 1 if a scene costs more than 1 %.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
ALLOWED = 1.01


def instructions(program, scene, options, args):
    """Of rendering the scene; None where it does not render in time."""
    width, height = args.size.split("x")
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
               "--toggle-collect=lentray::core::render_frame*", program, f"+I{scene.name}",
               "+O/dev/null", "+FN8", f"+W{width}", f"+H{height}", "-A", "-D", "-V", "+WT1", *options,
               *shlex.split(args.arguments)]
    with tempfile.TemporaryDirectory() as folder:
        command[command.index("+O/dev/null")] = f"+O{folder}/a.png"
        try:
            done = subprocess.run(command, cwd=scene.parent, stdin=subprocess.DEVNULL, text=True,
                                  capture_output=True, errors="replace", check=False,
                                  timeout=args.seconds)
        except subprocess.TimeoutExpired:
            return None
    found = re.search(r"Collected : (\d+)", done.stderr)
    return int(found.group(1)) if done.returncode == 0 and found else None


def measure(scene, args):
    plain = instructions(args.bin / "lentray", scene, ["Shadow_Cache=off", "Pixel_Order=rows"], args)
    auto = plain and instructions(args.bin / "lentray", scene, [], args)
    return plain, auto


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="word")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--size", default="64x48")
    parser.add_argument("--arguments", default="", help="further options of lentray")
    parser.add_argument("--seconds", type=float, default=120, help="for one picture")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    args = parser.parse_args()

    args.bin = args.bin.resolve()
    ratios = {}
    with tempfile.TemporaryDirectory() as temporary:
        tree = pathlib.Path(temporary) / "examples"  # scenes write files
        shutil.copytree(EXAMPLES, tree)
        for part in tree.rglob("*"):
            part.chmod(part.stat().st_mode | 0o200)
        scenes = sorted(tree.rglob("*.pov")) + sorted((ROOT / "scenes").glob("spd_*.pov"))
        chosen = [s for s in scenes if not args.words or any(w in str(s) for w in args.words)]
        chosen = chosen[::args.every]
        left_out = 0
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for scene, (plain, auto) in zip(chosen, pool.map(lambda s: measure(s, args), chosen)):
                name = str(scene.relative_to(tree if tree in scene.parents else ROOT))
                if not plain or not auto:
                    left_out += 1
                    print(f"{name:50s} not rendered within {args.seconds:g} s", flush=True)
                    continue
                ratios[name] = auto / plain
                print(f"{name:50s} {plain:14,d} {auto / plain:8.4f}", flush=True)
    if not ratios:
        sys.exit("no scene was measured")
    worst = max(ratios, key=ratios.get)
    over = [name for name, ratio in ratios.items() if ratio > ALLOWED]
    print(f"{len(ratios)} scenes, {left_out} not rendered in time: auto / off median "
          f"{statistics.median(ratios.values()):.4f}, least {min(ratios.values()):.4f}, greatest "
          f"{ratios[worst]:.4f} ({worst}); more than 1 %: {len(over)}")
    for name in sorted(over, key=ratios.get, reverse=True):
        print(f"  {ratios[name]:.4f} {name}")
    sys.exit(1 if over else 0)


if __name__ == "__main__":
    main()
