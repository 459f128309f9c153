"""Disks that are nearly full: what finds room without a journal is finished with one, alone and in batches.

  tests/batch/full_disks.py [--all] [--sizes 3] [--bin build/release/bin]
  tests/batch/full_disks.py --only-sizes --sizes 20

With --all every type of file and more numbers of jobs, otherwise some. --sizes: so many sizes of disks from 0.5 to 10 MB, each
with a still, a sheet and batches. What a run without a journal would finish there is finished, and the rest by the
same command once there is room. Inputs stay as they are.

Needs the right to mount a tmpfs. Sizes follow from files that were written before, and nothing depends on time: where a
machine is so quick that a run has no journal, less is tested.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import tempfile

import batch_tools as tools

# Colours that no encoder makes small, and a light that takes some seconds.
SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <0, 1, -6> look_at 0 }
light_source { <-9, 12, -9> 1 area_light 4*x, 4*z, LAMPS, LAMPS jitter }
sphere { <SHIFT, 0, 0>, 1 pigment { function { f_noise_generator(x*99, y*99, z*99, 2) } } }
plane { y, -1 pigment { granite scale .02 } finish { reflection .2 } }
plane { -z, -9 pigment { granite scale .03 } finish { ambient .5 } }
"""
SIZE = ["+W160", "+H120"]
TYPES = {"png": ["+FN16"], "tga": ["+FT"], "bmp": ["+FB"], "ppm": ["+FP"], "hdr": ["+FH"], "tif": [], "exr": ["+FE"], "jpg": ["+FJ95"]}
FEW_TYPES = ("png", "hdr", "tif")  # packed by the program, plain, and by OpenImageIO
BLOCK = 4096


SCENES_WRITTEN = set()


def scene(lamps, shift=0.0):
    text = SCENE.replace("LAMPS", str(lamps)).replace("SHIFT", str(shift))
    SCENES_WRITTEN.add(text)
    return text


class Disk:
    """A tmpfs of so many bytes."""

    def __init__(self, place, size):
        self.place, self.size = place, size

    def __enter__(self):
        self.place.mkdir(exist_ok=True)
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={self.size}", "none", self.place], check=True)
        return self

    def grow(self, size):
        subprocess.run(["mount", "-o", f"remount,size={size}", self.place], check=True)

    def __exit__(self, *_):
        subprocess.run(["umount", self.place], check=False)


def can_mount(folder):
    try:
        with Disk(folder / "probe", "1m"):
            return os.getuid() == 0
    except (subprocess.CalledProcessError, OSError):
        return False


def same_file(one, other):
    """But for the time that some types keep."""
    a, b = one.read_bytes(), other.read_bytes()
    return len(a) == len(b) and sum(x != y for x, y in zip(a, b)) <= (8 if one.suffix in (".tif", ".exr") else 0)


class Run:
    def __init__(self, folder, binaries):
        self.folder, self.binaries = folder, binaries
        self.given_up = 0

    def __call__(self, scene_file, picture, *more, **options):
        done = subprocess.run([self.binaries / "lentray", f"+I{scene_file}", f"+O{picture}", "-V", "+WT1", *SIZE, *map(str, more)],
                              cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace",
                              check=False, **options)
        self.given_up += "was given up" in done.stderr
        return done

    def plain(self, check):
        """The picture with room for all."""
        picture = self.folder / "plain.png"
        if not picture.exists():
            check(self("slow.pov", picture, "+FN16").returncode == 0, "plain")
        return picture


def blocks(path):
    return (path.stat().st_size + BLOCK - 1) // BLOCK * BLOCK


def kinds_of_files(check, run, kinds):
    """With room for the picture and a little more."""
    (run.folder / "fewer.pov").write_text(scene(9))  # each pixel has many samples
    cases = [("slow.pov", kind, options) for kind, options in TYPES.items() if kind in kinds]
    for file, kind, options in [*cases, ("fewer.pov", "png", ["+FN16", "+A0.1", "+AM2", "+R2"])]:
        if (file, kind) == ("slow.pov", "png"):
            plain = run.plain(check)
        else:
            plain = run.folder / f"{file}.{kind}"
            done = run(file, plain, *options)
            check(done.returncode == 0, f"{kind} {options}: {done.stderr}")
        with Disk(run.folder / "disk", blocks(plain) + 4 * BLOCK):
            tight = run.folder / "disk" / f"a.{kind}"
            done = run(file, tight, *options)
            check(done.returncode == 0, f"{kind} {options} on a tight disk: {done.stderr}")
            check(done.returncode != 0 or same_file(tight, plain), f"{kind} {options}: another file")
            left = [p.name for p in tight.parent.iterdir() if p != tight]
            check(not left, f"{kind} {options}: left behind: {left}")


