#!/usr/bin/env python3
"""What programs that call povray read of its lines, asked of stock and of lentray in its place.

    reading_callers.py [--bin build/release/bin] [--only NAME]

Each caller is a short likeness of a program that exists: it has that program's command line, reads the same
stream, and looks for the same expressions. It answers what the program would show: a bar, a place, a list of
warnings. Both renderers must bring about the same answer. lentray is called through a link named povray; the
last callers call it by its own name, with Stock_Messages=On. Python alone and stock are needed.
Status: 0 all as with stock, 1 something differs, 77 there is no stock POV-Ray.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -6*z look_at 0 }\n"
FILES = {
    "ok.pov": HEAD + "light_source { <4, 8, -9> rgb 1 area_light x, y, 5, 5 }\n"
              "sphere { 0, 1 pigment { rgb 1 } finish { reflection .3 } }\nplane { y, -1 pigment { rgb .7 } }\n",
    "bad.pov": "#version 3.7;\nsphere { 0, 1 pigment { rgb 1 }\ncamera { location -6*z }\n",
    "short.pov": "#version 3.7;\n\n#error \"no\"\n",
    "inside.pov": "#version 3.7;\n#include \"part.inc\"\n",
    "part.inc": "#declare A = 3;\n#declare B =\n  sphere { 0, nothing }\n",
    "macro.pov": "#version 3.7;\n#macro Ball(R)\n  sphere { 0, R nothing }\n#end\nBall(3)\n",
    "end.pov": "#version 3.7;\nsphere { 0, 1\n",
    "warns.pov": HEAD + "#warning \"mind you\"\n#debug \"say this\\n\"\nsphere { 0, 1 pigment { rgb 1 } }\n",
    "noimage.pov": HEAD + "sphere { 0, 1 pigment { image_map { png \"nowhere.png\" } } }\n",
}
SIZE = ["+W160", "+H120"]


class Renderer:
    """A program, and options that are put before those of a caller."""

    def __init__(self, program, *options):
        self.program, self.options = program, list(options)

    def run(self, *arguments):
        """Status, standard output and standard error, as bytes. Files of an earlier run are gone."""
        with tempfile.TemporaryDirectory(prefix="lentray-reading-") as folder:
            for name, text in FILES.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as out:
                    out.write(text)
            self.folder = folder
            done = subprocess.run([self.program, *self.options, *(a.replace("HERE", folder) for a in arguments)],
                                  cwd=folder, capture_output=True, timeout=120, stdin=subprocess.DEVNULL,
                                  env={**os.environ, "HOME": folder, "POVINI": os.path.join(folder, "none.ini")})
            self.left = {}
            for name in set(os.listdir(folder)) - set(FILES):
                with open(os.path.join(folder, name), "rb") as left:
                    self.left[name] = left.read()
        return done.returncode, done.stdout, done.stderr

    def text(self, *arguments):
        status, out, said = self.run(*arguments)
        return status, (out + said).decode("utf-8", "replace").replace(self.folder + "/", "")


def cuemol(povray):
    """CueMol 2 (CueMol/cuemol2, PovRender): a bar of the share, by whatever comes once a second."""
    status, said = povray.text("Input_File_Name='HERE/ok.pov'", "Output_File_Name='HERE/out.png'",
                               "Library_Path='HERE'", "File_Gamma=1", "-D", "+WT2", "+W640", "+H480", "+FN8",
                               "Quality=11", "Antialias=On", "Antialias_Depth=3", "Antialias_Threshold=0.1",
                               "Jitter=Off", "+V")
    bar = [int(share) for _, _, share in re.findall(r"Rendered (\d+) of (\d+) pixels \((\d+)%\)", said)]
    return status, "out.png" in povray.left, bool(bar), bar[-1:]


def farm(povray):
    """A node of a render farm: a part of a picture with -GA, pixels by pixels from standard error."""
    status, _, said = povray.run("+Iok.pov", "+W640", "+H480", "+SC11", "+SR21", "+EC110", "+ER70", "+FN", "+Oout.png",
                                 "-GA", "-P", "+Q9", "+A0.3", "-J", "-D")
    steps = re.findall(rb"Rendered (\d+) of (\d+) pixels \((\d+)%\)", said)
    return status, {whole for _, whole, _ in steps}, steps[-1:]


def leocad(povray):
    """LeoCAD (leozide/leocad, lc_renderdialog): the picture of standard output is good if the status is 0
    and a line of standard error is 'POV-Ray finished'."""
    answers = []
    for scene in ("ok.pov", "bad.pov"):
        status, out, said = povray.run(f'+I"HERE/{scene}"', *SIZE, "-O-", "+Q5", "+A0.1", "+FN", "-D")
        lines = said.decode("utf-8", "replace").split("\n")
        answers.append((status, any(re.search("^POV-Ray finished$", line) for line in lines), out[:4] == b"\x89PNG"))
    return answers


def vscode(povray):
    """The extension of Visual Studio Code (jmaxwilson/vscode-povray, problemMatchers): two lines, the second of
    which begins with a blank."""
    found = []
    for scene in ("bad.pov", "macro.pov"):
        status, said = povray.text(scene, "-D", "Width=160", "Height=120")
        lines = said.splitlines()
        for first, second in zip(lines, lines[1:]):
            place = re.match(r"^.*\s\'(.*\.pov|inc).*line\s+(\d+):.*(.*[Ee]rror.*):\s(.*$)", first)
            if place and re.match(r"^([\s]\w.*)", second):
                found.append((status, place[1], place[2], bool(place[4])))
    return found


def jupyter(povray):
    """povray-jupyter (itsactuallyluna9/povray-jupyter): the exception's file and line, and Python warnings."""
    answers = []
    for scene in ("ok.pov", "bad.pov", "inside.pov", "end.pov", "warns.pov"):
        status, said = povray.text("+W80", "+H60", "+FN", "+Oout.png", "-D", "+UA", "+A0.3", "+WT20", scene)
        lines = [line for line in said.splitlines() if "warning stream to console" not in line.lower()]
        warned = [line for line in lines if "parse warning" in line.lower() or line.lower().startswith("warning")]
        place = None
        if status != 0 and "parse error" in said.lower():
            place = re.search(r"File[: ]\s*['\"]?(.+?)['\"]?\s*line[: ]\s*(\d+)", said, re.IGNORECASE).groups()
        answers.append((status, place, [re.search("mind you", line) is not None for line in warned]))
    return answers


