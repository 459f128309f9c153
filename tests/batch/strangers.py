#!/usr/bin/env python3
"""Strangers' scenes and their INI files, folders and links, against Restrict_IO=On.    strangers.py --bin BUILD/bin

Each attack is an INI file beside a scene, rendered by lentray-batch, which restricts unless it is told otherwise, and
by lentray --scene-ini. No file outside changes, none outside is read, no command runs. What is the user's to say is
left out, with its line, and the picture is made; what would be read is refused. What the rules permit is rendered. The
folder is not below /tmp, where Debian's povray.conf lets scenes write.
"""
import json
import os
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from world import Folders, expect, programs, verdict  # noqa: E402

SCENE = "camera{location -5*z look_at 0} light_source{<2,4,-8>,1} sphere{0,1}\n"
SECRET = "// SECRET\n"


class World(Folders):
    """Folders strangers (scene and ini), victim (outside), home (a povray.conf that permits nothing)."""

    def __init__(self, root, binaries):
        super().__init__(root, binaries)
        for folder in ("strangers/sub", "victim/lib", "home/.povray/3.7", "here"):
            (self.root / folder).mkdir(parents=True)
        (self.root / "home/.povray/3.7/povray.conf").write_text("[File I/O Security]\nrestricted\n[Shellout Security]\nallowed\n")
        for name in ("rc", "a.inc", "more.ini", "lib/lens_sheets.ini", "a.pov"):
            (self.root / "victim" / name).write_text(SECRET)
        self.before = self.outside()

    def outside(self):
        found = {}
        for path in sorted([self.root / "victim", *(self.root / "victim").rglob("*"), *(self.root / "here").rglob("*")]):
            if "out" in path.relative_to(self.root).parts:
                continue
            found[str(path)] = path.read_text() if path.is_file() else ""
        for name in ("touched", ".bashrc", "povray.ini"):
            found[name] = [str(p) for p in self.root.rglob(name)]
        return found

    def put(self, ini, scene=SCENE):
        (self.root / "strangers/a.pov").write_text(scene)
        (self.root / "strangers/a.ini").write_text(ini.replace("ROOT", str(self.root)))

    def run(self, program, *words, cwd="here"):
        return super().run(program, *words, cwd=cwd)

    def batch(self, *words):
        status, said = self.run("lentray-batch", "../strangers", "--out", "out", "+W8", "+H6", "--quiet", *words)
        rows = [json.loads(line) for line in (self.root / "here/out/manifest.jsonl").read_text().splitlines()]
        return rows[-1], said


# What the INI file says, what the scene says besides, and what the messages must hold.
WRITES = [f"{name}=../victim/rc" for name in (
    "Debug_File", "All_File", "Warning_File", "Render_File", "Fatal_File", "Statistic_File", "Create_Ini")] + [
    "+GD../victim/rc", "+GA../victim/rc", "+GW../victim/rc", "+GR../victim/rc", "+GF../victim/rc", "+GS../victim/rc",
    "-GD../victim/rc", "+GI../victim/rc", "Debug_File=ROOT/victim/rc", "Debug_File=sub/../../victim/rc", "debug_file = \"../victim/rc\"",
    "Debug_File=link", "Debug_File=folder/rc", "Debug_File=/dev/ptmx", "Debug_File=pipe", "Debug_File=.bashrc",
    "Debug_File=povray.ini", "Debug_File=hard", "Debug_File=dangling", "Append_File=On\nDebug_File=../victim/rc",
    "Restrict_IO=Off\nDebug_File=../victim/rc", "Debug_File=../victim/rc\nRestrict_IO=Off", "Debug_File=x\nDebug_File=../victim/rc",
    "more.ini", "Include_Ini=more.ini"]
READS = ["Library_Path=../victim", "+L../victim", "Library_Path=folder", "Restrict_IO=Off\n+LROOT/victim", "Library_Path=sub\n+L../victim",
         "Include_Header=../victim/a.inc", "+HI../victim/a.inc", "+HIlink.inc"]
INIS = ["Include_Ini=../victim/more.ini", "../victim/more.ini", "Include_Ini=link.ini", "Include_Ini=ROOT/victim/more.ini",
        "folder/more.ini"]
COMMANDS = [f"{name}_Command=touch ../victim/touched" for name in (
    "Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error")]
# Only of lentray: the batch decides them itself.
LENTRAYS = ["Output_File_Name=../victim/rc", "+O../victim/rc.png", "Statistics_File=../victim/rc", "Dependencies_File=../victim/rc",
            "Output_File_Name=folder/",
            "Create_Ini=On\nDependencies_File=link", "Statistics_File=dangling"]


