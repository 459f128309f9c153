"""Media beside the truth by quadrature: errors against samples, phase functions, hard settings, scales, places.

  python3 tests/stability/media.py LENTRAY               the tables, on stdout
  ... media.py LENTRAY --write                           also docs/stability/tables.md and the charts beside it

The light along every ray of these scenes is an integral that quadrature finds to 1e-9. Pictures are floats.
An error is the root of the mean square over all pixels, as a share of the brightest truth. Stock is not
needed. The exit status is 1 where an error exceeds its limit, a pixel is no number, or light stands where
the truth is none.
"""
import argparse
import collections
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402

CHARTS = ROOT / "docs" / "stability"
PAGE = CHARTS / "tables.md"
MARKS = ("<!-- media: begin -->", "<!-- media: end -->")
WIDTH, HEIGHT = 40, 30
SAMPLES = (1, 4, 16, 64, 256)

# text: a scene that is seen along z, 2 units wide and 1.5 high. truth(x, y): of the ray through that point,
# or several numbers of which any is right. limits: of the error with the most samples, for each method.
# leak: how much light may stand where there is none, as a share of the brightest truth.
Case = collections.namedtuple("Case", "name text truth limits leak", defaults=[None, 1e-6])
# options(n): method, intervals and samples for about n samples a ray.
Method = collections.namedtuple("Method", "name options")
METHODS = [Method("1", lambda n: (1, 1, n)), Method("1, intervals", lambda n: (1, n, 1)),
           Method("2", lambda n: (2, 1, n)), Method("2, intervals", lambda n: (2, n, 1)),
           Method("3", lambda n: (3, 1, n)), Method("3, intervals", lambda n: (3, max(n // 4, 1), min(n, 4)))]
EXACT = (1e-5,) * 6
LIMITS = (None, 0.01, None, 1e-3, 0.02, 0.02)  # None: the error need not fall
STEP_LIMITS = (None, 0.01, None, 5e-3, 0.02, 0.02)
SURE = (2, 64, 1)  # options for what is even or smooth: all errors that are left have other causes
EACH = [("1", (1, 64, 1)), ("2", SURE), ("3", (3, 16, 4))]
SURE_LIMIT = 1e-3
LOST = (None,) * 3  # both programs take such distances for none


def integral(function, start, end, breaks=(), panels=24):
    """Gauss's rule of three points on panels; between breaks the function is smooth."""
    edges = [start, *sorted(b for b in breaks if start < b < end), end]
    nodes = ((0.0, 8.0 / 9.0), (-math.sqrt(0.6), 5.0 / 9.0), (math.sqrt(0.6), 5.0 / 9.0))
    total = 0.0
    for low, high in zip(edges, edges[1:]):
        half = (high - low) / panels / 2.0
        for panel in range(panels):
            middle = low + (2 * panel + 1) * half
            total += half * sum(weight * function(middle + place * half) for place, weight in nodes)
    return total


# S is the scene's scale, T where its origin lies.
CAMERA = "camera { orthographic location <0, 0, EYE>*S + T direction z*S right 2*x*S up 1.5*y*S }\n"
WHITE = "background { rgb 1 }\n"
WALL = "plane { -z, -2 hollow pigment { rgb 0 } finish { ambient 0 diffuse 0 } }\n"
CLEAR = "hollow pigment { rgbt 1 } interior { media { %s } }"
BOX = "box { <-2, -2, -1>*S + T, <2, 2, 1>*S + T " + CLEAR + " }\n"
DARK = "hollow pigment { rgb 0 } finish { ambient 0 diffuse 0 }"


def scene(body, eye=-4, scale=1.0, move=0.0):
    head = (f"#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 250 }}\n#declare S = {scale!r};\n"
            f"#declare T = <{move!r}, {move!r}/2, -{move!r}>;\n")
    return head + CAMERA.replace("EYE", str(eye)) + body + "\n"


def density(text):
    return f"density {{ function {{ {text} }} color_map {{ [0 rgb 0] [1 rgb 1] }} }}"


def even_truth(x, y):
    return math.exp(-2.4)


def ramp_truth(x, y):
    return math.exp(-3.0 * integral(lambda z: 0.2 + 0.6 * (0.5 + 0.5 * z)**2 + 0.1 * x, -1.0, 1.0))


def waves_truth(x, y):
    def before(z):  # the density's integral from -1
        return 0.5 * (z + 1.0) - 0.4 / 3.0 * (math.cos(3.0 * z + x) - math.cos(x - 3.0))
    return integral(lambda z: (0.5 + 0.4 * math.sin(3.0 * z + x)) * math.exp(-2.0 * before(z)), -1.0, 1.0)


NEAR = (0.3, 0.2, -0.4)  # a light in fog


def fog(more):
    place = f"<{NEAR[0]}, {NEAR[1]}, {NEAR[2]}>"
    return scene(WALL + f"light_source {{ {place}, 1 fade_distance 0.7 fade_power 2 {more} }}\n"
                 "media { scattering { 1, 0.5 } }")


def fog_truth(attenuated):
    def truth(x, y):
        def sent(z):
            far = math.dist((x, y, z), NEAR)
            light = 2.0 / (1.0 + (far / 0.7)**2) * (math.exp(-0.5 * far) if attenuated else 1.0)
            return 0.5 * light * math.exp(-0.5 * (z + 4.0))
        return integral(sent, -4.0, 2.0, (NEAR[2],), 48)
    return truth


LAMP = (-3.0, 0.5, -2.0)  # a light beside a box
LIT_BOX = f"light_source {{ <{LAMP[0]}, {LAMP[1]}, {LAMP[2]}>*S + T, 1 }}\n" + BOX % "scattering { 1, 0.6/S }"


def lit_box_truth(x, y):
    """The box dims the light on its way in through the wall x = -2 or z = -1, and on its way out."""
    def way_in(z):
        share = min((x + 2.0) / (x - LAMP[0]), (z + 1.0) / (z - LAMP[2]))
        return share * math.dist((x, y, z), LAMP)
    share = (x + 2.0) / (x - LAMP[0])
    edge = (2.0 * share - 1.0) / (1.0 - share)  # of the two walls
    return integral(lambda z: 0.6 * math.exp(-0.6 * (z + 1.0 + way_in(z))), -1.0, 1.0, (edge,))


WAVES = "emission 1 absorption 2 " + density("0.5 + 0.4*sin(3*z + x)")
STEP = ("emission 1 absorption 1 density { function { select(z - 0.3*x + 0.1, 0, 0.5) } "
        "color_map { [0 rgb 0] [0.5 rgb 1] } }")

# Error against samples.
SAMPLED = [
    Case("absorption, even", scene(WHITE + BOX % "absorption 1.2"), even_truth, EXACT),
    Case("absorption, denser towards the end",
         scene(WHITE + BOX % ("absorption 3 " + density("0.2 + 0.6*pow(0.5 + 0.5*z, 2) + 0.1*x"))),
         ramp_truth, LIMITS),
    Case("emission and absorption, waves", scene(WALL + BOX % WAVES), waves_truth, LIMITS),
    Case("fog, a light that fades", fog(""), fog_truth(False), LIMITS),
    Case("fog, media_attenuation", fog("media_attenuation on"), fog_truth(True), LIMITS),
    Case("a box lit from outside", scene(WALL + LIT_BOX), lit_box_truth, LIMITS),
    Case("a step of density", scene(WALL + BOX % STEP), lambda x, y: 1.0 - math.exp(-(1.1 - 0.3 * x)), STEP_LIMITS),
]


def phase(name, kind, function):
    """A thin slab that dims nothing, and a light near it, behind it or before: angles from 0 to 75 or 105 to 180."""
    def case(side, lamp):
        def truth(x, y):
            def sent(z):
                return 2.0 * function((lamp - z) / math.dist((x, y, z), (0.0, 0.0, lamp)))
            return integral(sent, -0.05, 0.05)
        text = scene(WALL + f"light_source {{ z*{lamp}, 1 }}\nbox {{ <-2, -2, -0.05>, <2, 2, 0.05> "
                     + CLEAR % f"scattering {{ {kind} extinction 0 }}" + " }")
        return Case(f"{name}, the light {side}", text, truth)
    return [case("behind", 0.3), case("before", -0.3)]


def henyey_greenstein(g):
    return phase(f"Henyey-Greenstein, {g}", f"5, 2 eccentricity {g}",
                 lambda c: (1.0 - g * g) / (1.0 + g * g - 2.0 * g * c)**1.5)


PHASES = [*phase("isotropic", "1, 2", lambda c: 1.0),
          *phase("Rayleigh", "4, 2", lambda c: 0.799372013 * (1.0 + c * c)),
          *(case for g in (-0.9, -0.4, 0.4, 0.9) for case in henyey_greenstein(g))]


def chord(radius, x, y):
    return 2.0 * math.sqrt(max(radius * radius - x * x - y * y, 0.0))


def shell(thick):
    """Between two balls, so that what it absorbs does not depend on `thick`."""
    inner = 0.7 * (1.0 - thick)
    text = scene(WHITE + f"difference {{ sphere {{ 0, 0.7 }} sphere {{ 0, {inner!r} }} "
                 + CLEAR % f"absorption {0.2 / thick!r}" + " }")
    return Case(f"a shell, {thick:g} of its radius thick", text,
                lambda x, y: math.exp(-0.2 / thick * (chord(0.7, x, y) - chord(inner, x, y))),
                LOST if thick < 1e-3 else None)


def wall(thick):
    text = scene(WHITE + f"box {{ <-3, -3, 0>, <3, 3, {thick!r}> "
                 + CLEAR % f"absorption {0.8 / thick!r}" + " rotate 30*y }")
    return Case(f"a slanting wall, {thick:g} thick", text, lambda x, y: math.exp(-0.8 / math.cos(math.radians(30.0))),
                LOST if thick < 1e-4 else None)


def side_by_side(start, width, amounts, half_height):
    return WHITE + "".join(
        f"box {{ <{start + i * width:.4f}, -{half_height}, -1>, <{start + (i + 1) * width:.4f}, {half_height}, 1> "
        + CLEAR % f"absorption {amount}" + " }\n" for i, amount in enumerate(amounts))


AMOUNTS = [0.05 * 2**i for i in range(6)]
PAIR = [0.1, 0.5] * 9


def shared_truth(x, y):
    number = math.floor((x + 0.9) / 0.3)
    return math.exp(-2.0 * AMOUNTS[number]) if 0 <= number < 6 and abs(y) < 0.6 else 1.0


def in_walls_truth(x, y):
    """Every second column of pixels lies in a wall: either box may count, or both, or none."""
    place = (x + 0.975) / 0.1
    number = round(place)
    if abs(place - number) > 1e-6:
        number = math.floor(place)
        return math.exp(-2.0 * PAIR[number]) if 0 <= number < 18 else 1.0
    left = PAIR[number - 1] if 0 < number <= 18 else 0.0
    right = PAIR[number] if 0 <= number < 18 else 0.0
    return tuple(math.exp(-2.0 * sum_) for sum_ in (0.0, left, right, left + right))


def nested_truth(x, y):
    return math.exp(-0.05 * sum(chord(0.7 * (1.0 - i / 25), x, y) for i in range(24)))


HARD = [
    *map(shell, (0.1, 1e-2, 1e-3, 1e-4)), *map(wall, (1e-2, 1e-3, 1e-4, 1e-6)),
    Case("boxes that share walls", scene(side_by_side(-0.9, 0.3, AMOUNTS, 0.6)), shared_truth),
    Case("rays in the walls of boxes", scene(side_by_side(-0.975, 0.1, PAIR, 2)), in_walls_truth),
    Case("the eye inside", scene(WHITE + BOX % "absorption 1.2", eye=0), lambda x, y: math.exp(-1.2)),
    Case("the eye in a wall", scene(WHITE + BOX % "absorption 1.2", eye=-1), lambda x, y: (math.exp(-2.4), 1.0)),
    Case("the eye 1e-9 before a wall", scene(WHITE + BOX % "absorption 1.2", eye=-1 - 1e-9), even_truth, LOST),
    Case("24 balls, one in another", scene(WHITE + "".join(
        f"sphere {{ 0, {0.7 * (1.0 - i / 25)!r} " + CLEAR % "absorption 0.05" + " }\n" for i in range(24))),
         nested_truth),
]


def cone_truth(x, y):
    """A sharp cone of 20 degrees that points down from <0, 0.9, 0>."""
    wide = (max(0.9 - y, 0.0) * math.tan(math.radians(20.0)))**2 - x * x
    return 0.8 * math.sqrt(max(wide, 0.0))


SPOT = ("light_source { <0, 0.9, 0>*S + T, 1 spotlight radius 20 falloff 20 tightness 0 point_at T }\n"
        + BOX % "scattering { 1, 0.4/S extinction 0 }")
TUBE = ("light_source { <-1.5, 0, 0>*S + T, 1 cylinder radius 0.4*S falloff 0.4*S tightness 0 point_at T }\n"
        + BOX % "scattering { 1, 0.4/S extinction 0 }")
# (name, body, truth): at all scales and places.
SIZED = [
    ("absorbing ball", WHITE + "sphere { T, 0.7*S " + CLEAR % "absorption 1.5/S" + " }",
     lambda x, y: math.exp(-1.5 * chord(0.7, x, y))),
    ("glowing waves", "box { <-2, -2, -1>, <2, 2, 1> "
     + CLEAR % WAVES.replace("1 abs", "1/S abs").replace("2 dens", "2/S dens")
     + " scale S translate T }", waves_truth),
    ("lit box", LIT_BOX, lit_box_truth),
    ("spotlight", SPOT, cone_truth),
    ("cylinder light", TUBE, lambda x, y: 0.4 * chord(0.4, 0.0, y)),
]
SETTINGS = [("scale 1e-6", 1e-6, 0.0), ("scale 1e-3", 1e-3, 0.0), ("scale 1", 1.0, 0.0), ("scale 1e3", 1e3, 0.0),
            ("scale 1e6", 1e6, 0.0), ("moved 1e3", 1.0, 1e3), ("moved 1e6", 1.0, 1e6)]

# No light is seen in these, or only where the truth is more than none.
LEAKS = [
    Case("beside a spotlight's cone", scene(SPOT), cone_truth),
    Case("beside a cylinder light", scene(TUBE), lambda x, y: 0.4 * chord(0.4, 0.0, y)),
    Case("fog around a closed box with a light", scene(
        f"light_source {{ 0, 1 }}\nbox {{ -0.6, 0.6 {DARK} }}\nmedia {{ scattering {{ 1, 0.5 }} }}"),
         lambda x, y: 0.0),
    Case("the same, walls 1e-4 thick", scene(
        f"light_source {{ 0, 1 }}\ndifference {{ box {{ -0.6, 0.6 }} box {{ -0.5999, 0.5999 }} {DARK} }}\n"
        "media { scattering { 1, 0.5 } }"), lambda x, y: 0.0),
    Case("a glowing box behind a black wall", scene(f"plane {{ -z, 1.001 {DARK} }}\n" + BOX % "emission 1"),
         lambda x, y: 0.0),
    Case("a glowing box that touches a black wall", scene(
        f"box {{ <-3, -3, -2>, <3, 3, -1> {DARK} }}\n" + BOX % "emission 1"), lambda x, y: 0.0),
    Case("beside a glowing ball", scene("sphere { 0, 0.5 " + CLEAR % "emission 1" + " }"),
         lambda x, y: chord(0.5, x, y)),
    Case("beside a glowing ring, 1e-3 thick", scene("torus { 0.5, 0.001 " + CLEAR % "emission 1" + " rotate 90*x }"),
         lambda x, y: chord(0.001, math.hypot(x, y) - 0.5, 0.0)),
]


def places():
    return [((column + 0.5) / WIDTH * 2.0 - 1.0, 0.75 - (row + 0.5) / HEIGHT * 1.5)
            for row in range(HEIGHT) for column in range(WIDTH)]


Result = collections.namedtuple("Result", "error bad leak seconds")


def red_of_exr(data):
    """Of an OpenEXR file of float scan lines in RGB, packed by zlib; rows from above."""
    place, attributes = 8, {}
    while data[place]:
        name, kind, rest = data[place:].split(b"\0", 2)
        place += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", data, place)[0]
        attributes[name] = data[place + 4:place + 4 + size]
        place += 4 + size
    left, top, right, bottom = struct.unpack("<4i", attributes[b"dataWindow"])
    lines = {b"\2": 1, b"\3": 16}[attributes[b"compression"]]
    width, height = right - left + 1, bottom - top + 1
    red = []
    for offset in struct.unpack_from(f"<{-(-height // lines)}Q", data, place + 1):
        first, size = struct.unpack_from("<2i", data, offset)
        count = min(lines, bottom + 1 - first)
        block = data[offset + 8:offset + 8 + size]
        if size < 12 * width * count:
            block = unpacked(block)
        for line in range(count):  # channels in the order of the alphabet
            red.extend(struct.unpack_from(f"<{width}f", block, (12 * line + 8) * width))
    return red


def unpacked(block):
    """Bytes are differences, and those at even places stand before the others."""
    raw = bytearray(zlib.decompress(block))
    for i in range(1, len(raw)):
        raw[i] = (raw[i - 1] + raw[i] - 128) & 255
    out, half = bytearray(len(raw)), (len(raw) + 1) // 2
    out[0::2], out[1::2] = raw[:half], raw[half:]
    return bytes(out)


def choices(truth):
    return truth if isinstance(truth, tuple) else (truth,)


class Measurements:
    """Pictures are frames of one animation, so that the program starts once: measurements are asked for twice,
    first to learn which pictures there are, then for their errors."""

    def __init__(self, lentray, folder):
        self.lentray, self.folder, self.truths, self.faults = lentray, folder, {}, []
        self.frames, self.pictures = {scene(WALL): 1}, None

    def picture(self, text, options):
        """(red of every pixel, seconds of processors), or nothing yet."""
        text = text.replace("media {", "media { method %d intervals %d samples %d, %d" % (*options, options[2]))
        frame = self.frames.setdefault(text, len(self.frames) + 1)
        return self.pictures[frame] if self.pictures else ([math.nan] * (WIDTH * HEIGHT), 0.0)

    def render(self):
        self.faults.clear()
        cases = "".join(f"#case ({frame})\n{text}#break\n" for text, frame in self.frames.items())
        (self.folder / "scene.pov").write_text(f"#version 3.7;\n#switch (frame_number)\n{cases}#end\n")
        last = len(self.frames)
        done = subprocess.run([self.lentray, "+Iscene.pov", "+Oscene.exr", "+FE32", f"+W{WIDTH}", f"+H{HEIGHT}", "-A",
                               "-D", "+WT1", "+KFI1", f"+KFF{last}"], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False)
        seconds = [float(s) for s in re.findall(r"rendering (\S+) \(CPU", done.stdout + done.stderr)]
        files = sorted(self.folder.glob("scene*.exr"), key=lambda file: int(file.stem[5:]))
        if done.returncode != 0 or len(files) != last or len(seconds) != last:
            sys.exit(f"{len(files)} pictures of {last}: {done.stderr[-2000:]}")
        reds = [red_of_exr(file.read_bytes()) for file in files]
        self.pictures = dict(enumerate(zip(reds, seconds), 1))

    def measure(self, what, text, truth, options, limit, most_leak=1e-6):
        if truth not in self.truths:
            self.truths[truth] = [choices(truth(x, y)) for x, y in places()]
        right = self.truths[truth]
        values, seconds = self.picture(text, options)
        brightest = max(max(t) for t in right) or 1.0
        finite = [(v, t) for v, t in zip(values, right) if math.isfinite(v)]
        error = math.sqrt(sum(min((v - u)**2 for u in t) for v, t in finite) / max(len(finite), 1)) / brightest
        leak = max((abs(v) / brightest for v, t in finite if max(t) == 0.0), default=0.0)
        result = Result(error, len(values) - len(finite), leak, seconds)
        if result.bad:
            self.faults.append(f"{what}: {result.bad} pixels are no numbers")
        if leak > most_leak:
            self.faults.append(f"{what}: {leak:.1e} of light where there is none")
        if limit is not None and error > limit:
            self.faults.append(f"{what}: error {error:.1e}, limit {limit:g}")
        return result


def number(value):
    return "0" if value < 5e-7 else f"{value:.1e}"


def rows(lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def sampled(m):
    """(table, {case: {method: errors}})"""
    lines = [["scene", "method", *map(str, SAMPLES), f"microseconds a ray, {SAMPLES[-1]}"],
             ["---"] * (len(SAMPLES) + 3)]
    curves = {}
    for case in SAMPLED:
        curves[case.name] = {}
        for method, limit in zip(METHODS, case.limits):
            results = [m.measure(f"{case.name}, method {method.name}, {n} samples", case.text, case.truth,
                                 method.options(n), limit if n == SAMPLES[-1] else None) for n in SAMPLES]
            curves[case.name][method.name] = [r.error for r in results]
            time = 1e6 * results[-1].seconds / (WIDTH * HEIGHT)
            lines.append([case.name, method.name, *(number(r.error) for r in results), f"{time:.0f}"])
    return rows(lines), curves


def all_methods(m, cases, title):
    """A table with a column a method, 64 samples."""
    lines = [[title, *(f"method {method}" for method, _ in EACH), "light where there is none"], ["---"] * 5]
    for case in cases:
        results = [m.measure(f"{case.name}, method {method}", case.text, case.truth, options,
                             SURE_LIMIT if method == "2" and case.limits is None else None, case.leak)
                   for method, options in EACH]
        lines.append([case.name, *(number(r.error) for r in results), number(max(r.leak for r in results))])
    return rows(lines)


def sized(m):
    """(table, {scene: errors})"""
    lines = [["scene", *(name for name, _, _ in SETTINGS)], ["---"] * (1 + len(SETTINGS))]
    errors = {}
    for name, body, truth in SIZED:
        errors[name] = [m.measure(f"{name}, {setting}", scene(body, scale=scale, move=move), truth, SURE,
                                  None if "light" in name and scale < 1e-3 else SURE_LIMIT).error
                        for setting, scale, move in SETTINGS]
        lines.append([name, *map(number, errors[name])])
    return rows(lines), errors


def everything(m):
    by_samples, curves = sampled(m)
    phases, hard, leaks = (all_methods(m, cases, title) for cases, title in
                           ((PHASES, "phase function"), (HARD, "setting"), (LEAKS, "scene")))
    return by_samples, curves, phases, hard, leaks, *sized(m)


def draw_errors(curves, path):
    cases = [name for name in curves if name != "absorption, even"]
    data, plots = [], []
    for name in cases:
        commands = []
        for k, method in enumerate(METHODS):
            commands.append(f"'data' index {len(data)} with linespoints pt {5 + k // 2 * 2} lc {k // 2 + 1} "
                            f"dt {1 + k % 2} title '{method.name}'")
            data.append("\n".join(f"{n} {max(e, 1e-9)}" for n, e in zip(SAMPLES, curves[name][method.name])))
        plots.append(f"set title '{name}'\nplot [0.8:330] [1e-7:1] " + ", ".join(commands))
    gnuplot("1200,760", "set logscale xy\nset format y '%.0e'\nset key bottom left samplen 2 font ',9'\nset xlabel 'samples a ray'\n"
            "set ylabel 'error, rms, share of the brightest'\nset multiplot layout 2,3\n"
            + "\n".join(plots), data, path)


def draw_scales(errors, path):
    tics = ", ".join(f"'{name}' {k}" for k, (name, _, _) in enumerate(SETTINGS))
    plots = ", ".join(f"'data' index {k} with linespoints pt {5 + 2 * k} title \"{name}\""
                      for k, name in enumerate(errors))
    data = ["\n".join(f"{k} {max(e, 1e-9)}" for k, e in enumerate(values)) for values in errors.values()]
    gnuplot("900,420", f"set logscale y\nset format y '%.0e'\nset xtics ({tics})\nset key outside\n"
            f"set ylabel 'error, rms, share of the brightest'\nplot [-0.3:{len(SETTINGS) - 0.7}] [1e-9:1] "
            f"{plots}", data, path)


SECTION = """Pictures of scenes whose light is known by quadrature, {width} x {height} floats. Errors are the root of
the mean square over all pixels, as a share of the brightest; 0 is less than 5e-7. The numbers above
the columns are samples a ray. The time is that of the whole picture, to a hundredth of a second.

![Errors against samples](media_error.png)

{sampled}

- *Intervals*: as many intervals of one sample; with method 3, a quarter as many of four.
- **Even media that only absorb** are exact with one sample.
- **Methods 1 and 2 need intervals.** They take each interval for even when they dim the light that
  it sends out: in one interval of a medium that varies, more samples do not lead to the truth.
- **Method 1** takes samples at random. In one interval its error falls with the root of their
  number at best; with more intervals it falls with the power 1.5 of theirs where the medium is smooth.
- **Method 2** takes them at even distances. Its error falls with the square of the number of
  intervals where the density is smooth, and with their number where it has a step.
- **Method 3** leaves out the last part of each interval, as stock does. Its error falls with the
  number of samples; intervals and samples have about the same effect.

Phase functions, in a thin slab that dims nothing, 64 samples:

{phases}

Hard settings, 64 samples. Every medium is even:

{hard}

- Walls thinner than 1e-4, and an eye nearer than that to a wall, are lost: a ray that starts on a
  surface does not hit another one so near. Stock loses the same ones.
- A ray remembers 24 containers, one in another. It forgets what lies in more.

Light that must not be seen, 64 samples. The error counts the whole picture; the last column is the
brightest pixel where the truth is none:

{leaks}

Walls throw a shadow on samples in the air however near they are. In stock those within 1e-3 let some
light through.

The same scenes at all scales (amounts divided by the scale) and far from the origin, method 2 with
64 samples:

![Errors at all scales and places](media_scales.png)

{sized}
"""


def write(text):
    page = PAGE.read_text()
    before, rest = page.split(MARKS[0])
    PAGE.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{rest.split(MARKS[1])[1]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lentray", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        m = Measurements(args.lentray.resolve(), pathlib.Path(folder))
        everything(m)
        m.render()
        by_samples, curves, phases, hard, leaks, by_size, errors = everything(m)
    text = SECTION.format(width=WIDTH, height=HEIGHT, sampled=by_samples, phases=phases, hard=hard, leaks=leaks,
                          sized=by_size)
    print(text)
    if args.write:
        write(text)
        draw_errors(curves, CHARTS / "media_error.png")
        draw_scales(errors, CHARTS / "media_scales.png")
    for fault in m.faults:
        print(f"fault: {fault}")
    return 1 if m.faults else 0


if __name__ == "__main__":
    sys.exit(main())
