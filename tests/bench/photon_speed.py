#!/usr/bin/env python3
"""What pictures with photons cost beside stock, 160 x 120 without antialiasing: examples, and the scenes of
tests/image/photons_test.cpp. Whole pictures on one thread, user + system time; the programs take turns, medians are
compared. Beside them lentray's pass of photons.

  tests/bench/photon_speed.py [--runs N] [--bin FOLDER] [--match WORD]
  tests/bench/photon_speed.py --threads      how much sooner two threads end the pass

Threads: the least wall time of the runs with one and with two, so that a busy machine disturbs least. A machine with
fewer than two idle processors tells nothing. The scenes of the tests are too small for it.

The exit status is 1 where a picture takes longer than stock's, or more than a third of its time at the median; with
--threads where two are less than 1.5 times as fast at the median.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import pass_speed
import two_builds

EXAMPLES = ["lights/phot_met_glass", "lights/glassthing", "advanced/optics", "advanced/grenadine/grenadine",
            "advanced/balcony/balcony", "advanced/benchmark/benchmark"]


def scenes_of_tests(program, folder):
    """Titles and files: the tests keep their scenes where LENTRAY_KEEP says."""
    tests = program.parent / "test_image"
    if not tests.is_file():
        sys.exit(f"no {tests}: build it, or name scenes with --match")
    subprocess.run([tests, "--gtest_filter=*ImagePhotons.*"], env={**os.environ, "LENTRAY_KEEP": folder},
                   stdout=subprocess.DEVNULL, check=False)
    return [(path.stem.split(".")[-1], path) for path in sorted(pathlib.Path(folder).glob("*.pov"))]


def main():
    args = pass_speed.parser_of(__doc__)
    scenes = two_builds.examples(args.parser, [name for name in EXAMPLES if args.match in name])
    with tempfile.TemporaryDirectory() as folder:
        if not args.threads and not (args.match and scenes):
            own = scenes_of_tests(two_builds.program(args.parser, args.bin), folder)
            scenes += [(name, path) for name, path in own if args.match in name]
        return pass_speed.measure("photons", scenes, args)


if __name__ == "__main__":
    two_builds.main(main)
