"""Every scene of Debian's povray-examples, rendered by stock POV-Ray and by lentray and compared.

  tests/compat/scenes.py                       all scenes; writes docs/scenes.md and docs/scenes.json
  tests/compat/scenes.py --no-docs advanced    those whose path contains a word
  tests/compat/scenes.py --no-docs --json a.json advanced       a part; then --read a.json b.json ...
  tests/compat/scenes.py --no-docs --list tests/compat/scenes_that_match.txt --grade match

Both render live, as the scenes lie: each from its own folder (of a copy, for scenes write files),
160 x 120, no antialiasing, one thread, no switch but size and output. The pictures are compared by
lentray-diff (docs/compare.md). With --grade the exit status is 1 unless every scene that stock
renders reaches that grade. --update-list writes the list of those that match or are better.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = "/usr/share/doc/povray/examples"
MATCH_LIST = ROOT / "tests" / "compat" / "scenes_that_match.txt"
WIDTH, HEIGHT = 160, 120
GRADES = ["exact", "match", "close", "differs", "fails"]
LEFT_OUT = "not rendered yet, left out of the picture: "


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


def reason(status, text, cpu, seconds):
    """One line on why a program failed."""
    if cpu >= seconds:
        return f"longer than {seconds} s"
    if status < 0:
        return f"ended by signal {-status}"
    for line in text.splitlines():
        found = re.search(r"(?:error: |Parse Error: )(.*)", line)
        if found:
            return found.group(1).strip()
    return f"exit status {status}"


def render(program, tree, scene, picture, seconds):
    """None if the picture is there, else why not; what the program said; its CPU seconds."""
    where = tree / scene
    command = [program, f"+I{where.name}", f"+O{picture}", f"+W{WIDTH}", f"+H{HEIGHT}", "-A", "-D",
               "+WT1"]
    status, text, cpu = run(command, where.parent, seconds)
    failed = status != 0 or not picture.is_file()
    return (reason(status, text, cpu, seconds) if failed else None), text, cpu


def left_out(text):
    """What lentray says that it left out of the picture."""
    names = []
    for line in text.splitlines():
        if LEFT_OUT in line:
            names += [n.strip() for n in line.split(LEFT_OUT, 1)[1].split(",")]
    return sorted(set(names))


def compare(binaries, ours, stock, folder):
    figures = folder / (ours.stem + ".json")
    done = subprocess.run([binaries / "lentray-diff", ours, stock, "--no-pictures", "--json",
                           figures], capture_output=True, text=True, check=False)
    if done.returncode == 2 or not figures.is_file():
        return {"grade": "fails", "note": (done.stdout + done.stderr).strip()[-200:]}
    whole = json.loads(figures.read_text())["whole"]
    return {"grade": "differs" if whole["grade"] == "fails" else whole["grade"],
            "psnr": whole["psnr"], "beyond_1": whole["beyond_1"]}


def examine(scene, args, work):
    """The row of one scene."""
    name = str(scene).replace("/", "__")[:-4] + ".png"
    reference = work / "stock" / name
    note = work / "stock" / (name + ".failed")
    row = {"scene": str(scene)}
    if not args.reuse or not (reference.is_file() or note.is_file()):
        # Stock has more time: what it cannot render is no measure.
        why, _, row["stock_cpu_s"] = render("povray", work / "tree_stock", scene, reference,
                                            5 * args.seconds)
        if why:
            reference.unlink(missing_ok=True)
            note.write_text(why)
    if note.is_file():
        return row | {"grade": None, "note": note.read_text()}
    ours = work / "lentray" / name
    ours.unlink(missing_ok=True)
    why, text, row["lentray_cpu_s"] = render(args.bin / "lentray", work / "tree_lentray", scene,
                                             ours, args.seconds)
    row["left_out"] = left_out(text)
    if why:
        return row | {"grade": "fails", "note": why}
    return row | compare(args.bin, ours, reference, work / "lentray")


def examine_all(scenes, args, work):
    for folder in ("stock", "lentray"):
        (work / folder).mkdir(exist_ok=True)
    for tree in ("tree_stock", "tree_lentray"):
        if not (work / tree).is_dir():
            shutil.copytree(args.examples, work / tree)
            for part in (work / tree).rglob("*"):
                part.chmod(part.stat().st_mode | 0o200)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for row in pool.map(lambda s: examine(s, args, work), scenes):
            rows.append(row)
            print(line(row), flush=True)
    return rows


def decibels(row):
    psnr = row.get("psnr")
    if "psnr" not in row:
        return ""
    return "equal" if psnr is None or math.isinf(psnr) else f"{psnr:.1f}"


def line(row):
    beyond = f"{100 * row['beyond_1']:.2f} %" if "beyond_1" in row else ""
    said = ", ".join(row.get("left_out", [])) or row.get("note", "")
    grade = row["grade"] or "(stock fails)"
    return f"{grade:<13} {decibels(row):>6} {beyond:>9}  {row['scene']}  {said}"


def stock_version():
    text = subprocess.run(["povray", "--version"], capture_output=True, text=True, check=False)
    found = re.search(r"POV-Ray (\S+)", text.stdout + text.stderr)
    return found.group(1) if found else "?"


def table(rows):
    """docs/scenes.md."""
    compared = [r for r in rows if r["grade"]]
    counts = collections.Counter(r["grade"] for r in compared)
    lacking = collections.Counter(n for r in compared for n in r.get("left_out", []))
    text = ["# Existing scenes", "",
            "Written by `python3 tests/compat/scenes.py`; do not edit. Every scene of Debian's",
            "`povray-examples`, as it lies and through its own camera, "
            f"{WIDTH} x {HEIGHT} without antialiasing,",
            f"rendered by stock POV-Ray {stock_version()} and by lentray in the same run. Grades:",
            "[compare.md](compare.md); *differs* is short of close, *fails* means no picture. ",
            f"Stock renders {len(compared)} of the {len(rows)} scenes as they lie; the others "
            "(named at the end) need a file that", "is not there, or are parts of a scene.", "",
            "| grade | scenes |", "|---|---:|"]
    text += [f"| {g} | {counts[g]} |" for g in GRADES]
    if lacking:
        text += ["", "What lentray does not render yet, and says so, by the number of scenes that "
                 "use it:", "", "| | scenes |", "|---|---:|"]
        text += [f"| {n} | {c} |" for n, c in sorted(lacking.items(), key=lambda p: (-p[1], p[0]))]
    text += ["", "Beyond: share of the pixels that differ by more than 1/255.", "",
             "| scene | grade | PSNR dB | beyond | not rendered yet |", "|---|---|---:|---:|---|"]
    for row in sorted(compared, key=lambda r: r["scene"]):
        beyond = f"{100 * row['beyond_1']:.2f} %" if "beyond_1" in row else ""
        said = ", ".join(row.get("left_out", [])) or row.get("note", "").replace("|", "/")
        text.append(f"| {row['scene']} | {row['grade']} | {decibels(row)} | {beyond} | {said} |")
    text += ["", "Stock does not render: " +
             ", ".join(sorted(r["scene"] for r in rows if not r["grade"])) + "."]
    return "\n".join(text) + "\n"


def json_row(row):
    """Without what changes from run to run."""
    row = {k: v for k, v in row.items() if not k.endswith("_cpu_s")}
    for key, digits in (("psnr", 2), ("beyond_1", 6)):
        if row.get(key) is not None and key in row:
            row[key] = round(row[key], digits)
    return row


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--examples", type=pathlib.Path, default=pathlib.Path(EXAMPLES))
    parser.add_argument("--seconds", type=int, default=60,
                        help="processor seconds a scene may take (stock: five times as many)")
    parser.add_argument("--jobs", type=int, default=1, help="scenes at a time")
    parser.add_argument("--list", type=pathlib.Path, help="only the scenes named in this file")
    parser.add_argument("--grade", choices=GRADES[:3], help="what every scene must reach")
    parser.add_argument("--no-docs", action="store_true", help="do not write docs/")
    parser.add_argument("--update-list", action="store_true", help=f"write {MATCH_LIST.name}")
    parser.add_argument("--json", type=pathlib.Path, help="figures and times of this run")
    parser.add_argument("--read", type=pathlib.Path, nargs="+",
                        help="figures of earlier runs (--json) of parts, joined; nothing is run")
    parser.add_argument("--keep", type=pathlib.Path, help="pictures stay in this folder")
    parser.add_argument("--reuse", action="store_true",
                        help="for developing: take stock's pictures that --keep left")
    parser.add_argument("words", nargs="*", help="only scenes whose path contains one of these")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    return args


def main():
    args = arguments()
    scenes = sorted(p.relative_to(args.examples) for p in args.examples.rglob("*.pov"))
    if args.list:
        listed = {n for n in args.list.read_text().split("\n") if n and not n.startswith("#")}
        missing = listed - {str(s) for s in scenes}
        if missing:
            sys.exit(f"listed, but not among the examples: {', '.join(sorted(missing))}")
        scenes = [s for s in scenes if str(s) in listed]
    if args.words:
        scenes = [s for s in scenes if any(w in str(s) for w in args.words)]
    if not scenes:
        sys.exit(f"no scenes in {args.examples}")
    if args.read:
        # Of a scene that was run twice the last.
        known = {row["scene"]: row for path in args.read for row in json.loads(path.read_text())}
        rows = [known[str(s)] for s in scenes if str(s) in known]
    elif args.keep:
        args.keep.mkdir(parents=True, exist_ok=True)
        rows = examine_all(scenes, args, args.keep.resolve())
    else:
        with tempfile.TemporaryDirectory() as temporary:
            rows = examine_all(scenes, args, pathlib.Path(temporary))
    counts = collections.Counter(r["grade"] or "stock fails" for r in rows)
    print(", ".join(f"{counts[g]} {g}" for g in GRADES + ["stock fails"]))
    if args.json:
        args.json.write_text(json.dumps(rows, indent=1) + "\n")
    if not args.no_docs:
        (ROOT / "docs" / "scenes.md").write_text(table(rows))
        (ROOT / "docs" / "scenes.json").write_text(
            "[\n" + ",\n".join(json.dumps(json_row(r)) for r in rows) + "\n]\n")
    if args.update_list:
        MATCH_LIST.write_text("# Written by scenes.py --update-list: match or better.\n" + "".join(
            r["scene"] + "\n" for r in rows if r["grade"] in ("exact", "match")))
    if args.grade:
        short = [r["scene"] for r in rows
                 if not r["grade"] or GRADES.index(r["grade"]) > GRADES.index(args.grade)]
        if short:
            sys.exit(f"short of {args.grade}: {', '.join(short)}")


if __name__ == "__main__":
    main()
