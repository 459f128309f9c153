#!/usr/bin/env python3
"""What pixel order and shadow cache bring on ten of POV-Ray's example scenes, as lens sheets: counts and times of
lentray-grouping, with charts in build/grouping/index.html.

  tests/bench/grouping_examples.py [--bin build/release/bin] [--repeats 5] [--write]

--write puts the table into docs/paper.md. The exit status is 1 if a picture differs or a scene fails.
"""
import argparse
import csv
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SCENES = """advanced/woodbox advanced/isocacti advanced/biscuit advanced/glasschess/glasschess advanced/landscape
camera/focalblur interior/iortest lights/arealit2 objects/chesmsh objects/csg/granite""".split()
MARKS = "<!-- grouping examples: begin -->\n", "<!-- grouping examples: end -->"


def measured(args, folder):
    folder.mkdir(parents=True, exist_ok=True)
    command = [args.bin / "lentray-grouping", *(EXAMPLES / f"{name}.pov" for name in SCENES), "Lenticular=On", "+W150", "+H110", "-A",
               "--orders", "rows,columns,hilbert,auto", "--caches", "off,last,auto", "--accelerators", "bvh,buffer",
               "--repeats", str(args.repeats), "--csv", folder / "table.csv", "--html", folder / "index.html"]
    done = subprocess.run(command, check=False)
    with open(folder / "table.csv", encoding="utf-8", newline="") as file:
        return done.returncode, list(csv.DictReader(file))


def line(name, rows):
    def of(order, cache, accelerator):
        return next(r for r in rows if (r["order"], r["cache"], r["accelerator"]) == (order, cache, accelerator))

    def saved(key, base, other):
        before = float(base[key])
        return f"{100 * (before - float(other[key])) / before:.1f} %" if before else "-"

    base = of("rows", "off", "bvh")
    best = min((r for r in rows if r["accelerator"] == "bvh"), key=lambda r: float(r["tests"]))
    cells = [name, base["shadow_rays"], f"{100 * float(base['blocked']) / max(1, float(base['shadow_rays'])):.0f} %",
             *(f"{100 * float(of(order, cache, 'bvh')['hits_of_blocked']):.1f} %"
               for order, cache in (("rows", "last"), ("columns", "last"), ("auto", "auto"))),
             saved("tests", base, of("rows", "last", "bvh")), saved("tests", base, of("columns", "last", "bvh")),
             saved("tests", base, of("auto", "auto", "bvh")), f"{best['order']}, {best['cache']}",
             saved("cpu_s", base, of("auto", "auto", "bvh")), saved("cpu_s", base, of("auto", "auto", "buffer"))]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    status, rows = measured(args, ROOT / "build/grouping")
    lines = ["| scene | shadow rays | blocked | hits of blocked: `last`, rows | `last`, columns | `auto`, `auto` "
             "| tests saved: `last`, rows | `last`, columns | `auto`, `auto` | fewest tests | time saved: `auto`, `auto` "
             "| with light buffers |", "|" + "---|" * 12]
    for name in SCENES:
        lines.append(line(name, [r for r in rows if r["scene"] == str(EXAMPLES / f"{name}.pov")]))
    print("\n".join(lines))
    if args.write:
        page = ROOT / "docs/paper.md"
        head, rest = page.read_text(encoding="utf-8").split(MARKS[0])
        page.write_text(head + MARKS[0] + "\n".join(lines) + "\n" + MARKS[1] + rest.split(MARKS[1])[1], encoding="utf-8")
    sys.exit(status)


if __name__ == "__main__":
    main()
