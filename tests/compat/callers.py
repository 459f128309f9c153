#!/usr/bin/env python3
"""Programs that call povray, each run twice: with stock, and with a link named povray to lentray first
in PATH. The exit status, the files that are there afterwards and the pictures must be the same.

    callers.py [--bin build/release/bin] [--only NAME] [--keep FOLDER]

Programs that are not installed are left out, and named; all of them, on Debian 12:
    apt install pymol python3-ase jmol xvfb xauth blender python3-numpy; pip install vapory
The rest is the command lines and INI files of such programs, with scenes of our own. Stock is needed.
Status: 0 all as with stock, 1 something differs, 77 there is no stock POV-Ray.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile

PYTHON = "/usr/bin/python3"  # Debian's, which has Debian's modules

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#ifndef (Turn) #declare Turn = 20; #end
camera { location <0, 2.5, -6> look_at <0, .4, 0> right x*image_width/image_height angle 40 }
light_source { <5, 7, -4> White }
background { rgb <.3, .4, .6> }
plane { y, -1 pigment { checker White Gray40 } }
sphere { 0, 1 pigment { Orange } finish { phong .8 reflection .2 } rotate y*(Turn + 90*clock) }
box { -.5, .5 rotate Turn*y translate <1.6, -.5, -.5> pigment { Red } }
text { ttf "timrom.ttf" "pov" .2, 0 pigment { Yellow } translate <-2, -1, -1> }
"""

MOLECULE = "6\nethene\nC 0 0 .67\nC 0 0 -.67\nH 0 .92 1.24\nH 0 -.92 1.24\nH 0 .92 -1.24\nH 0 -.92 -1.24\n"

PYMOL = """from pymol import cmd
cmd.load('molecule.xyz')
cmd.show_as('{what}')
cmd.bg_color('{background}')
cmd.turn('y', 30)
cmd.set('antialias', {antialias})
cmd.ray(200, 150, renderer=1)
"""

ASE = """from ase.build import fcc111, molecule
from ase.io import write
atoms = {atoms}
write('atoms.pov', atoms, rotation='10z,-75x', povray_settings=dict(canvas_width={width}, transparent={transparent},
      textures={textures})).render()
"""

BLENDER = """import addon_utils, bpy, os
addon_utils.enable('render_povray', default_set=True)
scene = bpy.context.scene
scene.render.engine = 'POVRAY_RENDER'
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 160, 120, 100
scene.pov.radio_enable = {radiosity}
scene.pov.tempfiles_enable = False
scene.pov.deletefiles_enable = False
scene.pov.scene_path = scene.pov.renderimage_path = os.getcwd() + '/'
scene.pov.scene_name = 'blend'
scene.render.filepath = os.getcwd() + '/result.png'
bpy.ops.render.render(write_still=True)
"""

VAPORY = """from vapory import *
scene = Scene(Camera('location', [0, 2, -3], 'look_at', [0, 1, 2]),
              [LightSource([2, 4, -3], 'color', [1, 1, 1]), Background('color', [.2, .3, .4]),
               Sphere([0, 1, 2], 1.5, Texture(Pigment('color', [1, 0, 1])), Finish('phong', .6))])
{call}
"""

# An exporter's INI file, and an editor's.
INI = """; made by an exporter
Input_File_Name=scene.pov
Output_to_File=True
Output_File_Type=N
Output_Alpha=on
Width=160
Height=119.99
Antialias=True
Antialias_Threshold=0.1
Jitter=off
Display=False
Pause_When_Done=False
Verbose=False
[large]
Input_File_Name=scene.pov
Width=240
Height=180
Display=False
"""


class Case:
    """commands: shell lines, run one after the other in a folder that holds `files`; the first status that
    is not 0 ends them. needs: programs, or modules of Python as python:NAME. grade: what pictures must reach;
    empty: they need only be there. jitter: whether the default INI file leaves it on, as POV-Ray does: its
    random numbers are stock's own, so that antialiased pictures can only be close."""

    def __init__(self, name, commands, files, needs=(), grade="match", jitter=False):
        self.name, self.files, self.needs, self.grade = name, files, needs, grade
        self.jitter = jitter
        self.commands = [commands] if isinstance(commands, str) else commands


