"""Small scenes through stock POV-Ray and lentray: read or refused, warned of, in the same lines.

  tests/compat/scene_cases.py                          all of tests/compat/scenes/*.scenes
  tests/compat/scene_cases.py sloppy.scenes            a file
  tests/compat/scene_cases.py --only 'media' FILE      cases whose name contains a word

A file holds scenes, each below a line `== name`. Both programs must accept a scene or both refuse
it with the error in the same line; write the same by #debug; and warn of the same lines. A name
that begins with ~ is a difference that docs/language.md explains: it must differ.
"""
import argparse
import concurrent.futures
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDES = "/usr/share/povray-3.7/include"
# Warnings of what only Lentray leaves out or does otherwise.
OURS = ["not rendered yet", "no photons are shot", "random numbers are not POV-Ray's"]
SIZE = ["+W4", "+H3", "-D", f"+L{INCLUDES}"]


def read_cases(path):
    cases = []
    for line in path.read_text().splitlines(keepends=True):
        if line.startswith("== "):
            cases.append([line[3:].strip(), ""])
        elif cases:
            cases[-1][1] += line
    return [tuple(c) for c in cases]


def run(command, folder):
    try:
        done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=60, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, (done.stdout + done.stderr).decode(errors="replace")


def whole_scene(warning):
    """What a warning without a line is about."""
    for word in ("assumed_gamma", "3.1 or earlier", "#version", "maximum_reuse"):
        if word in warning:
            return word
    return warning


def stock(text):
    """(accepted, debug text, lines warned of, line of the error, messages)"""
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "scene.pov").write_text(text)
        status, said = run(["povray", "+Iscene.pov", "-F", "+WT1", "-GR", "-GS", "+GDdebug.txt", *SIZE],
                           where)
        file = where / "debug.txt"
        debug = file.read_text(errors="replace") if file.exists() else ""
    said = re.sub(r"\n +", " ", said)
    warned, error, messages = set(), 0, []
    for line in said.splitlines():
        found = re.search(r"File '([^']*)' line (\d+): (.*)", line)
        if not found:
            if ("Parse Warning: " in line or "Possible Parse Error: " in line) and \
                    "experimental feature" not in line:
                messages.append(line)
                warned.add(whole_scene(line))
            continue
        if not found.group(1).endswith("scene.pov"):
            continue
        messages.append(found.group(2) + ": " + found.group(3))
        if re.match("Parse Warning|Possible Parse Error", found.group(3)):
            warned.add(int(found.group(2)))
        else:
            error = int(found.group(2))
    return (None if status is None else status == 0), debug, warned, error, messages


def lentray(binary, text):
    with tempfile.TemporaryDirectory() as folder:
        where = pathlib.Path(folder)
        (where / "scene.pov").write_text(text)
        command = [binary, "+Iscene.pov", "--parse-only", "-V", *SIZE]
        status, said = run([*command, "-GD"], where)
        _, debug = run([*command, "-GW"], where)
    warned, error, messages = set(), 0, []
    for line in said.splitlines():
        found = re.match(r"scene\.pov:(\d+):\d+: (warning|error): (.*)", line)
        if any(word in line for word in OURS):
            continue
        if line.startswith("lentray: warning: "):
            messages.append(line)
            warned.add(whole_scene(line))
        if not found:
            continue
        if found.group(2) == "warning":
            warned.add(int(found.group(1)))
        else:
            error = int(found.group(1))
        messages.append(f"{found.group(1)}: {found.group(2)}: {found.group(3)}")
    debug = debug.split("scene.pov:")[0]
    return status == 0, debug, warned, error, messages


def examine(case, binary):
    name, text = case
    wanted, found = stock(text), lentray(binary, text)
    differences = []
    if not wanted[0]:
        # What stock calls possible errors may have stopped it, in a line that it does not name.
        warned, error = wanted[2], wanted[3] or max((w for w in wanted[2] if isinstance(w, int)), default=0)
        wanted = (wanted[0], wanted[1], {w for w in warned if w != error}, error, wanted[4])
        found = (*found[:2], {w for w in found[2] if w not in (error, found[3])}, *found[3:])
        # It names the line that it has read to, which may be the next.
        if wanted[3] == 0 or wanted[3] - found[3] == 1:
            wanted = (*wanted[:3], found[3], wanted[4])
    if wanted[0] != found[0]:
        differences.append("stock {}, lentray {}".format(
            *("accepts" if w[0] else "refuses" for w in (wanted, found))))
    else:
        if wanted[1] != found[1]:
            differences.append(f"#debug: stock {wanted[1]!r}, lentray {found[1]!r}")
        if wanted[2] != found[2]:
            differences.append(f"warned of: stock {sorted(map(str, wanted[2]))}, lentray {sorted(map(str, found[2]))}")
        if wanted[3] != found[3]:
            differences.append(f"error: stock {wanted[3]}, lentray {found[3]}")
    if not differences and not name.startswith("~"):
        return name, ""
    if differences and name.startswith("~"):
        return name, ""
    text = f"{'no longer differs' if not differences else '; '.join(differences)}\n"
    for who, said in (("stock", wanted[4]), ("lentray", found[4])):
        text += "".join(f"    {who}: {line}\n" for line in said)
    return name, text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--jobs", type=int, default=4, help="scenes at a time")
    parser.add_argument("--only", default="", help="cases whose name contains this")
    parser.add_argument("files", nargs="*")
    args = parser.parse_args()
    folder = ROOT / "tests" / "compat" / "scenes"
    files = [folder / f for f in args.files] or sorted(folder.glob("*.scenes"))
    binary = args.bin.resolve() / "lentray"
    different = 0
    for file in files:
        cases = [c for c in read_cases(file) if args.only in c[0]]
        with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
            for name, why in pool.map(lambda c: examine(c, binary), cases):
                if why:
                    different += 1
                    print(f"{file.name}: {name}: {why}", flush=True)
        print(f"{file.name}: {len(cases)} scenes", flush=True)
    print(f"{different} differ from stock")
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
