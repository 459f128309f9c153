#!/usr/bin/env python3
"""How long a batch takes on a Slurm cluster, by a simulation of discrete events.

  cluster_simulation.py sweep    charts and tables for 1 to 1,024 nodes, from the measured costs in docs/cluster
  cluster_simulation.py predict RUN.json    how long a run takes whose tasks and scenes are known
  cluster_simulation.py check    the simulation against cases with known answers; status 1 if one fails

A node runs one task at a time with one processor. Slurm starts tasks in their order; a node stands idle for
`task_s` before every task. A task renders pieces, one after another: a scene, or a band of one. A piece that was
finished stays finished. When a node is lost, Slurm notices after `timeout_s`, and what the task had not
finished waits `requeue_s` more; then it is first in the queue. Scene files that have a size come from one file
system that all nodes share; a node keeps what it has read. All times in seconds of one processor.

RUN.json: {"nodes": 2, "tasks": [[{"name": "a.pov", "wall": 3.1}, ...], ...], "failures": [[at, node, back], ...],
"cluster": {"task_s": 1.0, ...}}. A piece has `wall`, or `reading`, `building`, `rendering` and `writing`.
"""
import argparse
import csv
import dataclasses
import heapq
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "docs" / "cluster"


@dataclasses.dataclass
class Cluster:
    nodes: int = 2
    submit_s: float = 0.1        # sbatch
    task_s: float = 0.7          # a node stands idle before a task; measured by slurm_prediction.py
    dispatch_per_s: float = 100  # tasks that the controller starts: 100 a pass (default_queue_depth), a pass a second
    mtbf_s: float = math.inf     # of one node, exponential
    repair_s: float = 1800
    timeout_s: float = 300       # SlurmdTimeout
    requeue_s: float = 120       # cred_expire
    bandwidth: float = math.inf  # bytes/s of the shared file system
    node_bandwidth: float = math.inf
    seed: int = 1
    failures: tuple = ()         # (at, node, back at): besides the random ones


@dataclasses.dataclass
class Piece:
    name: str
    cpu: float
    picture: str = ""            # bands of one picture are joined when all are there
    bytes: float = 0.0           # of the scene's files


class Reader:
    """The shared file system: who reads at a time has equal shares of it."""

    def __init__(self, cluster):
        self.cluster, self.now, self.work, self.readers = cluster, 0.0, 0.0, []

    def share(self):
        return min(self.cluster.node_bandwidth, self.cluster.bandwidth / max(1, len(self.readers)))

    def advance(self, now):
        if self.readers:
            self.work += (now - self.now) * self.share()
        self.now = now

    def add(self, now, size, key):
        self.advance(now)
        heapq.heappush(self.readers, (self.work + size, key))

    def remove(self, now, key):
        self.advance(now)
        self.readers = [r for r in self.readers if r[1] != key]
        heapq.heapify(self.readers)

    def next_end(self):
        return self.now + max(0.0, self.readers[0][0] - self.work) / self.share() if self.readers else math.inf


