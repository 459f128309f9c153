"""Views= in a batch: one run of lentray for the views of a scene, a row of each, kills, crashes, what is missing.

  tests/batch/views.py [--bin build/release/bin]
"""
import os
import re
import signal
import subprocess
import time

import batch_tools as tools

COUNT = 6
SHEET = ["Lenticular=On", "Lens_Pixels=6", "+W120", "+H60", f"Views={COUNT}", "View_Size=60x45"]
OLD = tools.scene(1, "#declare Old = 0.5;\n").replace("#version 3.7;", "#version 3.7;\n#warning \"of the scene\"")
SLOW = tools.scene(2).replace("5, 5 }", "20, 20 }")
# What a lentray of the tests does instead, given the first and the last view that it is to make.
CRASHES_AT = """if [ $first -le %d ] && [ $last -ge %d ]; then
  [ $first -lt %d ] && "$lentray" "$@" +EF%d
  kill -SEGV $$
fi"""
HANGS_AT = CRASHES_AT.replace("kill -SEGV $$", "exec sleep 60")


class Program:
    """A lentray that writes down the views it is called for, and may do something before."""

    def __init__(self, folder, binaries, before=""):
        self.log = folder / "views.log"
        self.log.unlink(missing_ok=True)
        self.path = folder / "lentray-of-views"
        self.path.write_text(f"""#!/bin/sh
lentray={binaries}/lentray
for word; do
  case $word in +SF*) first=${{word#+SF}};; +EF*) last=${{word#+EF}};; esac
done
echo "$first-$last" >> {self.log}
{before}
exec "$lentray" "$@"
""")
        self.path.chmod(0o755)

    def calls(self):
        return self.log.read_text().split() if self.log.exists() else []


def one_scene(folder, text):
    folder.mkdir()
    (folder / "a.pov").write_text(text)
    return folder


def states(out):
    return {int(name.split("#")[1]): row["state"] for name, row in tools.rows(out).items()}


def by_hand(folder, binaries, scenes, words):
    folder.mkdir()
    subprocess.run([binaries / "lentray", "a.pov", *words, f"+O{folder}/a.png"], cwd=scenes, check=True, capture_output=True)
    return tools.pictures(folder)


def one_run(check, folder, binaries):
    scenes, out = one_scene(folder / "scenes", OLD), folder / "out"
    program = Program(folder, binaries)
    batch = [scenes, "--out", out, "--lentray", program.path, *SHEET]
    done = tools.run(binaries, *batch)
    made = tools.pictures(out)
    check(done.returncode == 0 and made == by_hand(folder / "hand", binaries, scenes, SHEET), f"{done.stderr}, {sorted(made)}")
    check(program.calls() == ["0-5"], f"runs for all views: {program.calls()}")
    rows = tools.rows(out)
    check(sorted(rows) == [f"a#{j}" for j in range(COUNT)], f"rows: {sorted(rows)}")
    for j, (name, row) in enumerate(sorted(rows.items())):
        check(row["frame"] == j and row["width"] == 60 and row["attempts"] == 1, f"{name}: {row}")
        check(row["rendering_s"] > 0 and row["memory"] > 1e6 and 0 < row["wall_s"] < 60, f"{name}: {row}")
        check(str(scenes / "a.pov") in row["files"], f"{name} was made of {row['files']}")
        check(row["warnings"] == 2 and any("of the scene" in line for line in row["messages"]), f"{name}: {row['messages']}")
        views = [line.split(",")[0] for line in row["messages"] if re.match(r"View \d", line)]
        check(views == [f"View {j} of {COUNT}"], f"{name} tells of {views}")
        alone = subprocess.run([binaries / "lentray", *row["command"][1:], f"+O{folder}/alone.png"], cwd=scenes, check=True,
                               capture_output=True)
        same = (folder / f"alone{j}.png").read_bytes() == (out / row["picture"]).read_bytes()
        check(same, f"the command of {name} makes another picture: {alone.stderr}")
    tools.run(binaries, *batch)
    check(program.calls() == ["0-5"], f"a batch that is done is done: {program.calls()}")
    for missing in (1, 2, 4):
        (out / f"a{missing}.png").unlink()
    tools.run(binaries, *batch)
    check(sorted(program.calls()[1:]) == ["1-2", "4-4"], f"of what is missing: {program.calls()}")
    check(tools.pictures(out) == made, "the pictures are not the same")
    (scenes / "a.pov").write_text(OLD + "\n")
    program.log.unlink()
    some = tools.run(binaries, *batch, "+SF2", "+EF4")
    check(some.returncode == 0 and program.calls() == ["2-4"], f"some views: {program.calls()}, {some.stderr}")


def made(out):
    """Names of rows of pictures that are made: a batch that is stopped in order writes rows of those that wait, too."""
    return sorted(name for name, state in states(out).items() if state != "waiting")


