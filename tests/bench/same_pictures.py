"""Do two builds of lentray make the same pictures? Renders scenes with both and compares pixel for pixel.

  tests/bench/same_pictures.py BEFORE AFTER                    all kinds of scenes
  tests/bench/same_pictures.py BEFORE AFTER --only sheets      one kind
  tests/bench/same_pictures.py BEFORE AFTER --only random --random 500 --seed 7
  tests/bench/same_pictures.py BUILD BUILD --before-option Specialised_Paths=Off
                                                               rays together, and ray by ray

Meant for changes of the program that must not change a picture. BEFORE and AFTER are folders with bin/lentray, as
build/release, or the programs themselves. A build must not be rebuilt meanwhile: copy its bin folder first.

Kinds of scenes:
  corpus       all scenes of Debian's povray-examples, each from its own folder, 160 x 120, without antialiasing
  sheets       the SPD scenes as integral images, with V infinite and from the camera's eye, and others, 480 x 480
  antialiased  the 24 examples of tests/compat/antialiasing.py, methods 1 and 2, +A0.1 +R2, 160 x 120
  random       scenes made from --seed (random_scenes.py), 160 x 120

Pictures are PPM of 16 bits a channel. Scenes write no files (Scene_Writes=memory). A scene that fails with both
builds with the same words and status counts as "fail alike", one that neither renders within --limit (seconds of
processors, so that a busy machine decides nothing) as "too long alike". If one build alone takes longer, it gets three
times as long before that counts as a difference. Pictures that are the same while warnings, debug texts or the texts in
the file are not are named, and are no difference.

The exit status is 0 if nothing differs, 1 if something does or a kind has no picture that both make, 2 if the command
cannot begin.
"""
import array
import collections
import os
import pathlib
import random
import re
import shlex
import sys
import tempfile

import two_builds
import random_scenes
from two_builds import ROOT, SPD, Scene

VERDICTS = ["identical", "differ", "fail alike", "too long alike"]
SMALL = ["+W160", "+H120"]

Rendering = collections.namedtuple("Rendering", "status said picture")
Picture = collections.namedtuple("Picture", "width height most pixels texts")
Result = collections.namedtuple("Result", "verdict why note one_colour")


def corpus(parser, args):
    return [Scene("corpus", name, path, ["-A", *SMALL]) for name, path in two_builds.examples(parser)]


def sheets(parser, args):
    infinite, own = ["Declare=Lenticular_Camera=1"], ["Lenticular=On"]
    ways = [(f"spd_{name}", "infinite", infinite) for name in SPD] + [(f"spd_{name}", "eye", own) for name in SPD]
    ways += [("spd_gears", "12.5 pixels a lens", [*own, "Lens_Pixels=12.5"]),
             ("spd_balls", "pinhole", [*own, "Lens_Model=pinhole"]),
             ("spd_tree", "3 angles, +A", [*own, "+A0.1", "+R2", "Antialias_Angle=3"]),
             ("demo", "eye", own), ("mosaic", "as it is", [])]
    return [Scene("sheets", f"{name} ({way})", ROOT / "scenes" / (name + ".pov"), ["+W480", "+H480", *options])
            for name, way, options in ways]


def antialiased(parser, args):
    import antialiasing
    return [Scene("antialiased", f"{name} +AM{method}", path, [f"+AM{method}", "+A0.1", "+R2", *SMALL])
            for name, path in two_builds.examples(parser, antialiasing.SCENES) for method in (1, 2)]


def made_up(parser, args):
    """Written where the command works, so that both builds read the same file."""
    scenes = []
    for k in range(args.random):
        path = args.work / f"random_{args.seed}_{k}.pov"
        path.write_text(random_scenes.scene(random.Random(f"{args.seed} {k}")))
        scenes.append(Scene("random", f"{args.seed}_{k}", path, ["-A", *SMALL]))
    return scenes


MAKERS = {"corpus": corpus, "sheets": sheets, "antialiased": antialiased, "random": made_up}


