"""What the tests of lentray-batch share: scenes, a lentray that writes down its calls, runs, pictures, rows."""
import argparse
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = ROOT / "build/release/bin"


def scene(number, extra=""):
    """A small scene of its own: a ball, a floor, an area light that takes some time."""
    return f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
camera {{ location <0, 2, -5> look_at <0, 0.5, 0> }}
light_source {{ <4, 6, -5> 1 area_light x, y, 5, 5 }}
plane {{ y, 0 pigment {{ checker rgb 1 rgb <0.1, {number % 7 / 7:.3f}, 0.4> }} }}
sphere {{ <{number % 5 * 0.3 - 0.6:.2f}, 1, 0>, 1 pigment {{ rgb <1, {number % 11 / 11:.3f}, 0> }} finish {{ phong 1 reflection 0.2 }} }}
{extra}
"""


def write_scenes(folder, count):
    folder.mkdir(parents=True, exist_ok=True)
    for i in range(count):
        (folder / f"scene{i:02d}.pov").write_text(scene(i))


def logged_lentray(folder, binaries):
    """A program that does as lentray, and the file that it writes its arguments to."""
    log = folder / "calls.log"
    program = folder / "lentray-logged"
    program.write_text(f'#!/bin/sh\necho "$*" >> "{log}"\nexec "{binaries}/lentray" "$@"\n')
    program.chmod(0o755)
    return program, log


def calls(log):
    """Scenes that lentray was called for, in order."""
    if not log.exists():
        return []
    return [word[2:] for line in log.read_text().splitlines() for word in line.split() if word.startswith("+I")]


def run(binaries, *arguments, **options):
    options.setdefault("timeout", 600)
    return subprocess.run([binaries / "lentray-batch", *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, errors="replace", check=False, **options)


def pictures(folder):
    """Name and checksum of every picture."""
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(folder.rglob("*.png")) if ".lentray-batch" not in path.parts}


def rows(folder):
    """The manifest: the last row of each name."""
    out = {}
    for line in (folder / "manifest.jsonl").read_text(errors="replace").splitlines():
        try:
            row = json.loads(line)
        except ValueError:
            continue
        out[row["name"]] = row
    return out


class Checks:
    """Counts what was checked; ends in the line that test runners read."""

    def __init__(self):
        self.passed = self.failed = 0

    def __call__(self, holds, what):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"FAILED: {what}", flush=True)

    def end(self):
        print(f"{self.passed} passed, {self.failed} failed")
        sys.exit(1 if self.failed else 0)


def run_parts(about, parts):
    """The program of a suite: each part is called with the checks, a folder of its own and that of the programs."""
    parser = argparse.ArgumentParser(description=about.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=BIN)
    binaries = parser.parse_args().bin.resolve()
    check = Checks()
    with tempfile.TemporaryDirectory() as temporary:
        for part in parts:
            folder = pathlib.Path(temporary) / part.__name__
            folder.mkdir()
            part(check, folder, binaries)
    check.end()


def needs(*programs):
    """Ends with 77, which counts as left out, where a program is missing."""
    missing = [p for p in programs if shutil.which(p, path=os.environ["PATH"] + ":/usr/sbin:/sbin") is None]
    if missing:
        print("left out: not installed: " + ", ".join(missing))
        sys.exit(77)
