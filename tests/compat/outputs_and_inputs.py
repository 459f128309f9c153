#!/usr/bin/env python3
"""No output of any program takes the place of an input of the same run.    outputs_and_inputs.py --bin BUILD/bin

Every kind of input, every kind of output, by its name, a longer path, a link and a hard link: an error, and nothing
is touched. Also two outputs of one run that are one file, and pipes that nobody reads.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from world import Folders, expect, programs, verdict  # noqa: E402

SCENE = """#debug "said\\n"
#include "a.inc"
camera{location -5*z look_at 0} light_source{<2,4,-8>,1}
sphere{0,1 pigment{image_map{png "map.png"}}} text{ttf "font.ttf" "a" 1,0}
"""
FONTS = ("/usr/share/povray-3.7/include/timrom.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")
FONT = next((font for font in FONTS if os.path.exists(font)), "")


class World(Folders):
    def __init__(self, root, binaries):
        super().__init__(root, binaries)
        self.put("a.pov", SCENE if FONT else SCENE.split("text{")[0])
        self.put("plain.pov", "camera{location -5*z look_at 0} light_source{<2,4,-8>,1} sphere{0,1}\n")
        self.put("a.inc", "#declare A = 1;\n")
        self.put("a.ini", "Antialias=Off\n")
        self.put("lens_sheets.ini", "[mine]\nLens_LPI=40\n")
        if FONT:
            (self.root / "font.ttf").write_bytes(pathlib.Path(FONT).read_bytes())
        (self.root / "home/.povray/3.7").mkdir(parents=True)
        self.put("home/.povray/3.7/povray.conf", "[File I/O Security]\nnone\n")
        for words in (["+Oother.png", "+W8"], ["+Omap.png", "+W8"], ["+Os.png", "Lenticular=On", "Lens_Pixels=10", "+W60"]):
            status, said = self.run("lentray", "+Iplain.pov", "+H10", "-V", *words)
            assert status == 0, said

    def put(self, name, text):
        (self.root / name).write_text(text)

    def contents(self):
        return {str(p): p.read_bytes() for p in self.root.rglob("*") if p.is_file()}

    def names_of(self, name):
        """The file by other names: a longer path, a whole path, a link, a link of a link, a hard link."""
        ends = pathlib.Path(name).suffix
        for other in ("link" + ends, "chain" + ends, "hard" + ends):
            (self.root / other).unlink(missing_ok=True)
        (self.root / ("link" + ends)).symlink_to(name)
        (self.root / ("chain" + ends)).symlink_to("link" + ends)
        os.link(self.root / name, self.root / ("hard" + ends))
        return [name, "./" + name, "home/../" + name, self.root / name, "link" + ends, "chain" + ends, "hard" + ends]

    def refused(self, program, *words, says="this run reads"):
        """A restricted run may say that a text file has a second name, too, a hard link."""
        before = self.contents()
        status, said = self.run(program, *words)
        after = self.contents()
        expect(status != 0, program, words, "status", status, said)
        expect(says in said or ("Restrict_IO=On" in words and "a hard link" in said), program, words, "says", said)
        expect(all(after.get(k) == v for k, v in before.items()), program, words, "changed",
               [k for k, v in before.items() if after.get(k) != v])


def texts_of_lentray(world):
    render = ["+W8", "+H6", "-V", "+Oq.png"]
    options = ["Statistics_File=", "Dependencies_File=", "Debug_File=", "All_File=", "Warning_File=", "Render_File=",
               "Statistic_File=", "Fatal_File=", "Create_Ini=", "+GD", "+GA", "+GI"]
    inputs = ["a.pov", "a.inc", "a.ini", "map.png", "home/.povray/3.7/povray.conf"] + ["font.ttf"] * bool(FONT)
    for i, option in enumerate(options):
        for k, name in enumerate(inputs):
            conf = ["Restrict_IO=On"] if name.endswith("conf") else []
            # Every name of the scene and of the include file; of the others one name each.
            for other in world.names_of(name) if k < 2 else [world.names_of(name)[(i + k) % 7]]:
                world.refused("lentray", "a.ini", "+Ia.pov", *render, *conf, f"{option}{other}")
    for option in ("--dump-rays", "--depth-view"):
        sheet = ["Lenticular=On", "Lens_Pixels=10"]
        for name in ("a.pov", "a.inc", "hard.pov", "link.inc"):
            world.names_of("a.pov"), world.names_of("a.inc")
            world.refused("lentray", "+Ia.pov", *render, *sheet, option, name)
    world.refused("lentray", "+Ia.pov", *render, "Append_File=On", "Debug_File=a.inc")
    world.refused("lentray", "+Iplain.pov", *render, "Include_Header=a.inc", "Debug_File=a.inc")
    world.refused("lentray", "+Iplain.pov", *render, "Lenticular=On", "Lens_Sheet=mine", "Lens_Pixels=8", "Debug_File=lens_sheets.ini")
    world.refused("lentray", "+Ia.pov", "-V", "--parse-only", "Debug_File=a.inc")


def pictures_of_lentray(world):
    for other in world.names_of("map.png"):
        world.refused("lentray", "+Ia.pov", "+W8", "+H6", "-V", f"+O{other}")
    world.put("frames.pov", SCENE.split("text{")[0].replace('"map.png"', 'concat("f", str(frame_number, 0, 0), ".png")'))
    (world.root / "f2.png").write_bytes((world.root / "map.png").read_bytes())
    world.refused("lentray", "+Iframes.pov", "+W8", "+H6", "-V", "+Of.png", "+KFI2", "+KFF2")
    # A file that the run itself made is its own: a frame may use the one before.
    world.put("chain.pov", SCENE.split("sphere{")[0] + '#if (frame_number > 1) sphere{0,1 pigment{image_map{png "g1.png"}}} #end')
    status, said = world.run("lentray", "+Ichain.pov", "+W8", "+H6", "-V", "+Og.png", "+KFI1", "+KFF2")
    expect(status == 0, "the frame before", status, said)
    # What keeps a picture that is cut off is no include file of the scene's.
    world.put("q.png.lentray-state", "#declare B = 1;\n")
    world.put("state.pov", '#include "q.png.lentray-state"\n' + SCENE)
    before = world.contents()
    world.run("lentray", "+Istate.pov", "+W8", "+H6", "-V", "+Oq.png")
    expect(world.contents()[str(world.root / "q.png.lentray-state")] == before[str(world.root / "q.png.lentray-state")], "journal")


def other_programs(world):
    for other in world.names_of("s.png"):
        world.refused("lentray-print", "sheet", "s.png", "--out", other)
        world.refused("lentray-views", "s.png", "--view", "0", "--out", other)
        world.refused("lentray-merge", "s.png", "--out", other)
    world.refused("lentray-views", "s.png", "--preview", "--out", "s.png", says="")
    for view in range(10):
        (world.root / f"v{view}.png").write_bytes((world.root / "s.png").read_bytes())
    os.rename(world.root / "s.png", world.root / "v3.png")
    world.refused("lentray-views", "v3.png", "--all", "--out", "v#.png")
    os.rename(world.root / "v3.png", world.root / "s.png")
    world.refused("lentray-diff", "other.png", "map.png", "--json", "map.png")
    world.refused("lentray-diff", "other.png", "map.png", "--json", "home/../other.png")
    (world.root / "x-heat.png").write_bytes((world.root / "map.png").read_bytes())
    world.refused("lentray-diff", "other.png", "x-heat.png", "--output", "x")
    for other in world.names_of("a.pov"):
        world.refused("lentray-batch", "a.pov", "--out", "out", "--quiet", "+W8", "+H6", "--compare", "--table", other)
    for program, words in (("lentray-diff", ["a.pov", "+W8", "+H6", "--json", "a.inc"]),
                           ("lentray-grouping", ["plain.pov", "--csv", "plain.pov"]),
                           ("lentray-grouping", ["plain.pov", "--html", "home/../plain.pov"])):
        if (world.bin / program).exists():
            world.refused(program, *words, says="")


def two_outputs(world):
    render = ["+Iplain.pov", "+W8", "+H6", "-V"]
    os.symlink("q.json", world.root / "j.json")
    for words in (["Statistics_File=q.json", "Dependencies_File=q.json"], ["Statistics_File=q.png", "+Oq.png"],
                  ["Statistics_File=q.json", "Dependencies_File=./q.json"], ["Debug_File=q.json", "Statistics_File=q.json"],
                  ["Statistics_File=q.json", "Dependencies_File=j.json"], ["Create_Ini=q.json", "Dependencies_File=q.json"]):
        status, said = world.run("lentray", *render, *words)
        expect(status != 0 and "the file of both" in said, words, status, said)
    # Streams may go to one file, and devices are nobody's.
    status, said = world.run("lentray", "+Ia.pov", "+W8", "+H6", "-V", "-F", "Debug_File=text", "Render_File=./text", "All_File=/dev/null",
                             "Statistics_File=/dev/null", "Dependencies_File=/dev/null")
    expect(status == 0 and "said" in (world.root / "text").read_text(), "shared", status, said)
    # What a file of an earlier run held is replaced, or kept with Append_File.
    world.put("text", "earlier\n")
    world.run("lentray", "+Ia.pov", "+W8", "+H6", "-V", "-F", "Debug_File=text")
    expect((world.root / "text").read_text() == "said\n", "replaced", (world.root / "text").read_text())
    world.run("lentray", "+Ia.pov", "+W8", "+H6", "-V", "-F", "Debug_File=text", "Append_File=On")
    expect((world.root / "text").read_text() == "said\nsaid\n", "appended", (world.root / "text").read_text())
    # A scene with an error, or one that never ends, still leaves what it said.
    world.put("error.pov", '#debug "told\\n"\n#error "no"\n')
    world.run("lentray", "+Ierror.pov", "-V", "-F", "Debug_File=text")
    expect((world.root / "text").read_text() == "told\n", "after an error", (world.root / "text").read_text())
    world.put("endless.pov", '#debug "begun\\n"\n#while (1) #declare A = 1; #end\n')
    world.run("lentray", "+Iendless.pov", "-V", "-F", "Debug_File=text", "Max_Time=1s")
    expect((world.root / "text").read_text() == "begun\n", "after Max_Time", (world.root / "text").read_text())


def pipes(world):
    os.mkfifo(world.root / "pipe")
    for words in (["+Opipe"], ["-F", "Debug_File=pipe"], ["-F", "Statistics_File=pipe"], ["-F", "Create_Ini=pipe"],
                  ["-F", "Dependencies_File=pipe"]):
        begun = time.monotonic()
        status, said = world.run("lentray", "+Iplain.pov", "+W8", "+H6", "-V", *words, seconds=30)
        expect(status == 1 and "nobody reads" in said or "pipe" in said, words, status, said)
        expect(time.monotonic() - begun < 15, words, "waits")
    with subprocess.Popen(["cat", world.root / "pipe"], stdout=subprocess.PIPE) as reader:
        status, said = world.run("lentray", "+Iplain.pov", "+W8", "+H6", "-V", "+Opipe")
        expect(status == 0 and reader.stdout.read().startswith(b"\x89PNG"), "a pipe with a reader", status, said)
    for device in ("/dev/ptmx", "/dev/tty"):
        world.put("device.pov", f'#fopen F "{device}" write\n#write (F, "x")\n' + SCENE)
        status, said = world.run("lentray", "+Idevice.pov", "-V", "-F")
        expect(status == 1 and "is a device" in said, device, status, said)


def words_with_equals(world):
    for name in ("a=b.pov", "x_y=2.pov", "t=1.pov"):
        world.put(name, "camera{location -5*z look_at 0} sphere{0,1}\n")
        status, said = world.run("lentray", name, "+W8", "+H6", "-V", "+Oe.png")
        expect(status == 0, name, status, said)
        small = ("+W8", "+H6")
        for words in (["lentray-batch", name, "--out", "out", "--quiet", *small], ["lentray-diff", name, "--no-pictures", *small],
                      ["lentray-grouping", name, "--orders", "rows", "--caches", "off", *small],
                      ["lentray-chart", name, "--out", "chart", "--quick", "--no-stock", "--only", "quality", "--repeats", "1", *small]):
            status, said = world.run(*words, seconds=60)
            expect(status == 0, words, status, said)
    # A file that is called like an option does not take its place.
    world.put("Quality=0", "no scene")
    status, said = world.run("lentray-batch", "a=b.pov", "Quality=0", "--out", "out", "--quiet")
    expect(status == 0 and "1 done" in said, "a file called like an option", status, said)
    status, said = world.run("lentray", "c=d.pov", "-V")
    expect(status == 1 and "there is no scene 'c=d.pov'" in said, status, said)
    status, said = world.run("lentray", "Widht=9", "+Iplain.pov", "-V")
    expect(status == 1 and "did you mean Width" in said, status, said)


def main():
    binaries = programs()
    for check in (texts_of_lentray, pictures_of_lentray, other_programs, two_outputs, pipes, words_with_equals):
        with tempfile.TemporaryDirectory() as root:
            check(World(root, binaries))
    return verdict("no output is an input")


if __name__ == "__main__":
    raise SystemExit(main())