def read_ppm(data):
    """A picture of lentray's: P6, comments, size, greatest value, pixels."""
    head = re.match(rb"P6\n((?:#[^\n]*\n)*)(\d+) (\d+)\n(\d+)\n", data)
    if not head:
        return None
    texts, width, height, most = head.groups()
    return Picture(int(width), int(height), int(most), data[head.end():], texts)


def values(picture):
    if picture.most < 256:
        return array.array("B", picture.pixels)
    numbers = array.array("H", picture.pixels)
    if sys.byteorder == "little":
        numbers.byteswap()
    return numbers


def render(side, scene, args, seconds):
    program = side[0]
    with tempfile.TemporaryDirectory(dir=args.work) as folder:
        file = pathlib.Path(folder) / "picture.ppm"
        status, said = two_builds.run(command(side, scene, args, file), scene.path.parent, seconds)
        data = file.read_bytes() if file.is_file() else b""
    for own in (folder, str(program), str(program.parent)):
        said = said.replace(own, "")
    return Rendering(status, said, read_ppm(data) if status == 0 else None)


def command(side, scene, args, file):
    program, more = side
    return [program, f"+I{scene.path.name}", f"+O{file}", "+FP16", "-V", "Scene_Writes=memory",
            f"+WT{args.threads}", *scene.options, *more]


def render_both(scene, args):
    """With more time for one that alone takes too long."""
    sides = [render(side, scene, args, args.limit) for side in args.sides]
    late = [k for k, side in enumerate(sides) if side.status is None]
    if len(late) == 1:
        sides[late[0]] = render(args.sides[late[0]], scene, args, 3 * args.limit)
    return sides


def outcome(side, args):
    """What became of a rendering, in some words."""
    if side.status is None:
        return f"took more than {3 * args.limit:g} s"
    if side.picture:
        return "made a picture"
    words = " ".join(side.said.split())
    ended = f"signal {-side.status}" if side.status < 0 else f"status {side.status}"
    return f"{ended}, no picture: {words[-200:] or 'not a word'}"


def pixel_differences(before, after):
    """How many pixels differ and by how much at most, in words; "" for none."""
    if before[:3] != after[:3]:
        return "sizes: {} x {} of {} and {} x {} of {}".format(*before[:3], *after[:3])
    if before.pixels == after.pixels:
        return ""
    if len(before.pixels) != len(after.pixels):
        return f"files of {len(before.pixels)} and {len(after.pixels)} bytes of pixels"
    apart = [abs(a - b) for a, b in zip(values(before), values(after))]
    count = sum(1 for k in range(0, len(apart), 3) if any(apart[k:k + 3]))
    return (f"{count} of {len(apart) // 3} pixels, largest difference {max(apart)} of {before.most} "
            f"({255 * max(apart) / before.most:.3g}/255)")


def other_words(before, after):
    """The first line that one side alone has."""
    ours, theirs = before.splitlines(), after.splitlines()
    for when, lines, others in (("before", ours, theirs), ("after", theirs, ours)):
        for line in lines:
            if line not in others:
                return f"only {when}: {line.strip()[:150]}"
    return "other order of lines"


def compare(before, after, args):
    """Result of two renderings."""
    if before.status is None and after.status is None:
        return Result("too long alike", "", "", False)
    if not before.picture or not after.picture:
        if before == after:
            return Result("fail alike", outcome(before, args), "", False)
        return Result("differ", f"before {outcome(before, args)}; after {outcome(after, args)}", "", False)
    different = pixel_differences(before.picture, after.picture)
    if different:
        return Result("differ", different, "", False)
    note = ""
    if before.said != after.said:
        note = other_words(before.said, after.said)
    elif before.picture.texts != after.picture.texts:
        note = "in the file, " + other_words(*(s.picture.texts.decode(errors="replace") for s in (before, after)))
    size = len(before.picture.pixels) // (before.picture.width * before.picture.height)
    one_colour = before.picture.pixels == before.picture.pixels[:size] * (before.picture.width * before.picture.height)
    return Result("identical", "", note, one_colour)