def cases():
    scene = {"scene.pov": SCENE}
    for what, antialias in (("spheres", 1), ("sticks", 1), ("surface", 0)):
        yield Case(f"pymol {what}", f"{PYTHON} -m pymol -cq script.py",
                   {"molecule.xyz": MOLECULE, "script.py": PYMOL.format(
                       what=what, antialias=antialias, background="white" if antialias else "grey40")},
                   ["python:pymol"])
    for name, atoms, width, transparent, textures in (
            ("slab", "fcc111('Al', (3, 3, 2), vacuum=3)", 200, True, None),
            ("molecule", "molecule('CH3CH2OH', vacuum=2)", 160, False, ["glass"] * 9)):
        yield Case(f"ase {name}", f"{PYTHON} script.py",
                   {"script.py": ASE.format(atoms=atoms, width=width, transparent=transparent, textures=textures)},
                   ["python:ase"])
    yield Case("ase slab jitter", f"{PYTHON} script.py",
               {"script.py": ASE.format(atoms="fcc111('Al', (3, 3, 2), vacuum=3)", width=200, transparent=True, textures=None)},
               ["python:ase"], grade="close", jitter=True)
    yield Case("jmol", ["xvfb-run -a java -jar /usr/share/java/Jmol.jar -L -g200x150 -s script.spt -x",
                        "povray molecule.pov.ini -P -D"],
               {"molecule.xyz": MOLECULE,
                "script.spt": 'load molecule.xyz; background white; rotate x 40; write POVRAY "molecule.pov";\n'},
               ["xvfb-run", "/usr/share/java/Jmol.jar"])
    for radiosity in (False, True):
        yield Case("blender" + (" radiosity" if radiosity else ""),
                   "blender -b --factory-startup --python-exit-code 1 --python script.py",
                   {"script.py": BLENDER.format(radiosity=radiosity)}, ["blender"],
                   grade="" if radiosity else "match")
    yield Case("vapory file", f"{PYTHON} script.py", {"script.py": VAPORY.format(
        call="scene.render('out.png', width=160, height=120, antialiasing=0.001)")}, ["python:vapory"])
    yield Case("vapory array", f"{PYTHON} script.py", {"script.py": VAPORY.format(
        call="import numpy, subprocess\na = scene.render(width=160, height=120)\n"
             "open('a.ppm', 'wb').write(b'P6 160 120 255\\n' + a.astype('uint8').tobytes())")},
        ["python:vapory", "python:numpy"])
    # vapory's command lines.
    yield Case("lines vapory file", "povray __temp__.pov +H120 +W160 +A0.001000 -D +L. Output_File_Type=N +Oout.png",
               {"__temp__.pov": SCENE})
    yield Case("lines vapory jitter", "povray __temp__.pov +H120 +W160 +A0.001000 -D Output_File_Type=N +Oout.png",
               {"__temp__.pov": SCENE}, grade="close", jitter=True)
    yield Case("lines vapory alpha", "povray __temp__.pov +H120 +W160 +Q9 Output_Alpha=on -D Output_File_Type=N +Oout.png",
               {"__temp__.pov": SCENE})
    yield Case("lines vapory array", "povray __temp__.pov +H120 +W160 -D Output_File_Type=P +O- > out.ppm",
               {"__temp__.pov": SCENE})
    # Exporters' INI files.
    yield Case("lines ini", "povray scene.ini", {**scene, "scene.ini": INI})
    yield Case("lines ini part", "povray scene.ini[large] -GA", {**scene, "scene.ini": INI})
    # Editors, Emacs's pov-mode among them, and shell scripts.
    yield Case("lines editor", "povray -D Width=160 Height=120 Input_File_Name=scene.pov Antialias=off Output_to_File=on "
               "Output_File_Type=N Verbose=off Dither=off", scene)
    yield Case("lines editor dither", "povray -D Width=160 Height=120 scene.pov Dither=on", scene)
    yield Case("lines pov-mode", ["povray -D +H120 +W160 +Iscene.pov +Olow.png +Q5",
                                  "povray -D +H240 +W320 +A0.3 -J +R3 +Iscene.pov +L. +Ohigh"], scene)
    yield Case("lines shell pipe", "povray +Iscene.pov +O- +FN +W160 +H120 -D -GA 2>log | cat > out.png", scene)
    yield Case("lines shell declare", "povray +Iscene +W160 +H120 -D Declare=Turn=50 +K0.5 -V +WT1 +Osub/", {**scene, "sub/": ""})
    yield Case("lines animation", "povray scene.pov +W80 +H60 -D +KFI1 +KFF3 +KI0 +KF1 -GA", scene)
    # POV-Ray's own scripts, which take options of a comment in the scene.
    scripts = "/usr/share/povray-3.7/scripts/"
    yield Case("povray's render_scene", f"sh {scripts}render_scene.sh pictures scene.pov",
               {"scene.pov": "// +w160 +h120 -d +a0.2\n" + SCENE, "pictures/": ""}, [scripts + "render_scene.sh"])
    yield Case("povray's render_anim", f"sh {scripts}render_anim.sh pictures scene.pov",
               {"scene.pov": SCENE, "pictures/": "", "scene.ini":
                "Input_File_Name=scene.pov\nWidth=80\nHeight=60\nInitial_Frame=1\nFinal_Frame=2\nDisplay=off\n"},
               [scripts + "render_anim.sh"])
    # Grids: parts of a picture, by rows and by columns, in formats that can be put together.
    yield Case("lines grid png", [f"povray scene.pov +W160 +H120 +SR{a} +ER{b} +FN +Opart{a}.png -D -GA"
                                  for a, b in ((1, 40), (41, 80), (81, 120))], scene)
    yield Case("lines grid ppm", [f"povray scene.pov +W160 +H120 +SR{a} +ER{b} +SC1 +EC160 +FP +Opart{a}.ppm -D -GA"
                                  for a, b in ((1, 60), (61, 120))], scene)
    # What goes wrong.
    yield Case("lines no scene", "povray +Inowhere.pov -D -GA", {})
    yield Case("lines no argument", "povray", {})
    yield Case("lines syntax error", "povray broken.pov -D -GA +W16 +H12", {"broken.pov": "sphere { 0 1 pigment { rgb }\n"})
    yield Case("lines unknown option", "povray scene.pov Widht=100 -GA", scene)
    yield Case("lines version", "povray --version 2>&1 | grep -c '^POV-Ray 3\\.7' > out.txt", {})
    yield Case("lines help", "povray --help 2>/dev/null > out.txt", {})