def pov_mode(povray):
    """Emacs (emacsmirror/pov-mode): no errors are told if the status is 0 and nothing says 'Error:'."""
    answers = []
    for scene in ("ok.pov", "short.pov", "noimage.pov", "nowhere.pov"):
        status, said = povray.text("-D", "+H60", "+W80", "+I" + scene, "+L.", "+Oout.png", "+Q5")
        answers.append((status, "Error:" in said))
    return answers


def povrayer(povray):
    """povrayer (swhitt/povrayer, web): figures from the log of a picture, and a head line for a failure."""
    status, said = povray.text("+Iok.pov", "+Oout.png", "+FN", "-D", "-P", *SIZE, "+WT1", "-A", "+L.")
    numbers = [re.search(form, said, re.MULTILINE) for form in (
        r"Trace Time:[^(]*\(([\d.]+) seconds\)", r"Parse Time:[^(]*\(([\d.]+) seconds\)", r"^Rays:\s+(\d+)")]
    threads = re.findall(r"using (\d+) thread\(s\)", said)
    answers = [(status, [bool(n) and float(n[1]) >= 0.0 for n in numbers], threads[-1:],
                len(re.findall("Warning:", said)))]
    for scene in ("bad.pov", "short.pov", "inside.pov"):
        lines = povray.text("+I" + scene, "+Oout.png", "+FN", "-D", "-P", *SIZE)[1].split("\n")
        first = next(line for line in lines if re.search(r"parse error|^fatal|error:", line, re.IGNORECASE))
        place = re.search(r"File '[^']*' line (\d+):\s*(.*)", first)
        answers.append((place[1], place[2].split(":")[0]))
    return answers


def spack(povray):
    """Spack's test of its package (spack/spack, povray): 'POV-Ray finished' in what is said."""
    return "POV-Ray finished" in povray.text("ok.pov", "-D", "+W80", "+H60")[1]


def repairer(povray):
    """A script that gives a scene's fault back to what wrote the scene: the line's number and the message."""
    answers = []
    for scene in ("bad.pov", "inside.pov", "macro.pov", "end.pov"):
        said = povray.text("+I" + scene, "+Oout.png", *SIZE, "+A0.3", "+L.", "-D")[1]
        place = re.search(r"line (\d+): Parse Error: (.+)", said)
        answers.append(place and (place[1], len(place[2]) > 5))
    return answers


