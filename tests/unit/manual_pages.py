#!/usr/bin/env python3
"""Every option that a program's help tells of is in its manual page and in the completions, and bash
completes with them.    manual_pages.py BUILD_FOLDER PROGRAM...

That lentray's help tells of every option of its table is UnitOptionsHelp's to hold.
"""
import gzip
import os
import re
import shutil
import subprocess
import sys

failed = 0


def expect(condition, what):
    global failed
    if not condition:
        failed += 1
        print("FAILED:", what)


def options_of(text):
    """Names with their =, switches and long options, from the lines that begin an entry."""
    found = set()
    for line in re.findall(r"^  (\S.*)$", text.split("\nFiles:\n")[0], re.M):
        forms = line.split("  ")[0]
        found.update(re.findall(r"(?:^|, |\| )(\w+=)", forms))
        found.update(re.findall(r"(?:^|, )([+-][A-Z]+)", forms))
        found.update(re.findall(r"(?:^|, )(--[a-z-]+)", forms))
    return found


def completed(script, line):
    """What bash offers at the end of `line`."""
    words = re.split(r"(=)|\s+", line)
    words = [w for w in words if w is not None and w != ""] + ([""] if line[-1] in " =" else [])
    run = subprocess.run(["bash", "--norc", "-c", f"""
        compopt() {{ :; }}
        source '{script}'
        COMP_LINE=$1 COMP_POINT=${{#1}} COMP_WORDBREAKS=' ='
        _lentray_complete "$2" "$3" && printf '%s\\n' "${{COMPREPLY[@]}}" """, "bash", line, words[0], words[-1]],
        capture_output=True, text=True, cwd="/")
    return set(run.stdout.split())


def main():
    build = os.path.abspath(sys.argv[1])
    share = os.path.join(build, "share")
    bash = os.path.join(share, "completion.bash")
    shells = {shell: open(os.path.join(share, "completion." + shell), encoding="utf-8").read() for shell in ("bash", "zsh")}
    least = {"lentray": 180, "lentray-merge": 3}
    for program in sys.argv[2:]:
        command = [os.path.join(build, "bin", program)]
        text = subprocess.run(command + ["--help=all" if program == "lentray" else "--help"], capture_output=True,
                              text=True).stdout
        options = options_of(text)
        expect(len(options) > least.get(program, 8), f"{program}: only {len(options)} options found")
        offered = completed(bash, program + " ")
        path = os.path.join(share, program + ".1.gz")
        page = gzip.open(path, "rt", encoding="utf-8").read().replace("\\-", "-")
        for option in sorted(options):
            expect(option in page, f"{option} is not in the manual page of {program}")
            expect(option in offered, f"{option} of {program} is not completed by bash")
            expect(option in shells["zsh"], f"{option} of {program} is not completed by zsh")
        if shutil.which("man") and shutil.which("groff"):
            shown = subprocess.run(["man", "--warnings", "-l", path], capture_output=True, text=True,
                                   env={**os.environ, "MANWIDTH": "80", "LC_ALL": "C.UTF-8"})
            expect(shown.returncode == 0 and shown.stderr == "", f"man -l {path}: {shown.stderr}")
            for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "SEE ALSO"):
                expect("\n" + section + "\n" in shown.stdout, f"{program}.1 has no section {section}")
        print(f"{program}: {len(options)} options")
    expect(completed(bash, "lentray Lens_Model=pi") == {"pinhole"}, "Lens_Model=pi is completed")
    expect(completed(bash, "povray Wid") == {"Width="}, "the link named povray is completed")
    expect(completed(bash, "lentray Output_File_Type=") >= {"N", "E", "TIFF"}, "types are completed")
    for shell in ("bash", "zsh"):
        if shutil.which(shell):
            checked = subprocess.run([shell, "-n", os.path.join(share, "completion." + shell)], capture_output=True, text=True)
            expect(checked.returncode == 0, f"{shell} -n: {checked.stderr}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