def links(world):
    strangers = world.root / "strangers"
    for name, target in (("link", "../victim/rc"), ("folder", "../victim"), ("link.inc", "../victim/a.inc"),
                         ("link.ini", "../victim/more.ini"), ("dangling", "../victim/made")):
        (strangers / name).symlink_to(target)
    os.link(world.root / "victim/rc", strangers / "hard")
    os.mkfifo(strangers / "pipe")
    (strangers / "more.ini").write_text("Debug_File=../victim/rc\n")


def attempt(place, binaries, ini, scene, by_lentray, refused):
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        links(world)
        world.before = world.outside()
        world.put(ini, scene)
        if by_lentray:
            # The user's word may stand before or behind.
            for words in (["Restrict_IO=On", "--scene-ini", "a.ini"], ["--scene-ini=a.ini", "Restrict_IO=On"]):
                status, said = world.run("lentray", "+Ia.pov", "+W8", "+H6", "-V", *words, cwd="strangers")
                expect(status == (1 if refused else 0), ini, words, "status", status, said)
                expect("a.ini" in said or "more.ini" in said or "a.pov:" in said or "H" in ini.split("=")[0], ini, words, "has no place:", said)
                expect(refused or ": left out:" in said, ini, words, "is not told:", said)
                expect("SECRET" not in said, ini, words, "tells what is outside:", said)
        else:
            row, said = world.batch()
            told = " ".join(row.get("messages", [])) + row.get("reason", "") + said
            expect(row["state"] == ("failed" if refused else "done"), ini, "state", row["state"], told)
            expect("SECRET" not in told, ini, "tells what is outside:", told)
            expect(("Restrict_IO" if refused else ": left out:") in told, ini, "does not tell why:", told)
        expect(world.outside() == world.before, ini, "lentray" if by_lentray else "batch", "changed", {
            k: v for k, v in world.outside().items() if world.before.get(k) != v})


def attacks(place, binaries):
    debugs = SCENE + '#debug "alias ls=evil\\n"\n#warning "x"\n'
    for by_lentray in (False, True):
        for ini in WRITES + COMMANDS:
            attempt(place, binaries, ini, debugs, by_lentray, False)
        for ini in READS:
            scene = SCENE + ("" if "H" in ini.split("=")[0] else '#include "a.inc"\n#error "it was read"\n')
            attempt(place, binaries, ini, scene, by_lentray, True)
        for ini in INIS:
            attempt(place, binaries, ini, SCENE, by_lentray, True)
    for ini in LENTRAYS:
        attempt(place, binaries, ini, SCENE, True, False)


def permitted(place, binaries):
    """Harmless INI files are as before; what the batch says itself needs no warning."""
    for ini in ("Width=9", "Output_File_Name=a.png", "Input_File_Name=a.pov\nOutput_File_Name=/nowhere/a.png", "Library_Path=sub",
                "Input_File_Name=../victim/a.pov", "+I../victim/a.pov", "../victim/a.pov",
                "Include_Ini=sub/more.ini", "sub/more.ini", "Restrict_IO=On", "Include_Header=sub/h.inc",
                "Restrict_IO=Off", "Statistics_File=../victim/s.json", "Display=On\nVerbose=On"):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            (world.root / "strangers/sub/more.ini").write_text("Antialias=On\n")
            (world.root / "strangers/sub/h.inc").write_text("#declare H = 1;\n")
            world.put(ini, SCENE + '#debug "said\\n"\n')
            row, said = world.batch()
            told = " ".join(row.get("messages", [])) + said
            expect(row["state"] == "done" and ": left out:" not in told, ini, row, said)
            expect(world.outside() == world.before, ini, "something changed")
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        # The user's own words are the user's.
        world.put("", SCENE + '#debug "said\\n"\n')
        (world.root / "here/mine.ini").write_text("Debug_File=../victim/mine\n")
        status, said = world.run("lentray", "mine.ini", "Restrict_IO=On", "+I../strangers/a.pov", "+W8", "+H6", "-V")
        expect(status == 0 and (world.root / "victim/mine").read_text() == "said\n", "the user's own file", status, said)


