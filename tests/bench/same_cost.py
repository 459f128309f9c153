"""Does a build of lentray do as much work as another? Counts the instructions of both on the same scenes.

  tests/bench/same_cost.py BEFORE AFTER                        all kinds of scenes
  tests/bench/same_cost.py BEFORE AFTER --only primitives      one kind
  tests/bench/same_cost.py BUILD BUILD --before-option Specialised_Paths=Off
                                                               what an option costs: BEFORE has it as well

Meant for changes of the program that must not make it slower. BEFORE and AFTER are folders with bin/lentray, as
build/release, or the programs themselves. A build must not be rebuilt meanwhile: copy its bin folder first. Counts are
of whole processes with one thread, by perf (instructions:u) where the machine lets it count, else by valgrind's
callgrind; they hardly depend on what else the machine does.

Kinds of scenes:
  spd         the seven SPD scenes in their own cameras, 96 x 72
  primitives  the scenes of primitives.py, 96 x 72 (its mesh of a million triangles has 100,000 here)
  corpus      20 of Debian's povray-examples, 64 x 48
  auto        the SPD scenes as sheets of 150 x 120 with Shadow_Cache=auto, also without light buffers (-UL), where
              caches are asked
  thick       lens sheets with Lens_Model=thick and 8 rays a pixel, 120 x 90
  blur        cameras with an aperture: examples whose camera has one, or to which one is added, 96 x 72
  media, areas, radiosity, photons
              examples with media, area lights, radiosity and photons, 96 x 72 or smaller

The table has millions of instructions before and after, their ratio, and the ratio without what the same build needs
for an empty scene of one pixel. The limits are for the latter; the empty scene itself is judged as a whole.

The exit status is 0 if the median and the largest ratio are within --median and --largest, 1 if not or if a scene
renders with one build only, 2 if the command cannot begin.
"""
import collections
import pathlib
import re
import shutil
import statistics
import sys
import tempfile

import primitives
import two_builds
from two_builds import ROOT, SPD, Scene

SMALL, SHEET, CORPUS = ["+W96", "+H72"], ["+W150", "+H120"], ["+W64", "+H48"]
EXAMPLES = """
advanced/biscuit advanced/glasschess/glasschess advanced/isocacti advanced/landscape advanced/mtmand
advanced/teapot/teapot advanced/whiltile advanced/woodbox camera/fisheye camera/focalblur incdemo/glasses/glass
interior/fog_std interior/iortest lights/arealit2 objects/chesmsh objects/csg/granite objects/lathe1a
objects/fractal1 textures/normals/normavg textures/patterns/pigment_pattern
""".split()

THICK = """
advanced/infinitybox advanced/teapot/teapot advanced/whiltile textures/patterns/agate objects/blob objects/chesmsh
objects/lathe1a interior/skysph1 lights/spotlite incdemo/woods/woods2
""".split()
MEDIA = """
advanced/abyss interior/media/galaxy interior/media/hollow2 interior/media/hollow3 interior/media/media1
interior/media/media2 interior/media/media3 interior/media/media4 interior/media/media5 interior/media/micro
lights/phot_met_glass interior/media/hollow1
""".split()
AREAS = """
lights/arealit1 lights/arealit2 lights/arealit3 lights/circular lights/orient lights/shadows lights/soft advanced/woodbox
""".split()
RADIOSITY = """
radiosity/cornell radiosity/radiosity2 radiosity/radiosity3 radiosity/radiosity_37 radiosity/rad_def_test_37
radiosity/radiosity_36 radiosity/rad_def_test_36 radiosity/patio-radio_37
""".split()
PHOTONS = """
lights/glassthing lights/phot_met_glass advanced/optics advanced/benchmark/benchmark
""".split()
# The cameras of these examples, with an aperture.
BLURRED = {
    "objects/csg/granite": "location <0, 3.5, -3.7> angle 69 right x*image_width/image_height look_at <0, -0.25, 0>",
    "objects/lathe1a": "location <0, 7, -10> right x*image_width/image_height angle 45 look_at <0, -0.2, 0>",
    "objects/blob": "location <0, 0, -5> right x*image_width/image_height angle 60 look_at 0",
}

Cost = collections.namedtuple("Cost", "before after why")


