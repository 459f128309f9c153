"""What a picture depended on: changes that are easily missed are seen, by a batch and by +C; what is no picture is none.

  tests/batch/depends.py [--bin build/release/bin]
"""
import os
import subprocess
import time

import batch_tools as tools

HEAD = "#version 3.7;\n"
RADIOSITY = """global_settings { assumed_gamma 1 radiosity { count 60 error_bound 0.4 recursion_limit 1 } }
camera { location <0, 1, -6> look_at 0 }
light_source { <-9, 12, -9> 1 }
"""
SLOW = """global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
light_source { <-9, 12, -9> 1 area_light 4*x, 4*z, 60, 60 }
plane { z, 0 pigment { rgb 1 } }
#for (I, 0, 3)
  box { <-2, 1.3 - I*0.75, -1>, <2, 1.5 - I*0.75, -0.9> pigment { rgb Shade } finish { ambient 1 diffuse 0 } no_shadow }
#end
"""


def lentray(binaries, folder, *words):
    return subprocess.run([binaries / "lentray", "-D", "-V", "-GA", *words], cwd=folder, capture_output=True, text=True,
                          errors="replace", check=False, timeout=300)


def batch(binaries, folder, *words):
    return tools.run(binaries, "in", "--out", "out", "+W160", "+H120", *words, cwd=folder)


