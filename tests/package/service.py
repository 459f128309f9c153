#!/usr/bin/env python3
"""The units of tools/service: systemd takes them, their exposure is small, and the command does what docs/service.md says.

  tests/package/service.py --bin FOLDER_OF_PROGRAMS

Status: 0 all is well, 1 something is not, 77 there is no systemd-analyze here.
"""
import argparse
import json
import pathlib
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile

UNITS = pathlib.Path(__file__).resolve().parents[2] / "tools/service"
MOST_EXPOSURE = 10   # tenths, as systemd-analyze wants them
GOOD = "#version 3.7; global_settings { assumed_gamma 1 } light_source { -5*z, 1 } sphere { 3*z, 1 pigment { rgb 1 } }\n"
ENDLESS = "#while (1) #end\n"
CURIOUS = '#include "/etc/passwd"\n'


def fail(text):
    sys.exit(f"FAILED: {text}")


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)


def units(folder, programs):
    """Copies with a name for the instance, whose program is there."""
    for path in UNITS.glob("lentray@.*"):
        text = path.read_text().replace("/usr/bin/", f"{programs}/")
        pathlib.Path(folder, path.name.replace("@", "@shop")).write_text(text)
    return pathlib.Path(folder, "lentray@shop.service"), pathlib.Path(folder, "lentray@shop.path")


def check_units(folder, programs):
    service, path = units(folder, programs)
    done = run("systemd-analyze", "verify", "--man=no", service, path)
    ours = [line for line in done.stderr.splitlines() if "lentray" in line]
    if done.returncode != 0 or ours:
        fail(f"systemd-analyze verify: {done.stderr}")
    done = run("systemd-analyze", "security", "--offline=true", f"--threshold={MOST_EXPOSURE}", "--no-pager", service)
    if done.returncode != 0:
        fail(f"systemd-analyze security: {done.stdout}{done.stderr}")
    print(done.stdout.strip().splitlines()[-1])


def size(text):
    number, unit = re.fullmatch(r"(\d+)([KMG]?)", text).groups()
    return int(number) << {"": 0, "K": 10, "M": 20, "G": 30}[unit]


def run_command(folder, programs):
    """The command of the unit on an inbox of three scenes, with its limits but for the time of a scene."""
    unit = (UNITS / "lentray@.service").read_text()
    inbox, out = folder / "inbox", folder / "out"
    inbox.mkdir()
    for name, scene in (("good", GOOD), ("endless", ENDLESS), ("curious", CURIOUS)):
        (inbox / f"{name}.pov").write_text(scene)
    words = re.search(r"^ExecStart=(.*)$", unit, re.MULTILINE).group(1)
    words = words.replace("/usr/bin", str(programs)).replace("/srv/lentray/%i", str(inbox)).replace("/var/lib/lentray/%i", str(out))
    words = words.replace("--time-limit 10m", "--time-limit 30 +W8 +H6")

    def limits():
        for name, which in (("FSIZE", resource.RLIMIT_FSIZE), ("NOFILE", resource.RLIMIT_NOFILE), ("CORE", resource.RLIMIT_CORE)):
            most = size(re.search(rf"^Limit{name}=(\w+)$", unit, re.MULTILINE).group(1))
            resource.setrlimit(which, (most, most))

    before = {path.name: path.read_bytes() for path in inbox.iterdir()}
    done = run(*shlex.split(words), preexec_fn=limits, timeout=200)
    accepted = {0, *map(int, re.search(r"^SuccessExitStatus=(.*)$", unit, re.MULTILINE).group(1).split())}
    rows = {row["name"]: row for row in map(json.loads, (out / "manifest.jsonl").read_text().splitlines())}
    if done.returncode != 1 or done.returncode not in accepted:
        fail(f"status {done.returncode}: {done.stdout}{done.stderr}")
    if {name: row["state"] for name, row in rows.items()} != {"good": "done", "endless": "failed", "curious": "failed"}:
        fail(f"rows: {rows}")
    if "Restrict_IO" not in rows["curious"]["reason"] or not (out / "good.png").exists() or not (out / "index.html").exists():
        fail(f"rows: {rows}")
    if {path.name: path.read_bytes() for path in inbox.iterdir()} != before:
        fail("the inbox was changed")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    programs = parser.parse_args().bin.resolve()
    with tempfile.TemporaryDirectory() as name:
        run_command(pathlib.Path(name), programs)
        if not shutil.which("systemd-analyze"):
            print("no systemd-analyze here: the command alone was run")
            return 77
        check_units(name, programs)
    print("service: all is well")
    return 0


if __name__ == "__main__":
    sys.exit(main())
