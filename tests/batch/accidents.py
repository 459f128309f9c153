"""What a picture depended on changes by accident: is what says "done" always one undisturbed picture?

  tests/batch/accidents.py [--bin FOLDER] [--jobs 2] [--seconds 2.5] [--only WORD ...]

Stills, lens sheets, animations, views and batches, each with and without radiosity; ten things change (CHANGES) at three
moments (MOMENTS): 300 cases. Each ends, bit for bit, in the undisturbed pictures of the old or of the new inputs, or with
another status than 0, the change named, and not all pictures there. A batch ends in the new ones. A scene that asks for
`now` shows it as its background, so that its undisturbed picture is that of the same moment.
Cases that were over before anything could be cut off are counted apart. The exit status is 1 if a case fails.
"""
import argparse
import collections
import concurrent.futures
import itertools
import os
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

import batch_tools as tools

sys.path.insert(0, str(tools.ROOT / "tests/support"))
import pictures

KINDS = {"still": [], "sheet": ["Lenticular=On"], "animation": ["+KFF3", "Final_Clock=1"],
         "views": ["Lenticular=On", "Views=3"], "batch": []}
CHANGES = ["scene", "include", "image", "font", "df3", "a file appears", "clock", "now", "option", "program"]
# What the message of a refusal has to name; the clock's line and option begin small and large.
NAMES = {"scene": "scene", "include": "part.inc", "image": "tile.png", "font": "letters.ttf", "df3": "cloud.df3",
         "a file appears": "extra.inc", "clock": "lock", "now": "now", "option": "Declare", "program": "program"}
MOMENTS = ["before it goes on", "during", "when it is done"]
FONTS = pathlib.Path("/usr/share/povray-3.7/include")
SCENE = """#version 3.7;
#include "part.inc"
#ifndef (Option) #declare Option = 0.2; #end
#declare Extra = 0;
#if (file_exists("extra.inc")) #include "extra.inc" #end
#ifndef (Moment) #declare Moment = MOMENT; #end
global_settings { assumed_gamma 1 RADIOSITY }
background { rgb Moment }
camera { location <0, 1, -6> look_at 0 right 4/3*x }
light_source { <-9, 12, -9> rgb 1 area_light 4*x, 4*z, LAMPS, LAMPS jitter }
sphere { <-1.5, 0, 0>, 1 pigment { rgb <Shade, Extra, clock> } finish { reflection 0.2 } }
plane { y, -1 pigment { image_map { png "tile.png" } rotate 90*x } finish { ambient 0.1 } }
text { ttf "letters.ttf" "R" 0.3, 0 pigment { rgb <1, Option, 0.2> } translate <0.4, 0, -0.5> }
box { 0, 1 pigment { density_file df3 "cloud.df3" colour_map { [0 rgb 0.1] [1 rgb <0, 1, 1>] } } translate <0.5, -1, 0.5> }
"""
RADIOSITY = "radiosity { pretrace_start 0.04 pretrace_end 0.01 count 150 error_bound 0.2 recursion_limit 2 }"


def png(red):
    return pictures.png([[(red, 200, 100)] * 4 + [(20, 20, 60)] * 4] * 8)


def df3(first):
    return struct.pack(">HHH", 2, 2, 2) + bytes((first, 255, 0, 128, 255, 0, 60, 200))


def other_program(program):
    """The same program of another build: the linker's note of it has other bytes."""
    note = subprocess.run(["readelf", "-n", program], capture_output=True, text=True, check=True).stdout
    build = bytes.fromhex(note.split("Build ID:")[1].split()[0])
    bytes_ = program.read_bytes()
    assert bytes_.count(build) == 1
    program.write_bytes(bytes_.replace(build, build[::-1]))


