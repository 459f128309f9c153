"""A batch on a cluster of Slurm with two nodes: the same pictures as on one machine, also where a node is lost.

  tests/batch/slurm_batch.py [--bin build/release/bin] [--scenes 40]

Starts the cluster of slurm_cluster.sh. Ends with 77 where Slurm is not installed.
1. So many scenes through Slurm: the files of a batch without it. The same work by two plain loops of lentray at a time
   gives the throughput that the cluster is held against (at least 0.9 of it).
2. A sheet that is cut into bands: the file of the sheet rendered whole.
3. The same with a node that is lost in the middle: all is done, once, the same files.
"""
import argparse
import os
import pathlib
import subprocess
import tempfile
import threading
import time

import batch_tools as tools

CLUSTER = pathlib.Path(__file__).with_name("slurm_cluster.sh")
SHEET = ["Lenticular=On", "+W3600", "+H2400"]
LEAST_BANDS = 16


def cluster(*words, check=True):
    return subprocess.run(["bash", CLUSTER, *map(str, words)], capture_output=True, text=True, check=check)


def environment(folder):
    out = dict(os.environ)
    for line in cluster("env", folder).stdout.splitlines():
        if line.startswith("export "):
            name, value = line[7:].split("=", 1)
            out[name] = value.strip("'\"").rstrip(";").strip("'\"")
    return out


def scene(number):
    """Takes a second or two."""
    return tools.scene(number) + "".join(
        f"sphere {{ <{i % 7 - 3}, 0.3, {i // 7 - 2}>, 0.3 pigment {{ rgb <1, 1, {i / 40}> }} finish {{ reflection 0.3 }} }}\n"
        for i in range(35))


def by_hand(binaries, scenes, out, options):
    """Seconds that two loops take, which share the scenes as they come."""
    out.mkdir()
    waiting, lock = sorted(scenes.glob("*.pov")), threading.Lock()

    def loop():
        while True:
            with lock:
                if not waiting:
                    return
                path = waiting.pop()
            subprocess.run([binaries / "lentray", path.name, *options, "+WT1", "-V", f"+O{out / path.stem}.png"], cwd=scenes,
                           capture_output=True, check=True)

    start = time.monotonic()
    loops = [threading.Thread(target=loop) for _ in range(2)]
    for thread in loops:
        thread.start()
    for thread in loops:
        thread.join()
    return time.monotonic() - start


def through_slurm(binaries, env, *arguments, meanwhile=None):
    start = time.monotonic()
    batch = subprocess.Popen([binaries / "lentray-batch", *map(str, arguments), "--slurm"], env=env, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
    if meanwhile:
        meanwhile()
    said, _ = batch.communicate(timeout=1200)
    return batch.returncode, said, time.monotonic() - start


def attempts(out):
    """Rows that workers wrote, by name."""
    counts = {}
    for path in (out / ".lentray-batch/slurm").glob("*/results/*.jsonl"):
        for line in path.read_text().splitlines():
            name = line.split('"name":"', 1)[1].split('"', 1)[0]
            counts[name] = counts.get(name, 0) + 1
    return counts


def lose_node(folder, out, rows):
    """Loses node 1 once so many rows are there."""
    for _ in range(1200):
        if out.exists() and sum(attempts(out).values()) >= rows:
            break
        time.sleep(0.1)
    cluster("kill-node", folder, 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN)
    parser.add_argument("--scenes", type=int, default=40)
    given = parser.parse_args()
    tools.needs("sbatch", "slurmctld", "slurmd", "munged")
    binaries = given.bin.resolve()
    check = tools.Checks()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        scenes, options = folder / "scenes", ["+W320", "+H240", "+A0.1", "-J"]
        scenes.mkdir()
        for i in range(given.scenes):
            (scenes / f"scene{i:02d}.pov").write_text(scene(i))
        sheets = folder / "sheets"
        sheets.mkdir()
        (sheets / "sheet.pov").write_text(scene(3))
        cluster("start", folder / "slurm")
        try:
            env = environment(folder / "slurm")
            alone = tools.run(binaries, scenes, "--out", folder / "alone", *options)
            check(alone.returncode == 0, f"one machine: {alone.stderr[-300:]}")
            hand = by_hand(binaries, scenes, folder / "hand", options)
            status, said, seconds = through_slurm(binaries, env, scenes, "--out", folder / "many", *options)
            print(said, f"by hand {hand:.1f} s, through Slurm {seconds:.1f} s: {hand / seconds:.2f} of the throughput", sep="")
            check(status == 0, f"Slurm: status {status}: {said[-500:]}")
            check(tools.pictures(folder / "many") == tools.pictures(folder / "alone"), "pictures of the cluster differ")
            check(hand / seconds >= 0.9, f"throughput {hand / seconds:.2f}")
            again = through_slurm(binaries, env, scenes, "--out", folder / "many", *options)
            check(f"{given.scenes} of {given.scenes} pictures are there" in again[1], f"again: {again[1][-300:]}")

            whole = tools.run(binaries, sheets, "--out", folder / "whole", *SHEET)
            check(whole.returncode == 0, f"the sheet whole: {whole.stderr[-300:]}")
            for what, meanwhile in (("bands", None), ("lost", lambda: lose_node(folder / "slurm", folder / "lost", 3))):
                out = folder / what
                status, said, seconds = through_slurm(binaries, env, sheets, "--out", out, "--task-time=2", *SHEET, meanwhile=meanwhile)
                counts = attempts(out)
                print(said, f"{what}: {len(counts)} bands, {sum(counts.values())} rows of workers, {seconds:.1f} s", sep="")
                check(status == 0, f"{what}: status {status}: {said[-500:]}")
                check(tools.pictures(out) == tools.pictures(folder / "whole"), f"{what}: the sheet differs")
                check(len(counts) >= (LEAST_BANDS if what == "bands" else 2), f"{what}: {len(counts)} bands")
                check(max(counts.values()) == 1, f"{what}: {[n for n, c in counts.items() if c > 1]} were done twice")
                if what == "lost":
                    cluster("revive-node", folder / "slurm", 1)
        finally:
            cluster("stop", folder / "slurm", check=False)
    check.end()


if __name__ == "__main__":
    main()