def too_small(check, run):
    """The picture does not fit: a reason, no picture, and with room +C goes on with what was kept."""
    plain = run.plain(check)
    with Disk(run.folder / "disk", blocks(plain) - 4 * BLOCK) as disk:
        tight = disk.place / "a.png"
        for more in ([], ["+C"]):
            done = run("slow.pov", tight, "+FN16", *more)
            check(done.returncode == 1 and "No space left" in done.stderr, f"too small {more}: {done.returncode} {done.stderr}")
            check(not tight.exists() and not list(disk.place.glob(".*")), f"too small: {list(disk.place.iterdir())}")
        disk.grow("40m")
        done = run("slow.pov", tight, "+FN16", "+C")
        check(done.returncode == 0 and tight.read_bytes() == plain.read_bytes(), f"gone on with: {done.stderr}")
        check(list(disk.place.iterdir()) == [tight], f"left behind: {list(disk.place.iterdir())}")


def full_journal(check, run):
    """A run that was stopped has filled the disk with its journal; what goes on with it has the picture."""
    plain = run.plain(check)
    with Disk(run.folder / "disk", blocks(plain) + 4 * BLOCK) as disk:
        tight = disk.place / "a.png"
        run("slow.pov", tight, "+FN16", "Max_Time=1.25")
        for more in (["+C"], []):
            tight.unlink(missing_ok=True)
            done = run("slow.pov", tight, "+FN16", *more)
            check(done.returncode == 0 and tight.read_bytes() == plain.read_bytes(), f"after a stop {more}: {done.stderr}")
            (disk.place / "a.png.lentray-state").write_bytes(b"")
        (disk.place / "a.png.lentray-state").unlink(missing_ok=True)


def passes_of_radiosity(check, run):
    """What they keep is larger than the disk, or fills it: the picture is written all the same, and nothing stays."""
    text = SCENE.replace("assumed_gamma 1", "assumed_gamma 1 radiosity { count 400 error_bound 0.05 recursion_limit 2 }")
    text = text.replace("LAMPS", "4").replace("SHIFT", "0")
    SCENES_WRITTEN.add(text)
    (run.folder / "light.pov").write_text(text)
    plain = run.folder / "light.png"
    check(run("light.pov", plain, "+FN16").returncode == 0, "with radiosity")
    for more in (2, 16, 64):
        with Disk(run.folder / "disk", blocks(plain) + more * BLOCK) as disk:
            tight = disk.place / "a.png"
            done = run("light.pov", tight, "+FN16")
            check(done.returncode == 0 and tight.read_bytes() == plain.read_bytes(), f"passes, {more} blocks: {done.stderr}")
            check(list(disk.place.iterdir()) == [tight], f"passes, {more} blocks: left behind: {list(disk.place.iterdir())}")


def limited_files(check, run):
    """A limit of a file's size that the journal meets and the picture does not."""
    plain = run.plain(check)
    most = blocks(plain)
    place = run.folder / "limited.png"
    done = run("slow.pov", place, "+FN16", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)))
    check(done.returncode == 0 and place.read_bytes() == plain.read_bytes(), f"a limit of files: {done.stderr}")
    less = most // 2
    place.unlink()
    done = run("slow.pov", place, "+FN16", preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (less, less)))
    check(done.returncode == 1 and "File too large" in done.stderr and not place.exists(), f"a lower one: {done.stderr}")


def journals_that_cannot_be(check, run):
    plain = run.plain(check)
    place = run.folder / "own.png"
    (run.folder / "own.png.lentray-state").mkdir()
    done = run("slow.pov", place, "+FN16")
    check(done.returncode == 0 and place.read_bytes() == plain.read_bytes(), f"a folder in its place: {done.stderr}")
    (run.folder / "own.png.lentray-state").rmdir()


