"""Scenes whose names are any bytes: every program takes them, and what is written of them can be used again.

  tests/names/any_bytes.py [--bin build/release/bin]

A name is bytes that need not be UTF-8. In JSON a byte that is no part of a character stands as the character
U+EF00 + byte (parser/base/utf8.h); name_in() is how another program reads it.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "batch"))
import batch_tools as tools  # noqa: E402

SCENE = "camera { location -5*z look_at 0 } light_source { <3, 5, -9>, 1 } sphere { 0, 1 pigment { rgb <1, .5, .2> } }\n"
NAMES = [b"caf\xe9", b"\xff\xfe", b"half \xe2\x82", b"two\nlines", b"q\"uote's", b"<script>alert(1)<", b"back\\slash", b"-dash",
         b" two  spaces ", b"x" * 246, "\u202egnp.evil".encode(), "\uef80\uefe9".encode(), "Überblick".encode(), b"%41&amp;", b"a#12~3",
         b"$HOME`id`;", b"a=b", b"tab\there", b"\x9b31m"]
SIZE = [b"+W8", b"+H6"]


def name_in(text):
    """The bytes of a name in JSON."""
    return b"".join(bytes([ord(c) & 0xFF]) if "\uef80" <= c <= "\uefff" else c.encode() for c in text)


class Programs:
    def __init__(self, check, binaries, folder):
        self.check, self.binaries, self.folder = check, os.fsencode(binaries), os.fsencode(folder)

    def __call__(self, what, program, *arguments, status=0):
        done = subprocess.run([self.binaries + b"/" + program, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=300, check=False)
        said = done.stderr + done.stdout
        self.check(done.returncode == status, f"{what}: status {done.returncode}: {said[-300:]!r}")
        self.check(b"internal error" not in said, f"{what}: {said[-300:]!r}")
        return done

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def read(self, *parts):
        try:
            with open(self.path(*parts), "rb") as file:
                return file.read()
        except OSError as error:
            self.check(False, str(error))
            return b"{}"


def is_tame(said):
    """Neither control characters nor marks of direction nor bytes that are no text go to a terminal."""
    try:
        text = said.decode()
    except UnicodeDecodeError:
        return False
    return not any((ord(c) < 32 and c not in "\n\t\r\b") or 0x7F <= ord(c) < 0xA0 or 0x202A <= ord(c) <= 0x202E for c in text)


def renderer(check, run, names):
    for name in names:
        scene = b"sc/" + name + b".pov"
        words = [b"+I" + scene, b"+Oone.png", b"-V", *SIZE, b"Statistics_File=s.json", b"Dependencies_File=d.json"]
        if b"\n" in name:  # an INI file cannot hold it
            refused = run(f"Create_Ini of {name!r}", b"lentray", *words, b"Create_Ini=one.ini", status=1)
            check(b"which an INI file cannot hold" in refused.stderr, f"Create_Ini of {name!r}: {refused.stderr!r}")
        else:
            words.append(b"Create_Ini=one.ini")
        run(f"lentray {name!r}", b"lentray", *words)
        json.loads(run.read(b"s.json").decode())
        read = [name_in(path) for path in json.loads(run.read(b"d.json").decode())["read"]]
        check(scene in read, f"dependencies of {name!r}: {read}")
        dump = run(f"--dump of {name!r}", b"lentray", b"+I" + scene, b"--dump", b"-V")
        json.loads(dump.stdout.decode())
        # The default picture has the scene's name.
        run(f"the picture of {name!r}", b"lentray", b"+I" + scene, b"-V", *SIZE)
        check(os.path.isfile(run.path(b"sc", name + b".png")), f"no picture of {name!r}")
        failed = run(f"an error in {name!r}", b"lentray", b"+Ibad/" + name + b".pov", b"-V", b"-F", status=1)
        check(is_tame(failed.stderr), f"the message of {name!r}: {failed.stderr!r}")
        missing = run(f"no scene {name!r}", b"lentray", b"+Inowhere/" + name + b".pov", b"-V", b"-F", status=1)
        check(is_tame(missing.stderr), f"of no scene {name!r}: {missing.stderr!r}")


def batch(check, run, names):
    """Each scene has its row, which is found again."""
    out = b"out"
    arguments = [b"sc", b"bad", b"--out", out, *SIZE]
    first = run("batch", b"lentray-batch", *arguments, status=1)
    check(is_tame(first.stderr), f"batch: {first.stderr[-400:]!r}")
    rows = [json.loads(line) for line in run.read(out, b"manifest.jsonl").decode().splitlines()]
    sources = {name_in(row["source"]) for row in rows}
    for folder in (b"sc", b"bad"):
        for name in names:
            check(run.path(folder, name + b".pov") in sources, f"no row of {folder + b'/' + name!r}")
    for row in rows:
        good = os.path.dirname(name_in(row["source"])).endswith(b"sc")
        check(row["state"] == ("done" if good else "failed"), f"{row['source']!r}: {row['state']}, {row.get('reason')}")
        if good:
            check(os.path.isfile(run.path(out, name_in(row["picture"]))), f"no file {row['picture']!r}")
    times = {p: p.stat().st_mtime_ns for p in pathlib.Path(os.fsdecode(run.path(out))).rglob("*.png")}
    again = run("batch again", b"lentray-batch", *arguments, status=1)
    done = sum(row["state"] == "done" for row in rows)
    check(b"%d of %d pictures are there" % (done, len(rows)) in again.stderr, f"batch again: {again.stderr[:300]!r}")
    check(all(p.stat().st_mtime_ns == time for p, time in times.items()), "a picture was made twice")
    page = run.read(out, b"index.html").decode()
    check("<script>alert" not in page, "a name is markup on the page")
    check("caf%E9.png" in page, "the page has no link to a name of bytes")


def others(check, run):
    name = b"caf\xe9"
    scene = b"sc/" + name + b".pov"
    sheet = [b"Lenticular=On", b"Lens_Pixels=4", b"+W40", b"+H20"]
    run("the sheet", b"lentray", b"+I" + scene, b"+Osheet-" + name + b".png", b"-V", *sheet)
    run("views out of it", b"lentray-views", b"sheet-" + name + b".png", b"--all", b"--out", b"v" + name + b"#.png")
    views = sorted(f for f in os.listdir(run.folder) if f.startswith(b"v" + name))
    check(len(views) == 4, f"views: {views}")
    run("a page to tilt it", b"lentray-views", b"sheet-" + name + b".png", b"--preview", b"v" + name + b".html", b"--count", b"4")
    run.read(b"v" + name + b".html").decode()
    run("a page of the sheet", b"lentray-print", b"sheet", b"sheet-" + name + b".png", b"--out", b"p" + name + b".pdf")
    run("a chart", b"lentray-chart", scene, b"--out", b"chart", b"--quick", b"--no-stock", b"--only", b"quality", b"--repeats", b"1",
        *SIZE, b"-V")
    run("the same chart", b"lentray-chart", scene, b"--out", b"chart", b"--quick", b"--no-stock", b"--only", b"quality", b"--repeats",
        b"1", *SIZE, b"-V")
    run("grouping", b"lentray-grouping", scene, b"+W40", b"+H20", b"Lens_Pixels=4")
    if shutil.which("povray"):
        run("diff", b"lentray-diff", scene, *SIZE, b"--json=diff.json", b"--output=diff-" + name)
        json.loads(run.read(b"diff.json").decode())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=tools.BIN)
    binaries = parser.parse_args().bin.resolve()
    check = tools.Checks()
    with tempfile.TemporaryDirectory() as temporary:
        run = Programs(check, binaries, temporary)
        for folder, text in ((b"sc", SCENE), (b"bad", SCENE + "sphere { 0, 1 pigmnt { rgb 1 } }\n")):
            os.mkdir(run.path(folder))
            for name in NAMES:
                with open(run.path(folder, name + b".pov"), "w") as file:
                    file.write(text)
        renderer(check, run, NAMES)
        batch(check, run, NAMES)
        others(check, run)
    check.end()


if __name__ == "__main__":
    main()
