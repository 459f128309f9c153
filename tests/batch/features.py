"""What a batch does besides stills: frames, views, comparisons, exceptions of a scene, stops, what is out of date, what
will be wrong with sheets.

  tests/batch/features.py [--bin build/release/bin]
"""
import json
import os
import pathlib
import signal
import subprocess
import time

import batch_tools as tools

MOVING = tools.scene(1).replace("sphere { <", "sphere { clock*x + <")
SLOW = tools.scene(2).replace("5, 5 }", "60, 60 }")


def frames(check, folder, binaries):
    scenes = folder / "frames"
    scenes.mkdir()
    (scenes / "ball.pov").write_text(MOVING)
    (scenes / "ball.ini").write_text("Initial_Frame=1\nFinal_Frame=12\nFinal_Clock=2\nWidth=60\nHeight=45\n")
    done = tools.run(binaries, scenes, "--out", folder / "frames-out", "--frames", "--compare")
    by_hand = folder / "by-hand"
    by_hand.mkdir()
    subprocess.run([binaries / "lentray", "ball.ini", "+Iball.pov", f"+O{by_hand}/ball.png", "-V"], cwd=scenes, check=True,
                   capture_output=True)
    made = {name: sum_ for name, sum_ in tools.pictures(folder / "frames-out").items() if not name.startswith("compare/")}
    check(done.returncode == 0 and len(made) == 12, f"frames: {done.returncode}, {sorted(made)}, {done.stderr[-300:]}")
    check(made == tools.pictures(by_hand), "frames are not those of lentray's animation")
    grades = {row["name"]: row["verdict"]["grade"] for row in tools.rows(folder / "frames-out").values()}
    check(len(grades) == 12 and set(grades.values()) == {"exact"}, f"frames against stock: {grades}")
    still = tools.run(binaries, scenes, "--out", folder / "still-out")
    check(list(tools.pictures(folder / "still-out")) == ["ball.png"], f"a still: {still.stderr[-300:]}")


def sheets(check, folder, binaries):
    scenes = folder / "sheets"
    scenes.mkdir()
    (scenes / "a.pov").write_text(tools.scene(3))
    (scenes / "fisheye.pov").write_text(tools.scene(4).replace("camera {", "camera { fisheye angle 150"))
    (folder / "sheet.ini").write_text("Lenticular=On\nLens_Pixels=6\nView_Distance=inf\n")
    options = [scenes, "--out", folder / "sheets-out", folder / "sheet.ini", "+W120", "+H60"]
    done = tools.run(binaries, *options, "--views", "--compare")
    rows = tools.rows(folder / "sheets-out")
    check(done.returncode == 1, f"sheets: {done.returncode}")
    check(rows["fisheye"]["state"] == "failed" and "no lens sheet" in rows["fisheye"]["reason"], f"{rows['fisheye']}")
    row = rows["a"]
    check(row["lens_pixels"] == 6 and row["verdict"]["grade"] == "exact", f"sheet: {row}")
    check(row["verdict"]["view_grades"] == {"exact": 6} and row["verdict"]["lens_grades"] == {"exact": 20}, f"{row['verdict']}")
    for j in (0, 5):
        subprocess.run([binaries / "lentray", "a.pov", folder / "sheet.ini", "+W120", "+H60", f"View={j}", "-V", f"+O{folder}/view{j}.png"],
                       cwd=scenes, check=True, capture_output=True)
        same = subprocess.run([binaries / "lentray-diff", folder / f"view{j}.png", folder / "sheets-out" / row["views"][j],
                               "--no-pictures", "--grade", "exact"], capture_output=True, text=True, check=False)
        check(same.returncode == 0 and "equal" in same.stdout, f"view {j}: {same.stdout}")


