#!/usr/bin/env python3
"""Fuzzes what reads files under the address and undefined-behaviour sanitizers, one process at a time.

  tests/fuzz/fuzz.py [KIND...] [--seconds N] [--piece N]   goes on until each kind has N seconds of processor time in all
  tests/fuzz/fuzz.py --table                               what was done so far

Kinds, all unless told: scene (the parser), picture (image files), data (fonts and density files), ini (options), manifest (rows
of a batch), journal (what +C and +RFI read). An hour each unless told, in pieces of five minutes, one kind after another. The
same command goes on where the last one was stopped: build/fuzz has the corpus and the hours of each kind. Several may run at a
time, with other kinds each.

Builds preset fuzz (clang) and makes the seeds. Time is the processor's: neither what counts as too long nor what is reached
depends on what else the machine does. Memory is limited to 1 GiB as with Max_Memory; more than 2 GiB at a time, 3 GiB with what
the sanitizers keep, or 10 s for an input, is a fault. An input that is one ends its piece and is left in build/fuzz/found; what
it shows, cut short, belongs into tests/fuzz/inputs once it is mended. Status 1: there were such.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build/fuzz"
FOUND = WORK / "found"
HOURS = WORK / "hours.json"
KINDS = ("scene", "picture", "data", "ini", "manifest", "journal")
NICE = 15          # of runs
BUILD_NICE = 10
LONGEST_WAIT = 900  # seconds of the clock: an input that waits for something takes no processor time
MOST_FAULTS = 5    # of a kind in one run of this program
LEAKS = 8          # one piece in so many looks for leaks too, which makes some kinds five times slower
OPTIONS = [f"-timeout={LONGEST_WAIT}", f"-report_slow_units={LONGEST_WAIT}", "-rss_limit_mb=3072", "-malloc_limit_mb=2048",
           "-max_len=40000", "-len_control=0", "-print_final_stats=1"]


def hours():
    return json.loads(HOURS.read_text()) if HOURS.exists() else {}


def keep(all_hours):
    part = HOURS.with_suffix(".part")
    part.write_text(json.dumps(all_hours, indent=1) + "\n")
    part.replace(HOURS)


def build(kinds):
    nice = ["nice", "-n", str(BUILD_NICE)]
    subprocess.run([*nice, "cmake", "--preset", "fuzz"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    targets = [f"fuzz_{kind}" for kind in kinds]
    subprocess.run([*nice, "cmake", "--build", "--preset", "fuzz", "-j1", "--target", *targets], cwd=ROOT, check=True)


def faults(kind):
    return {path.name for path in FOUND.glob(f"{kind}-*")}


def run_piece(kind, seconds, leaks):
    """What the fuzzer noted, and the coverage it reached."""
    corpus, seeds, notes = WORK / f"corpus-{kind}", WORK / f"seeds-{kind}", WORK / f"notes-{kind}.json"
    corpus.mkdir(exist_ok=True)
    notes.unlink(missing_ok=True)
    env = {**os.environ, "LENTRAY_FUZZ_SECONDS": str(seconds), "LENTRAY_FUZZ_NOTES": str(notes),
           "UBSAN_OPTIONS": "print_stacktrace=1",
           "ASAN_OPTIONS": "detect_stack_use_after_return=0:allocator_may_return_null=0:quarantine_size_mb=64:"
                           "allocator_release_to_os_interval_ms=500"}
    command = [str(WORK / "bin" / f"fuzz_{kind}"), str(corpus), str(seeds), f"-artifact_prefix={FOUND}/{kind}-", *OPTIONS,
               f"-detect_leaks={int(leaks)}"]
    with open(WORK / f"log-{kind}.txt", "w", encoding="utf-8") as log:
        status = subprocess.run(command, cwd=WORK, env=env, stdout=log, stderr=log, check=False,
                                preexec_fn=lambda: os.nice(NICE)).returncode
    text = (WORK / f"log-{kind}.txt").read_text(errors="replace")
    coverage = [int(edges) for edges in re.findall(r"\bcov: (\d+)", text)]
    if not notes.exists() and "Test unit written" not in text:
        sys.exit(f"fuzz_{kind} ended with status {status} and did nothing; {WORK}/log-{kind}.txt says why")
    done = json.loads(notes.read_text()) if notes.exists() else {"inputs": 1, "seconds": 0, "longest": 0, "memory": 0}
    return done, max(coverage, default=0)


def add(total, notes, coverage):
    for name in ("inputs", "seconds"):
        total[name] = total.get(name, 0) + notes[name]
    for name, value in (("longest", notes["longest"]), ("memory", notes["memory"]), ("coverage", coverage)):
        total[name] = max(total.get(name, 0), value)


def fuzz(kind, seconds, piece):
    """A piece, unless there were enough of them. Whether more is to be done."""
    total = hours().get(kind, {})
    left = seconds - total.get("seconds", 0)
    if left <= 0:
        return False
    before = faults(kind)
    leaks = total.get("seconds", 0) // piece % LEAKS == 0
    notes, coverage = run_piece(kind, min(piece, left), leaks)
    all_hours = hours()  # anew: other kinds may have gone on meanwhile
    total = all_hours.setdefault(kind, {})
    add(total, notes, coverage)
    keep(all_hours)
    new = faults(kind) - before
    for name in sorted(new):
        print(f"{kind}: {FOUND / name} is a fault; {WORK}/log-{kind}.txt has the stack")
    print(f"{kind}: {total['seconds']:.0f} of {seconds} s, {total['inputs']} inputs, {total['coverage']} edges", flush=True)
    return True


def table():
    print(f"{'kind':<9}{'hours':>7}{'inputs':>12}{'edges':>8}{'corpus':>8}{'faults':>8}{'most memory':>13}{'longest input':>15}")
    for kind in KINDS:
        total = hours().get(kind, {})
        corpus = sum(1 for _ in (WORK / f"corpus-{kind}").glob("*"))
        print(f"{kind:<9}{total.get('seconds', 0) / 3600:>7.2f}{total.get('inputs', 0):>12}{total.get('coverage', 0):>8}{corpus:>8}"
              f"{len(faults(kind)):>8}{total.get('memory', 0) / 1e6:>10.0f} MB{total.get('longest', 0):>13.2f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=", ".join(KINDS))
    parser.add_argument("--seconds", type=float, default=3600, help="of processor time for each kind in all")
    parser.add_argument("--piece", type=float, default=300, help="seconds of processor time at a time")
    parser.add_argument("--table", action="store_true", help="only say what was done")
    arguments = parser.parse_args()
    unknown = set(arguments.kinds) - set(KINDS)
    if unknown:
        parser.error(f"no kind of fuzzer: {', '.join(sorted(unknown))}")
    kinds = arguments.kinds or list(KINDS)
    if not arguments.table:
        build(kinds)
        FOUND.mkdir(exist_ok=True)
        for kind in kinds:
            subprocess.run([sys.executable, ROOT / "tests/fuzz/seeds.py", kind, WORK / f"seeds-{kind}"], check=True)
        at_first = {kind: len(faults(kind)) for kind in kinds}
        going_on = list(kinds)
        while going_on:
            going_on = [kind for kind in going_on if fuzz(kind, arguments.seconds, arguments.piece)
                        and len(faults(kind)) < at_first[kind] + MOST_FAULTS]
    table()
    return 1 if any(faults(kind) for kind in kinds) else 0


if __name__ == "__main__":
    sys.exit(main())
