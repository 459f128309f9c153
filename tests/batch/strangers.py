#!/usr/bin/env python3
"""INI files that came with strangers' scenes, against Restrict_IO=On.    strangers.py --bin BUILD/bin

Each attack is an INI file beside a scene, rendered by lentray-batch and by lentray --scene-ini. No file outside
changes, none outside is read, no command runs; a refusal tells the line of the INI file. What the rules permit is
rendered. The folder is not below /tmp, where Debian's povray.conf lets scenes write.
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
        for folder in ("strangers/sub", "victim/lib", "home/.povray/3.7", "work"):
            (self.root / folder).mkdir(parents=True)
        (self.root / "home/.povray/3.7/povray.conf").write_text("[File I/O Security]\nrestricted\n[Shellout Security]\nallowed\n")
        for name in ("rc", "a.inc", "more.ini", "lib/lens_sheets.ini", "a.pov"):
            (self.root / "victim" / name).write_text(SECRET)
        self.before = self.outside()

    def outside(self):
        found = {}
        for path in sorted([self.root / "victim", *(self.root / "victim").rglob("*"), *(self.root / "work").rglob("*")]):
            if "out" in path.relative_to(self.root).parts:
                continue
            found[str(path)] = path.read_text() if path.is_file() else ""
        for name in ("touched", ".bashrc", "povray.ini"):
            found[name] = [str(p) for p in self.root.rglob(name)]
        return found

    def put(self, ini, scene=SCENE):
        (self.root / "strangers/a.pov").write_text(scene)
        (self.root / "strangers/a.ini").write_text(ini.replace("ROOT", str(self.root)))

    def run(self, program, *words, cwd="work"):
        return super().run(program, *words, cwd=cwd)

    def batch(self, *words):
        status, said = self.run("lentray-batch", "../strangers", "--out", "out", "+W8", "+H6", "--quiet", *words)
        rows = [json.loads(line) for line in (self.root / "work/out/manifest.jsonl").read_text().splitlines()]
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
            "Input_File_Name=../victim/a.pov", "+I../victim/a.pov", "../victim/a.pov", "Output_File_Name=folder/",
            "Create_Ini=On\nDependencies_File=link", "Statistics_File=dangling"]


def links(world):
    strangers = world.root / "strangers"
    for name, target in (("link", "../victim/rc"), ("folder", "../victim"), ("link.inc", "../victim/a.inc"),
                         ("link.ini", "../victim/more.ini"), ("dangling", "../victim/made")):
        (strangers / name).symlink_to(target)
    os.link(world.root / "victim/rc", strangers / "hard")
    os.mkfifo(strangers / "pipe")
    (strangers / "more.ini").write_text("Debug_File=../victim/rc\n")


def attempt(place, binaries, ini, scene, by_lentray):
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        links(world)
        world.before = world.outside()
        world.put(ini, scene)
        if by_lentray:
            # The user's word may stand before or behind.
            for words in (["Restrict_IO=On", "--scene-ini", "a.ini"], ["--scene-ini=a.ini", "Restrict_IO=On"]):
                status, said = world.run("lentray", "+Ia.pov", "+W8", "+H6", "-V", *words, cwd="strangers")
                expect(status == 1, ini, words, "status", status, said)
                expect("a.ini" in said or "more.ini" in said or "a.pov:" in said, ini, words, "has no place:", said)
                expect("SECRET" not in said, ini, words, "tells what is outside:", said)
        else:
            row, said = world.batch("Restrict_IO=On")
            told = " ".join(row.get("messages", [])) + row.get("reason", "") + said
            expect(row["state"] == "failed", ini, "state", row["state"], told)
            expect("SECRET" not in told, ini, "tells what is outside:", told)
            expect("Restrict_IO" in told, ini, "does not tell why:", told)
        expect(world.outside() == world.before, ini, "lentray" if by_lentray else "batch", "changed", {
            k: v for k, v in world.outside().items() if world.before.get(k) != v})


def attacks(place, binaries):
    debugs = SCENE + '#debug "alias ls=evil\\n"\n#warning "x"\n'
    for ini in WRITES:
        for by_lentray in (False, True):
            attempt(place, binaries, ini, debugs, by_lentray)
    for ini in READS:
        scene = SCENE + ("" if "H" in ini.split("=")[0] else '#include "a.inc"\n#error "it was read"\n')
        for by_lentray in (False, True):
            attempt(place, binaries, ini, scene, by_lentray)
    for ini in INIS + COMMANDS:
        for by_lentray in (False, True):
            attempt(place, binaries, ini, SCENE, by_lentray)
    for ini in LENTRAYS:
        attempt(place, binaries, ini, SCENE, True)


def permitted(place, binaries):
    """Harmless INI files are as before, and what a scene may write is written."""
    for ini in ("Width=9", "Output_File_Name=a.png", "Input_File_Name=a.pov\nOutput_File_Name=/nowhere/a.png", "Library_Path=sub",
                "Include_Ini=sub/more.ini", "sub/more.ini", "Debug_File=debug.txt", "Restrict_IO=On", "Include_Header=sub/h.inc",
                "Restrict_IO=Off", "Statistics_File=../victim/s.json", "+GD"):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            (world.root / "strangers/sub/more.ini").write_text("Antialias=On\n")
            (world.root / "strangers/sub/h.inc").write_text("#declare H = 1;\n")
            world.put(ini, SCENE + '#debug "said\\n"\n')
            row, said = world.batch("Restrict_IO=On")
            expect(row["state"] == "done", ini, row, said)
            expect(world.outside() == world.before, ini, "something changed")
            expect(not (world.root / "strangers/debug.txt").exists(), ini, "the folders of scenes are never changed")
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("Debug_File=debug.txt", SCENE + '#debug "said\\n"\n')
        status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", "--scene-ini", "a.ini", cwd="strangers")
        expect(status == 0 and (world.root / "strangers/debug.txt").read_text() == "said\n", "a permitted file", status, said)
        # The user's own words are the user's.
        (world.root / "work/mine.ini").write_text("Debug_File=../victim/mine\n")
        status, said = world.run("lentray", "mine.ini", "Restrict_IO=On", "+I../strangers/a.pov", "+W8", "+H6", "-V")
        expect(status == 0 and (world.root / "victim/mine").read_text() == "said\n", "the user's own file", status, said)


def sticky(place, binaries):
    """No later word turns Restrict_IO off."""
    for words in (["Restrict_IO=On", "Restrict_IO=Off"], ["mine.ini"], ["Restrict_IO=On", "off.ini"],
                  ["Restrict_IO=On", "Include_Ini=off.ini"], ["on.ini", "restrict_io=no"]):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries)
            world.put("", SCENE + '#include "../victim/a.inc"\n')
            (world.root / "work/on.ini").write_text("Restrict_IO=On\n")
            (world.root / "work/off.ini").write_text("Restrict_IO=Off\n")
            (world.root / "work/mine.ini").write_text("Include_Ini=on.ini\nRestrict_IO=Off\n")
            status, said = world.run("lentray", *words, "+I../strangers/a.pov", "+W8", "+H6", "-V")
            expect(status == 1 and "is refused" in said and "it stays on" in said, words, status, said)


def links_of_pictures(place, binaries):
    """A link where a picture without a name goes."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries)
        world.put("")
        (world.root / "strangers/a.png").symlink_to("../victim/rc")
        status, said = world.run("lentray", "Restrict_IO=On", "+Ia.pov", "+W8", "+H6", "-V", cwd="strangers")
        expect(status == 1 and world.outside() == world.before, "a link under the picture's name", status, said)


def main():
    binaries = programs()
    with tempfile.TemporaryDirectory(dir=binaries.parent) as place:
        attacks(place, binaries)
        permitted(place, binaries)
        sticky(place, binaries)
        links_of_pictures(place, binaries)
    return verdict("strangers' INI files: all hold")


if __name__ == "__main__":
    raise SystemExit(main())