def batches(check, run, numbers_of_jobs):
    """A batch finishes what a loop over its scenes does, for any number of jobs, and the rest once there is room."""
    scenes = run.folder / "scenes"
    scenes.mkdir()
    sizes = 0
    for i in range(5):
        (scenes / f"t{i}.pov").write_text(scene(9, i * 0.1))
        check(run(scenes / f"t{i}.pov", run.folder / f"t{i}.png", "+FN16").returncode == 0, f"t{i}")
        sizes += blocks(run.folder / f"t{i}.png")
    own = 1 << 20  # the page, small pictures, what programs said
    for fits, size in ((5, sizes + own), (3, sizes * 3 // 5 + own // 4)):
        for jobs in numbers_of_jobs:
            with Disk(run.folder / "disk", size) as disk:
                out = disk.place / "out"
                arguments = [scenes, "--out", out, "--jobs", jobs, "--quiet", *SIZE, "+FN16"]
                done = tools.run(run.binaries, *arguments)
                rows = tools.rows(out)
                finished = [row for row in rows.values() if row["state"] == "done"]
                what = f"--jobs {jobs}, room for {fits}"
                check(len(rows) == 5, f"{what}: {len(rows)} rows")
                check(len(finished) >= (5 if fits == 5 else 1), f"{what}: {len(finished)} done: {done.stderr[-300:]}")
                for row in rows.values():
                    is_there = (out / row["picture"]).is_file()
                    check(is_there == (row["state"] == "done"), f"{what}: {row['name']} is {row['state']}")
                    told = row["state"] == "done" or ("pace" in row["reason"] and row.get("lacks_room"))
                    check(told, f"{what}: {row.get('reason')}")
                check(done.returncode == (0 if len(finished) == 5 else 1) or "page" in done.stderr, f"{what}: {done.returncode}")
                disk.grow("60m")
                again = tools.run(run.binaries, *arguments)
                check(again.returncode == 0, f"{what}, and then room: {again.returncode} {again.stderr[-300:]}")
                check(len(tools.pictures(out)) == 5, f"{what}, and then room: {len(tools.pictures(out))} pictures")
                left = [p.name for p in out.rglob("*") if p.name.endswith((".part", ".lentray-state"))]
                check(not left, f"{what}: left behind: {left}")


def errors_are_not_tried_again(check, run):
    scenes = run.folder / "broken"
    scenes.mkdir()
    (scenes / "broken.pov").write_text("sphere { 0, 1 pigmnt { rgb 1 } }\n")
    program, log = tools.logged_lentray(run.folder, run.binaries)
    for _ in range(2):
        tools.run(run.binaries, scenes, "--out", run.folder / "broken-out", "--lentray", program)
    check(len(tools.calls(log)) == 1, f"a broken scene is tried again: {tools.calls(log)}")


def pictures_on_many_sizes(check, run, sizes):
    """A still and a sheet of about a megabyte, with journals of four. What fits is finished; with room +C finishes the rest."""
    for kind, words in (("still", []), ("sheet", ["Lenticular=On", "Lens_Pixels=8"])):
        options = ["+W480", "+H360", "+FN16", *words]
        plain = run.folder / f"{kind}.png"
        check(run("large.pov", plain, *options).returncode == 0, kind)
        fitting = 0
        for size in sizes:
            with Disk(run.folder / "disk", size) as disk:
                what, tight = f"a {kind} on {size} bytes", disk.place / "a.png"
                done = run("large.pov", tight, *options)
                if size >= blocks(plain) + 4 * BLOCK:
                    fitting += 1
                    check(done.returncode == 0 and same_file(tight, plain), f"{what}: {done.returncode} {done.stderr}")
                elif done.returncode == 0:
                    check(same_file(tight, plain), f"{what}: another file")
                else:
                    check(done.returncode == 1 and "No space left" in done.stderr and not tight.exists(),
                          f"{what}: {done.returncode} {done.stderr}")
                disk.grow("40m")
                done = run("large.pov", tight, *options, "+C")
                check(done.returncode == 0 and same_file(tight, plain), f"{what}, and then room: {done.stderr}")
                check(list(disk.place.iterdir()) == [tight], f"{what}: left behind: {list(disk.place.iterdir())}")
        print(f"{kind}s: {len(sizes)} disks, of which {fitting} have room for the picture of {blocks(plain)} bytes", flush=True)


def batches_on_many_sizes(check, run, sizes, numbers_of_jobs):
    """As many pictures as have room beside a batch's own files; with room the same command makes the rest."""
    scenes, count = run.folder / "five", 5
    scenes.mkdir()
    size_of_one = 0
    for i in range(count):
        (scenes / f"t{i}.pov").write_text(scene(5, i * 0.1))
        check(run(scenes / f"t{i}.pov", run.folder / f"five{i}.png", "+W240", "+H180", "+FN16").returncode == 0, f"five {i}")
        size_of_one = max(size_of_one, blocks(run.folder / f"five{i}.png"))
    own = 600_000  # the page, small pictures, rows, what programs said
    told = []
    for size in sizes:
        for jobs in numbers_of_jobs:
            with Disk(run.folder / "disk", size) as disk:
                out = disk.place / "out"
                arguments = [scenes, "--out", out, "--jobs", jobs, "--quiet", "+W240", "+H180", "+FN16"]
                done = tools.run(run.binaries, *arguments)
                what = f"a batch on {size} bytes, --jobs {jobs}"
                made = [p for p in out.glob("t*.png") if same_file(p, run.folder / f"five{p.stem[1:]}.png")]
                fitting = max(0, min(count, (size - own) // size_of_one))
                check(len(made) >= fitting, f"{what}: {len(made)} of {fitting} pictures: {done.stderr[-300:]}")
                told.append(f"{len(made)}/{fitting}")
                disk.grow("60m")
                again = tools.run(run.binaries, *arguments)
                check(again.returncode == 0, f"{what}, and then room: {again.returncode} {again.stderr[-300:]}")
                made = [p for p in out.glob("t*.png") if same_file(p, run.folder / f"five{p.stem[1:]}.png")]
                check(len(made) == count, f"{what}, and then room: {len(made)} pictures")
    print(f"batches: {len(told)} disks; pictures made of those that fit: {' '.join(told)}", flush=True)


def many_sizes(count):
    """Bytes from 0.5 to 10 MB, whole blocks."""
    return [round(5e5 * 20 ** (i / max(1, count - 1)) / BLOCK) * BLOCK for i in range(count)]


def page_without_room(check, run):
    """Its message says why."""
    scenes = run.folder / "one"
    scenes.mkdir()
    (scenes / "t.pov").write_text(scene(1))
    with Disk(run.folder / "disk", "8m") as disk:
        out = disk.place / "out"
        check(tools.run(run.binaries, scenes, "--out", out, *SIZE).returncode == 0, "the first batch")
        with open(disk.place / "filler", "wb", buffering=0) as filler:
            try:
                while True:
                    filler.write(bytes(BLOCK))
            except OSError:
                pass
        done = tools.run(run.binaries, scenes, "--out", out, *SIZE)
        told = "the page could not be written: " in done.stderr and "space" in done.stderr
        check(done.returncode == 1 and told, f"no room for the page: {done.returncode} {done.stderr}")
        check((out / "t.png").is_file() and (out / "index.html").stat().st_size > 0, "the earlier page is gone")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN)
    parser.add_argument("--all", action="store_true", help="every type of file, and more numbers of jobs")
    parser.add_argument("--sizes", type=int, default=3, help="disks from 0.5 to 10 MB")
    parser.add_argument("--only-sizes", action="store_true")
    arguments = parser.parse_args()
    binaries = arguments.bin.resolve()
    check = tools.Checks()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "slow.pov").write_text(scene(24 if arguments.all else 18))
        (folder / "large.pov").write_text(scene(6))
        run = Run(folder, binaries)
        if not arguments.only_sizes:
            limited_files(check, run)
            journals_that_cannot_be(check, run)
            errors_are_not_tried_again(check, run)
        mounts = can_mount(folder)
        if mounts:
            sizes = many_sizes(arguments.sizes)
            pictures_on_many_sizes(check, run, sizes)
            batches_on_many_sizes(check, run, sizes, (1, 2) if arguments.all else (2,))
        if mounts and not arguments.only_sizes:
            kinds_of_files(check, run, TYPES if arguments.all else FEW_TYPES)
            too_small(check, run)
            full_journal(check, run)
            passes_of_radiosity(check, run)
            batches(check, run, (1, 2, 5) if arguments.all else (2,))
            page_without_room(check, run)
        if mounts:
            print(f"{run.given_up} journals were given up")
            check(all(p.read_text() in SCENES_WRITTEN for p in folder.rglob("*.pov") if p.name != "broken.pov"), "an input has changed")
        else:
            print("left out: disks, which need the right to mount one")
    check.end()


if __name__ == "__main__":
    main()
