"""A batch that is killed again and again ends in the same pictures, and makes none twice.

  tests/batch/kills.py [--bin build/release/bin] [--kills 20] [--scenes 60]

Scenes are rendered once without a kill. Then the same batch runs with SIGKILL after a random time, until it has been
killed so often, and once more to its end. Pictures must be the same files; a picture whose row was written before a
kill is not rendered again; and of those in the making at a kill at most one a processor is begun anew.
"""
import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time

import batch_tools as tools


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    check = tools.Checks()
    rng = random.Random(given.seed)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        tools.write_scenes(folder / "scenes", given.scenes)
        program, log = tools.logged_lentray(folder, given.bin.resolve())
        options = [folder / "scenes", "+W160", "+H120", "+A0.1", "--lentray", program]
        start = time.monotonic()
        whole = tools.run(given.bin, *options, "--out", folder / "whole")
        seconds = time.monotonic() - start
        check(whole.returncode == 0, f"the batch without kills: {whole.stderr[-300:]}")
        log.unlink()

        scenes = {path: path.read_bytes() for path in (folder / "scenes").iterdir()}
        out = folder / "killed"
        kills = repeated = kills_before = 0
        while kills < given.kills:
            done_before = set(tools.rows(out)) if (out / "manifest.jsonl").exists() else set()
            calls_before = len(tools.calls(log))
            batch = subprocess.Popen([given.bin / "lentray-batch", *map(str, options), "--out", out], stdin=subprocess.DEVNULL,
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            # Twenty kills are spread over the whole batch.
            time.sleep(rng.uniform(0.2, 1.8) * seconds / given.kills * 0.8)
            if batch.poll() is not None:  # quicker than thought: begun again from nothing
                shutil.rmtree(out)
                log.unlink(missing_ok=True)
                kills_before = kills
                continue
            os.kill(batch.pid, signal.SIGKILL)
            batch.wait()
            kills += 1
            begun = [pathlib.Path(c).stem for c in tools.calls(log)[calls_before:]]
            repeated += len(done_before & set(begun))
        last = tools.run(given.bin, *options, "--out", out)
        check(last.returncode == 0, f"the batch after the kills: {last.stderr[-300:]}")
        check(tools.pictures(out) == tools.pictures(folder / "whole"), "the pictures are not the same")
        check(len(tools.pictures(out)) == given.scenes, "pictures are missing")
        check(repeated == 0, f"{repeated} pictures with a row were rendered again")
        calls = tools.calls(log)
        most = given.scenes + (given.kills - kills_before) * (os.cpu_count() or 1)
        check(len(calls) <= most, f"{len(calls)} runs of lentray for {given.scenes} scenes and {given.kills} kills")
        check(all(row["state"] == "done" for row in tools.rows(out).values()), "a row is not done")
        check(scenes == {path: path.read_bytes() for path in (folder / "scenes").iterdir()}, "the scenes have changed")
        left = [p.name for p in out.rglob("*") if p.name.endswith((".part", ".lentray-state"))]
        check(not left, f"left behind: {left}")
        print(f"{given.kills} kills, {given.scenes} scenes in {seconds:.1f} s without kills: {len(calls)} runs of lentray")
    check.end()


if __name__ == "__main__":
    main()
