#!/usr/bin/env python3
"""The sandbox beneath Restrict_IO=On: a reader of fonts that was taken over gets nowhere.    sandbox.py --bin BUILD/bin

tests/compat/sandbox.c takes the place of FreeType, and so is past all rules of the program. What it can do without
Restrict_IO it cannot do with it; both are counted. Left out (77) where there is no compiler or no Landlock.
"""
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from world import Folders, expect, programs, verdict  # noqa: E402

SCENE = "camera{location -5*z look_at 0} sphere{0,1}\n"
OUTSIDE = ("/usr/bin/lentray-escape", "/tmp/lentray-escape", "/dev/shm/lentray-escape")
TEXT = 'text{ttf "timrom.ttf" "a" 1,0}\n'


class World(Folders):
    def __init__(self, root, binaries, library):
        super().__init__(root, binaries)
        for folder in ("work", "outside/empty", "home/.povray/3.7", "out"):
            (self.root / folder).mkdir(parents=True)
        (self.root / "home/.povray/3.7/povray.conf").write_text("[File I/O Security]\nrestricted\n[Shellout Security]\nallowed\n")
        for name in ("outside/text", "outside/font.ttf", "work/own"):
            (self.root / name).write_text("text")
        (self.root / "work/own.sh").write_text("#!/bin/sh\nexit 0\n")
        (self.root / "work/own.sh").chmod(0o755)
        (self.root / "work/link").symlink_to("../outside/text")
        (self.root / "work/dangling").symlink_to("../outside/made")
        (self.root / "work/a.pov").write_text(SCENE + TEXT)
        (self.root / "work/plain.pov").write_text(SCENE)
        self.library = library
        self.before = self.outside()

    def outside(self):
        return {str(p): (p.stat().st_mode, p.stat().st_mtime_ns, p.read_text() if p.is_file() else "")
                for p in [self.root / "outside", *(self.root / "outside").rglob("*")]}

    def attacked(self, *words, program="lentray", cwd="work"):
        terminal, end = pty.openpty()
        done = subprocess.run([self.bin / program, *words], cwd=self.root / cwd, stdin=end, capture_output=True, text=True, timeout=120,
                              start_new_session=True, env=dict(os.environ, HOME=str(self.root / "home"), TMPDIR=str(self.root / "work"), POVINI="", LD_PRELOAD=str(self.library),
                                       OUTSIDE=str(self.root / "outside")))
        os.close(terminal)
        os.close(end)
        for place in OUTSIDE:
            pathlib.Path(place).unlink(missing_ok=True)
        return done.stdout + done.stderr


def tried(said):
    return sum(int(number) for number in re.findall(r"TRIED (\d+)", said))


def attempts(place, binaries, library):
    with tempfile.TemporaryDirectory(dir=place) as root:
        said = World(root, binaries, library).attacked("+Ia.pov", "-F", "-V")
        done = said.count("ESCAPED")
        expect(done >= 30, "the attempts are not real:", done, said)
        print(f"without Restrict_IO: {done} of {tried(said)} attempts get out")
    ways = count = escapes = 0
    for words in (["+Ia.pov", "-F"], ["+Ia.pov", "-F", "--parse-only"], ["+Ia.pov", "+O../out/a.png"], ["+Ia.pov", "-F", "+WT1"],
                  ["+Ia.pov", "+O-"]):
        with tempfile.TemporaryDirectory(dir=place) as root:
            world = World(root, binaries, library)
            said = world.attacked("Restrict_IO=On", "-V", *words)
            expect("TAKEN OVER" in said and "ESCAPED" not in said and tried(said) >= 40, words, said)
            ways, count, escapes = ways + 1, count + tried(said), escapes + said.count("ESCAPED")
            expect(world.outside() == world.before, words, "changed")
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries, library)
        world.attacked("work", "--out", "pictures", "--quiet", program="lentray-batch", cwd=".")
        rows = (world.root / "pictures/manifest.jsonl").read_text()
        expect("TAKEN OVER" in rows and "ESCAPED" not in rows, "a batch", rows)
        expect(world.outside() == world.before, "a batch changed")
        ways, count, escapes = ways + 1, count + tried(rows), escapes + rows.count("ESCAPED")
    print(f"in the sandbox alone, {ways} ways to start it: {count} attempts, {escapes} escapes")