def keep(scene, sides, args):
    """Pictures, the scene if it was made up, and how to repeat it."""
    name = re.sub(r"[^\w.+-]+", "_", f"{scene.kind}_{scene.name}")
    args.keep.mkdir(parents=True, exist_ok=True)
    if scene.kind == "random":
        (args.keep / (scene.path.name)).write_bytes(scene.path.read_bytes())
    lines = [f"# in {scene.path.parent if scene.kind != 'random' else args.keep}"]
    for when, made_by, side in zip(("before", "after"), args.sides, sides):
        file = args.keep / f"{name}-{when}.ppm"
        lines.append(shlex.join(map(str, command(made_by, scene, args, file))))
        if side.picture:
            p = side.picture
            file.write_bytes(b"P6\n%s%d %d\n%d\n" % (p.texts, p.width, p.height, p.most) + p.pixels)
    (args.keep / f"{name}.txt").write_text("\n".join(lines) + "\n")


def work_on(scene, args):
    sides = render_both(scene, args)
    result = compare(*sides, args)
    if result.verdict == "differ" and args.keep:
        keep(scene, sides, args)
    words = result.verdict + (", " + result.why if result.verdict == "differ" else "")
    return result, words


def report(rows):
    """The table and the lists; true if nothing differs."""
    print(f"{'kind':<12} {'scenes':>7} {'identical':>10} {'differ':>7} {'fail alike':>11} {'too long alike':>15}")
    for kind in [*(k for k in MAKERS if any(s.kind == k for s, _ in rows)), "all"]:
        of_kind = [result for scene, result in rows if kind in (scene.kind, "all")]
        counts = collections.Counter(result.verdict for result in of_kind)
        print("{:<12} {:7} {:10} {:7} {:11} {:15}".format(kind, len(of_kind), *(counts[v] for v in VERDICTS)))
    groups = [("fail alike", lambda r: r.verdict == "fail alike", lambda r: r.why),
              ("too long alike", lambda r: r.verdict == "too long alike", lambda r: ""),
              ("identical pictures of one colour", lambda r: r.one_colour, lambda r: ""),
              ("identical pictures, other words", lambda r: r.note, lambda r: r.note),
              ("differ", lambda r: r.verdict == "differ", lambda r: r.why)]
    for title, belongs, words in groups:
        found = [(scene, result) for scene, result in rows if belongs(result)]
        if found:
            print(f"\n{title}: {len(found)}")
        for scene, result in found:
            print(f"  {scene.kind} {scene.name}" + (": " + words(result) if words(result) else ""))
    return judge(rows)


def judge(rows):
    """Nothing differs, and there is something of each kind that could have."""
    empty = {scene.kind for scene, _ in rows} - {scene.kind for scene, result in rows if result.verdict == "identical"}
    for kind in sorted(empty):
        print(f"\nno picture of the kind {kind} is identical: nothing is proved")
    return not empty and not any(result.verdict == "differ" for _, result in rows)


def read_arguments():
    parser = two_builds.parser_of(__doc__, MAKERS, 60, "a scene")
    parser.add_argument("--random", type=int, default=50, metavar="N", help="how many random scenes (default 50)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="which random scenes (default 1)")
    parser.add_argument("--keep", type=pathlib.Path, metavar="DIR",
                        help="keep pictures that differ there, with the commands that make them")
    args = two_builds.read_arguments(parser)
    if args.random < 0:
        parser.error("--random must not be below 0")
    args.keep = args.keep and args.keep.resolve()
    args.threads = max(1, (os.cpu_count() or 1) // args.jobs)
    return parser, args


def main():
    parser, args = read_arguments()
    rows = two_builds.of_all(parser, args, MAKERS, work_on)
    return 0 if report(rows) else 1


if __name__ == "__main__":
    two_builds.main(main)