class Simulation:
    """Runs tasks, lists of pieces, on a cluster. `joins`: seconds to join a picture's bands."""

    def __init__(self, cluster, tasks, joins=None):
        self.c, self.random = cluster, random.Random(cluster.seed)
        self.events, self.serial = [], itertools.count()
        self.queue = [(i, list(task)) for i, task in enumerate(tasks)]
        heapq.heapify(self.queue)
        self.idle = list(range(cluster.nodes))
        self.running = {}        # node: [order, pieces that are left, epoch]
        self.epoch = [0] * cluster.nodes
        self.up = [True] * cluster.nodes
        self.kept = [set() for _ in range(cluster.nodes)]
        self.reader = Reader(cluster)
        self.next_start = cluster.submit_s
        self.left = sum(len(task) for task in tasks)
        self.bands = {}
        for piece in itertools.chain(*tasks):
            self.bands[piece.picture] = self.bands.get(piece.picture, 0) + 1
        self.joins, self.join_free = joins or {}, 0.0
        self.end = 0.0
        self.requeued = 0

    def at(self, time, what, *data):
        heapq.heappush(self.events, (time, next(self.serial), what, data))

    def run(self):
        self.at(self.c.submit_s, self.dispatch)
        for node in range(self.c.nodes):
            self.plan_failure(0.0, node)
        for time, node, back in self.c.failures:
            self.at(time, self.fail, node, back)
        while self.left:
            time = self.events[0][0] if self.events else math.inf
            if self.reader.next_end() <= time:
                time = self.reader.next_end()
                if time == math.inf:
                    raise RuntimeError("no node is left")
                self.reader.advance(time)
                _, (node, epoch) = heapq.heappop(self.reader.readers)
                self.compute(time, node, epoch)
                continue
            time, _, what, data = heapq.heappop(self.events)
            what(time, *data)
        return max(self.end, self.join_free)

    def plan_failure(self, now, node):
        if self.c.mtbf_s < math.inf:
            at = now + self.random.expovariate(1 / self.c.mtbf_s)
            self.at(at, self.fail, node, at + self.c.repair_s)

    def dispatch(self, now):
        while self.queue and self.idle:
            order, pieces = heapq.heappop(self.queue)
            node = self.idle.pop(0)
            self.next_start = max(self.next_start + 1 / self.c.dispatch_per_s, now)
            self.running[node] = [order, pieces, self.epoch[node]]
            self.at(self.next_start + self.c.task_s, self.begin, node, self.epoch[node])

    def begin(self, now, node, epoch):
        """The next piece of the node's task."""
        if epoch != self.epoch[node]:
            return
        pieces = self.running[node][1]
        if not pieces:
            del self.running[node]
            self.idle.append(node)
            self.dispatch(now)
            return
        piece = pieces[0]
        if piece.bytes and self.c.bandwidth < math.inf and piece.picture not in self.kept[node]:
            self.reader.add(now, piece.bytes, (node, epoch))
        else:
            self.compute(now, node, epoch)

    def compute(self, now, node, epoch):
        if epoch == self.epoch[node]:
            piece = self.running[node][1][0]
            self.kept[node].add(piece.picture)
            self.at(now + piece.cpu, self.finish, node, epoch)

    def finish(self, now, node, epoch):
        if epoch != self.epoch[node]:
            return
        piece = self.running[node][1].pop(0)
        self.left -= 1
        self.end = max(self.end, now)
        self.bands[piece.picture] -= 1
        if self.bands[piece.picture] == 0 and piece.picture in self.joins:
            self.join_free = max(self.join_free, now) + self.joins[piece.picture]
        self.begin(now, node, epoch)

    def fail(self, now, node, back):
        if not self.up[node]:
            return
        self.up[node] = False
        self.epoch[node] += 1
        self.reader.remove(now, (node, self.epoch[node] - 1))
        self.kept[node].clear()
        if node in self.idle:
            self.idle.remove(node)
        if node in self.running:
            order, pieces, _ = self.running.pop(node)
            self.requeued += 1
            noticed = min(now + self.c.timeout_s, back if back is not None else math.inf)
            self.at(noticed + self.c.requeue_s, self.requeue, order, pieces)
        if back is not None:
            self.at(back, self.revive, node)

    def requeue(self, now, order, pieces):
        heapq.heappush(self.queue, (order, pieces))
        self.dispatch(now)

    def revive(self, now, node):
        self.up[node] = True
        self.idle.append(node)
        self.plan_failure(now, node)
        self.dispatch(now)


@dataclasses.dataclass
class Scene:
    """Costs of a picture; `fixed` is paid again by every band: reading, building, writing black rows."""
    name: str
    fixed: float
    rendering: float
    bytes: float = 0.0
    join: float = 0.0            # joining bands: of the picture
    join_band: float = 0.0       # and of each band
    rows: tuple = ()             # weights of equal bands of rows from the top; empty: all rows cost the same

    def whole(self):
        return self.fixed + self.rendering


def band_shares(scene, count):
    """The part of the rendering that is in each of `count` bands of equal height."""
    if not scene.rows:
        return [1 / count] * count
    sums = [0.0]
    for weight in scene.rows:
        sums.append(sums[-1] + weight / sum(scene.rows))

    def up_to(part):
        place = part * len(scene.rows)
        whole = min(int(place), len(scene.rows) - 1)
        return sums[whole] + (sums[whole + 1] - sums[whole]) * (place - whole)
    return [up_to((i + 1) / count) - up_to(i / count) for i in range(count)]


WORTH = 5  # a band takes at least so many times what it pays again