def outputs(place, binaries):
    """What the user names is written, wherever it is."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries, None)
        on = ("lentray", "Restrict_IO=On", "+Iplain.pov", "-V", "+W16", "+H12")
        for words, names in ((["+O../out/a.png", "Statistics_File=../outside/s.json", "Dependencies_File=../d.json", "Debug_File=../out/t"],
                              ("out/a.png", "outside/s.json", "d.json", "out/t")),
                             (["+O../out/b.exr", "+FE"], ("out/b.exr",)), (["Create_Ini=../out/c.ini"], ("out/c.ini", "work/plain.png")),
                             (["-F", "--dump-rays", "../out/rays"], ("out/rays",)), (["+O../out/"], ("out/plain.png",)),
                             (["+O/dev/null"], ()), (["+O-"], ()),
                             (["Lenticular=On", "Lens_Pixels=4", "View_Cameras=../out/v.json", "+O../out/l.png"], ("out/v.json", "out/l.png"))):
            status, said = world.run(*on, *words, cwd="work")
            expect(status == 0, words, status, said)
            for name in names:
                expect((world.root / name).exists(), words, name, "is not there", said)
        (world.root / "out/link.png").symlink_to("../outside/linked.png")
        (world.root / "outside/linked.png").write_text("old")
        status, said = world.run(*on, "+O../out/link.png", cwd="work")
        expect(status == 0 and (world.root / "outside/linked.png").read_bytes().startswith(b"\x89PNG"), "the user's own link", said)
        (world.root / "work/c.ini").write_text("Post_Scene_Command=touch ../out/touched\n")
        status, said = world.run(*on, "c.ini", cwd="work")
        expect(status == 0 and (world.root / "out/touched").exists() == ("commands of INI files" in said), "commands", status, said)


def libraries(place, binaries):
    """A stranger's folder may hold files that are called as libraries are: none is loaded."""
    names = re.findall(r"(\S+\.so\S*) =>", subprocess.run(["ldd", binaries / "lentray"], capture_output=True, text=True, check=True).stdout)
    expect(len(names) >= 8, "libraries", names)
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries, None)
        for name in [*names, "lentray_openimageio.so"]:
            (world.root / "work" / name).write_text("no library")
        for program in sorted(p.name for p in binaries.glob("lentray*") if p.suffix == ""):
            status, said = world.run(program, "--version", cwd="work")
            expect(status != 127, program, "loads libraries of the current folder:", said)
        status, said = world.run("lentray", "+Iplain.pov", "-V", "+W8", "+H6", "+Oa.tif", cwd="work")
        expect(status == 0, "a picture by OpenImageIO", status, said)


def cost(place, binaries):
    """Milliseconds of processor time that a start takes with and without, the medians."""
    with tempfile.TemporaryDirectory(dir=place) as root:
        world = World(root, binaries, None)
        taken = {"On": [], "Off": []}
        for mode in ["On", "Off"] * 40:
            child = subprocess.Popen([binaries / "lentray", f"Restrict_IO={mode}", "+Iplain.pov", "-V", "-F", "+W4", "+H4"],
                                     cwd=world.root / "work", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            usage = os.wait4(child.pid, 0)[2]
            taken[mode].append(usage.ru_utime + usage.ru_stime)
        print("a start:", ", ".join(f"{sorted(all)[20] * 1e3:.1f} ms Restrict_IO={mode}" for mode, all in taken.items()))


def main():
    binaries = programs()
    compiler = shutil.which("cc")
    if compiler is None:
        return 77
    with tempfile.TemporaryDirectory(dir=binaries.parent) as place:
        library = pathlib.Path(place) / "taken.so"
        subprocess.run([compiler, "-shared", "-fPIC", pathlib.Path(__file__).with_suffix(".c"), "-o", library], check=True)
        with tempfile.TemporaryDirectory(dir=place) as root:
            if "without a sandbox" in World(root, binaries, None).run("lentray", "Restrict_IO=On", "+Iplain.pov", "-F", cwd="work")[1]:
                return 77
        attempts(place, binaries, library)
        outputs(place, binaries)
        libraries(place, binaries)
        cost(place, binaries)
    return verdict("the sandbox holds")


if __name__ == "__main__":
    raise SystemExit(main())
