"""The animations among Debian's povray-examples, by stock POV-Ray and by lentray, from their INI files.

  tests/compat/animations.py [--bin FOLDER] [word ...]      animations whose name contains a word

Stock renders in one block larger than the picture, as its antialiasing begins anew in each. raddem is passed over,
as it is lit by radiosity, and reflection, whose INI file names a scene that is not there. Every frame has stock's name and matches stock's picture, at 96 x 72 and without jitter; and lentray's processor
time a frame is no more than that of stills, each with its frame's clock. The exit status is 1 if one does not.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples/animations")
SIZE = ["+W96", "+H72", "-J", "-D", "-P", "-V", "-GA", "+WT1"]
ONE_BLOCK = ["+BS4096"]
PASSED_OVER = {"raddem", "reflection"}
MORE = 1.05  # of the stills' time: what a timer shows of the same work


def run(command, where):
    """CPU seconds."""
    process = subprocess.Popen(command, cwd=where, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def grades(diff, ours, stock, names):
    out = []
    for name in names:
        figures = ours / "figures.json"
        subprocess.run([diff, ours / name, stock / name, "--no-pictures", "--json", figures],
                       capture_output=True, check=False)
        out.append(json.loads(figures.read_text())["whole"]["grade"])
    return out


def still_seconds(lentray, ini, where):
    """Of stills with the clocks that lentray's own loop tells."""
    told = subprocess.run([lentray, ini.name, *(o for o in SIZE if o not in ("-V", "-GA")), "-F"], cwd=where,
                          capture_output=True, text=True, check=False).stderr
    clocks = re.findall(r"^Frame \d+ \(\d+ of \d+\), clock (\S+)", told, re.M)
    ends = ["+KFI1", "+KFF1", "+SF1", "+EF1"]
    return sum(run([lentray, ini.name, *SIZE, *ends, f"+K{clock}", "+Ostill"], where)[1] for clock in clocks)


def check(ini, args, work):
    where = {}
    times = {}
    for program, command in (("stock", "povray"), ("ours", args.bin / "lentray")):
        where[program] = work / program / ini.parent.name
        shutil.copytree(ini.parent, where[program])
        for part in where[program].rglob("*"):
            part.chmod(part.stat().st_mode | 0o200)
        where[program].chmod(0o755)
        blocks = ONE_BLOCK if program == "stock" else []
        status, times[program] = run([command, ini.name, *SIZE, *blocks], where[program])
        if status != 0:
            print(f"{ini.stem:14} {program}: status {status}")
            return False
    names = {p: sorted(f.name for f in where[p].iterdir() if f.suffix == ".png") for p in where}
    if names["ours"] != names["stock"] or not names["stock"]:
        print(f"{ini.stem:14} other files: {set(names['ours']) ^ set(names['stock'])}")
        return False
    found = grades(args.bin / "lentray-diff", where["ours"], where["stock"], names["stock"])
    stills = still_seconds(args.bin / "lentray", ini, where["ours"])
    bad = [f"{n} {g}" for n, g in zip(names["stock"], found) if g not in ("exact", "match")]
    good = not bad and times["ours"] <= MORE * stills
    print(f"{ini.stem:14} {len(found):3} frames, {found.count('exact')} exact, {found.count('match')} match; CPU seconds: "
          f"stock {times['stock']:.2f}, lentray {times['ours']:.2f}, its stills {stills:.2f}"
          + ("" if good else "  <-- " + " ".join(bad[:4])), flush=True)
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    args = parser.parse_args()
    args.bin = args.bin.resolve()
    inis = [i for i in sorted(EXAMPLES.glob("*/*.ini")) if i.stem not in PASSED_OVER
            and (not args.words or any(w in i.stem for w in args.words))]
    with tempfile.TemporaryDirectory() as folder:
        good = [check(ini, args, pathlib.Path(folder)) for ini in inis]
    print(f"{len(good)} animations, {good.count(False)} not as they should be")
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
