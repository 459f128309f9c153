"""Scenes and disks that go wrong in a batch: each is a row with its reason, and all other scenes are rendered.

  tests/batch/bad_company.py [--bin build/release/bin]

As root also: a folder that another user cannot write, and a disk that fills up (a tmpfs).
"""
import os
import pathlib
import shutil
import subprocess

import batch_tools as tools

NAMES = ["with space.pov", "it's \"quoted\".pov", "Überblick.pov", "#1 & $HOME;.pov", "-dash.pov", "same.pov", "same.POV"]


def write_bad_scenes(folder):
    (folder / "loops.pov").write_text("#while (1) #end\n")
    (folder / "array.pov").write_text("#declare A = array[60000000];\n#declare A[59999999] = 1;\n" + tools.scene(1))
    (folder / "crash.pov").write_text(tools.scene(2))
    (folder / "missing.pov").write_text('#include "nowhere.inc"\n' + tools.scene(3))
    (folder / "broken.pov").write_text("sphere { 0, 1 pigmnt { rgb 1 } }\n")
    (folder / "part.pov").write_text("sphere { y, 1 pigment { rgb x } }\n")
    (folder / "whole.pov").write_text(tools.scene(4) + '#include "part.pov"\n')
    (folder / "markup.pov").write_text('#warning "<script>alert(1)</script> \\u001b[31m"\n' + tools.scene(5))


def crashing_lentray(folder, binaries):
    """As lentray, but that it falls over one scene."""
    program = folder / "lentray-crashes"
    program.write_text('#!/bin/sh\ncase "$*" in *+Icrash.pov*) kill -SEGV $$;; esac\n'
                       f'exec "{binaries}/lentray" "$@"\n')
    program.chmod(0o755)
    return program


def bad_scenes(check, folder, binaries):
    scenes, out = folder / "scenes", folder / "out"
    tools.write_scenes(scenes, 4)
    for name in NAMES:
        (scenes / name).write_text(tools.scene(6))
    write_bad_scenes(scenes)
    done = tools.run(binaries, scenes, "--out", out, "--time-limit", "5s", "--memory-limit", "150M", "+W80", "+H60",
                     "--lentray", crashing_lentray(folder, binaries))
    rows = tools.rows(out)
    check(done.returncode == 1, f"status {done.returncode}: {done.stderr[-300:]}")
    for name, words in (("loops", "--time-limit"), ("array", "Max_Memory"),  ("crash", "signal 11"),
                        ("missing", "nowhere.inc"), ("broken", "pigmnt")):
        row = rows.get(name, {})
        check(row.get("state") == "failed" and words in row.get("reason", ""), f"{name}: {row.get('state')}, {row.get('reason')}")
    check(rows["part"]["state"] == "skipped" and "whole.pov" in rows["part"]["reason"], f"part: {rows['part']}")
    good = [f"scene{i:02d}" for i in range(4)] + ["whole", "markup"]
    good += [row for row in rows if pathlib.Path(rows[row]["source"]).name in NAMES]
    check(len(good) == 6 + len(NAMES), f"rows of odd names: {good}")
    for name in good:
        check(rows[name]["state"] == "done" and (out / rows[name]["picture"]).is_file(), f"{name}: {rows[name].get('reason')}")
    check(len({rows[name]["picture"] for name in good}) == len(good), "two scenes have one picture")
    page = (out / "index.html").read_text(errors="strict")
    check("<script>alert" not in page, "a scene's text is markup on the page")
    check(not [p for p in scenes.iterdir() if p.suffix not in (".pov", ".POV")], "something was left among the scenes")
    again = tools.run(binaries, scenes, "--out", out, "--time-limit", "5s", "--memory-limit", "150M", "+W80", "+H60",
                      "--lentray", folder / "lentray-crashes")
    check(f"{len(good)} of {len(rows) - 1} pictures are there and up to date; 5 failed before" in again.stderr,
          f"again: {again.stderr[:200]}")


def memory_that_grows(check, folder, binaries):
    """Slowly, without a size that is told first: with time enough for a slow machine."""
    (folder / "grows.pov").write_text("#declare I = 0; #while (I < 1e9) sphere { I, 1 pigment { rgb I } finish { phong I } } #declare I = I + 1; #end\n")
    done = tools.run(binaries, folder / "grows.pov", "--out", folder / "grows-out", "--time-limit", "5m", "--memory-limit", "150M")
    row = tools.rows(folder / "grows-out")["grows"]
    check(done.returncode == 1 and row["state"] == "failed" and "memory" in row["reason"], f"grows: {row.get('reason')}")


