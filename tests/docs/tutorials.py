#!/usr/bin/env python3
"""Runs the commands of docs/tutorial-print.md, -jobs.md, -flip.md and -display.md as they stand there, one after another in an
empty folder, and looks at what they leave.

    tutorials.py [--bin build/release/bin] [--full] [word ...]

Pictures are smaller than on the pages, unless --full. With words only the pages whose name has one. Of the commands that
fetch and build, what they name must exist; the programs are those of --bin.
"""
import argparse
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))

import pictures  # noqa: E402

MOST_COMMANDS = 5  # from nothing to the page to print
MOST_PICTURE = 100_000  # bytes
# Options of the pages and smaller ones. Each must be on a page, or it is out of date.
SMALLER = {
    "Print_DPI=600": "Print_DPI=200", "Print_DPI=720": "Print_DPI=120", "+A0.1": "-A", "+W1200": "+W240", "+H900": "+H180", "Quilt=portrait":
    "Quilt=portrait Quilt_Tile=21x28", "Quilt_Tile=400x300": "Quilt_Tile=40x30", "View_Size=400x300": "View_Size=80x60",
}


class Wrong(Exception):
    """What is not as a page says."""


def expect(is_so, what):
    if not is_so:
        raise Wrong(what)


def commands_of(page):
    """The lines of its code blocks, joined where they end in a backslash."""
    lines = re.findall(r"^    (\S.*|  +\S.*)$", page.read_text(encoding="utf-8"), re.M)
    return [line.strip() for line in re.sub(r"\s*\\\n\s*", " ", "\n".join(lines)).split("\n")]


def check_links(page):
    """Pages, parts of pages and pictures that it names."""
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)]+)\)", text):
        name, _, part = target.partition("#")
        if "://" in name:
            continue
        file = page.parent / name if name else page
        expect(file.exists(), f"{page.name}: there is no {name}")
        if file.suffix == ".png":
            expect(file.stat().st_size < MOST_PICTURE, f"{name}: {file.stat().st_size} bytes")
        if part:
            heads = re.findall(r"^#+ (.*)$", file.read_text(encoding="utf-8"), re.M)
            anchors = [re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads]
            expect(part in anchors, f"{page.name}: {name} has no part #{part}")


def check_fetching(command):
    """What the commands that fetch and build name."""
    words = shlex.split(command)
    if words[:2] == ["git", "clone"]:
        expect(words[3:] == ["lentray", "&&", "cd", "lentray"], f"'{command}': into a folder, and there")
        return
    for part in command.split("&&"):
        words = shlex.split(part)
        if words[0].startswith("tools/"):
            expect(os.access(ROOT / words[0], os.X_OK), f"there is no {words[0]}")
        elif words[0] == "cmake":
            presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
            kind = "buildPresets" if "--build" in words else "configurePresets"
            names = [preset["name"] for preset in presets[kind]]
            expect(words[words.index("--preset") + 1] in names, f"'{part}': there are {names}")
            for target in words[words.index("--target") + 1:] if "--target" in words else []:
                expect((ROOT / "tools" / target / "main.cpp").exists(), f"there is no program {target}")
        else:
            expect(words == ["PATH=$PWD/build/release/bin:$PATH"], f"'{part}' is not known here")


