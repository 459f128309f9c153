#!/usr/bin/env python3
"""Example scenes as a job array on the two nodes of slurm_cluster.sh, held against cluster_simulation.py.

  slurm_prediction.py [--bin FOLDER] [--lose] [--width W]

The simulation is told what every scene took in that run, and predicts from sbatch to the last picture; the
prediction must be within 10 %. With --lose a node is lost on the way. Prints also for how long a node stood idle
before a task, which is the simulation's `task_s`. Exit status: 0; 1 if the prediction is off or a picture is
missing; 77 without Slurm. Needs povray-examples.
"""
import argparse
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

import cluster_simulation

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SCENES = ("advanced/abyss", "advanced/balcony/balcony", "advanced/biscuit", "advanced/diffuse_back",
          "advanced/drums2/drums", "advanced/glasschess/glasschess", "advanced/grenadine/grenadine",
          "advanced/isocacti", "advanced/lamppost", "advanced/landscape", "advanced/mediasky", "advanced/pawns",
          "advanced/quilt1", "advanced/whiltile", "advanced/wineglass", "advanced/woodbox", "incdemo/shapes",
          "gamma/gamma_showcase", "incdemo/glasses/glass", "advanced/blocks/stackergold")
TASK = """#!/bin/bash
# A task: its scenes, one after another. A line of the log: name, node, begin, end, s since 1970.
while IFS=: read -r name width; do
  [ -e {folder}/out/$(basename "$name").done ] && continue
  began=$(date +%s.%N)
  cd {folder}/examples/$(dirname "$name")
  {lentray} $(basename "$name").pov +W$width +H$((width * 3 / 4)) -V -D Work_Threads=1 \\
    +O{folder}/out/$(basename "$name").png </dev/null 2>/dev/null
  echo "$name $SLURMD_NODENAME $began $(date +%s.%N)" >> {folder}/log.$SLURM_ARRAY_TASK_ID
  touch {folder}/out/$(basename "$name").done
done < {folder}/task.$SLURM_ARRAY_TASK_ID
"""


def cluster(*words):
    run = subprocess.run([HERE / "slurm_cluster.sh", *words], capture_output=True, text=True)
    if run.returncode:
        print(run.stdout + run.stderr, end="")
        sys.exit(run.returncode)
    return run.stdout


def wait_for(count, folder, limit=600):
    end = time.time() + limit
    while len(list((folder / "out").glob("*.done"))) < count:
        if time.time() > end:
            sys.exit(f"only {len(list((folder / 'out').glob('*.done')))} of {count} pictures are there")
        time.sleep(0.2)


def run_batch(folder, width, tasks, lentray, lose):
    """Begin of the run, and what is known of it for the simulation."""
    (folder / "out").mkdir()
    shutil.copytree(EXAMPLES, folder / "examples")
    for i, task in enumerate(tasks):
        (folder / f"task.{i}").write_text("".join(f"{name}:{width}\n" for name in task))
    (folder / "job.sh").write_text(TASK.format(folder=shlex.quote(str(folder)), lentray=shlex.quote(lentray)))
    began, failures = time.time(), []
    subprocess.run(["sbatch", "--parsable", f"--array=0-{len(tasks) - 1}", "--output=/dev/null", folder / "job.sh"],
                   env={"SLURM_CONF": str(folder / "slurm" / "slurm.conf"), "PATH": "/usr/bin:/bin"}, check=True,
                   stdout=subprocess.DEVNULL)
    if lose:
        wait_for(len(SCENES) // 4, folder)
        cluster("kill-node", str(folder / "slurm"), "1")
        failures.append((time.time() - began, 1, None))
    wait_for(len(SCENES), folder)
    return began, failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=HERE.parents[1] / "build" / "release" / "bin")
    parser.add_argument("--lose", action="store_true", help="a node is lost when a quarter is done")
    parser.add_argument("--width", type=int, default=480)
    arguments = parser.parse_args()
    if not EXAMPLES.is_dir():
        print("povray-examples is not installed")
        return 77
    tasks = [list(SCENES[i::8]) for i in range(8)]
    folder = pathlib.Path(tempfile.mkdtemp(prefix="lentray-prediction-"))
    try:
        cluster("start", str(folder / "slurm"))
        began, failures = run_batch(folder, arguments.width, tasks, str(arguments.bin.resolve() / "lentray"),
                                    arguments.lose)
        log = [line.split() for i in range(len(tasks)) for line in (folder / f"log.{i}").read_text().splitlines()]
    finally:
        cluster("stop", str(folder / "slurm"))
        shutil.rmtree(folder)
    return judge(tasks, log, began, failures)


def judge(tasks, log, began, failures):
    wall = {name: float(end) - float(start) for name, _, start, end in log}
    took = max(float(row[3]) for row in log) - began
    first = {name: float(start) for name, _, start, _ in log}
    idle = []
    for node in sorted({row[1] for row in log}):
        rows = sorted((float(start), float(end), name) for name, at, start, end in log if at == node)
        ends = [began] + [end for _, end, _ in rows]
        idle += [start - before for (start, _, name), before in zip(rows, ends) if name in {t[0] for t in tasks}]
    about = {"task_s": cluster_simulation.Cluster.task_s, "timeout_s": 12.5, "requeue_s": 5.0}
    run = {"nodes": 2, "failures": failures, "cluster": about,
           "tasks": [[{"name": name, "wall": wall[name]} for name in task] for task in tasks]}
    predicted = cluster_simulation.predict(run)
    off = predicted / took - 1
    print(f"{len(first)} scenes, {sum(wall.values()):.1f} s in {len(tasks)} tasks on 2 nodes"
          f"{', one lost' if failures else ''}: took {took:.1f} s, predicted {predicted:.1f} s ({100 * off:+.1f} %)")
    print(f"a node is idle before a task for {sum(idle) / len(idle):.2f} s "
          f"({min(idle):.2f} to {max(idle):.2f}), of {len(idle)}")
    return 0 if abs(off) <= 0.1 else 1


if __name__ == "__main__":
    sys.exit(main())