class Inputs:
    """A folder with a scene and all that it reads."""

    def __init__(self, folder, kind, radiosity, change, lamps, binaries):
        self.folder, self.kind, self.change = folder, kind, change
        self.scenes = folder / "in" if kind == "batch" else folder
        self.scenes.mkdir(parents=True, exist_ok=True)
        self.binaries = binaries
        self.program = binaries / "lentray"
        if change == "program":
            self.program = folder / "lentray"
            for name in ("lentray", "lentray_openimageio.so"):
                shutil.copy(binaries / name, folder)
        moment = "(8 + mod(floor(now*86400), 64))/80" if change == "now" else "0.5"
        self.text = (SCENE.replace("MOMENT", moment).replace("RADIOSITY", RADIOSITY if radiosity else "")
                     .replace("LAMPS", str(lamps)))
        self.options = []
        self.put("a.pov", self.text)
        self.put("part.inc", "#declare Shade = 1;\n")
        self.put("tile.png", png(250))
        self.put("letters.ttf", (FONTS / "timrom.ttf").read_bytes())
        self.put("cloud.df3", df3(10))

    def put(self, name, what):
        """As editors and copying tools leave it: a new file under the name."""
        new = self.scenes / (name + ".new")
        new.write_bytes(what.encode() if isinstance(what, str) else what)
        new.rename(self.scenes / name)

    def alter(self):
        if self.change == "scene":
            self.put("a.pov", self.text.replace("<-1.5, 0, 0>", "<-1.4, 0, 0>"))
        elif self.change == "include":
            self.put("part.inc", "#declare Shade = 0;\n")
        elif self.change == "image":
            self.put("tile.png", png(10))
        elif self.change == "font":
            self.put("letters.ttf", (FONTS / "cyrvetic.ttf").read_bytes())
        elif self.change == "df3":
            self.put("cloud.df3", df3(99))
        elif self.change == "a file appears":
            self.put("extra.inc", "#declare Extra = 1;\n")
        elif self.change == "clock":
            self.options = ["+KF0.7"] if self.kind == "animation" else ["+K0.7"]
        elif self.change == "option":
            self.options = ["Declare=Option=0.9"]
        elif self.change == "program":
            new = self.folder / "program"
            shutil.copy(self.program, new)
            other_program(new)
            new.rename(self.program)

    def command(self, going_on, extra=()):
        size = ["+W120", "+H90", *KINDS[self.kind], *self.options, *extra]
        if self.kind == "batch":
            return [self.binaries / "lentray-batch", "in", "--out", "out", "--lentray", self.program, "--jobs", "1", *size]
        return [self.program, "a.pov", "+Oa.png", "-D", "+WT1", *size, *(["+C"] if going_on else [])]

    def start(self, going_on, extra=()):
        return subprocess.Popen(list(map(str, self.command(going_on, extra))), cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                                start_new_session=True)

    def run(self, going_on, extra=()):
        """Status and words."""
        process = self.start(going_on, extra)
        words, _ = process.communicate()
        return process.returncode, words

    def wait_for_work(self, process, pause):
        """Until something is kept that a later run may go on with; False: it ended before."""
        where = self.folder / "out" if self.kind == "batch" else self.folder
        while process.poll() is None:
            kept = [p for p in where.glob("*.lentray-*") if p.name.endswith(("-state", "-passes.part")) and p.stat().st_size]
            if kept:
                time.sleep(pause)
                return process.poll() is None
            time.sleep(0.01)
        return False

    def results(self):
        """Rows of pixels of each picture."""
        where = self.folder / "out" if self.kind == "batch" else self.folder
        out = {}
        for path in sorted(where.glob("*.png")):
            if path.name != "tile.png":
                out[path.name] = pictures.read_png(path.read_bytes())[0]
        return out


def moment_of(rows):
    """That the background shows, of the scene's 64."""
    value = rows[0][0][0] / 255
    linear = value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
    return round(linear * 80 - 8)


