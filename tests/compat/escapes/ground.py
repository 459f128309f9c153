"""Where attempts to escape are made: a stranger's folder, the user's, and what lies outside and is watched."""
import dataclasses
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
import pictures  # noqa: E402
from escapes.watch import Watch  # noqa: E402

MARK = "SECRET7f3a"
SCENE = "camera{location -5*z look_at 0} light_source{<2,4,-8>,1} sphere{0,1 pigment{rgb 1}}\n"
ODD = b"od\xff d"
FONT = "/usr/share/povray-3.7/include/timrom.ttf"
ON = "Restrict_IO=On"
SMALL = ("+W8", "+H6", "-V")
CONF = "[File I/O Security]\nrestricted\n[Shellout Security]\nallowed\n"
OBEYED = (".ini", ".rca", ".conf")  # ends of names of what later runs obey
LONGEST = 300.0  # seconds of an attempt, on a busy machine


@dataclasses.dataclass(frozen=True)
class Link:
    to: str


@dataclasses.dataclass(frozen=True)
class Hard:
    to: str  # below the root


class Fifo:
    pass


@dataclasses.dataclass
class Attempt:
    """A command line of the user's with files that are a stranger's. ROOT in words and texts is the ground's folder."""
    kind: str
    what: str
    program: str
    words: list
    files: dict = dataclasses.field(default_factory=dict)  # below the root: text, bytes, Link, Hard, Fifo
    cwd: str = "strangers"
    is_refused: bool = False  # that it succeeds is an escape
    swaps: tuple = ()  # a name in strangers, and what it is in turn
    longest: float = 0.0005  # seconds that it is each of them, at most
    before: object = None  # called with the ground once the files are there
    path: str = ""  # a folder of programs that go first
    are_reads_told: bool = True  # a hard link of the stranger's is read like any file there


def secrets():
    """What a stranger is after: a file for each reader."""
    pixel = (200, 10, 200)
    return {"secret.inc": f'#declare Told = 1;\n#debug "{MARK}\\n"\n', "text": f'"{MARK}", 1\n', "secret.ini": f"Declare={MARK}=1\n",
            "secret.png": pictures.png([[pixel] * 4] * 4), "secret.ppm": b"P6 2 2 255 " + bytes(pixel) * 4,
            "secret.tif": pictures.tiff([[pixel] * 4] * 4), "secret.df3": bytes([0, 1, 0, 1, 0, 1, 9]),
            "secret.ttf": pathlib.Path(FONT).read_bytes() if os.path.exists(FONT) else b"\0\1\0\0", "secret.ph": MARK, "rc": MARK + "\n",
            "more.ini": "Debug_File=../victim/rc\n", "secret.pov": SCENE + f'#error "{MARK}"\n', "a.pov": SCENE, "secret.rca": MARK,
            "lens_sheets.ini": "[mine]\nLens_Pitch=1\nLens_Thickness=3\n"}