def spd(parser, args):
    return [Scene("spd", name, ROOT / "scenes" / f"spd_{name}.pov", ["-A", *SMALL]) for name in SPD]


def auto(parser, args):
    sheet = ["Declare=Lenticular_Camera=1", "Shadow_Cache=auto", "-A", *SHEET]
    return [Scene("auto", name + more, ROOT / "scenes" / f"spd_{name}.pov", [*sheet, *options])
            for name in SPD for more, options in (("", []), (" -UL", ["-UL"]))]


def corpus(parser, args):
    return [Scene("corpus", name, path, ["-A", *CORPUS])
            for name, path in two_builds.examples(parser, EXAMPLES)]


def one_a_primitive(parser, args):
    scenes = []
    for name, (text, _) in primitives.SCENES.items():
        if name == "mesh_million":
            name, text = "mesh_100000", primitives.mesh(224, .5)
        path = args.work / f"{name}.pov"
        path.write_text(primitives.STAGE + (text() if callable(text) else text))
        scenes.append(Scene("primitives", name, path, ["-A", *SMALL]))
    return scenes


def thick(parser, args):
    paths = [(name, ROOT / "scenes" / f"spd_{name}.pov") for name in ("balls", "gears")]
    paths += two_builds.examples(parser, THICK)
    sheet = ["Lenticular=On", "Lens_Model=thick", "Lens_Rays=8", "-A", "+W120", "+H90"]
    return [Scene("thick", name, path, sheet) for name, path in paths]


def blur(parser, args):
    scenes = [Scene("blur", name, path, ["-A", *SMALL])
              for name, path in two_builds.examples(parser, ["camera/focalblur"])]
    for name, path in two_builds.examples(parser, BLURRED):
        wrapper = args.work / f"{path.stem}_blur.pov"
        wrapper.write_text(f'#include "{path}"\ncamera {{ {BLURRED[name]} aperture 0.15 focal_point 0 blur_samples 19 }}\n')
        scenes.append(Scene("blur", name, wrapper, ["-A", *SMALL, f"+L{path.parent}"]))
    return scenes


def of_examples(kind, names, size):
    return lambda parser, args: [Scene(kind, name, path, ["-A", *size]) for name, path in two_builds.examples(parser, names)]


MAKERS = {"spd": spd, "primitives": one_a_primitive, "corpus": corpus, "auto": auto, "thick": thick, "blur": blur,
          "media": of_examples("media", MEDIA, SMALL), "areas": of_examples("areas", AREAS, SMALL),
          "radiosity": of_examples("radiosity", RADIOSITY, CORPUS), "photons": of_examples("photons", PHOTONS, SMALL)}


def empty(args):
    path = args.work / "empty.pov"
    path.write_text(primitives.EMPTY)
    return Scene("start-up", "empty scene", path, ["-A", "+W1", "+H1"])


def by_perf(command, folder, seconds):
    """Instructions of a command; None where perf cannot count. Kinds of cores are counted each for themselves."""
    with tempfile.NamedTemporaryFile("r") as file:
        status, said = two_builds.run(["perf", "stat", "-x,", "-o", file.name, "-e", "instructions:u", "--", *command],
                                      folder, seconds)
        counts = re.findall(r"^(\d+),[^,]*,[^,]*instructions", file.read(), re.MULTILINE)
    return status, said, sum(map(int, counts)) or None


def by_callgrind(command, folder, seconds):
    status, said = two_builds.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command], folder,
                                  seconds)
    found = re.search(r"Collected : (\d+)", said)
    return status, said, int(found.group(1)) if found else None


METERS = {"perf": by_perf, "callgrind": by_callgrind}


def choose_meter(parser, wanted):
    """perf where it counts here: it takes no time. Else callgrind, which takes fifty times the time."""
    works = shutil.which("perf") and by_perf(["true"], "/", 60)[2]
    if wanted == "perf" and not works:
        parser.error("perf is not there (Debian: linux-perf) or counts no instructions on this machine, as on many "
                     "virtual ones; see: perf stat -e instructions:u true")
    if wanted != "callgrind" and works:
        return "perf"
    if not shutil.which("valgrind"):
        parser.error("neither perf counts instructions here nor is there valgrind (Debian: valgrind)")
    return "callgrind"


