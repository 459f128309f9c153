#!/usr/bin/env python3
"""Measures what scenes cost, for cluster_simulation.py: CPU seconds of one thread, as Statistics_File tells them.

  slurm_costs.py examples [--bin FOLDER] [--out FILE]   every scene of povray-examples, at 160 x 120 and 480 x 360
  slurm_costs.py sheet [--bin FOLDER] [--out FILE]      12 bands of 16 rows of scenes/demo.pov as a sheet of
                                                        24,000 x 24,000 pixels, written to no file

About 5 and 1.5 minutes of one processor. Status of a scene: lentray's exit status.
"""
import argparse
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
TIMES = ("parse_cpu_s", "compile_cpu_s", "render_cpu_s", "write_cpu_s")


def render(lentray, scene, folder, options):
    """Exit status, s of wall clock, the statistics or nothing."""
    file = folder / "statistics.json"
    file.unlink(missing_ok=True)
    began = time.monotonic()
    run = subprocess.run([lentray, scene.name, "-V", "-D", "Work_Threads=1", f"Statistics_File={file}", *options],
                         cwd=scene.parent, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                         stderr=subprocess.DEVNULL)
    took = time.monotonic() - began
    return run.returncode, took, json.loads(file.read_text()) if file.exists() and run.returncode == 0 else None


def examples(lentray, folder, out):
    out.writerow("scene width height status reading_s building_s rendering_s writing_s wall_s peak_bytes".split())
    shutil.copytree(EXAMPLES, folder / "examples")
    for width, height in ((160, 120), (480, 360)):
        for scene in sorted((folder / "examples").rglob("*.pov")):
            options = [f"+W{width}", f"+H{height}", f"+O{folder}/picture.png", "Max_Time=5m"]
            status, took, known = render(lentray, scene, folder, options)
            times = [known["time"][t] if known else 0.0 for t in TIMES]
            out.writerow([scene.relative_to(folder / "examples"), width, height, status, *(f"{t:.4f}" for t in times),
                          f"{took:.4f}", known["memory"]["peak_bytes"] if known else 0])


def sheet(lentray, folder, out):
    out.writerow("first_row rows reading_s building_s rendering_s shadow_rays camera_rays peak_bytes".split())
    for band in range(12):
        first = 1000 + 2000 * band - 7
        options = ["+W24000", "+H24000", "Lenticular=On", f"+SR{first}", f"+ER{first + 15}", "-F"]
        status, _, known = render(lentray, ROOT / "scenes" / "demo.pov", folder, options)
        if status:
            sys.exit(f"lentray ends with status {status}")
        out.writerow([first, 16, *(f"{known['time'][t]:.4f}" for t in TIMES[:3]), known["rays"]["shadow"],
                      known["rays"]["camera"], known["memory"]["peak_bytes"]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("examples", "sheet"))
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    place = arguments.out or ROOT / "docs" / "cluster" / ("costs.csv" if arguments.what == "examples" else "sheet.csv")
    lentray = str(arguments.bin.resolve() / "lentray")
    with tempfile.TemporaryDirectory(prefix="lentray-costs-") as folder, \
            open(place, "w", newline="", encoding="utf-8") as file:
        measure = examples if arguments.what == "examples" else sheet
        measure(lentray, pathlib.Path(folder), csv.writer(file, lineterminator="\n"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