def limits_of_lentray(check, folder, binaries):
    """Its options hold for each scene; frames that nobody can wait for are no rows; a page that is not there is not named."""
    scenes, out = folder / "limited", folder / "limited-out"
    tools.write_scenes(scenes, 1)
    for name, ini in (("wide", "Width=4000\nHeight=3000\nMax_Pixels=1T\n"), ("long", "Final_Frame=2000000000\n")):
        (scenes / f"{name}.pov").write_text(tools.scene(1))
        (scenes / f"{name}.ini").write_text(ini)
    (out / "index.html").mkdir(parents=True)
    done = tools.run(binaries, scenes, "--out", out, "--frames", "+W40", "+H30", "Max_Pixels=1M", "Max_Files=9", "Max_Written=50M")
    rows = tools.rows(out)
    check(rows["scene00"]["state"] == "done", f"within the limits: {rows['scene00']}")
    for name in ("wide", "long"):
        check(rows[name]["state"] == "failed" and "Max_Pixels" in rows[name]["reason"], f"{name}: {rows[name]}")
    check(done.returncode == 1 and "page could not be written" in done.stderr, f"no page: {done.returncode} {done.stderr}")
    check("index.html" not in done.stdout, f"a page that is not there is named: {done.stdout}")
    done = tools.run(binaries, scenes / "long.pov", "--out", folder / "long-out", "--frames", "+W40", "+H30")
    row = tools.rows(folder / "long-out")["long"]
    check("2000000000 frames" in row["reason"] and done.returncode == 1, f"endless frames: {row}")


def scenes_given_one_by_one(check, folder, binaries):
    """Two scenes of one name, from two folders."""
    for part in ("a", "b"):
        tools.write_scenes(folder / "two" / part, 1)
    done = tools.run(binaries, folder / "two/a/scene00.pov", folder / "two/b/scene00.pov", "--out", folder / "two/out", "+W40", "+H30")
    check(done.returncode == 0 and len(tools.pictures(folder / "two/out")) == 2, f"two of one name: {done.stdout} {done.stderr}")


def folder_of_another(check, folder, binaries):
    if os.getuid() != 0 or not shutil.which("setpriv"):
        print("left out: a folder of another user needs root and setpriv")
        return
    out = folder / "closed"
    out.mkdir(mode=0o755)
    folder.parent.chmod(0o755)
    scenes = folder / "scenes"
    tools.write_scenes(scenes, 1)
    programs = folder / "bin"
    shutil.copytree(binaries, programs, ignore=lambda _, names: [n for n in names if n.startswith("test_")])
    done = subprocess.run(["setpriv", "--reuid=65534", "--clear-groups", programs / "lentray-batch", scenes, "--out", out],
                          capture_output=True, text=True, check=False)
    check(done.returncode == 2 and "cannot write into the folder" in done.stderr, f"a closed folder: {done.returncode} {done.stderr}")


def disk_that_fills(check, folder, binaries):
    disk = folder / "disk"
    disk.mkdir()
    many = folder / "many"
    tools.write_scenes(many, 24)
    for scene in many.iterdir():  # large files in a short time
        scene.write_text(scene.read_text().replace("area_light x, y, 5, 5", ""))
    options = ["+W400", "+H400", "+FN16"]
    subprocess.run([binaries / "lentray", f"+I{many}/scene00.pov", f"+O{folder}/size.png", "-V", *options], check=True)
    # Eight pictures, and what a batch keeps for rows and page.
    size = 8 * (folder / "size.png").stat().st_size + (2 << 20)
    if os.getuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", disk], check=False).returncode != 0:
        print("left out: a disk that fills needs the right to mount one")
        return
    try:
        done = tools.run(binaries, many, "--out", disk / "out", *options, "--quiet")
        rows = tools.rows(disk / "out")
        failed = [row for row in rows.values() if row["state"] == "failed"]
        check(done.returncode == 1, f"a full disk: status {done.returncode}: {done.stderr[-300:]}")
        check(len(rows) == 24, f"a full disk: {len(rows)} rows of 24")
        check(0 < len(failed) < 24, f"a full disk: {len(failed)} of 24 failed")
        check(all("space" in row["reason"] for row in failed), f"reasons: {[row['reason'] for row in failed]}")
        for row in rows.values():
            whole = row["state"] == "failed" or (disk / "out" / row["picture"]).is_file()
            check(whole, f"{row['name']} is done and has no picture")
    finally:
        subprocess.run(["umount", disk], check=False)


if __name__ == "__main__":
    tools.run_parts(__doc__, (bad_scenes, memory_that_grows, limits_of_lentray, scenes_given_one_by_one, folder_of_another, disk_that_fills))
