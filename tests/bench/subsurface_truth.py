"""Subsurface light beside what it stands for: charts without threshold.

  tests/bench/subsurface_truth.py LENTRAY [POVRAY]    all charts, on stdout

pencil  A beam of 1 mm falls on a large flat solid. What leaves at some distance is the dipole's R(r)
        (Jensen and others, SIGGRAPH 2001, equation 4), summed over the beam, times what passes the surface in
        and out. Single scattering is off.
slab    A flat slab with the light behind it, seen straight on. Its truth is a random walk: even scattering,
        no surface (ior 1).
noise   Three solids with `samples 50, 50` and fewer or more: the rms difference, in 1/255, from Lentray's
        picture of 1,500 samples.

Brightnesses are those of POV-Ray: 1 is a white matt surface in the same light. One thread.
"""
import math
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from pictures import read_png  # noqa: E402

MM = 10.0        # in a unit
LOST = 1.0       # per mm
IOR = 1.3
BEAM = 1.0       # mm, radius
COLUMNS = 16


def boundary_factor(ior):
    x = 1.0 - 1.0 / ior
    inside = (x + 3.0 * x ** 4.5) / 4.0
    return (1.0 + inside) / (1.0 - inside)


def reflectance(factor, albedo):
    root = math.sqrt(3.0 * (1.0 - albedo))
    return albedo / 2.0 * (1.0 + math.exp(-4.0 / 3.0 * factor * root)) * math.exp(-root)


def dipole(r, albedo, factor):
    decay = math.sqrt(3.0 * (1.0 - albedo)) * LOST
    total = 0.0
    for depth in (1.0 / LOST, (1.0 + 4.0 / 3.0 * factor) / LOST):
        d = math.hypot(depth, r)
        total += depth * (decay + 1.0 / d) * math.exp(-decay * d) / d ** 2
    return albedo / (4.0 * math.pi) * total


def pencil_truth(r, albedo):
    """Over the beam, in rings and sectors."""
    factor, passes, total = boundary_factor(IOR), 1.0 - ((IOR - 1.0) / (IOR + 1.0)) ** 2, 0.0
    rings, sectors = 20, 48
    for i in range(rings):
        ring = BEAM * (i + 0.5) / rings
        for j in range(sectors):
            angle = 2.0 * math.pi * (j + 0.5) / sectors
            away = math.hypot(r - ring * math.cos(angle), ring * math.sin(angle))
            total += dipole(away, albedo, factor) * ring * (BEAM / rings) * (2.0 * math.pi / sectors)
    return total * passes ** 2


def slab_truth(thickness, albedo, walks=40000):
    """Of a walk each scattering sends some light straight to the eye."""
    chance, total = random.Random(1), 0.0
    for _ in range(walks):
        depth, cosine, weight = 0.0, 1.0, 1.0
        while weight > 1e-4:
            depth += cosine * -math.log(1.0 - chance.random()) / LOST
            if not 0.0 < depth < thickness:
                break
            weight *= albedo
            total += weight / 4.0 * math.exp(-LOST * (thickness - depth))
            cosine = 2.0 * chance.random() - 1.0
    return total / walks


def pigment_of(albedo, ior):
    return reflectance(boundary_factor(ior), albedo)


SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 mm_per_unit {mm} subsurface {{ samples {samples} }} }}
camera {{ orthographic location {eye} look_at {at} right {width}*x up y*.01 }}
{light}
{solid}
  pigment {{ rgb {pigment} }} finish {{ ambient 0 diffuse 1 subsurface {{ translucency {translucency} }} }}
  interior {{ ior {ior} }} }}