def folders(place, binaries):
    """What a batch lets its scenes read: its inputs, library and permitted paths; all with Restrict_IO=Off."""
    outside = SCENE + '#include "../victim/plain.inc"\n'
    cases = [(outside, [], "failed"), (outside, ["off.ini"], "failed"), (outside, ["Restrict_IO=Off"], "done"),
             (outside, ["Permitted_Path=../victim"], "done"), (outside, ["+L../victim"], "done"), (outside, ["permits.ini"], "done"),
             (outside, ["Restrict_IO=Off", "Restrict_IO=On"], "failed"), (outside, ["Restrict_IO=Off", "on.ini"], "failed")]
    for scene, words, state in cases:
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            (world.root / "victim/plain.inc").write_text("#declare P = 1;\n")
            # What Debian's povray.conf permits is no concern of a batch's.
            (world.root / "home/.povray/3.7/povray.conf").write_text("[File I/O Security]\nread-only\n")
            for name, text in (("off", "Restrict_IO=Off"), ("on", "Restrict_IO=On"), ("permits", "Permitted_Path=../victim")):
                (world.root / f"here/{name}.ini").write_text(text + "\n")
            world.put("", scene)
            row, said = world.batch(*words)
            expect(row["state"] == state, words, row.get("reason"), said)
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("Include_Ini=../common.ini\n", SCENE + '#include "common.inc"\n#include "../common.inc"\n')
        for name in ("a.pov", "a.ini"):
            (world.root / "strangers" / name).rename(world.root / "strangers/sub" / name)
        (world.root / "strangers/common.inc").write_text("#declare C = 1;\n")
        (world.root / "strangers/common.ini").write_text("Antialias=On\n")
        (world.root / "strangers/sub/common.inc").write_text("#declare D = 1;\n")
        row, said = world.batch()
        expect(row["state"] == "done", "a file beside the scene's folder, of the same input", row, said)
        status, said = world.run("lentray-batch", "../strangers/sub/a.pov", "--out", "alone", "+W8", "+H6")
        expect(status == 1 and "Restrict_IO=On: scenes read" in said and "is refused" in said, "a scene named alone", status, said)


def links_of_folders(place, binaries):
    """Links that came with scenes: of scenes, of folders of libraries, of places of pictures."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("")
        (world.root / "victim/secret.pov").write_text(SCENE + '#error "SECRET"\n')
        (world.root / "strangers/b.pov").symlink_to("../victim/secret.pov")
        (world.root / "strangers/sub/c.pov").symlink_to("../a.pov")
        status, said = world.run("lentray-batch", "../strangers", "--out", "out", "+W8", "+H6", "--quiet")
        rows = [json.loads(line) for line in (world.root / "here/out/manifest.jsonl").read_text().splitlines()]
        expect(status == 0 and sorted(r["name"] for r in rows) == ["a", "sub/c"] and "SECRET" not in said, "links of scenes", said)
        expect("leads out of" in said, "a link that is left out", said)
        status, said = world.run("lentray", "Restrict_IO=On", "+Ib.pov", "-V", "-F", cwd="strangers")
        expect(status == 1 and "is refused" in said and "SECRET" not in said, "a scene that is a link", status, said)
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("", SCENE + '#include "a.inc"\n#error "it was read"\n')
        (world.root / "strangers/lib").symlink_to("../victim")
        status, said = world.run("lentray", "Restrict_IO=On", "+Llib", "+Ia.pov", "-V", "-F", cwd="strangers")
        expect(status == 1 and "is refused" in said, "a library path that is a link of the scene's folder", status, said)
        (world.root / "here/mine.ini").write_text("Library_Path=lib\n")
        row, said = world.batch("mine.ini")
        expect(row["state"] == "failed" and "is refused" in row["reason"] + " ".join(row["messages"]), "a batch's library", row)
    for name in ("a.png", "manifest.jsonl", "index.html", ".lentray-batch/lock", ".lentray-batch/runs/x"):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("")
            link = world.root / "strangers/out" / name
            link.parent.mkdir(parents=True)
            link.symlink_to(world.root / "victim/rc")
            status, said = world.run("lentray-batch", "../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet")
            expect(status == 2 and "holds a link" in said, name, status, said)
            expect(world.outside() == world.before, name, "changed")


def photons(place, binaries):
    """A batch leaves folders of scenes as they are, save_file or not."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("", SCENE.replace("sphere{0,1}", "sphere{0,1 pigment{rgbt 1} interior{ior 1.5} photons{target refraction on}}"
                                    "plane{y,-2 pigment{rgb 1}}") + 'global_settings{photons{count 500 save_file "a.ph"}}\n')
        for words in ([], ["Restrict_IO=Off"]):
            row, said = world.batch("--retry", *words)
            expect(row["state"] == "done" and "photons are not saved" in " ".join(row["messages"]), row, said)
            expect(not (world.root / "strangers/a.ph").exists(), "photons were saved", words)
        status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", cwd="strangers")
        expect(status == 0 and (world.root / "strangers/a.ph").exists(), "lentray saves photons", status, said)