def kills(check, folder, binaries):
    """Rows come while the run goes on; after a kill what has none is made."""
    scenes, out = one_scene(folder / "scenes", SLOW), folder / "out"
    words = [*SHEET[:-1], "View_Size=240x180"]
    whole = by_hand(folder / "hand", binaries, scenes, words)
    program = Program(folder, binaries)
    command = [str(word) for word in
               (binaries / "lentray-batch", scenes, "--out", out, "--lentray", program.path, *words)]
    seen = []
    for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGKILL):
        batch = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wanted = len(seen) + 1
        until = time.monotonic() + 200
        while time.monotonic() < until and batch.poll() is None:
            seen = made(out) if (out / "manifest.jsonl").exists() else []
            if len(seen) >= wanted:
                break
            time.sleep(0.02)
        check(batch.poll() is None and wanted <= len(seen) < COUNT, f"rows while it runs: {seen}")
        time.sleep(0.3)
        seen = made(out)
        os.kill(batch.pid, number)
        batch.wait()
        after = made(out)
        check(set(seen) <= set(after), f"rows are lost: {seen}, {after}")
        seen = after
    last = tools.run(binaries, *command[1:])
    check(last.returncode == 0 and tools.pictures(out) == whole, f"after the kills: {last.stderr}, {sorted(tools.pictures(out))}")
    check(set(states(out).values()) == {"done"} and len(states(out)) == COUNT, f"{states(out)}")
    starts = [int(call.split("-")[0]) for call in program.calls()]
    check(len(starts) == 4 and starts == sorted(set(starts)) and starts[0] == 0, f"each goes on where the last one was: {starts}")
    left = [p.name for p in out.rglob("*") if p.name.endswith((".part", ".lentray-state"))]
    check(not left, f"left behind: {left}")


def failures(check, folder, binaries):
    """A view that fails, crashes or takes too long is alone in that; a scene that fails does so twice."""
    rest = {j: "done" for j in range(COUNT)}
    cases = [
        ("crash", CRASHES_AT % (2, 2, 2, 1), [], ["0-5", "3-5"], {2: "signal 11"}),
        ("hang", HANGS_AT % (3, 3, 3, 2), ["--time-limit=4"], ["0-5", "4-5"], {3: "longer than 4.0 s"}),
        ("slow-reading", "exec sleep 60", ["--time-limit=2"], ["0-5"], {j: "longer than 2.0 s" for j in range(COUNT)}),
        ("bad-scene", "set -- \"$@\" Declare=A=", [], ["0-5", "1-5"], {j: "Declare=A=" for j in range(COUNT)}),
        ("no-view", "[ $first -gt 0 ] || exit 0", [], ["0-5", "1-5"], {0: "ended before this view"})]
    for name, before, options, calls, failed in cases:
        where = folder / name
        where.mkdir()
        scenes, out = one_scene(where / "scenes", tools.scene(3)), where / "out"
        program = Program(where, binaries, before)
        start = time.monotonic()
        done = tools.run(binaries, scenes, "--out", out, "--lentray", program.path, *SHEET, *options)
        rows = tools.rows(out)
        check(done.returncode == 1 and program.calls() == calls, f"{name}: {program.calls()}, {done.stderr}")
        check(time.monotonic() - start < 40, f"{name}: {time.monotonic() - start:.0f} s")
        check(states(out) == {**rest, **{j: "failed" for j in failed}}, f"{name}: {states(out)}")
        for j, reason in failed.items():
            row = rows[f"a#{j}"]
            check(reason in row["reason"] and str(scenes / "a.pov") in row["files"], f"{name}: {row}")
        again = tools.run(binaries, scenes, "--out", out, "--lentray", program.path, *SHEET, *options)
        check(program.calls() == calls, f"{name}, tried again though nothing has changed: {program.calls()}, {again.stderr}")


def places_that_are_taken(check, folder, binaries):
    scenes, out = one_scene(folder / "scenes", tools.scene(3)), folder / "out"
    (out / "a2.png").mkdir(parents=True)
    program = Program(folder, binaries)
    tools.run(binaries, scenes, "--out", out, "--lentray", program.path, *SHEET)
    check(states(out) == {j: "failed" if j == 2 else "done" for j in range(COUNT)}, f"{states(out)}")
    check("a2.png" in tools.rows(out)["a#2"]["reason"], tools.rows(out)["a#2"]["reason"])
    (out / "a2.png").rmdir()
    program.log.unlink()
    again = tools.run(binaries, scenes, "--out", out, "--lentray", program.path, *SHEET, "--retry")
    check(again.returncode == 0 and program.calls() == ["2-2"], f"{program.calls()}, {again.stderr}")


def many_scenes(check, folder, binaries):
    """Side by side, and the slow one gone on with by all processors, with what it has."""
    scenes, out = folder / "scenes", folder / "out"
    tools.write_scenes(scenes, 5)
    program = Program(folder, binaries)
    done = tools.run(binaries, scenes, "--out", out, "--lentray", program.path, *SHEET, "--jobs=3")
    check(done.returncode == 0 and len(tools.pictures(out)) == 5 * COUNT, f"{done.stderr}")
    check(program.calls() == ["0-5"] * 5, f"{program.calls()}")


if __name__ == "__main__":
    tools.run_parts(__doc__, (one_run, kills, failures, places_that_are_taken, many_scenes))
