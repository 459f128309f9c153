"""CPU time of lentray against stock POV-Ray on integral images of the SPD scenes.

Whole processes, one thread each, user + system time. Each way is run five times, interleaved so
that a slower spell of the machine meets all alike; medians are compared. Stock is timed in both
ways it has: all N views one after the other, and one mesh_camera.

  tests/bench/compare.sh [--size WxH] [--runs N] [--bin FOLDER] [--json FILE] [scene ...]
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def cpu_seconds(command, folder):
    """User + system time of a command; stops on failure."""
    before = os.times()
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False)
    after = os.times()
    if done.returncode != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{done.stdout.decode(errors='replace')}")
    return (after.children_user - before.children_user) + (
        after.children_system - before.children_system)


def wrappers(scene, width, height, binaries, folder, lens):
    """Stock's wrapper scenes, as lentray-diff writes them, for the views and the mesh_camera. `lens`: the options that
    make an integral image of the scene. There are no views where a lens has no whole number of pixels or the eye is
    near."""
    result = subprocess.run(
        [binaries / "lentray-diff", scene, *lens, f"+W{width}",
         f"+H{height}", "--write-wrappers", folder], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(result.stdout + result.stderr)
    views = sorted(folder.glob("view*.pov"), key=lambda p: int(p.stem[4:]))
    return views, folder / "mesh.pov"


def stock(scene, width, height, library, threads, antialiasing=("-A", "-J")):
    return ["povray", f"+I{scene}", "+Ostock.png", f"+W{width}", f"+H{height}", f"+L{library}",
            *antialiasing, "-D", "-V", "-P", f"+WT{threads}", "+FN8"]


def measure(name, args, binaries):
    width, height = (int(n) for n in args.size.split("x"))
    scene = ROOT / "scenes" / f"spd_{name}.pov"
    with tempfile.TemporaryDirectory() as temporary:
        # Wrappers bring includes of their own (an empty camera): they must not lie where lentray
        # looks first, or it would render another picture.
        folder = pathlib.Path(temporary) / "pictures"
        wrapped = pathlib.Path(temporary) / "wrappers"
        folder.mkdir()
        wrapped.mkdir()
        lens = ["Declare=Lenticular_Camera=1", f"Declare=Lens_Pixels={args.lens_pixels:g}",
                f"Declare=View_Distance={args.view_distance:g}"]
        views, mesh = wrappers(scene, width, height, binaries, wrapped, lens)

        def ours():
            return cpu_seconds([binaries / "lentray", scene, *lens, "+Oours.png", f"+W{width}", f"+H{height}",
                                f"+WT{args.threads}", "-V"], folder)

        def stock_views():
            # The last lens may be cut: the views beyond it have one pixel less a row.
            total = 0.0
            for j, view in enumerate(views):
                columns = len(range(j, width, len(views)))
                total += cpu_seconds(stock(view, columns, height, wrapped, args.threads), folder)
            return total

        def stock_mesh():
            return cpu_seconds(stock(mesh, width, height + 1, wrapped, args.threads), folder)

        ways = {"lentray": ours, "stock mesh_camera": stock_mesh}
        if views and not args.no_views:
            ways["stock views"] = stock_views
        times = {way: [] for way in ways}
        for _ in range(args.runs):
            for way, run in ways.items():
                times[way].append(run())
    medians = {way: statistics.median(seconds) for way, seconds in times.items()}
    far = f"seen from {args.view_distance:g} mm" if args.view_distance else "seen from infinity"
    print(f"{name}: {width} x {height}, {width / args.lens_pixels:g} lenses of {args.lens_pixels:g} pixels, {far}, "
          f"{args.threads} threads, medians of {args.runs}")
    for way, seconds in medians.items():
        ratio = "" if way == "lentray" else f"   stock / lentray = {seconds / medians['lentray']:.2f}"
        print(f"  {way:<18} {seconds:9.3f} CPU s{ratio}")
    return {"scene": name, "width": width, "height": height, "medians": medians, "all": times}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", default="1995x2000")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--threads", type=int, default=1, help="CPU time is that of all threads")
    parser.add_argument("--lens-pixels", type=float, default=15, help="pixels a lens (15)")
    parser.add_argument("--view-distance", type=float, default=0, help="of the eye, in mm (0: infinitely far)")
    parser.add_argument("--no-views", action="store_true", help="only stock's mesh_camera way")
    parser.add_argument("--bin", default=str(ROOT / "build" / "release" / "bin"))
    parser.add_argument("--json")
    parser.add_argument("scenes", nargs="*", default=["balls", "gears"])
    args = parser.parse_args()
    results = [measure(name, args, pathlib.Path(args.bin).resolve()) for name in args.scenes]
    if args.json:
        pathlib.Path(args.json).write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()
