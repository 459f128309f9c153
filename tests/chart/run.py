#!/usr/bin/env python3
"""lentray-chart from end to end on small scenes: what the table says is true, a stopped chart goes on, settings that fail
are rows, and a scene, a stock POV-Ray or a reference that cannot be had is told of.

  tests/chart/run.py [--bin build/release/bin]
"""
import argparse
import csv
import os
import pathlib
import pty
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at <0, 0.5, 0> }
light_source { <4, 6, -5> 1 area_light x, y, 3, 3 }
plane { y, 0 pigment { checker rgb 1 rgb <0.1, 0.3, 0.4> scale 3 } }
sphere { <-0.3, 1, 0>, 1 pigment { rgb <1, 0.3, 0> } finish { phong 1 reflection 0.2 } }
"""
SIZE = ["+W60", "+H45"]
FEW = ["--quick", "--repeats", "1", "--reference-limit", "1s"]
# Enough for a first reference by the lens model thick, on a busy machine too.
SHEET = ["Lenticular=On", "Lens_Pixels=6", "View_Distance=inf", "+W30", "+H24", "--quick", "--repeats", "1", "--reference-limit", "10s"]


class Checks:
    def __init__(self):
        self.passed = self.failed = 0

    def __call__(self, holds, what):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"FAILED: {what}", flush=True)


class Chart:
    """A folder with a scene, a lentray that writes down its calls, and the charts that are made there."""

    def __init__(self, folder, binaries):
        self.folder, self.binaries = folder, binaries
        folder.mkdir()
        (folder / "my scene.pov").write_text(SCENE)
        self.log = folder / "calls.log"
        self.program = self.wrapper("lentray-logged", "")

    def wrapper(self, name, middle):
        program = self.folder / name
        program.write_text(f'#!/bin/sh\necho "$*" >> "{self.log}"\n{middle}\nexec "{self.binaries}/lentray" "$@"\n')
        program.chmod(0o755)
        return program

    def command(self, *options):
        return [self.binaries / "lentray-chart", "my scene.pov", *map(str, options)]

    def run(self, *options, **more):
        return subprocess.run(self.command(*options), cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False, timeout=300, **more)

    def rows(self, out="out"):
        with open(self.folder / out / "chart.csv", encoding="utf-8", newline="") as file:
            return {row["id"]: row for row in csv.DictReader(file)}

    def rendered(self, picture=None):
        """Calls of lentray that rendered a picture of a setting, or that one."""
        calls = self.log.read_text().splitlines() if self.log.exists() else []
        return [c for c in calls if (f"/pictures/{picture}.png" if picture else "/pictures/") in c]


def stop_and_go_on(check, chart):
    options = ["--out", "out", *SIZE, "--quick", "--repeats", "2", "--only", "antialiasing,quality,exact,combined",
               "--reference-limit", "3s", "--lentray", chart.program, "--error", "30", "--budget", "2s"]
    with subprocess.Popen(chart.command(*options), cwd=chart.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as child:
        until = time.time() + 120
        while len(chart.rendered()) < 6 and time.time() < until:
            time.sleep(0.01)
        child.send_signal(signal.SIGINT)
        _, said = child.communicate(timeout=60)
    check(child.returncode == 3 and "stopped; the same command goes on from here" in said, f"a stop: {child.returncode}, {said}")
    left = [p.name for p in chart.folder.rglob("*") if p.name.endswith((".lentray-state", ".part"))]
    check(not left and not (chart.folder / "out/chart.csv").exists(), f"a stop leaves nothing unfinished: {left}")
    before = len(chart.rendered())
    done = chart.run(*options)
    check(done.returncode == 0, f"going on: {done.returncode}, {done.stderr}")
    rows = chart.rows()
    check(before < len(rows), f"it was stopped in the middle: {before} of {len(rows)}")
    for name in rows:
        # The one that ran when it was stopped begins anew, and the choice is rendered again to see that it holds.
        check(2 <= len(chart.rendered(name)) <= 6, f"{name} was rendered {len(chart.rendered(name))} times")
    check(sum(len(chart.rendered(name)) == 2 for name in rows) >= len(rows) - 3, "what was there was not rendered again")
    return done.stdout


def table_is_true(check, chart):
    rows, plain = chart.rows(), chart.rows()["plain"]
    exact = [r for r in rows.values() if r["kind"] == "exact"]
    check(len(exact) >= 5, f"exact settings: {[r['id'] for r in exact]}")
    for row in exact:
        check(row["from_plain_rms"] == "0" and row["from_plain_largest"] == "0" and row["rms"] == plain["rms"],
              f"exact settings have the plain picture: {row}")
        same = subprocess.run([chart.binaries / "lentray-diff", chart.folder / "out/pictures/plain.png",
                               chart.folder / "out" / row["picture"], "--no-pictures", "--grade", "exact"],
                              capture_output=True, text=True, check=False)
        check(same.returncode == 0 and "equal" in same.stdout, f"{row['id']}: {same.stdout}")
    kinds = {row["kind"] for row in rows.values()}
    check(kinds == {"antialiasing", "area_light", "depth", "quality", "exact", "combined"}, f"kinds: {kinds}")
    trading = [r for r in rows.values() if r["kind"] != "exact" or r["id"] == "plain"]
    for row in exact:
        check(row["id"] == "plain" or (row["on_front"] == "no" and row["dominated_by"] == ""), f"exact: {row}")
    for row in rows.values():
        check(row["state"] == "done" and float(row["cpu_s"]) > 0 and int(row["repeats"]) >= 2, f"times: {row}")
        check(float(row["cpu_least_s"]) <= float(row["cpu_s"]) <= float(row["cpu_most_s"]), f"spread: {row}")
        has_stock = row["id"] == "plain" or row["kind"] in ("antialiasing", "quality") and "grid" not in row["id"]
        check((row["stock_cpu_s"] != "") == has_stock, f"stock's time: {row}")
        if has_stock and "jitter" not in row["id"]:
            # Every sample of the area light is a point of a grid: both have the same picture.
            check(float(row["from_stock_rms"]) < 0.1, f"stock's picture: {row}")
        if shutil.which("butteraugli_main"):
            check(row["perceived"] != "", f"perceived: {row}")
    for row in trading:
        beaten = [o for o in trading if float(o["cpu_s"]) <= float(row["cpu_s"]) and float(o["rms"]) <= float(row["rms"])
                  and (o["cpu_s"], o["rms"]) != (row["cpu_s"], row["rms"])]
        check((row["on_front"] == "yes") == (not beaten), f"the front: {row}")
        check((row["dominated_by"] == "") == (row["on_front"] == "yes"), f"dominated: {row}")
    depths = [float(rows[f"aa-method1-depth{d}-threshold{t}"]["rms"]) for d, t in (("3", "0-3"), ("5", "0-03"))]
    check(float(plain["rms"]) > depths[0] > depths[1], f"more samples, less error: {plain['rms']}, {depths}")
    check((chart.folder / "out/index.html").stat().st_size > 100, "the page")


def choices_hold(check, chart, said):
    rows = chart.rows()
    picks = {}
    lines = said.splitlines()
    for i, line in enumerate(lines):
        for asked in ("within", "error at most"):
            if line.startswith(asked + " "):
                picks[asked] = lines[i + 1].strip()
    check(set(picks) == {"within", "error at most"}, f"two choices: {said}")
    chosen = {asked: [r for r in rows.values() if r["command"] == command] for asked, command in picks.items()}
    check(all(len(c) == 1 for c in chosen.values()), f"choices are rows: {picks}")
    budget, error = chosen["within"][0], chosen["error at most"][0]
    check(not [r for r in rows.values() if float(r["cpu_s"]) <= 2 and float(r["rms"]) < float(budget["rms"])], f"budget: {budget}")
    check(float(error["rms"]) <= 30 and not [r for r in rows.values() if float(r["rms"]) <= 30 and
                                             (r["kind"] != "exact" or r["id"] == "plain") and
                                             float(r["cpu_s"]) < float(error["cpu_s"])], f"error: {error}")
    command = shlex.split(picks["within"])
    check(command[:2] == ["lentray", "my scene.pov"], f"a command: {command}")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([chart.binaries / "lentray", *command[1:], "+Oanew.png", "-V"], cwd=chart.folder, capture_output=True,
                         text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    check(run.returncode == 0 and taken <= 1.1 * 2, f"the choice run anew takes {taken} s: {run.stderr}")


def again(check, chart):
    calls = len(chart.rendered())
    options = ["--out", "out", *SIZE, "--quick", "--repeats", "2", "--only", "antialiasing,quality,exact,combined",
               "--reference-limit", "3s", "--lentray", chart.program]
    quiet = chart.run(*options, "--error", "1e-9")
    check(quiet.returncode == 2 and "no setting has an error of at most 1e-09/255; the least," in quiet.stdout,
          f"no such error: {quiet.returncode}, {quiet.stdout}")
    none = chart.run(*options, "--budget", "1ms")
    check(none.returncode == 2 and "no setting renders within 0.0 s; the fastest," in none.stdout, f"no such time: {none.stdout}")
    check(len(chart.rendered()) <= calls + 4, "a chart that is done renders no setting again")
    (chart.folder / "my scene.pov").write_text(SCENE.replace("rgb <1, 0.3, 0>", "rgb <0, 0.3, 1>"))
    new = chart.run("--out", "out", *SIZE, *FEW, "--only", "exact", "--no-stock", "--lentray", chart.program)
    check(new.returncode == 0, f"{new.stderr}")
    check("the chart begins anew: the scene's name, an option" not in new.stderr and
          "the chart begins anew: " in new.stderr and "my scene.pov has changed" in new.stderr, f"a changed scene: {new.stderr}")
    other = chart.run("--out", "out", "+W50", "+H40", *FEW, "--only", "exact", "--no-stock", "--lentray", chart.program)
    check("the chart begins anew: the scene's name, an option or the program is another one" in other.stderr,
          f"other options: {other.stderr}")
    (chart.folder / "out/.lentray-chart/state.json").write_text("{")
    damaged = chart.run("--out", "out", "+W50", "+H40", *FEW, "--only", "exact", "--no-stock", "--lentray", chart.program)
    check("the chart begins anew: this is no state of a chart" in damaged.stderr, f"a damaged state: {damaged.stderr}")


def lost_pictures(check, chart):
    """A picture of the chart's own that is emptied, cut, exchanged or gone is made again, and that one alone."""
    options = ["--out", "damaged", *SIZE, *FEW, "--only", "exact", "--lentray", chart.program]
    first = chart.run(*options)
    check(first.returncode == 0, f"{first.returncode}, {first.stderr}")
    pictures = chart.folder / "damaged/pictures"
    whole = {name: (pictures / name).read_bytes() for name in ("plain.png", "order-rows.png", "reference.png", "order-rows-difference.png",
                                                               "plain-stock.png", "accelerator-grid.png") if (pictures / name).exists()}
    check(len(whole) >= 4, f"pictures: {list(whole)}")
    for i, (name, bytes) in enumerate(whole.items()):
        every = (b"", bytes[:len(bytes) // 2], b"no picture", None)
        for damage in every if i == 1 else every[i % 4:i % 4 + 1]:
            path = pictures / name
            path.unlink()
            if damage is not None:
                path.write_bytes(damage)
            before = len(chart.rendered()) - len(chart.rendered("reference-next"))
            done = chart.run(*options)
            made = len(chart.rendered()) - len(chart.rendered("reference-next")) - before
            check(done.returncode == 0, f"{name}, {damage}: {done.returncode}, {done.stderr}")
            same = subprocess.run([chart.binaries / "lentray-diff", "--grade", "exact", path, path, "--no-pictures"],
                                  capture_output=True, text=True, check=False)
            check(same.returncode == 0, f"{name} is a picture again: {same.stderr}")
            check(made <= 1, f"{name}: {made} settings were rendered again")


def others_files(check, chart):
    """What stands there and is not of a chart stays."""
    for name in ("index.html", "chart.csv", "chart.svg", "chart.png"):
        out = chart.folder / "others"
        out.mkdir()
        (out / name).write_text("<p>mine</p>\n")
        done = chart.run("--out", "others", *SIZE, *FEW, "--only", "exact")
        check(done.returncode == 1 and f"others/{name}' is not of lentray-chart" in done.stderr, f"{done.returncode}, {done.stderr}")
        check([p.name for p in out.iterdir()] == [name] and (out / name).read_text() == "<p>mine</p>\n", f"{name} stays")
        shutil.rmtree(out)


def failing_settings(check, chart):
    program = chart.wrapper("lentray-odd", """case "$*" in
  *Accelerator=grid*) echo "lentray: error: there is no grid today" >&2; exit 1 ;;
  *Shadow_Cache=off*) set -- "$@" +Q0 ;;
esac""")
    none = chart.folder / "nothing-here"
    done = chart.run("--out", "odd", *SIZE, *FEW, "--only", "exact", "--lentray", program, "--povray", none)
    rows = chart.rows("odd")
    row = rows["accelerator-grid"]
    check(row["state"] == "failed" and row["reason"] == "there is no grid today" and row["cpu_s"] == "", f"a failing setting: {row}")
    check(rows["order-rows"]["state"] == "done", "the others go on")
    check("accelerator grid: failed: there is no grid today" in done.stderr, f"a failure is told of: {done.stderr}")
    check(done.returncode == 1 and "shadow cache off changes the picture, by up to " in done.stderr, f"a broken promise: {done.stderr}")
    check(f"stock POV-Ray is left out: cannot start '{none}': is it installed?" in done.stderr, f"no stock: {done.stderr}")


def bad_scenes(check, chart):
    for text, said in ((SCENE + "sphere {", "lentray cannot read the scene"),):
        (chart.folder / "my scene.pov").write_text(text)
        bad = chart.run("--out", "bad", *SIZE)
        check(bad.returncode == 1 and said in bad.stderr, f"a bad scene: {bad.returncode}, {bad.stderr}")
    (chart.folder / "my scene.pov").write_text(SCENE)
    program = chart.wrapper("lentray-never", 'case "$*" in *pictures/*) echo "no picture today"; exit 1 ;; esac')
    never = chart.run("--out", "never", *SIZE, "--lentray", program)
    check(never.returncode == 1 and "lentray cannot render the scene: no picture today" in never.stderr, f"{never.stderr}")
    wrong = chart.run("--out", "o", "--budget", "soon")
    check(wrong.returncode == 1 and "a time above 0 is expected" in wrong.stderr, f"a bad budget: {wrong.stderr}")
    gone = chart.run("--out", "o", "--lentray", chart.folder / "nothing-here")
    check(gone.returncode == 1 and "there is no program '" in gone.stderr, f"no lentray: {gone.stderr}")
    (chart.folder / "file").write_text("")
    taken = chart.run("--out", "file")
    check(taken.returncode == 1 and "cannot write into the folder" in taken.stderr, f"no folder: {taken.stderr}")


def bare_machine(check, chart):
    """Without butteraugli_main and povray along PATH, with a reference that may take no time, and quiet."""
    (chart.folder / "empty").mkdir()
    env = {**os.environ, "PATH": str(chart.folder / "empty")}
    bare = chart.run("--out", "bare", *SIZE, "--quick", "--repeats", "1", "--only", "exact", "--reference-limit", "1ms", "-V",
                     env=env)
    check(bare.returncode == 0, f"a bare machine: {bare.returncode}, {bare.stderr}")
    check("butteraugli_main is not installed (Debian's libjxl-devtools)" in bare.stderr, f"no butteraugli: {bare.stderr}")
    check("cannot start 'povray': is it installed?" in bare.stderr, f"no povray: {bare.stderr}")
    check("reference: NOT converged (the next step would pass the limit of 0.0 s)" in bare.stderr, f"no time: {bare.stderr}")
    check("round" not in bare.stderr, f"-V: no progress: {bare.stderr}")
    check(all(r["perceived"] == "" and r["stock_cpu_s"] == "" for r in chart.rows("bare").values()), "columns are empty")
    never = chart.wrapper("lentray-no-reference", 'case "$*" in *reference-next*) echo "no reference today"; exit 1 ;; esac')
    lost = chart.run("--out", "lost", *SIZE, *FEW, "--only", "exact", "--no-stock", "--lentray", never, "--budget", "1s")
    check(lost.returncode == 1 and "reference: there is none: no reference today" in lost.stderr, f"{lost.stderr}")
    check("no setting has a time and an error" in lost.stdout, f"{lost.stdout}")


def odd_stock(check, chart):
    """Programs that are no POV-Ray, or one that cannot render."""
    none = chart.run("--out", "odd-stock", *SIZE, *FEW, "--only", "quality", "--povray", "/bin/true")
    check(none.returncode == 0 and "stock POV-Ray is left out: '/bin/true' is no POV-Ray 3" in none.stderr, f"{none.stderr}")
    broken = chart.folder / "povray-broken"
    broken.write_text('#!/bin/sh\necho "POV-Ray 3.7.0 of no use"\ncase "$*" in --version) ;; *) exit 1 ;; esac\n')
    broken.chmod(0o755)
    lost = chart.run("--out", "odd-stock", *SIZE, *FEW, "--only", "quality", "--povray", broken)
    check(lost.returncode == 0 and "stock POV-Ray is left out: " in lost.stderr and "of no use" in lost.stderr, f"{lost.stderr}")
    sheet = ["Lenticular=On", "Lens_Pixels=6", *SIZE, *FEW, "--only", "lens_model"]
    views = chart.run("--out", "odd-sheet", *sheet, "--povray", broken)
    check("stock POV-Ray is left out: of the sheet: " in views.stderr, f"{views.stderr}")
    mesh = chart.run("--out", "mesh", *sheet, "Lens_Model=pinhole", "+A0.3")
    check("stock POV-Ray is left out: stock antialiases no mesh_camera" in mesh.stderr, f"{mesh.stderr}")


def references(check, chart):
    """One that converges at once, one that cannot get better, and one that takes too long."""
    flat = chart.folder / "flat.pov"
    flat.write_text("#version 3.7; global_settings { assumed_gamma 1 } camera { location 0 } background { rgb 0.5 }")
    options = ["--quick", "--repeats", "1", "--no-stock", "+W20", "+H15", "--only", "exact"]
    command = [chart.binaries / "lentray-chart", "flat.pov", "--out", "flat", *options]
    done = subprocess.run(command, cwd=chart.folder, capture_output=True, text=True, check=False, timeout=300)
    check(done.returncode == 0 and "reference: converged, it changes by 0/255" in done.stderr, f"{done.stderr}")
    plain = chart.rows("flat")["plain"]
    check(plain["rms"] == "0" and plain["psnr"] == "inf" and plain["told_apart"] == "yes", f"an error of 0: {plain}")
    poor = chart.wrapper("lentray-poor", 'case "$*" in --help=all) echo "  Width=n"; exit 0 ;; esac')
    ended = chart.run("--out", "poor", *options, "--lentray", poor)
    check("reference: NOT converged (more samples are not possible): it changes by " in ended.stderr, f"{ended.stderr}")
    steps = [line for line in ended.stderr.splitlines() if line.startswith("reference, ")]
    changes = [float(line.split("changes by ")[1].split("/")[0]) for line in steps]
    check(len(changes) == 4 and sorted(changes, reverse=True) == changes, f"steps change less and less: {steps}")
    busy = chart.wrapper("lentray-busy", 'case "$*" in *reference-next*) while :; do :; done ;; esac')
    slow = chart.run("--out", "busy", *options, "--reference-limit", "1s", "--lentray", busy)
    check(slow.returncode == 1 and "reference: there is none: it passed the limit of 1.0 s" in slow.stderr, f"{slow.stderr}")
    sleepy = chart.wrapper("lentray-sleepy", f'case "$*" in *--explain*) touch "{chart.folder}/asleep"; sleep 60 ;; esac')
    with subprocess.Popen(chart.command("--out", "asleep-out", *options, "--lentray", sleepy), cwd=chart.folder,
                          stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as child:
        until = time.time() + 60
        while not (chart.folder / "asleep").exists() and time.time() < until:
            time.sleep(0.01)
        child.send_signal(signal.SIGTERM)
        _, said = child.communicate(timeout=60)
    check(child.returncode == 3 and "stopped; the same command begins again" in said, f"a stop at once: {child.returncode}, {said}")


def bar(check, chart):
    """What a terminal shows."""
    ours, theirs = pty.openpty()
    with subprocess.Popen(chart.command("--out", "bar", *SIZE, *FEW, "--only", "exact", "--no-stock"), cwd=chart.folder,
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs) as child:
        os.close(theirs)
        shown = b""
        try:
            while part := os.read(ours, 4096):
                shown += part
        except OSError:  # the other end is closed
            pass
    os.close(ours)
    text = shown.decode(errors="replace")
    check(child.returncode == 0 and "#" in text and " s left: [round 1, " in text and "\r\x1b[K" in text, f"a bar: {text!r}")


def sheets(check, chart):
    done = chart.run("--out", "sheet", *SHEET, "--only", "lens_model")
    check(done.returncode == 0, f"a sheet: {done.returncode}, {done.stderr}")
    rows = chart.rows("sheet")
    check({"plain", "lens-paraxial", "lens-pinhole"} <= set(rows), f"lens models: {list(rows)}")
    plain = rows["plain"]
    check(plain["stock_cpu_s"] != "" and float(plain["from_stock_rms"]) < 0.5, f"a sheet beside stock: {plain}")
    check("stock renders a lens sheet view by view" in done.stderr and "exact" in done.stderr, f"{done.stderr}")
    check("reference of lens models: " in done.stderr, f"{done.stderr}")
    check(float(rows["lens-paraxial"]["rms"]) > float(rows["lens-pinhole"]["rms"]), "Snell's law is nearer to the truth")
    check("Lens models, against the truest one:" in done.stdout, f"{done.stdout}")
    check(all(row["seen"] == "" for row in rows.values()) and "what an eye sees of the sheet is left out: " in done.stderr
          and "infinite" in done.stderr, f"no eye is infinitely far: {done.stderr}")
    near = [word.replace("=inf", "=40cm") for word in SHEET]
    done = chart.run("--out", "near-sheet", *near, "--only", "lens_model", "--no-stock")
    check(done.returncode == 0, f"a sheet before an eye: {done.returncode}, {done.stderr}")
    for row in chart.rows("near-sheet").values():
        check(row["seen"] != "" and 0 <= float(row["seen"]) < 50, f"a sheet as an eye sees it: {row}")
        check((float(row["seen"]) == 0) <= (float(row["rms"]) < 1), f"what is not seen is small: {row}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    binaries = parser.parse_args().bin.resolve()
    if shutil.which("povray") is None:
        print("left out: povray is not installed")
        sys.exit(77)
    check = Checks()
    with tempfile.TemporaryDirectory() as place:
        chart = Chart(pathlib.Path(place) / "first", binaries)
        said = stop_and_go_on(check, chart)
        table_is_true(check, chart)
        choices_hold(check, chart, said)
        again(check, chart)
        other = Chart(pathlib.Path(place) / "second", binaries)
        lost_pictures(check, other)
        others_files(check, other)
        failing_settings(check, other)
        bare_machine(check, other)
        bar(check, other)
        odd_stock(check, other)
        references(check, other)
        sheets(check, other)
        bad_scenes(check, other)
    print(f"{check.passed} passed, {check.failed} failed")
    sys.exit(1 if check.failed else 0)


if __name__ == "__main__":
    main()
