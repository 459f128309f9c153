#!/usr/bin/env python3
"""What lentray-chart promises, on example scenes of POV-Ray: exact settings have no error, a setting that is chosen for a
budget keeps to it when it is run anew, and none that was measured within the budget has less error.

  tests/chart/promises.py [--bin build/release/bin] [--folder DIR] [--only exact|budgets] [--write]

--write puts the tables into docs/accuracy.md. The exit status is 0 if all holds, 1 if not, 77 without povray-examples.
"""
import argparse
import csv
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SHEET = ["Declare=Lenticular_Camera=1", "+W150", "+H150"]
SMALL = ["+W96", "+H72"]
EXACT = [("scenes/spd_balls.pov", SHEET), ("scenes/spd_gears.pov", SHEET)] + [
    (f"{name}.pov", SMALL) for name in ("advanced/woodbox", "camera/focalblur", "interior/fog_std", "interior/iortest",
                                        "interior/media/media1", "lights/arealit2", "objects/csg/granite", "objects/lathe1a")]
BUDGETS = [("scenes/spd_balls.pov", SHEET, 0.5), ("advanced/woodbox.pov", SMALL, 0.8), ("camera/focalblur.pov", SMALL, 0.6),
           ("interior/iortest.pov", SMALL, 0.4), ("interior/media/media1.pov", SMALL, 0.5)]


def path_of(name):
    return ROOT / name if name.startswith("scenes/") else EXAMPLES / name


def chart(args, folder, name, options):
    out = folder / name.replace("/", "-").removesuffix(".pov")
    done = subprocess.run([args.bin / "lentray-chart", path_of(name), "--out", out, "--no-stock", *options], cwd=folder,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(f"lentray-chart fails on {name}: {done.returncode}, {done.stderr}")
    with open(out / "chart.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file)), done


def exact(args, folder):
    """Rows of the table, and whether all is equal."""
    lines, holds = [], True
    for name, options in EXACT:
        rows, done = chart(args, folder, name, [*options, "--only", "exact", "--repeats", "2", "--reference-limit", "2s"])
        others = [r for r in rows if r["id"] != "plain"]
        failed = [r["id"] for r in rows if r["state"] != "done"]
        largest = max(float(r["from_plain_largest"] or "nan") for r in others) if others else float("nan")
        holds = holds and done.returncode == 0 and not failed and len(others) >= 10 and largest == 0
        times = sorted((float(r["cpu_s"]), r["label"]) for r in rows if r["cpu_s"])
        lines.append(f"| {name.removesuffix('.pov')} | {len(others)} | {largest:g} | {times[0][0]:.3g} s: {times[0][1]} "
                     f"| {times[-1][0]:.3g} s: {times[-1][1]} |")
        print(lines[-1], *failed, flush=True)
    head = ["| scene | exact settings | largest difference | fastest | slowest |", "|---|---|---|---|---|"]
    return head + lines, holds


def seconds(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def budgets(args, folder):
    lines, holds = [], True
    for name, options, budget in BUDGETS:
        rows, done = chart(args, folder, name, [*options, "--quick", "--reference-limit", "15s", "--budget", f"{budget}s"])
        said = done.stdout.splitlines()
        picked = [said[i + 1].strip() for i, line in enumerate(said) if line.startswith("within ")]
        row = [r for r in rows if [r["command"]] == picked]
        if done.returncode != 0 or len(row) != 1:
            sys.exit(f"no choice for {name}: {done.stdout}{done.stderr}")
        command = shlex.split(picked[0])
        taken = seconds([args.bin / "lentray", *command[1:], "+Oanew.png", "-V"], folder)
        error = float(row[0]["rms"])
        # Another lens model is another picture, measured against its own reference, and is not chosen.
        less = [r["id"] for r in rows if r["rms"] and not r["id"].startswith("lens-") and float(r["cpu_s"]) <= budget
                and float(r["rms"]) < error]
        holds = holds and taken <= 1.1 * budget and not less
        lines.append(f"| {name.removesuffix('.pov')} | {budget} s | {len(rows)} | {row[0]['label']} | {error:.3g}/255 "
                     f"| {taken:.2f} s | {taken / budget:.2f} | {len(less)} |")
        print(lines[-1], *less, flush=True)
    head = ["| scene | budget | settings | chosen | error | CPU, run anew | of the budget | within it with less error |",
            "|---|---|---|---|---|---|---|---|"]
    return head + lines, holds


def write(name, lines):
    page = ROOT / "docs/accuracy.md"
    text = page.read_text(encoding="utf-8")
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    head, rest = text.split(begin)
    page.write_text(head + begin + "\n".join(lines) + "\n" + end + rest.split(end)[1], encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=lambda text: pathlib.Path(text).resolve(), default=ROOT / "build/release/bin")
    parser.add_argument("--folder", type=pathlib.Path, help="where the charts stay")
    parser.add_argument("--only", choices=["exact", "budgets"])
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    if not EXAMPLES.is_dir():
        print("left out: povray-examples is not installed")
        sys.exit(77)
    holds = True
    with tempfile.TemporaryDirectory() as place:
        folder = args.folder.resolve() if args.folder else pathlib.Path(place)
        folder.mkdir(parents=True, exist_ok=True)
        for name, tables in (("exact", exact), ("budgets", budgets)):
            if args.only in (None, name):
                lines, does = tables(args, folder)
                holds = holds and does
                if args.write:
                    write(name, lines)
    sys.exit(0 if holds else 1)


if __name__ == "__main__":
    main()