def sticky(place, binaries):
    """No later word turns Restrict_IO off."""
    for words in (["Restrict_IO=On", "Restrict_IO=Off"], ["mine.ini"], ["Restrict_IO=On", "off.ini"],
                  ["Restrict_IO=On", "Include_Ini=off.ini"], ["on.ini", "restrict_io=no"]):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("", SCENE + '#include "../victim/a.inc"\n')
            (world.root / "here/on.ini").write_text("Restrict_IO=On\n")
            (world.root / "here/off.ini").write_text("Restrict_IO=Off\n")
            (world.root / "here/mine.ini").write_text("Include_Ini=on.ini\nRestrict_IO=Off\n")
            status, said = world.run("lentray", *words, "+I../strangers/a.pov", "+W8", "+H6", "-V")
            expect(status == 1 and "is refused" in said and "it stays on" in said, words, status, said)


def links_of_outputs(place, binaries):
    """Links of the current folder where outputs go: they may have come with the scene. A whole name is the user's."""
    cases = [([], "a.png"), (["+Ob.png"], "b.png"), (["+O./"], "a.png"), (["+Osub/b.png"], "sub/b.png"), (["+OROOT/strangers/"], "a.png"),
             (["Debug_File=true"], "debug.out"), (["Debug_File=w.txt"], "w.txt"), (["All_File=w.txt"], "w.txt"), (["Statistics_File=s.json"], "s.json"),
             (["Dependencies_File=s.json"], "s.json"), (["Create_Ini=On"], "a.ini"), (["+RFO", "+RFx"], "x"),
             (["-F", "--dump-rays", "rays"], "rays"), (["+KFF2", "+Ob.png"], "b2.png"), (["+Oin/b.png"], "in")]
    for words, name in cases:
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("", SCENE + '#debug "alias ls=evil\\n"\n')
            (world.root / "strangers/a.ini").unlink()
            folder = name == "in"
            (world.root / "strangers" / name).symlink_to(world.root / ("victim" if folder else "victim/rc"))
            words = [word.replace("ROOT", str(world.root)) for word in words]
            status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", *words, cwd="strangers")
            expect(status == 1 and "may have come with the scene" in said, words, name, status, said)
            expect(world.outside() == world.before, words, name, "changed")
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("")
        (world.root / "strangers/in").symlink_to("../here")
        for name in (f"{world.root}/strangers/in/a.png", "../here/b.png", "sub/c.png"):
            status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", "+O" + name, cwd="strangers")
            expect(status == 0 and (world.root / "strangers" / name).exists(), "the user's own name", name, status, said)


def hard_links(place, binaries):
    """Files that are written in place have no second name outside, and links to nothing make no file there."""
    for words, name, link in ((["Debug_File=w.txt"], "w.txt", True), (["All_File=w.txt"], "w.txt", True), (["Append_File=On", "Debug_File=w.txt"], "w.txt", True),
                              (["Debug_File=w.txt"], "w.txt", False), (["All_File=w.txt"], "w.txt", False), (["Statistics_File=t"], "t", False)):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("", SCENE + '#debug "alias ls=evil\\n"\n')
            at = world.root / "strangers" / name
            os.link(world.root / "victim/rc", at) if link else at.symlink_to(world.root / "victim/made")
            status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", *words, cwd="strangers")
            expect(status == 1 and "may have come with the scene" in said, words, link, status, said)
            expect(world.outside() == world.before, words, link, "changed")
    for name in ("manifest.jsonl", ".lentray-batch/reserve", ".lentray-batch/runs/x"):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("")
            link = world.root / "strangers/out" / name
            link.parent.mkdir(parents=True)
            os.link(world.root / "victim/rc", link)
            status, said = world.run("lentray-batch", "../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet")
            expect(status == 2 and "holds a hard link" in said, name, status, said)
            expect(world.outside() == world.before, name, "changed")
    # A picture of an earlier run may have one: it is replaced, and its other name keeps what it had.
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("")
        (world.root / "strangers/out").mkdir()
        os.link(world.root / "victim/rc", world.root / "strangers/out/a.png")
        status, said = world.run("lentray-batch", "../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet")
        expect(status == 0 and world.outside() == world.before, "a picture with a second name", status, said)