def missing(needs):
    absent = []
    for need in needs:
        if need.startswith("python:"):
            there = subprocess.run([PYTHON, "-c", f"import {need[7:]}"], capture_output=True).returncode == 0
        else:
            there = os.path.exists(need) or shutil.which(need)
        if not there:
            absent.append(need.removeprefix("python:"))
    return absent


def run(case, folder, path):
    """Status and standard error of the case in a new folder, with `path` as PATH."""
    os.makedirs(folder)
    for name, text in case.files.items():
        if name.endswith("/"):
            os.makedirs(os.path.join(folder, name))
            continue
        with open(os.path.join(folder, name), "w", encoding="utf-8") as out:
            out.write(text)
    environment = {**os.environ, "PATH": path, "HOME": folder + ".home", "PYTHONDONTWRITEBYTECODE": "1"}
    os.makedirs(folder + ".home", exist_ok=True)
    if not case.jitter:
        environment["POVINI"] = folder + ".ini"
        with open(environment["POVINI"], "w", encoding="utf-8") as out:
            out.write("Library_Path=/usr/share/povray-3.7/include\nJitter=off\n")
    said = ""
    for command in case.commands:
        done = subprocess.run(["bash", "-c", "set -o pipefail; " + command], cwd=folder, env=environment, timeout=300,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        said += done.stdout.decode("utf-8", "replace")
        if done.returncode:
            return done.returncode, said
    return 0, said


def files_below(folder):
    found = set()
    for where, _, names in os.walk(folder):
        found |= {os.path.relpath(os.path.join(where, name), folder) for name in names}
    return found


def grade_of(bin_folder, ours, stock):
    """Grade and PSNR of one picture; pictures are compared as viewers show them."""
    report = ours + ".json"
    done = subprocess.run([os.path.join(bin_folder, "lentray-diff"), ours, stock, "--no-pictures", "--grade", "match",
                           "--json", report], capture_output=True, text=True)
    if not os.path.exists(report):
        return "fails", done.stderr.strip()
    with open(report, encoding="utf-8") as text:
        whole = json.load(text)["whole"]
    os.remove(report)
    return whole["grade"], whole.get("psnr")


def compare(case, folder, link, bin_folder):
    """What differs, and what the table says of the case."""
    ours, stock = os.path.join(folder, "ours"), os.path.join(folder, "stock")
    status_stock, _ = run(case, stock, os.environ["PATH"])
    status_ours, said = run(case, ours, link + os.pathsep + os.environ["PATH"])
    faults, grades = [], []
    if (status_ours == 0) != (status_stock == 0) or (status_ours != status_stock and status_ours > 2):
        faults.append(f"status {status_ours}, stock {status_stock}: {' / '.join(said.strip().splitlines()[-2:])}")
    if status_stock == 0 and not files_below(stock) - set(case.files):
        faults.append("stock wrote nothing: the case tests nothing")
    only_ours, only_stock = files_below(ours) - files_below(stock), files_below(stock) - files_below(ours)
    if only_ours:
        faults.append("files too many: " + " ".join(sorted(only_ours)))
    if only_stock:
        faults.append("files missing: " + " ".join(sorted(only_stock)))
    order = ("exact", "match", "close", "differs", "fails")
    for name in sorted(files_below(ours) & files_below(stock)):
        if name.endswith((".png", ".ppm")):
            grade, more = grade_of(bin_folder, os.path.join(ours, name), os.path.join(stock, name))
            grades.append(grade)
            if case.grade and order.index(grade) > order.index(case.grade):
                faults.append(f"{name}: {grade} ({more})")
        if name == "out.txt":
            with open(os.path.join(ours, name), "rb") as a, open(os.path.join(stock, name), "rb") as b:
                if a.read() != b.read():
                    faults.append(name + " differs")
    return faults, f"{status_stock:>5} {status_ours:>5} {len(files_below(stock) - set(case.files)):>5}   {' '.join(grades) or '-'}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--bin", default="build/release/bin")
    parser.add_argument("--only", default="", help="cases whose name begins with this")
    parser.add_argument("--keep", help="a folder where everything stays")
    arguments = parser.parse_args()
    bin_folder = os.path.abspath(arguments.bin)
    if not shutil.which("povray"):
        print("callers: there is no stock POV-Ray to compare with (apt install povray)")
        return 77
    work = os.path.abspath(arguments.keep) if arguments.keep else tempfile.mkdtemp(prefix="lentray-callers-")
    link = os.path.join(work, "link")
    os.makedirs(link)
    os.symlink(os.path.join(bin_folder, "lentray"), os.path.join(link, "povray"))
    absent, failed, count = set(), [], 0
    print(f"{'caller':<22} stock  ours files   grades")
    for case in cases():
        if not case.name.startswith(arguments.only):
            continue
        if missing(case.needs):
            absent.update(missing(case.needs))
            print(f"{case.name:<22} left out: {' '.join(missing(case.needs))} not installed")
            continue
        faults, told = compare(case, os.path.join(work, case.name.replace(" ", "-")), link, bin_folder)
        count += 1
        print(f"{case.name:<22} {told}", flush=True)
        for fault in faults:
            print("    " + fault)
        if faults:
            failed.append(case.name)
    if not arguments.keep:
        shutil.rmtree(work)
    if absent:
        print("Not installed, and so not tried:", " ".join(sorted(absent)))
    print(f"{count} cases, {len(failed)} failed" + (": " + ", ".join(failed) if failed else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