def views(check, folder, binaries):
    """Views= of lentray: a row and a picture for each view, none of them twice."""
    scenes, by_hand = folder / "views", folder / "views-by-hand"
    by_hand.mkdir()
    scenes.mkdir()
    (scenes / "a.pov").write_text(MOVING)
    words = ["Lenticular=On", "Lens_Pixels=6", "+W120", "+H60", "Views=3", "View_Clock=0..1", "View_Size=40x30"]
    told = subprocess.run([binaries / "lentray", "a.pov", *words, f"+O{by_hand}/a.png"], cwd=scenes, check=True,
                          capture_output=True, text=True).stderr
    check("View 3 of 3 (number 2), clock 1" in told and "Frame" not in told, f"progress of views: {told}")
    program, log = tools.logged_lentray(folder, binaries)
    for options in ([], ["--frames"], ["--views", "--compare"]):
        out = folder / ("views-out" + "".join(options))
        log.unlink(missing_ok=True)
        done = tools.run(binaries, scenes, "--out", out, "--lentray", program, *words, *options)
        made = {name: sum_ for name, sum_ in tools.pictures(out).items() if not name.startswith("compare/")}
        check(done.returncode == 0 and made == tools.pictures(by_hand), f"views: {options}, {sorted(made)}, {done.stderr}")
        check(len(tools.calls(log)) == 3, f"views {options}: {len(tools.calls(log))} runs")
        rows = tools.rows(out)
        check({name: row["picture"] for name, row in rows.items()} == {f"a#{j}": f"a{j}.png" for j in range(3)}, f"{rows}")
        check([row["frame"] for _, row in sorted(rows.items())] == [0, 1, 2], f"{rows}")
        check(all("lens_pixels" not in row for row in rows.values()), "a view is no integral image")
        if "--compare" in options:
            check(all("integral image" in row["verdict"]["note"] for row in rows.values()), f"not compared: {rows}")
        again = tools.run(binaries, scenes, "--out", out, "--lentray", program, *words, *options)
        check(len(tools.calls(log)) == 3, f"views {options} again: {again.stderr}")


def out_of_date(check, folder, binaries):
    scenes, out = folder / "dates", folder / "dates-out"
    tools.write_scenes(scenes, 3)
    (scenes / "scene00.pov").write_text('#include "colour.inc"\n' + tools.scene(0))
    (scenes / "colour.inc").write_text("#declare C = rgb 1;\n")
    (scenes / "scene01.pov").write_text('#if (file_exists("later.inc")) #include "later.inc" #end\n' + tools.scene(1))
    program, log = tools.logged_lentray(folder, binaries)

    def calls(*options):
        log.unlink(missing_ok=True)
        tools.run(binaries, scenes, "--out", out, "+W40", "+H30", "--lentray", program, *options)
        return sorted(pathlib.Path(c).stem for c in tools.calls(log))

    everything = ["scene00", "scene01", "scene02"]
    check(calls() == everything and calls() == [], "a batch that is done is done")
    os.utime(scenes / "scene02.pov")
    check(calls() == [], "a file that was only touched")
    (scenes / "colour.inc").write_text("#declare C = rgb 0;\n")
    check(calls() == ["scene00"], "an include file that has changed")
    (scenes / "later.inc").write_text("#declare D = 1;\n")
    check(calls() == ["scene01"], "a file that was looked for in vain has come to be")
    (out / "scene02.png").unlink()
    check(calls() == ["scene02"], "a picture that is gone")
    (scenes / "scene02.ini").write_text("+Q3\n")
    check(calls() == ["scene02"], "an exception of a scene")
    check(calls("--quiet", "Shadow_Cache=off") == [], "options that decide nothing")
    check(calls("+A") == everything, "an option that decides the picture")
    program.write_text(program.read_text() + "# another version\n")
    check(calls("+A") == everything, "another program")
    (scenes / "scene02.pov").unlink()
    calls("+A")
    check("scene02" not in tools.rows(out), "a scene that is gone")


def stops(check, folder, binaries):
    """Ctrl-C: within a second, nothing lost, and the next run goes on within the picture."""
    scenes, out = folder / "stops", folder / "stops-out"
    scenes.mkdir()
    (scenes / "slow.pov").write_text(SLOW)
    journal = out / "slow.png.lentray-state"
    options = ["+W640", "+H480", "+A0.1", "-J"]
    command = [binaries / "lentray-batch", str(scenes), "--out", str(out), *options]
    for number, then in ((signal.SIGINT, []), (signal.SIGTERM, [signal.SIGTERM])):
        kept = journal.stat().st_size if journal.exists() else 0
        batch = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while batch.poll() is None and (not journal.exists() or journal.stat().st_size == kept):
            time.sleep(0.1)
        start = time.monotonic()
        batch.send_signal(number)
        for second in then:
            batch.send_signal(second)
        _, said = batch.communicate(timeout=60)
        check(batch.returncode == 3, f"status {batch.returncode} after a signal: {said}")
        check(time.monotonic() - start < 2.0, f"{time.monotonic() - start:.1f} s to stop")
        check("goes on from here" in said, said)
        check(journal.exists(), "the picture's journal is gone")
    left = subprocess.run(["pgrep", "-f", str(scenes)], capture_output=True, text=True, check=False).stdout
    check(left == "", f"still running: {left}")


