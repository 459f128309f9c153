"""Every scene of Debian's povray-examples, read by stock POV-Ray and by lentray.

  tests/compat/parse_scenes.py                 the table; exit status 1 if the two disagree
  tests/compat/parse_scenes.py language        those whose path contains a word

A scene that stock renders must be read by `lentray --dump`, which must print JSON; one that stock refuses must be
refused for the same kind of reason, in the same file and line (stock may name the next). Both run live, each scene from its
own folder of a copy, at 8 x 6 pixels. A scene that stock has read and renders for longer than
--seconds counts as rendered.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = "/usr/share/doc/povray/examples"
SIZE = ["+W8", "+H6", "-D", "+WT1"]
# What both programs say in their own words: kind, stock's words, lentray's.
KINDS = [
    ("missing file", r"cannot find file|could not find|cannot open", r"(there is no|cannot find|cannot read)"),
    ("subscript", r"subscript", r"subscript|index"),
    ("undeclared", r"undeclared identifier", r"undeclared|unknown|is not declared"),
    ("syntax", r"expected but|no matching", r"expected|unexpected"),
    ("the scene's own #error", r"user error|parse halted by #error", r"#error"),
    ("time", r"longer than", r"longer than"),
]


def run(command, folder, seconds):
    """(status, output, CPU seconds) of a command that may use so many seconds of processor."""

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))

    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=log,
                                   stderr=subprocess.STDOUT, preexec_fn=limit)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read().decode(errors="replace")
    return process.returncode, text, usage.ru_utime + usage.ru_stime


def kind_of(message, column):
    for kind in KINDS:
        if re.search(kind[column], message, re.I):
            return kind[0]
    return "other: " + message


def stock_failure(text):
    """(file, line, message) of stock's error."""
    text = re.sub(r"\s*\n\s*", " ", text)
    found = re.search(r"File '([^']*)' line (\d+): (?:Parse|File|Fatal|User) ?\w* ?Error: (.*?)"
                      r"(?: Fatal error|$)", text) or \
        re.search(r"File '([^']*)' line (\d+): (.*?)(?: Fatal error|$)", text)
    if found:
        return pathlib.Path(found.group(1)).name, int(found.group(2)), found.group(3)
    return "", 0, text[-300:]


def lentray_failure(text):
    for line in text.splitlines():
        found = re.search(r"([\w.]+\.(?:pov|inc|map)):(\d+):\d+: error: (.*)", line)
        if found:
            return found.group(1), int(found.group(2)), found.group(3)
    return "", 0, text[-300:]


def lentray(args, scene, work):
    """(exit status, what lentray does)"""
    where = (work / "lentray" / scene).parent
    with tempfile.TemporaryFile() as dump:
        try:
            done = subprocess.run([args.bin / "lentray", f"+I{scene.name}", *SIZE, "--dump", "-GD"],
                                  cwd=where, stdin=subprocess.DEVNULL, stdout=dump,
                                  stderr=subprocess.PIPE, timeout=args.seconds, check=False)
        except subprocess.TimeoutExpired:
            return 1, ("", 0, f"longer than {args.seconds} s")
        if done.returncode != 0:
            return done.returncode, lentray_failure(done.stderr.decode(errors="replace"))
        dump.seek(0)
        try:
            json.load(dump)
        except ValueError as error:
            return 1, ("", 0, f"--dump prints no JSON: {error}")
    return 0, ("read",)


def examine(scene, args, work):
    """(scene, what stock does, what lentray does, do they agree)"""
    name = scene.name
    status, text, cpu = run(["povray", f"+I{name}", "-F", *SIZE], (work / "stock" / scene).parent,
                            args.seconds)
    rendered = status == 0 or (cpu >= args.seconds and "[Rendering" in text)
    stock = ("rendered",) if rendered else stock_failure(text)
    status, ours = lentray(args, scene, work)
    if rendered or status == 0:
        return scene, stock, ours, rendered and status == 0
    # Stock names the line that it has read to, which may be the next.
    same = stock[0] == ours[0] and stock[1] - ours[1] in (0, 1) and kind_of(stock[2], 1) == kind_of(ours[2], 2)
    return scene, stock, ours, same


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--examples", type=pathlib.Path, default=pathlib.Path(EXAMPLES))
    parser.add_argument("--seconds", type=int, default=120, help="processor seconds a scene may take")
    parser.add_argument("--jobs", type=int, default=1, help="scenes at a time")
    parser.add_argument("words", nargs="*", help="only scenes whose path contains one of these")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    return args


def told(result):
    return result[0] if len(result) == 1 else f"{result[0]}:{result[1]}: {result[2]}"


def main():
    args = arguments()
    scenes = sorted(p.relative_to(args.examples) for p in args.examples.rglob("*.pov"))
    if args.words:
        scenes = [s for s in scenes if any(w in str(s) for w in args.words)]
    if not scenes:
        sys.exit(f"no scenes in {args.examples}")
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as temporary:
        work = pathlib.Path(temporary)
        for tree in ("stock", "lentray"):
            shutil.copytree(args.examples, work / tree)
            for part in (work / tree).rglob("*"):
                part.chmod(part.stat().st_mode | 0o200)
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for scene, stock, ours, same in pool.map(lambda s: examine(s, args, work), scenes):
                counts[(len(stock) == 1, len(ours) == 1, same)] += 1
                if len(stock) == 1 and same:
                    continue
                print(f"{scene}: {'the same' if same else 'DIFFERENT'}\n  stock:   {told(stock)}"
                      f"\n  lentray: {told(ours)}", flush=True)
    rendered = sum(n for k, n in counts.items() if k[0])
    agreed = counts[(False, False, True)]
    print(f"{len(scenes)} scenes; stock renders {rendered}, lentray reads "
          f"{counts[(True, True, True)]} of them; stock refuses {len(scenes) - rendered}, lentray "
          f"refuses {agreed} of them for the same reason in the same line")
    sys.exit(0 if all(k[2] for k in counts) else 1)


if __name__ == "__main__":
    main()