def film(povray):
    """A bar over the frames of an animation, whole pictures between them."""
    status, said = povray.text("ok.pov", "+W40", "+H30", "-D", "+KFI1", "+KFF3")
    frames = re.findall(r"^Rendering frame (\d+) of (\d+)$", said, re.MULTILINE)
    heads = re.findall(r"^==== \[(\w+)\.\.\.\] ====", said, re.MULTILINE)
    whole = re.findall(r"Rendered (\d+) of \1 pixels \(100%\)", said)
    return status, sorted(set(frames)), heads, whole, re.findall(r"^Image Resolution .*", said, re.MULTILINE)


def quiet(povray):
    """-V leaves out the bar and nothing else; what is small has a bar too; +C says that a picture is there."""
    quiet_run = povray.text("ok.pov", "+W40", "+H30", "-D", "-V")[1]
    small = povray.text("ok.pov", "+W3", "+H2", "-D", "+V")[1]
    return ("Rendered" in quiet_run, "Render Statistics\n" in quiet_run, "POV-Ray finished\n" in quiet_run,
            re.findall(r"Rendered .*?\r", small), re.findall(r"  Output file\.+(.*)", small),
            re.findall(r"  Image resolution\.+(.*)", small))


def files(povray):
    """What goes to files: errors, warnings, #debug, statistics; the bar and the ends of a run do not."""
    arguments = ["+W40", "+H30", "-D", "All_File=all", "Debug_File=d", "Warning_File=w", "Fatal_File=f",
                 "Statistic_File=s", "Render_File=r", "All_Console=off"]
    povray.run("bad.pov", *arguments)
    answers = [[b"Parse Error: " in povray.left.get(name, b"") for name in ("all", "f", "w")]]
    povray.run("warns.pov", *arguments)
    for name, text in (("w", b"Parse Warning: mind you"), ("d", b"say this"), ("s", b"Render Statistics"),
                       ("r", b"Image Output Options"), ("all", b"Trace Time:"), ("all", b"POV-Ray finished"),
                       ("all", b"Rendered ")):
        answers.append(text in povray.left.get(name, b""))
    return answers


def statuses(povray):
    """The status of what fails, and the first line where an option is wrong."""
    answers = []
    for arguments in (["nowhere.pov"], ["ok.pov", "Widht=3"], ["ok.pov", "+Wx"], ["ok.pov", "+Onowhere/x.png"],
                      ["short.pov"], ["+Iok.pov", "none.ini"]):
        status, said = povray.text(*arguments, "-D")
        options = f"\nProblem with option setting\n{povray.program} {' '.join(arguments)} -D\n"
        answers.append((status, options in said, "\nRender failed\n" in said))
    answers.append(povray.text("-D")[0])
    return answers


CALLERS = (cuemol, farm, leocad, vscode, jupyter, pov_mode, povrayer, spack, repairer, film, quiet, files, statuses)
BY_NAME = (statuses,)  # which ask for what an option comes too late for


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--bin", default="build/release/bin")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    stock = shutil.which("povray")
    if not stock:
        print("reading_callers: there is no stock POV-Ray to compare with (apt install povray)")
        return 77
    lentray = os.path.abspath(os.path.join(arguments.bin, "lentray"))
    failed = 0
    with tempfile.TemporaryDirectory(prefix="lentray-link-") as folder:
        link = os.path.join(folder, "povray")
        os.symlink(lentray, link)
        ours = [("by the name", Renderer(link)), ("by the option", Renderer(lentray, "Stock_Messages=On"))]
        for caller in (c for c in CALLERS if c.__name__.startswith(arguments.only)):
            expected = caller(Renderer(stock))
            for how, renderer in ours[:1] if caller in BY_NAME else ours:
                found = caller(renderer)
                failed += found != expected
                print(f"{caller.__name__:<10} {how:<14} {'as stock' if found == expected else 'DIFFERS'}", flush=True)
                if found != expected:
                    print(f"    stock {expected}\n    ours  {found}")
        if not arguments.only:
            own = Renderer(link, "Stock_Messages=Off").text("ok.pov", *SIZE, "-D")[1]
            if "Rendering: 100%\n" not in own or "Rendered" in own:
                failed += 1
                print("Stock_Messages=Off does not bring lentray's own form:\n" + own)
    print(f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