class Ground:
    """Folders strangers, lib (a library of the user's), here (the user's), home, and victim, which is outside."""

    def __init__(self, place, binaries):
        self.folder = tempfile.TemporaryDirectory(dir=place)
        self.root, self.bin = pathlib.Path(self.folder.name), binaries
        for name in ("strangers/sub", "lib", "here", "home/.povray/3.7", "home/private", "victim/sub"):
            (self.root / name).mkdir(parents=True)
        odd = os.path.join(os.fsencode(self.root), ODD)
        os.mkdir(odd)
        for folder in (os.fsencode(self.root / "victim"), os.fsencode(self.root / "home/private"), odd):
            for name, content in secrets().items():
                self.write(os.path.join(folder, os.fsencode(name)), content)
        for name, content in (("home/.bashrc", "alias a=b\n"), ("home/.povray/3.7/povray.conf", CONF), ("here/.profile", "a\n"),
                              ("here/own.txt", "own\n"), ("strangers/a.pov", SCENE)):
            self.write(self.root / name, content)
        os.symlink(self.root / "victim", self.root / "strangers/folder")
        os.symlink("../..", self.root / "strangers/sub/up")
        self.watch = None

    def write(self, place, content):
        if isinstance(content, str):
            content = content.replace("ROOT", str(self.root)).encode("utf-8", "surrogateescape")
        with open(place, "wb") as file:
            file.write(content)

    def put(self, files):
        for name, content in files.items():
            place = self.root / name
            place.parent.mkdir(parents=True, exist_ok=True)
            if os.path.lexists(place):
                place.unlink()
            if isinstance(content, Link):
                os.symlink(content.to.replace("ROOT", str(self.root)), place)
            elif isinstance(content, Hard):
                os.link(self.root / content.to, place)
            elif isinstance(content, Fifo):
                os.mkfifo(place)
            else:
                self.write(place, content)

    def outside(self, attempt):
        """Content, size, mode and times of all that no run may change, and which names there are."""
        folders = ["victim", "home", "lib", os.fsdecode(ODD)] + (["strangers"] if attempt.cwd == "here" and not attempt.swaps else [])
        out = {}
        for folder in folders:
            for where, names, files in os.walk(os.fsencode(self.root / folder)):
                for name in [b"."] + names + files:
                    if b"out" not in os.path.join(where, name).split(b"/"):
                        self.note(os.path.join(where, name), out)
        for name in (".profile", "own.txt"):
            self.note(os.fsencode(self.root / "here" / name), out)
        return out

    @staticmethod
    def note(place, out):
        about = os.lstat(place)
        content = b""
        if os.path.isfile(place) and not os.path.islink(place):
            with open(place, "rb", opener=lambda path, flags: os.open(path, flags | os.O_NOATIME)) as file:
                content = file.read()
        elif os.path.islink(place):
            content = os.readlink(place)
        if place.endswith(b"/.") or os.path.isdir(place):
            out[place] = (about.st_mode, about.st_uid, about.st_mtime_ns)
        else:
            out[place] = (about.st_mode, about.st_uid, about.st_mtime_ns, about.st_size, content)

    def obeyed(self):
        """What the user's later runs would obey."""
        return {str(p) for p in (self.root / "here").iterdir() if p.name.startswith(".") or p.name.endswith(OBEYED)}

    def told(self, said):
        """Whether the secret is in what was said or in a file that anybody could read."""
        if MARK in said:
            return "the secret is told"
        for place in [*(self.root / "here").rglob("*"), *(self.root / "strangers").rglob("*")]:
            if place.is_file() and not place.is_symlink() and place.stat().st_nlink == 1 and MARK.encode() in place.read_bytes():
                return f"the secret is in {place}"
        return ""

    def command(self, attempt):
        words = [word.replace("ROOT", str(self.root)) if isinstance(word, str) else word for word in attempt.words]
        return [self.bin / attempt.program, *words]

    def run(self, attempt):
        """Its status and all that it says; None for the status: it went on for too long."""
        env = dict(os.environ, HOME=str(self.root / "home"), POVINI="", TMPDIR=str(self.root / "here"))
        if attempt.path:
            env["PATH"] = f"{self.root / attempt.path}:{env['PATH']}"
        swapping = Swaps(self.root / "strangers", attempt.swaps, attempt.longest) if attempt.swaps else None
        try:
            done = subprocess.run(self.command(attempt), cwd=self.root / attempt.cwd, stdin=subprocess.DEVNULL, capture_output=True,
                                  env=env, timeout=LONGEST, check=False)
            status, said = done.returncode, (done.stdout + done.stderr).decode(errors="replace")
        except subprocess.TimeoutExpired as late:
            status, said = None, f"went on for more than {LONGEST} s {late.output}"
        finally:
            if swapping:
                swapping.end()
        return status, said

    def escapes(self, attempt):
        """What got out in words, none if nothing did; and what the program said."""
        self.put({name: content for name, content in attempt.files.items() if not isinstance(content, Hard)})
        self.put({name: content for name, content in attempt.files.items() if isinstance(content, Hard)})
        if attempt.before:
            attempt.before(self)
        before, obeyed = self.outside(attempt), self.obeyed()
        watch = Watch()
        for folder, reads in (("victim", attempt.are_reads_told), ("home", False), ("home/private", True), (os.fsdecode(ODD), True), ("lib", False)):
            watch.add(self.root / folder, reads)
        status, said = self.run(attempt)
        found = watch.told()
        watch.close()
        after = self.outside(attempt)
        if os.path.exists("/dev/shm/lentray-escape"):
            found.append("a file in /dev/shm")
            os.unlink("/dev/shm/lentray-escape")
        found += [f"{os.fsdecode(place)} has changed" for place in {**before, **after} if before.get(place) != after.get(place)]
        found += [f"{place} was made, which later runs obey" for place in self.obeyed() - obeyed]
        found += [text for text in (self.told(said),) if text]
        if status is None:
            found.append("it does not end")
        elif status < 0:
            found.append(f"ended by signal {-status}")
        if attempt.is_refused and status == 0:
            found.append("it succeeds")
        return found, status, said

    def close(self):
        self.folder.cleanup()


class Swaps(threading.Thread):
    """Exchanges what a name means, quickly."""

    def __init__(self, folder, swaps, longest):
        super().__init__(daemon=True)
        self.folder, self.swaps, self.longest, self.goes_on = folder, swaps, longest, True
        self.start()

    def run(self):
        name, states = self.swaps
        spare = self.folder / (name + ".next")
        chance = random.Random()
        while self.goes_on:
            for state in states:
                try:
                    self.make(spare, state)
                    if state is not None:
                        self.exchange(spare, self.folder / name)
                except OSError:
                    continue
                time.sleep(chance.uniform(0, self.longest))

    def make(self, place, state):
        if state is None:
            target = self.folder / self.swaps[0]
            if os.path.lexists(target):
                os.unlink(target)
        elif isinstance(state, Link):
            os.symlink(state.to, place)
        elif isinstance(state, Hard):
            os.link(self.folder.parent / state.to, place)
        elif isinstance(state, dict):
            os.mkdir(place)
            for name, text in state.items():
                (place / name).write_text(text)
        else:
            place.write_text(state)

    @staticmethod
    def exchange(spare, place):
        """Folders are moved out of the way, since they are not replaced by a rename."""
        if place.is_dir() and not place.is_symlink():
            shutil.rmtree(place)
        if spare.is_dir() and not spare.is_symlink() and place.is_symlink():
            place.unlink()
        os.rename(spare, place)

    def end(self):
        self.goes_on = False
        self.join()
