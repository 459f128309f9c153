"""What a batch costs over a plain loop of lentray's calls, in processor time.

  tests/batch/cost.py [--bin build/release/bin] [--scenes FOLDER] [options of lentray]

Both render all scenes of a folder (a copy: scenes write files). The loop calls lentray in each scene's folder, with one thread as the batch does. Status 1
if the batch takes more than 1.05 of the loop's time and more than 20 ms a scene besides.
"""
import argparse
import pathlib
import resource
import shutil
import subprocess
import tempfile

import batch_tools as tools

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def loop(binaries, scenes, out, options):
    before = processor_seconds()
    for number, scene in enumerate(scenes):
        subprocess.run([binaries / "lentray", f"+I{scene.name}", f"+O{out}/{number}.png", "+WT1", "-V", *options], cwd=scene.parent,
                       capture_output=True, check=False)
    return processor_seconds() - before


def batch(binaries, folder, out, options):
    before = processor_seconds()
    done = tools.run(binaries, folder, "--out", out, "--no-scene-ini", "--quiet", *options, timeout=7200)
    return processor_seconds() - before, done.stdout.splitlines()[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN)
    parser.add_argument("--scenes", type=pathlib.Path, default=EXAMPLES)
    given, options = parser.parse_known_args()
    options = options or ["+W160", "+H120", "-A"]
    binaries = given.bin.resolve()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        shutil.copytree(given.scenes, folder / "scenes")
        scenes = sorted((folder / "scenes").rglob("*.pov"))
        (folder / "loop").mkdir()
        by_loop = loop(binaries, scenes, folder / "loop", options)
        by_batch, said = batch(binaries, folder / "scenes", folder / "out", options)
    more = (by_batch - by_loop) / len(scenes)
    print(f"{len(scenes)} scenes: {said}\nloop {by_loop:.2f} s, batch {by_batch:.2f} s of a processor: "
          f"{by_batch / by_loop:.3f} of it, {1000 * more:.1f} ms a scene more")
    return 0 if by_batch <= 1.05 * by_loop or more <= 0.02 else 1


if __name__ == "__main__":
    raise SystemExit(main())