def pack(scenes, task_s, may_split, error, seed, most_bands=1024):
    """Tasks of about `task_s`, the longest first. What a scene is estimated to take is off by a factor whose
    logarithm has the standard deviation `error`. Returns tasks and the seconds to join pictures."""
    dice = random.Random(seed)
    pieces, joins = [], {}
    for scene in scenes:
        off = math.exp(dice.gauss(0.0, error))
        count = min(most_bands, math.ceil(scene.whole() * off / max(task_s, WORTH * scene.fixed))) if may_split else 1
        if count > 1:
            joins[scene.name] = scene.join + scene.join_band * count
        for i, share in enumerate(band_shares(scene, count)):
            name = scene.name if count == 1 else f"{scene.name} {i + 1}/{count}"
            piece = Piece(name, scene.fixed + scene.rendering * share, scene.name, scene.bytes)
            pieces.append((off * piece.cpu, piece))
    pieces.sort(key=lambda p: -p[0])
    tasks, filled = [], math.inf
    for estimate, piece in pieces:
        if filled + estimate > task_s:
            tasks.append([])
            filled = 0.0
        tasks[-1].append(piece)
        filled += estimate
    return tasks, joins


def simulate(scenes, cluster, task_s, may_split, error, most_bands=1024):
    tasks, joins = pack(scenes, task_s, may_split, error, cluster.seed, most_bands)
    simulation = Simulation(cluster, tasks, joins)
    return simulation.run(), simulation


# --- what was measured

def examples(scale):
    """The example scenes, each with `scale` times the pixels of those measured at the larger size."""
    rows = list(csv.DictReader(open(FOLDER / "costs.csv", encoding="utf-8")))
    best = {}
    for row in rows:
        if row["status"] == "0" and int(row["width"]) >= int(best.get(row["scene"], row)["width"]):
            best[row["scene"]] = row
    most = max(int(row["width"]) * int(row["height"]) for row in rows)
    scenes = []
    for row in best.values():
        pixels = scale * most / (int(row["width"]) * int(row["height"]))
        scenes.append(Scene(row["scene"], float(row["reading_s"]) + float(row["building_s"]),
                            (float(row["rendering_s"]) + float(row["writing_s"])) * pixels))
    return scenes


# Measured on pictures of 24,000 x 24,000 pixels: writing one whose rows are nearly all black; joining 16 bands of
# noise, less what follows; passing over black rows in a band's file, for a band at the lower edge.
SHEET_WRITING, SHEET_JOINING, SHEET_PASSING = 7.8, 37.0, 1.15


def sheet(own_rows_only=False):
    """`own_rows_only`: files of bands hold the rows of the band alone, not a whole picture that is black elsewhere."""
    rows = list(csv.DictReader(open(FOLDER / "sheet.csv", encoding="utf-8")))
    per_row = [float(row["rendering_s"]) / int(row["rows"]) for row in rows]
    rendering = sum(per_row) / len(per_row) * 24000
    fixed = float(rows[0]["reading_s"]) + float(rows[0]["building_s"])
    scene = Scene("sheet", fixed, rendering, rows=tuple(per_row), join=SHEET_JOINING)
    if own_rows_only:
        scene.rendering += SHEET_WRITING
    else:
        scene.fixed += SHEET_WRITING
        scene.join_band = SHEET_PASSING / 2
    return scene


def huge_scene(bytes_of_scene, reading_s):
    """A scene of much geometry, rendered in bands: every node reads all of it."""
    return Scene("huge", reading_s, 40000.0, bytes=bytes_of_scene, join=1.0, join_band=0.1)


NODES = [2 ** i for i in range(11)]


def adapted(scenes, nodes, task_s, least):
    """Tasks so small that every node has four of them, but not smaller than `least`."""
    return max(least, min(task_s, sum(s.whole() for s in scenes) / (4 * nodes)))


def curve(name, scenes, out, error, *, split, adapt=False, task_s=180.0, least=10.0, seeds=1, useful=None, **about):
    """Rows of the table: makespan and efficiency over nodes, means of `seeds` runs."""
    useful = useful or sum(s.whole() for s in scenes)
    for nodes in NODES:
        size = adapted(scenes, nodes, task_s, least) if adapt else task_s
        spans, requeued = [], 0
        for seed in range(1, seeds + 1):
            span, simulation = simulate(scenes, Cluster(nodes=nodes, seed=seed, **about), size, split, error)
            spans.append(span)
            requeued += simulation.requeued
        mean = sum(spans) / len(spans)
        out.append({"workload": name[0], "curve": name[1], "nodes": nodes, "task_s": f"{size:.1f}",
                    "makespan_s": f"{mean:.1f}", "longest_s": f"{max(spans):.1f}",
                    "efficiency": f"{useful / (nodes * mean):.4f}", "lost_tasks": f"{requeued / seeds:.2f}"})