def count(program, scene, more, args):
    """Instructions, or why there is no count."""
    with tempfile.TemporaryDirectory(dir=args.work) as folder:
        file = pathlib.Path(folder) / "picture.png"
        command = [program, f"+I{scene.path.name}", f"+O{file}", "+FN8", "-V", "+WT1", "Scene_Writes=memory",
                   *scene.options, *more]
        status, said, instructions = METERS[args.meter](command, scene.path.parent, args.limit)
        if status is None:
            return f"more than {args.limit:g} s"
        if status != 0 or not file.is_file():
            said = [line for line in said.splitlines() if not line.startswith("==")]
            return f"status {status}: {' '.join(' '.join(said).split())[-160:]}"
    return instructions or f"{args.meter} did not count"


def work_on(scene, args):
    before, after = (count(program, scene, more, args) for program, more in args.sides)
    failed = [f"{when} {what}" for when, what in (("before", before), ("after", after)) if isinstance(what, str)]
    if failed:
        return Cost(before, after, "; ".join(failed)), "; ".join(failed)
    return Cost(before, after, ""), f"{before / 1e6:.1f} {after / 1e6:.1f} {after / before:.4f}"


def millions(number):
    return f"{number / 1e6:12.2f}"


def row(scene, cost, start):
    """A line of the table, and the ratio that counts."""
    whole = cost.after / cost.before
    if scene.kind == "start-up":
        own, shown = whole, ""
    else:
        own = (cost.after - start.after) / max(1, cost.before - start.before)
        shown = f"{own:8.4f}"
    name = f"{scene.kind} {scene.name}"
    return f"{name:<42} {millions(cost.before)} {millions(cost.after)} {whole:8.4f} {shown:>9}", own


def report(rows, args):
    """The table and the verdict; true if all is within the limits."""
    start = rows[0][1]
    if start.why:
        print(f"the empty scene has no count: {start.why}")
        return False
    print(f"millions of instructions, counted by {args.meter}, one thread")
    print(f"{'scene':<42} {'before':>12} {'after':>12} {'ratio':>8} {'no start':>9}")
    ratios, one_sided, alike = {}, [], []
    for scene, cost in rows:
        name = f"{scene.kind} {scene.name}"
        if cost.why:
            both = isinstance(cost.before, str) and isinstance(cost.after, str)
            (alike if both else one_sided).append(f"{name}: {cost.why}")
            continue
        line, ratios[name] = row(scene, cost, start)
        print(line)
    for title, names in (("no count with either build", alike), ("a count with one build only", one_sided)):
        if names:
            print(f"\n{title}: {len(names)}\n  " + "\n  ".join(names))
    if len(ratios) < 2:
        print("\nno scene was counted with both builds")
        return False
    return judge(ratios, args) and not one_sided


def judge(ratios, args):
    median, largest = statistics.median(ratios.values()), max(ratios, key=ratios.get)
    over = sorted((name for name in ratios if ratios[name] > args.largest), key=ratios.get, reverse=True)
    print(f"\n{len(ratios)} scenes, ratio without start-up: median {median:.4f} (limit {args.median:g}), largest "
          f"{ratios[largest]:.4f} ({largest}; limit {args.largest:g}), smallest {min(ratios.values()):.4f}")
    for name in over:
        print(f"  over the limit: {name} {ratios[name]:.4f}")
    return median <= args.median and not over


def read_arguments():
    parser = two_builds.parser_of(__doc__, MAKERS, 300, "a count")
    parser.add_argument("--median", type=float, default=1.02, metavar="R",
                        help="greatest median of the ratios that passes (default 1.02)")
    parser.add_argument("--largest", type=float, default=1.05, metavar="R",
                        help="greatest ratio of a scene that passes (default 1.05)")
    parser.add_argument("--meter", choices=list(METERS), help="how to count (default: perf where it works)")
    args = two_builds.read_arguments(parser)
    args.meter = choose_meter(parser, args.meter)
    print(f"instructions are counted by {args.meter}", file=sys.stderr)
    return parser, args


def main():
    parser, args = read_arguments()
    rows = two_builds.of_all(parser, args, MAKERS, work_on, first=empty)
    return 0 if report(rows, args) else 1


if __name__ == "__main__":
    two_builds.main(main)