def arrives_with_an_old_time(check, folder, binaries):
    """As rsync -a leaves it, while the old one is rendered; and other contents of one size and time."""
    (folder / "in").mkdir()
    old = HEAD + SLOW.replace("Shade", "0.3").replace("60, 60", "20, 20")
    scene = folder / "in/a.pov"
    scene.write_text(old)
    (folder / "new").write_text(old.replace("rgb 1 }", "rgb y }"))
    an_hour_ago = time.time() - 3600
    os.utime(folder / "new", (an_hour_ago, an_hour_ago))
    program, log = tools.logged_lentray(folder, binaries)
    command = ["--lentray", program]
    running = subprocess.Popen([binaries / "lentray-batch", "in", "--out", "out", "+W160", "+H120", *command], cwd=folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while running.poll() is None and not list(folder.glob("out/.lentray-batch/**/*read*")):
        time.sleep(0.01)
    (folder / "new").rename(scene)
    running.wait()
    first = len(tools.calls(log))
    batch(binaries, folder, *command)
    check(len(tools.calls(log)) == first + 1, "a newer scene with an old time came while the old one was rendered")
    batch(binaries, folder, *command)
    check(len(tools.calls(log)) == first + 1, "nothing changed")
    os.utime(scene, (1, 1))
    batch(binaries, folder, *command)
    other = scene.read_text().replace("0.3", "0.7")
    scene.unlink()
    scene.write_text(other)
    os.utime(scene, (1, 1))
    batch(binaries, folder, *command)
    check(len(tools.calls(log)) == first + 2, "other contents of the same size and time")


def is_no_picture(check, folder, binaries):
    tools.write_scenes(folder / "in", 2)
    picture = folder / "out/scene00.png"
    batch(binaries, folder)
    good = picture.read_bytes()

    def becomes(what):
        picture.unlink()
        if what is None:
            picture.mkdir()
        else:
            picture.write_bytes(what)
        done = batch(binaries, folder)
        row = tools.rows(folder / "out")["scene00"]
        if what is None:
            check(done.returncode == 1 and row["state"] == "failed", f"a folder: {done.returncode}, {row}")
        else:
            check(done.returncode == 0 and picture.read_bytes() == good, f"{len(what)} bytes: {done.stderr}")

    for what in (b"", good[:300], bytes(len(good)), (folder / "out/scene01.png").read_bytes(), None):
        becomes(what)
    picture.rmdir()
    batch(binaries, folder, "--retry")
    (folder / "in/scene01.pov").write_text("#error \"x\"\n" + tools.scene(1))
    batch(binaries, folder)
    done = batch(binaries, folder)
    check("1 of 2 pictures are there and up to date; 1 failed before" in done.stderr, done.stderr)


def scenes_of_one_text(check, folder, binaries):
    """What they show follows from their names, or from what lies beside them: each has its own radiosity."""
    text = HEAD + RADIOSITY + """#if (QUESTION) #declare C = <1, 0.05, 0.05>; #else #declare C = <0.05, 0.05, 1>; #end
plane { z, 2 pigment { rgb C } } plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgb 1 } }
"""
    for question, names in (('!strcmp(input_file_name, "red.pov")', ("red", "tea")), ('file_exists("red.txt")', ("1/s", "2/s"))):
        place = folder / names[0].replace("/", "")
        for name in names:
            scene = place / "in" / f"{name}.pov"
            scene.parent.mkdir(parents=True, exist_ok=True)
            scene.write_text(text.replace("QUESTION", question))
        if "/" in names[0]:
            (place / "in/1/red.txt").touch()
        batch(binaries, place, "--jobs", "1")
        for name in names:
            scene = place / "in" / f"{name}.pov"
            lentray(binaries, scene.parent, scene.name, "+W160", "+H120", f"+O{folder}/own.png")
            check((place / f"out/{name}.png").read_bytes() == (folder / "own.png").read_bytes(), f"{question}: {name}")


def kept_radiosity(check, folder, binaries):
    text = HEAD + RADIOSITY + "#declare V = ANSWER;\nsphere { 0, 1 pigment { rgb <V, 1 - V, 0.5> } } plane { y, -1 pigment { rgb 1 } }\n"
    cases = (("file_exists(\"snow.inc\")", "s.pov", lambda place: (place / "snow.inc").touch()),
             ("strlen(input_file_name)/20", "./s.pov", lambda _: None),
             ("mod(now*86400, 7)/7", "s.pov", lambda _: time.sleep(1.1)))
    for i, (answer, scene, change) in enumerate(cases):
        place = folder / str(i)
        (place / "r").mkdir(parents=True)
        (place / "s.pov").write_text(text.replace("ANSWER", answer))
        words = ["+W64", "+H48", "+RFI", "+RFO", "+RFr/"]
        lentray(binaries, place, "s.pov", *words, "+Oa.png")
        lentray(binaries, place, "s.pov", *words, "+Oagain.png")
        kept = len(list((place / "r").iterdir()))
        change(place)
        lentray(binaries, place, scene, *words, "+Ob.png")
        if not answer.startswith("mod(now"):
            check(kept == 1, f"{answer}: the same question is answered by the same pass: {kept}")
            lentray(binaries, place, scene, "+W64", "+H48", "+Oc.png")
            check((place / "b.png").read_bytes() == (place / "c.png").read_bytes(), f"{answer}: of another pass")
        else:
            check(kept == 2 and len(list((place / "r").iterdir())) == 3, f"{answer}: a pass served another run")


def begin(binaries, folder, *words):
    """A run that is stopped once its journal holds something."""
    run = subprocess.Popen([binaries / "lentray", *words], cwd=folder, stderr=subprocess.DEVNULL)
    journals = lambda: [path for path in folder.glob("*.lentray-state") if path.stat().st_size > 4000]
    while run.poll() is None and not journals():
        time.sleep(0.05)
    time.sleep(0.3)
    run.terminate()
    return run.wait()


def a_picture_of_one_moment(check, folder, binaries):
    (folder / "s.pov").write_text(HEAD + "#declare R = seed(now*86400);\n#declare Shade = rand(R);\n" + SLOW)
    words = ["s.pov", "+W320", "+H256", "+WT1", "Shadow_Cache=off", "Light_Buffer=off", "-GA", "+FP"]
    check(begin(binaries, folder, *words) == 2, "it was stopped")
    time.sleep(1.1)
    done = lentray(binaries, folder, *words, "+C")
    data = (folder / "s.ppm").read_bytes()[-320 * 256 * 3:]
    shades = {data[(row * 320 + column) * 3] for row in (10, 74, 138, 202) for column in range(320)}
    check(done.returncode == 0 and len(shades) == 1, f"{done.returncode} {done.stderr}: shades of one bar {shades}")


def answers_that_change(check, folder, binaries):
    for question, change, scene, named in (
            ("file_exists(\"bars.txt\")", lambda place: (place / "bars.txt").touch(), "s.pov", "bars.txt has come to be"),
            ("file_exists(\"there.txt\")", lambda place: (place / "there.txt").unlink(), "s.pov", "there.txt is gone"),
            ("!strcmp(substr(input_file_name, 1, 1), \".\")", lambda _: None, "./s.pov", "input_file_name was 's.pov'")):
        place = folder / str(len(list(folder.iterdir())))
        place.mkdir()
        (place / "there.txt").touch()
        (place / "s.pov").write_text(HEAD + f"#declare Shade = 0.2 + 0.5*{question};\n" + SLOW)
        words = ["+W320", "+H256", "+WT1", "Shadow_Cache=off", "Light_Buffer=off", "+Oa.png"]
        check(begin(binaries, place, "s.pov", *words) == 2, f"{question}: it was stopped")
        change(place)
        done = lentray(binaries, place, scene, *words, "+C")
        check(done.returncode == 1 and named in done.stderr, f"{question}: {done.returncode} {done.stderr}")
        check((place / "a.png.lentray-state").exists(), f"{question}: the journal stays")


def says_too_much(check, folder, binaries):
    (folder / "in").mkdir()
    (folder / "in/a.pov").write_text(HEAD + "#while (1) #debug \"" + 20 * "a" + "\\n\" #end\n")
    tools.write_scenes(folder / "in", 1)
    done = batch(binaries, folder)
    rows = tools.rows(folder / "out")
    check(done.returncode == 1 and "25 MB of messages" in rows["a"]["reason"], f"{rows['a']}")
    check(rows["scene00"]["state"] == "done", "the other scene")
    size = sum(path.stat().st_size for path in (folder / "out").rglob("*") if path.is_file())
    check(size < 60e6, f"{size} bytes are left")


def names_with_lines(check, folder, binaries):
    """A stranger's file name makes no options of the INI file of +GI."""
    (folder / "theirs").mkdir()
    (folder / "important.txt").write_text("a thesis\n")
    name = 'theirs/p.pov"\nAll_File=important.txt\nRestrict_IO=Off\nLibrary_Path="x.pov'
    (folder / name).write_text(HEAD + tools.scene(1))
    done = lentray(binaries, folder, "Restrict_IO=On", "+I" + name, "+GIrerun.ini", "+W20", "+H20", "+Oa.png")
    check(done.returncode == 1 and "Create_Ini: the value of Input_File_Name" in done.stderr, f"{done.returncode} {done.stderr}")
    check(not (folder / "rerun.ini").exists() and not (folder / "a.png").exists(), "refused before rendering")
    done = lentray(binaries, folder, "Restrict_IO=On", "+I" + name, "+W20", "+H20", "+Oa.png")
    check(done.returncode == 0, f"without an INI file it is rendered: {done.stderr}")


def folders_of_others(check, folder, binaries):
    tools.write_scenes(folder / "in", 1)
    for name in ("index.html", "manifest.jsonl"):
        out = folder / "out"
        out.mkdir()
        (out / name).write_text("<p>mine</p>\n")
        done = batch(binaries, folder)
        check(done.returncode == 2 and f"out/{name}' is not of lentray-batch" in done.stderr, f"{done.returncode} {done.stderr}")
        check([path.name for path in out.iterdir()] == [name] and (out / name).read_text() == "<p>mine</p>\n", "it stays")
        (out / name).unlink()
        out.rmdir()


if __name__ == "__main__":
    tools.run_parts(__doc__, (arrives_with_an_old_time, is_no_picture, scenes_of_one_text, kept_radiosity,
                              a_picture_of_one_moment, answers_that_change, says_too_much, names_with_lines, folders_of_others))