def other_programs(place, binaries):
    """Names that lentray-diff and lentray-chart choose themselves."""
    chart = ("lentray-chart", ["a.pov", "--out", "out", "--quick", "--no-stock", "--only", "quality", "--repeats", "1"])
    diff, stock_alone = ("lentray-diff", ["a.pov"]), ("lentray-diff", ["a.pov", "--stock-alone"])
    for (program, words), name in ((diff, "a-diff-ours.png"), (stock_alone, "a-diff-stock.png"), (chart, "out/chart.csv"),
                                   (chart, "out/pictures/own.png"), (chart, "out/.lentray-chart/log")):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("")
            link = world.root / "strangers" / name
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(world.root / "victim/rc")
            if not (world.bin / program).exists():
                continue
            status, said = world.run(program, *words, "+W8", "+H6", "Restrict_IO=On", cwd="strangers")
            expect(status != 0 and "may have come with the scene" in said, program, name, status, said)
            expect(world.outside() == world.before, program, name, "changed")


def rows_of_strangers(place, binaries):
    """A manifest that came with the scenes gives no picture a place elsewhere."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("")
        out = world.root / "strangers/out"
        out.mkdir()
        (out / "manifest.jsonl").write_text("".join(json.dumps(
            {"name": name, "source": str(world.root / "strangers/a.pov"), "state": "done", "picture": "../../victim/rc", "files": {}}) + "\n"
            for name in ("../../victim/x", str(world.root / "victim/x"))))
        status, said = world.run("lentray-batch", "../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet")
        expect(status == 0 and (out / "a.png").exists() and world.outside() == world.before, "rows of strangers", status, said)


SBATCH = """#!/usr/bin/env python3
# Runs the tasks at once.
import os, subprocess, sys
tasks, log = ([w.split("=")[1] for w in sys.argv if w.startswith(option)][0] for option in ("--array=", "--output="))
for task in tasks.split(","):
    first, _, last = task.partition("-")
    for i in range(int(first), int(last or first) + 1):
        with open(log.replace("%a", str(i)), "w") as out:
            subprocess.run(["sh", sys.argv[-1]], env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(i)), stdout=out, stderr=out)
print(7)
"""


def tasks_of_strangers(place, binaries):
    """A run on a cluster that came with the scenes: neither its script nor its scenes are obeyed."""
    words = ["../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet", "--slurm"]
    path = os.environ["PATH"]
    for source in ("strangers/a.pov", "victim/secret.pov"):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("")
            (world.root / "victim/secret.pov").write_text(SCENE + '#error "SECRET"\n')
            world.before = world.outside()
            slurm = world.root / "slurm"
            slurm.mkdir()
            for name, text in (("sinfo", "#!/bin/sh\necho 0/2/0/2\n"), ("squeue", "#!/bin/sh\n"), ("sbatch", SBATCH)):
                (slurm / name).write_text(text)
                (slurm / name).chmod(0o755)
            run = world.root / "strangers/out/.lentray-batch/slurm/run"
            for folder in ("results", "scratch", "logs"):
                (run / folder).mkdir(parents=True)
            (run.parent / "current").write_text("run 7")
            (run / "command.json").write_text(json.dumps({"words": words, "folder": str(world.root / "here")}))
            (run / "tasks.jsonl").write_text(json.dumps([{"name": "a", "band": 0, "bands": 1, "first_row": 1, "last_row": 0,
                "seconds": 1.0, "source": str(world.root / source), "scene": "a", "ini": ""}]) + "\n")
            (run / "task.sh").write_text(f"touch {world.root}/victim/touched\n")
            os.environ["PATH"] = f"{slurm}:{path}"
            status, said = world.run("lentray-batch", *words)
            os.environ["PATH"] = path
            told = said + "".join(log.read_text() for log in run.glob("logs/*"))
            expect(world.outside() == world.before, source, "changed", told)
            expect("SECRET" not in told, source, told)
            expect((status == 0) == source.startswith("strangers"), source, "status", status, told)
            expect(status == 0 or "which is no scene of this batch" in told, source, told)


def main():
    binaries = programs()
    with tempfile.TemporaryDirectory(dir=binaries.parent) as place:
        attacks(place, binaries)
        permitted(place, binaries)
        folders(place, binaries)
        sticky(place, binaries)
        links_of_folders(place, binaries)
        links_of_outputs(place, binaries)
        hard_links(place, binaries)
        other_programs(place, binaries)
        rows_of_strangers(place, binaries)
        tasks_of_strangers(place, binaries)
        photons(place, binaries)
    return verdict("strangers' scenes: all hold")


if __name__ == "__main__":
    raise SystemExit(main())