def page_data(out):
    text = (out / "index.html").read_text()
    return json.loads(text.split('<script type="application/json" id="data">', 1)[1].split("</script>", 1)[0])


def one_that_never_ends(check, folder, binaries):
    """It holds up no other; once the batch is stopped, page and manifest say what is done and what is not."""
    scenes, out = folder / "never", folder / "never-out"
    tools.write_scenes(scenes, 9)
    (scenes / "a_never.pov").write_text("#while (1) #end\n" + tools.scene(1))
    command = [binaries / "lentray-batch", str(scenes), "--out", str(out), "--jobs", "1", "+W40", "+H30"]
    for number, others in ((signal.SIGINT, 0), (signal.SIGTERM, 1)):
        batch = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        start = time.monotonic()
        while batch.poll() is None and len(tools.pictures(out)) < 9 and time.monotonic() - start < 60:
            time.sleep(0.1)
        if others:  # the second time there is that scene alone
            time.sleep(1)
        batch.send_signal(number)
        said = batch.communicate(timeout=60)[1]
        states = {row["name"]: row["state"] for row in tools.rows(out).values()}
        check(batch.returncode == 3 and len(states) == 10, f"{batch.returncode}, {states}, {said}")
        check(states.pop("a_never") == "waiting" and set(states.values()) == {"done"}, f"manifest: {states}")
        summary = page_data(out)["summary"]
        told = {name: summary[name] for name in ("stage", "done", "waiting", "made", "expected")}
        check(told == {"stage": "stopped", "done": 9, "waiting": 1, "made": 9, "expected": 10}, f"page: {told}")
        check(f"{9 * others} of 10 pictures are there" in said or not others, said)
    (scenes / "a_never.pov").write_text(tools.scene(1))
    done = tools.run(binaries, *command[1:])
    check(done.returncode == 0 and page_data(out)["summary"]["stage"] == "finished", done.stderr)
    check({row["state"] for row in tools.rows(out).values()} == {"done"}, f"{tools.rows(out)}")


def kinds_of_warnings(check, folder, binaries):
    """Warnings that begin with a word of their own are told apart: in rows, on the page, on the terminal."""
    scenes, out = folder / "kinds", folder / "kinds-out"
    tools.write_scenes(scenes, 4)
    program = folder / "lentray-warns"
    program.write_text('#!/bin/sh\ncase "$*" in\n'
                       '*+Iscene01*) echo "warning: jumps: by 3.1 pixels a view; say Depth_Budget=1"; echo "warning: other";;\n'
                       '*+Iscene02*) echo "warning: jumps: by 9 pixels"; echo "warning: flat: nothing moves";;\n'
                       f'esac\nexec "{binaries}/lentray" "$@"\n')
    program.chmod(0o755)
    options = [scenes, "--out", out, "+W40", "+H30", "--lentray", program]
    for again in (False, True):
        done = tools.run(binaries, *options)
        check("2 of 4 sheets jump, 1 is flat" in done.stdout, f"{again}: {done.stdout}")
        check(again or "jumps, 2 warnings" in done.stderr, done.stderr)
        rows = tools.rows(out)
        check(rows["scene01"]["kinds"] == {"jumps": "by 3.1 pixels a view; say Depth_Budget=1"}, f"{rows['scene01']}")
        check("kinds" not in rows["scene00"], f"{rows['scene00']}")
        data = page_data(out)
        check(data["summary"]["kinds"] == {"jumps": 2, "flat": 1}, f"{data['summary']}")
        check([card.get("kinds", {}).get("flat") for card in data["cards"]] == [None, None, "nothing moves", None], f"{data['cards']}")
        check(data["cards"][1]["others"] == 1 and "others" not in data["cards"][2], f"{data['cards']}")


if __name__ == "__main__":
    tools.run_parts(__doc__, (frames, sheets, views, out_of_date, stops, one_that_never_ends, kinds_of_warnings))