def chart(rows, workload, path, title, ideal):
    """Makespan above, efficiency below."""
    curves = list(dict.fromkeys(r["curve"] for r in rows if r["workload"] == workload))
    blocks = []
    for name in curves:
        lines = [f"{r['nodes']} {r['makespan_s']} {r['efficiency']}" for r in rows
                 if r["workload"] == workload and r["curve"] == name]
        blocks.append("\n".join(lines))
    plots = {column: ", ".join(f"$data index {i} using 1:{column} with linespoints lw 2 lc {i + 1} pt 7 ps 0.6 "
                               f"title '{name}'" for i, name in enumerate(curves)) for column in (2, 3)}
    script = "$data << EOD\n" + "\n\n\n".join(blocks) + f"""
EOD
set terminal pngcairo size 900,900 font 'sans,11'
set output '{path}'
set multiplot layout 2,1 title '{title}'
set logscale x 2
set xrange [1:1024]
set xtics ("1" 1, "2" 2, "4" 4, "8" 8, "16" 16, "32" 32, "64" 64, "128" 128, "256" 256, "512" 512, "1024" 1024)
set grid
set xlabel 'nodes'
set ylabel 'makespan, s'
set logscale y
set key bottom left
plot {ideal} / x with lines dt 2 lc 'gray' title 'work / nodes', {plots[2]}
unset logscale y
set yrange [0:1.05]
set ylabel 'efficiency'
set key off
plot {plots[3]}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def sweep(arguments):
    rows, error = [], arguments.error
    scenes = examples(64)
    failing = dict(mtbf_s=arguments.mtbf, timeout_s=300, requeue_s=120)
    quick = {**failing, "timeout_s": 30, "requeue_s": 10}
    name = "examples"
    curve((name, "whole scenes, tasks of 180 s"), scenes, rows, error, split=False)
    curve((name, "bands, tasks of 180 s"), scenes, rows, error, split=True)
    curve((name, "bands, tasks by nodes"), scenes, rows, error, split=True, adapt=True)
    curve((name, "bands, tasks by nodes, failures"), scenes, rows, error, split=True, adapt=True,
          seeds=arguments.seeds, **failing)
    curve((name, "the same, lost nodes noticed after 30 s"), scenes, rows, error, split=True, adapt=True,
          seeds=arguments.seeds, **quick)
    name, one, small = "sheet", [sheet()], [sheet(True)]
    useful = one[0].whole()
    curve((name, "whole"), one, rows, error, split=False)
    curve((name, "bands, tasks of 180 s"), one, rows, error, split=True, useful=useful)
    curve((name, "bands, tasks by nodes"), one, rows, error, split=True, adapt=True, useful=useful)
    curve((name, "bands by nodes, files of the rows alone"), small, rows, error, split=True, adapt=True, useful=useful)
    curve((name, "the same, failures"), small, rows, error, split=True, adapt=True, useful=useful,
          seeds=arguments.seeds, **failing)
    name, big = "huge", [huge_scene(2e9, arguments.huge_reading)]
    for text, speed in (("117 MB/s (1 Gbit/s)", 117e6), ("1.2 GB/s (10 Gbit/s)", 1.17e9), ("12 GB/s", 1.2e10)):
        curve((name, "bands, file system of " + text), big, rows, error, split=True, adapt=True, least=60.0,
              useful=big[0].whole(), bandwidth=speed, node_bandwidth=1.17e9)
    with open(arguments.out / "simulation.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    chart(rows, "examples", arguments.out / "examples.png", "Example scenes at 3840 x 2880",
          sum(s.whole() for s in scenes))
    chart(rows, "sheet", arguments.out / "sheet.png", "One sheet of 24,000 x 24,000", useful)
    chart(rows, "huge", arguments.out / "huge.png", "A scene of 2 GB", big[0].whole())
    for row in rows:
        print(f"{row['workload']:9} {row['curve']:45} {row['nodes']:5} {row['makespan_s']:>9} s "
              f"{100 * float(row['efficiency']):5.1f} %  {row['lost_tasks']}")


# --- known runs

def piece_of(given):
    cpu = given.get("wall")
    if cpu is None:
        cpu = sum(given.get(part, 0.0) for part in ("reading", "building", "rendering", "writing"))
    return Piece(given["name"], cpu, given.get("picture", given["name"]), given.get("bytes", 0.0))


def predict(run):
    """Seconds from sbatch to the last picture."""
    about = Cluster(nodes=run["nodes"], failures=tuple(tuple(f) for f in run.get("failures", ())),
                    **run.get("cluster", {}))
    return Simulation(about, [[piece_of(p) for p in task] for task in run["tasks"]], run.get("joins", {})).run()


def check():
    """Cases whose answers can be worked out by hand."""
    failed = []

    def expect(what, is_value, should):
        if abs(is_value - should) > 1e-6 * max(1.0, abs(should)):
            failed.append(f"{what}: {is_value}, not {should}")
    plain = dict(submit_s=0.0, task_s=1.0, dispatch_per_s=1e9)

    def span(tasks, joins=None, **about):
        return Simulation(Cluster(**{**plain, **about}), tasks, joins).run()
    two = [[Piece("a", 5.0, "a")], [Piece("b", 3.0, "b"), Piece("c", 4.0, "c")]]
    expect("one node: every task and its start", span(two, nodes=1), 14.0)
    expect("two nodes: the longer task", span(two, nodes=2), 8.0)
    expect("more nodes than tasks", span(two, nodes=50), 8.0)
    expect("the controller starts one task in 10 s", span(two, nodes=2, dispatch_per_s=0.1), 28.0)
    # Node 1 is lost at 5 s, with b done and c begun: c is noticed at 15, waits until 20, starts at 21.
    lost = dict(nodes=2, failures=((5.0, 1, None),), timeout_s=10, requeue_s=5)
    expect("a lost node", span(two, **lost), 25.0)
    expect("a node that is back is noticed at once", span(two, **{**lost, "failures": ((5.0, 1, 7.0),)}), 17.0)
    read = [[Piece("a", 1.0, "a", bytes=100.0)] for _ in range(4)]
    expect("four read at a time", span(read, nodes=4, bandwidth=10.0), 1.0 + 40.0 + 1.0)
    expect("a node reads a scene once", span(read, nodes=1, bandwidth=10.0), 4 * 2.0 + 10.0)
    expect("a node's own line", span(read, nodes=2, bandwidth=1e3, node_bandwidth=10.0), 4.0 + 10.0)
    bands = [[Piece("a1", 2.0, "a")], [Piece("a2", 4.0, "a")]]
    expect("bands are joined when the last is there", span(bands, {"a": 7.0}, nodes=2), 12.0)
    shares = band_shares(Scene("s", 0, 1, rows=(1.0, 3.0)), 4)
    for share, should in zip(shares, (0.125, 0.125, 0.375, 0.375)):
        expect("shares of bands", share, should)
    scenes = [Scene(str(i), 1.0, float(i)) for i in range(40)]
    for split in (False, True):
        tasks, _ = pack(scenes, 30.0, split, 0.0, 1)
        expect("packing loses no rendering", sum(p.cpu - 1.0 for t in tasks for p in t), sum(range(40)))
        sizes = [sum(p.cpu for p in task) for task in tasks]
        expect("no task is longer than it may be", max(sizes), 40.0 if not split else 30.0)
    first = Simulation(Cluster(nodes=8, mtbf_s=50, timeout_s=5, requeue_s=5, repair_s=20, seed=3), tasks)
    again = Simulation(Cluster(nodes=8, mtbf_s=50, timeout_s=5, requeue_s=5, repair_s=20, seed=3), tasks)
    expect("a seed is a run", first.run(), again.run())
    expect("all is rendered in spite of failures", first.left, 0)
    print("\n".join(["FAILED: " + f for f in failed] or ["simulation: all is well"]))
    return 1 if failed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("sweep")
    command.add_argument("--out", type=pathlib.Path, default=FOLDER)
    command.add_argument("--mtbf", type=float, default=5 * 3600, help="of a node, s (18000)")
    command.add_argument("--error", type=float, default=0.06, help="of estimates: standard deviation of the logarithm")
    command.add_argument("--seeds", type=int, default=20, help="runs with failures")
    command.add_argument("--huge-reading", type=float, default=83.0,
                         help="s to read and build 2 GB of scene; 1.69 s are measured for 40.6 MB of triangles")
    command = commands.add_parser("predict")
    command.add_argument("run", type=argparse.FileType("r"))
    commands.add_parser("check")
    arguments = parser.parse_args()
    if arguments.command == "sweep":
        return sweep(arguments)
    if arguments.command == "predict":
        print(f"{predict(json.load(arguments.run)):.2f}")
        return 0
    return check()


if __name__ == "__main__":
    sys.exit(main())