class Trial:
    def __init__(self, args, folder):
        self.args, self.folder = args, folder
        self.lamps, self.known, self.lock = {}, {}, threading.Lock()
        self.number = itertools.count()

    def inputs(self, kind, radiosity, change):
        lamps = self.lamps.get((kind, radiosity), 3)
        return Inputs(self.folder / str(next(self.number)), kind, radiosity, change, lamps, self.args.bin)

    def find_lamps(self, kind, radiosity):
        """So many that the work takes long enough to be cut off: nothing is kept of the first second of a picture."""
        lamps = 3
        while True:
            self.lamps[kind, radiosity] = lamps
            inputs = self.inputs(kind, radiosity, "scene")
            start = os.times()
            status, words = inputs.run(False)
            end = os.times()
            assert status == 0, words
            shutil.rmtree(inputs.folder)
            parts = 3 if kind in ("animation", "views") else 1
            seconds = (end.children_user - start.children_user) / parts
            if seconds >= self.args.seconds:
                return
            lamps = int(lamps * min(max(1.1, (1.2 * self.args.seconds / max(seconds, 0.05)) ** 0.5), 3)) + 1

    def undisturbed(self, kind, radiosity, change, is_new, moment):
        """Pictures of inputs that nobody touches."""
        if change == "program" or not is_new:
            is_new, change = False, "now" if change == "now" else "scene"
        key = kind, radiosity, change, is_new, moment
        with self.lock:
            future = self.known.get(key)
            mine = future is None
            if mine:
                future = self.known[key] = concurrent.futures.Future()
        if mine:
            inputs = self.inputs(kind, radiosity, change)
            if is_new:
                inputs.alter()
            status, words = inputs.run(False, [] if moment is None else [f"Declare=Moment={(8 + moment) / 80:.17g}"])
            future.set_result(inputs.results() if status == 0 else {"it failed": words})
            shutil.rmtree(inputs.folder)
        return future.result()

    def which(self, kind, radiosity, change, results):
        """"old" or "new", if that is what the pictures show."""
        if change == "now":
            # Each frame asks anew; whatever else goes on, views too, is of one moment.
            moments = {name: moment_of(rows) for name, rows in results.items()}
            if kind != "animation" and len(set(moments.values())) > 1:
                return None
            for name, rows in results.items():
                if rows != self.undisturbed(kind, radiosity, change, False, moments[name]).get(name):
                    return None
            return "new" if results else None
        for name in ("new", "old"):
            if results == self.undisturbed(kind, radiosity, change, name == "new", None):
                return name
        return None

    def case(self, kind, radiosity, change, moment, seed):
        """(What is wrong, or None; whether anything was cut off or changed while it ran; how it ended)."""
        pause = random.Random(seed).uniform(0.05, 0.8)
        inputs = self.inputs(kind, radiosity, change)
        try:
            return self.judge(inputs, kind, radiosity, change, moment, pause)
        finally:
            shutil.rmtree(inputs.folder)

    def judge(self, inputs, kind, radiosity, change, moment, pause):
        was_in_work = True
        if moment == "when it is done":
            status, words = inputs.run(False)
        else:
            process = inputs.start(False)
            reader = concurrent.futures.ThreadPoolExecutor(1).submit(process.stdout.read)
            was_in_work = inputs.wait_for_work(process, pause)
            if moment == "before it goes on":
                if process.poll() is None:
                    os.killpg(process.pid, signal.SIGKILL)
            else:
                inputs.alter()
            process.wait()
            status, words = process.returncode, reader.result()
        if moment != "before it goes on":
            if moment == "during" and status == 1 and kind == "animation" and "of two versions" in words:
                whole = self.undisturbed(kind, radiosity, change, False, None)
                if len(inputs.results()) >= len(whole) or NAMES[change] not in words.split("of two versions")[-1]:
                    return f"the first run: {words[-300:]}", was_in_work, "refused"
                return self.second(inputs, kind, radiosity, change, was_in_work)
            if status != 0:
                return f"the first run ended with {status}: {words[-300:]}", was_in_work, ""
            shows = self.which(kind, radiosity, change, inputs.results())
            if shows != "old" and change not in ("now", "program") and not (kind == "batch" and shows == "new"):
                return f"the first run shows {shows}", was_in_work, ""
        if moment != "during":
            inputs.alter()
        return self.second(inputs, kind, radiosity, change, was_in_work)

    def second(self, inputs, kind, radiosity, change, was_in_work):
        """The run that goes on."""
        if change == "now":
            time.sleep(1.1)
        status, words = inputs.run(True)
        results = inputs.results()
        if status != 0:
            whole = self.undisturbed(kind, radiosity, change, False, None if change != "now" else 0)
            if len(results) >= len(whole):
                return f"it ended with {status}, and all pictures are there", was_in_work, "refused"
            if NAMES[change] not in words.split("error:")[-1]:
                return f"the change is not named: {words[-300:]}", was_in_work, "refused"
            return None, was_in_work, "refused"
        shows = self.which(kind, radiosity, change, results)
        if shows is None:
            return "the pictures are of no undisturbed run", was_in_work, ""
        if kind == "batch" and shows != "new" and change not in ("now", "program"):
            return "the batch keeps old pictures", was_in_work, shows
        return None, was_in_work, shows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN, metavar="FOLDER")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=2.5, help="of a picture, undisturbed")
    parser.add_argument("--only", nargs="*", default=[], metavar="WORD", help="cases whose names contain all of them")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    tools.needs("readelf")
    if not FONTS.is_dir():
        print("left out: POV-Ray's fonts are not installed")
        sys.exit(77)
    cases = [c for c in itertools.product(KINDS, (False, True), CHANGES, MOMENTS)
             if all(w in f"{c[0]}, {'radiosity' if c[1] else 'plain'}, {c[2]}, {c[3]}" for w in args.only)]
    check, ends, idle = tools.Checks(), collections.Counter(), 0
    with tempfile.TemporaryDirectory() as temporary:
        trial = Trial(args, pathlib.Path(temporary))
        for kind, radiosity in sorted({c[:2] for c in cases}):
            trial.find_lamps(kind, radiosity)
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for case, (wrong, was_in_work, end) in zip(cases, pool.map(lambda c: trial.case(*c, str(c)), cases)):
                name = f"{case[0]}, {'radiosity' if case[1] else 'plain'}: {case[2]} {case[3]}"
                check(wrong is None, f"{name}: {wrong}")
                print(f"{name}: {end}{'' if was_in_work else ' (nothing was cut off)'}", flush=True)
                ends[end] += 1
                idle += not was_in_work
    print(f"{len(cases)} cases: " + ", ".join(f"{n} {end}" for end, n in ends.most_common()) +
          f"; in {idle} nothing was cut off")
    check.end()


if __name__ == "__main__":
    main()