class Tutorial:
    """A folder in which the commands of a page run."""

    def __init__(self, folder, binaries, is_full):
        self.folder, self.is_full, self.used = folder, is_full, set()
        self.environment = {**os.environ, "PATH": f"{binaries}:{os.environ['PATH']}", "HOME": str(folder)}
        (folder / "scenes").symlink_to(ROOT / "scenes")

    def smaller(self, command):
        if self.is_full:
            return command
        words = command.split(" ")
        self.used.update(word for word in words if word in SMALLER)
        return " ".join(SMALLER.get(word, word) for word in words)

    def run(self, command):
        """What it says; its status must be 0."""
        run = subprocess.run(["bash", "-c", self.smaller(command)], cwd=self.folder, env=self.environment, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        expect(run.returncode == 0, f"'{command}' has status {run.returncode}: {run.stdout[-600:]}")
        return run.stdout

    def run_page(self, page):
        """What each command says, by command."""
        told = {}
        for command in commands_of(page):
            if command.startswith(("git ", "tools/")):
                check_fetching(command)
                told[command] = ""
            else:
                expect(command.startswith(("lentray ", "lentray-")), f"{page.name}: '{command}' is no command")
                told[command] = self.run(command)
        return told

    def size(self, name):
        """Width and height of a PNG or GIF file."""
        head = (self.folder / name).read_bytes()[:24]
        if head.startswith(b"GIF89a"):
            return struct.unpack("<HH", head[6:10])
        expect(head.startswith(b"\x89PNG"), f"{name} is no PNG")
        return struct.unpack(">II", head[16:24])


def brightness_of(file):
    """The mean of a PNG file's samples."""
    samples = [value for row in pictures.read_png(file.read_bytes())[0] for pixel in row for value in pixel]
    return sum(samples) / len(samples)


def said_by(told, *words):
    """What the command that has these words said."""
    found = [text for command, text in told.items() if all(word in command for word in words)]
    expect(len(found) == 1, f"{len(found)} commands with {words}")
    return found[0]


def check_pdf(file):
    if not shutil.which("pdfinfo"):
        return
    told = subprocess.run(["pdfinfo", file], text=True, capture_output=True, check=True).stdout
    size = re.search(r"Page size: +([\d.]+) x ([\d.]+) pts", told)
    millimetres = sorted(float(points) / 72 * 25.4 for points in size.groups())
    expect(abs(millimetres[0] - 210) < 0.01 and abs(millimetres[1] - 297) < 0.01, f"{file.name}: {told}")


def check_print(tutorial, page):
    told = tutorial.run_page(page)
    commands = list(told)
    last = next(i for i, command in enumerate(commands) if command.startswith("lentray-print sheet"))
    looks = [command for command in commands[:last] if command.startswith("lentray-views")]
    expect(last + 1 - len(looks) <= MOST_COMMANDS, f"{last + 1 - len(looks)} commands to the page: {commands}")
    text = page.read_text(encoding="utf-8")
    band = re.search(r"Here that was the band of ([\d.]+)\.", text)[1]
    report = said_by(told, "Print_LPI=")
    pitch = float(re.search(r"pitch ([\d.]+) mm", report)[1])
    expect(abs(25.4 / pitch - float(band)) < 0.005, f"strips of {25.4 / pitch} lpi, not {band}: {report}")
    expect(f"pitch {pitch:.3f} mm*" in text, f"the page names another pitch than {pitch}")
    sheet = re.search(r"Lens sheet ([\d.]+) x ([\d.]+) mm", report)
    expect(abs(float(sheet[1]) - 100) < 0.1 and abs(float(sheet[2]) - 75) < 0.1, report)
    expect("In the sheet's plane" in report and "Jumps: none" in report, report)
    for name in ("pitch.pdf", "sheet.pdf"):
        check_pdf(tutorial.folder / name)
    expect(tutorial.size("eyes.png") == (720, 270), "the two eyes' pictures")
    expect("<canvas" in (tutorial.folder / "sheet.html").read_text(encoding="utf-8"), "the preview")


def parts_of(page):
    """Its parts, each with its head."""
    return re.split(r"^(?=## )", page.read_text(encoding="utf-8"), flags=re.M)[1:]


def check_flip(tutorial, page):
    told = tutorial.run_page(page)
    for part in parts_of(page):
        commands = [line for line in re.findall(r"^    (lentray\S* )", part, re.M)]
        if "lentray-print " in commands:
            to_page = commands.index("lentray-print ") + 1
            expect(to_page <= MOST_COMMANDS, f"{to_page} commands to the page: {part[:60]}")
    text = page.read_text(encoding="utf-8")
    report = said_by(told, "day.png night.png")
    expect("'day.png', is seen from below, the last, 'night.png', from above" in report, report)
    expect("lower edge turns away" in report and "lower edge turns away" in " ".join(text.split()), report)
    for name in ("flip.pdf", "phases.pdf"):
        check_pdf(tutorial.folder / name)
    wiggle = said_by(told, "--wiggle")
    views = re.search(r"(\d+) frames of 640 x 480 pixels", wiggle)
    expect(views, wiggle)
    if tutorial.is_full:
        expect(int(views[1]) == 15, wiggle)
    expect("<canvas" in (tutorial.folder / "flip.html").read_text(encoding="utf-8"), "the preview")
    # An eye below sees day, one above night.
    for seen, picture in (("below.png", "day.png"), ("above.png", "night.png")):
        ours, theirs = (brightness_of(tutorial.folder / name) for name in (seen, picture))
        expect(abs(ours - theirs) < 0.05 * theirs, f"{seen}: {ours}, {picture}: {theirs}")


def check_jobs(tutorial, page):
    told = tutorial.run_page(page)
    for part in parts_of(page):
        count = len(re.findall(r"^    lentray", part, re.M))
        expect(0 < count <= MOST_COMMANDS, f"{count} commands: {part[:60]}")
    for name in ("mill", "teapot", "glass"):
        report = said_by(told, f"+O{name}.png")
        expect("Jumps: none" in report and "warning: cut" not in report, report)
        expect("<canvas" in (tutorial.folder / f"{name}.html").read_text(encoding="utf-8"), "the preview")
        check_pdf(tutorial.folder / f"{name}.pdf")
    width, height = tutorial.size("mill.png")
    expect(abs(width / height - 148 / 210) < 0.01, f"A5: {width} x {height}")
    listed = said_by(told, "demo.pov", "--depth")
    expect("sphere at scenes/demo.pov:121:1: " in listed, listed)
    # Killed, and given again: it goes on.
    batch = next(command for command in told if command.startswith("lentray-batch"))
    pictures_there = list((tutorial.folder / "sheets").glob("*.png"))
    expect(len(pictures_there) == 10, f"{len(pictures_there)} pictures")
    for picture in pictures_there[3:]:
        picture.unlink()
    again = subprocess.Popen(["bash", "-c", "exec " + tutorial.smaller(batch)], cwd=tutorial.folder,
                             env=tutorial.environment, stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT)
    time.sleep(1)
    again.kill()
    again.wait()
    tutorial.run(batch)
    expect(len(list((tutorial.folder / "sheets").glob("*.png"))) == 10, "pictures after a kill")
    quilt = said_by(told, "Quilt=portrait", "Depth=print")
    expect("In the sheet's plane" in quilt and "Jumps: none" in quilt, quilt)
    width, height = tutorial.size("mill.gif")
    expect(abs(width / height - 0.75) < 0.02, f"the quilt's preview: {width} x {height}")


def check_display(tutorial, page):
    told = tutorial.run_page(page)
    for name, size in (("demo_qs8x6a0.75.png", (3360, 3360)), ("demo_qs5x3a1.3333.png", (2000, 900))):
        expect((tutorial.folder / name).exists(), f"there is no {name}")
        if tutorial.is_full:
            expect(tutorial.size(name) == size, f"{name}: {tutorial.size(name)}")
    # The names of the page are those that the report tells.
    for grid, end in (("Quilt=portrait", "_qs8x6a0.75"), ("Quilt=5x3", "_qs5x3a1.3333")):
        expect(end in said_by(told, grid), said_by(told, grid))
    if tutorial.is_full:
        expect("80 lenses of 15 pixels" in told["lentray-views sheet.png"], told["lentray-views sheet.png"])
    expect("of 15 pixels" in told["lentray-views sheet.png"], told["lentray-views sheet.png"])
    for name in ("sheet_qs5x3a1.33333.png", "views_qs5x3a1.3333.png"):
        width, height = tutorial.size(name)
        expect(width % 5 == 0 and height % 3 == 0, f"{name}: {width} x {height}")
    expect(tutorial.size("demo.gif") == (320, 240), "the GIF")
    expect(b"acTL" in (tutorial.folder / "demo.png").read_bytes()[:200], "the animated PNG")
    for name in ("sheet_stereo.png", "sheet_anaglyph.png", "view_stereo.png", "sheet.html"):
        expect((tutorial.folder / name).stat().st_size > 1000, f"{name} is small")
    width, height = tutorial.size("sheet_stereo.png")
    expect(abs(width / 2 / height - 4 / 3) < 0.02, f"square pixels: {width} x {height}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*", metavar="word")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--full", action="store_true")
    args = parser.parse_args()
    failed, used = 0, set()
    for name, check in (("print", check_print), ("jobs", check_jobs), ("flip", check_flip),
                        ("display", check_display)):
        if args.words and not any(word in name for word in args.words):
            continue
        page = ROOT / f"docs/tutorial-{name}.md"
        try:
            check_links(page)
            with tempfile.TemporaryDirectory() as folder:
                tutorial = Tutorial(pathlib.Path(folder), args.bin.resolve(), args.full)
                check(tutorial, page)
                used |= tutorial.used
            print(f"{page.name}: good")
        except Wrong as wrong:
            failed += 1
            print(f"{page.name}: {wrong}")
    for name in ("glossary", "print", "views"):
        try:
            check_links(ROOT / f"docs/{name}.md")
        except Wrong as wrong:
            failed += 1
            print(wrong)
    if not args.words and not args.full and used != set(SMALLER):
        failed += 1
        print(f"no page has {set(SMALLER) - used}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