"""


def picture(program, scene, columns, rows, *options):
    """Values of 0 to 1 of all channels, pixel after pixel."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        (path / "scene.pov").write_text(scene)
        run = subprocess.run([program, "+Iscene.pov", "+Oout.png", "+FN16", f"+W{columns}", f"+H{rows}", "-A", "-D",
                              "-GA", "+WT1", *options], cwd=folder, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(run.stdout + run.stderr)
        rows, bits = read_png((path / "out.png").read_bytes())
        return [value / (2 ** bits - 1) for row in rows for pixel in row for value in pixel[:3]]


def render(program, scene, columns):
    """Red, of a row."""
    return picture(program, scene, columns, 1, "File_Gamma=1")[::3]


def chart(title, head, rows):
    print(f"{title}\n\n| {' | '.join(head)} |\n|{'---:|' * len(head)}")
    for row in rows:
        print(f"| {' | '.join(row)} |")
    print()


def pencil(programs):
    albedo, step, bright = 0.9, 0.5, 4.0
    width = COLUMNS * step / MM
    scene = SCENE.format(
        mm=MM, samples="20000, 0", eye=f"<{width / 2}, 1, 0>", at=f"<{width / 2}, 0, 0.000001>", width=width,
        light=f"light_source {{ 5*y rgb {bright} cylinder point_at 0 radius {BEAM / MM} falloff {BEAM / MM} "
              "tightness 0 parallel }", solid="box { <-50, -50, -50>, <50, 0, 50>", pigment=pigment_of(albedo, IOR),
        translucency=1.0 / (albedo * LOST), ior=IOR)
    seen = [render(program, scene, COLUMNS) for program in programs]
    rows = []
    for i in range(COLUMNS):
        r = (i + 0.5) * step
        rows.append([f"{r:.2f}", f"{pencil_truth(r, albedo):.5f}"] + [f"{s[i] / bright:.5f}" for s in seen])
    chart("A beam of 1 mm on a flat solid: what leaves at r",
          ["r, mm", "dipole"] + [pathlib.Path(p).name for p in programs], rows)


def slab(programs):
    albedo, rows = 0.9, []
    for thickness in (0.5, 1.0, 2.0, 4.0, 8.0):
        scene = SCENE.format(
            mm=MM, samples="4000, 4000", eye="<0, 0, -3>", at="<0, 0, 0>", width=0.01,
            light="light_source { 100*z rgb 1 parallel point_at 0 }",
            solid=f"box {{ <-20, -20, 0>, <20, 20, {thickness / MM}>", pigment=pigment_of(albedo, 1.0),
            translucency=1.0 / (albedo * LOST), ior=1.0)
        seen = [render(program, scene, 4) for program in programs]
        rows.append([f"{thickness:.1f}", f"{slab_truth(thickness, albedo):.4f}"] +
                    [f"{sum(s) / len(s):.4f}" for s in seen])
    chart("A slab with the light behind it",
          ["thickness, mm", "random walk"] + [pathlib.Path(p).name for p in programs], rows)


SOLIDS = {
    "ball": "sphere { 0, 1",
    "slab": "box { <-1, -.2, -1>, <1, .2, 1> rotate 20*y",
    "bowl": "difference { sphere { 0, 1 } box { <-2, .3, -2>, 2 } sphere { .5*y, .7 }",
}
SOLID_SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 mm_per_unit 10 subsurface {{ samples 50, 50 }} }}
camera {{ location <0, 1.2, -5> look_at <0, 0.2, 0> angle 42 }}
light_source {{ <-5, 8, -6> rgb 1 }}
plane {{ y, -1 pigment {{ checker rgb .7 rgb .3 }} finish {{ ambient .05 }} }}
{solid}
  pigment {{ rgb <.8, .6, .4> }} finish {{ ambient 0 subsurface {{ translucency <1.5, 1, .7> }} }}
  interior {{ ior 1.4 }} }}
"""


def noise(programs):
    def rms(one, other):
        return 255.0 * math.sqrt(sum((a - b) ** 2 for a, b in zip(one, other)) / len(one))
    counts, rows = (25, 33, 50, 67, 100), []
    for name, solid in SOLIDS.items():
        scene = SOLID_SCENE.format(solid=solid)
        truth = picture(programs[0], scene, 96, 72, "Subsurface_Samples=1500")
        ours = [picture(programs[0], scene, 96, 72, f"Subsurface_Samples={n}") for n in counts]
        others = [picture(p, scene, 96, 72) for p in programs[1:]]
        rows.append([name] + [f"{rms(p, truth):.2f}" for p in others + ours])
    chart("Noise, rms in 1/255", ["solid"] + [f"{pathlib.Path(p).name}, 50" for p in programs[1:]] +
          [f"{pathlib.Path(programs[0]).name}, {n}" for n in counts], rows)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    pencil(sys.argv[1:])
    slab(sys.argv[1:])
    noise(sys.argv[1:])
