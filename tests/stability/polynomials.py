"""Every polynomial solver side by side: speed against accuracy, and what each misses.

  tests/stability/polynomials.py [--bin FOLDER] [--count 60] [--rounds 9] [--csv FILE]

Runs lentray-polynomials, draws docs/stability/polynomials.png and docs/stability/gaps.png and prints
the table of docs/stability/tables.md. Times are the least of some rounds in which the solvers take turns.
"""
import argparse
import collections
import csv
import io
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs" / "stability"
NAMES = {"closed": "closed form", "polished": "closed form + Newton", "sturm": "Sturm chain",
         "simultaneous": "all at once (Aberth)", "lentray": "lentray"}
COLOURS = {"closed": "#999999", "polished": "#e69f00", "sturm": "#0072b2",
           "simultaneous": "#009e73", "lentray": "#d00000"}
SPREAD = ("simple", "wide", "coefficients")
ORDERS = range(2, 16)

HEAD = """set terminal pngcairo enhanced size 1150,520 font 'Sans,10' background rgb 'white'
set output 'chart'
set encoding utf8
set tics nomirror
set grid lc rgb '#e4e4e4'
set multiplot layout 1,2
"""


def gnuplot(script, data, path):
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "data").write_text(data)
        (where / "script").write_text(script)
        subprocess.run(["gnuplot", "script"], cwd=where, check=True)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes((where / "chart").read_bytes())


def wrong_share(rows):
    """Of the roots: missed and invented ones that rounding does not excuse."""
    roots = sum(int(r["roots"]) for r in rows)
    return sum(int(r["missed"]) + int(r["invented"]) for r in rows) / max(1, roots)


def of(rows, solver, order, kinds):
    return [r for r in rows if r["solver"] == solver and int(r["order"]) == order and
            any(r["kind"].startswith(k) for k in kinds)]


def worst(rows, field):
    return max(float(r[field]) for r in rows)


def mean_ns(rows):
    return sum(float(r["ns"]) for r in rows) / len(rows)


def draw_speed(rows, path):
    """Left: time against the error beyond the coefficients' own. Right: against wrong roots."""
    blocks = []
    for solver in NAMES:
        lines = []
        for order in ORDERS:
            chosen = of(rows, solver, order, SPREAD)
            if chosen:
                lines.append(f"{mean_ns(chosen) / 1000:.4g} {max(worst(chosen, 'excess'), 0.1):.4g} "
                             f"{100 * max(wrong_share(chosen), 3e-4):.4g} {order}")
        blocks.append("\n".join(lines))
    script = HEAD + """set logscale xy
set format y '10^{%L}'
set xlabel 'microseconds a polynomial'
set key left center reverse Left
set title 'error, in units of one rounding of the coefficients (99th percentile)'
set yrange [0.1:*]
"""
    def plots(column):
        parts = []
        for i, solver in enumerate(NAMES):
            style = f"lc rgb '{COLOURS[solver]}'"
            parts.append(f"'data' index {i} using 1:{column} with linespoints pt 7 ps 0.5 {style} "
                         f"title '{NAMES[solver]}'")
            parts.append(f"'data' index {i} using 1:{column}:4 with labels font ',7' offset 0.6,0.5 "
                         f"tc rgb '{COLOURS[solver]}' notitle")
        return "plot " + ", ".join(parts) + "\n"

    script += plots(2)
    script += ("set title 'roots missed or invented, % (lowest line: none)'\nunset key\n"
               "set format y '%g'\nset yrange [0.02:100]\n")
    gnuplot(script + plots(3), "\n\n\n".join(blocks) + "\n", path)


def draw_gaps(rows, path):
    kinds = [k for k in dict.fromkeys(r["kind"] for r in rows) if k.startswith("gap")] + ["double"]
    blocks = []
    for solver in NAMES:
        lines = []
        for i, kind in enumerate(kinds):
            chosen = [r for r in rows if r["solver"] == solver and r["kind"] == kind and
                      int(r["order"]) <= 4]
            more = [r for r in rows if r["solver"] == solver and r["kind"] == kind and int(r["order"]) > 4]
            lines.append(f"{i} {100 * wrong_share(chosen):.4g} "
                         f"{100 * wrong_share(more):.4g}" if more else f"{i} {100 * wrong_share(chosen):.4g} NaN")
        blocks.append("\n".join(lines))
    tics = ", ".join(f'"{k.replace("gap ", "")}" {i}' for i, k in enumerate(kinds))
    script = HEAD + f"""set xtics ({tics}) rotate by 30 right
set xlabel 'gap between two of the roots'
set ylabel '%'
set key left center reverse Left
set xrange [-0.3:{len(kinds)} - 0.7]
set title 'roots missed or invented that rounding does not excuse, orders 2 to 4'
"""

    def plots(column, solvers):
        return "plot " + ", ".join(
            f"'data' index {i} using 1:{column} with linespoints pt 7 ps 0.6 lw 2 "
            f"lc rgb '{COLOURS[s]}' title '{NAMES[s]}'" for i, s in enumerate(NAMES) if s in solvers) + "\n"

    script += plots(2, NAMES)
    script += "set title 'the same, orders 5 to 15'\n" + plots(3, ("sturm", "simultaneous", "lentray"))
    gnuplot(script, "\n\n\n".join(blocks) + "\n", path)


def table(rows):
    lines = ["| order | solver | time, lentray = 1 | error, median | error, largest | times rounding | "
             "missed | invented | of roots |", "|---|---|---|---|---|---|---|---|---|"]
    for low, high in ((2, 2), (3, 3), (4, 4), (5, 7), (8, 11), (12, 15)):
        group = [r for r in rows if low <= int(r["order"]) <= high]
        times = collections.defaultdict(float)
        for r in group:
            times[r["solver"]] += float(r["ns"])
        for solver in NAMES:
            own = [r for r in group if r["solver"] == solver]
            if not own:
                continue
            spread = [r for r in own if r["kind"] in SPREAD]
            medians = sorted(float(r["median"]) for r in spread)
            count = {f: sum(int(r[f]) for r in own) for f in ("missed", "invented", "roots")}
            name = str(low) if low == high else f"{low} to {high}"
            lines.append(f"| {name} | {NAMES[solver]} | {times[solver] / times['lentray']:.2f} | "
                         f"{medians[len(medians) // 2]:.0e} | {worst(spread, 'largest'):.0e} | "
                         f"{worst(own, 'excess'):.2g} | {count['missed']} | {count['invented']} | "
                         f"{count['roots']} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--csv", type=pathlib.Path, help="where the figures go as well")
    args = parser.parse_args()
    done = subprocess.run([args.bin / "lentray-polynomials", str(args.count), str(args.rounds)],
                          capture_output=True, text=True, check=True)
    if args.csv:
        args.csv.write_text(done.stdout)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    draw_speed(rows, DOCS / "polynomials.png")
    draw_gaps(rows, DOCS / "gaps.png")
    print(table(rows))


if __name__ == "__main__":
    main()
