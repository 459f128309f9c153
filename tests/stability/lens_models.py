"""The lens models paraxial and pinhole beside the model thick: where each may be used.

  python3 tests/stability/lens_models.py LENTRAY           checks the rays of LENTRAY; the tables, on stdout
  ... lens_models.py LENTRAY --write                       also docs/stability/tables.md, the charts and lens_models.csv

The truth is a trace of its own: rays in the cross-section of a sheet of glass, each of which leaves the print
through one of 201 points of the lens's surface. The exit status is 1 where the rays that LENTRAY writes
(--dump-rays) are farther than 1e-12 from it. Stock is not needed.
"""
import argparse
import collections
import csv
import io
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from support.charts import gnuplot  # noqa: E402

PAGE = ROOT / "docs" / "stability" / "tables.md"
CHARTS = ROOT / "docs" / "stability"
MARKS = ("<!-- lens models: begin -->", "<!-- lens models: end -->")
POINTS = 201

Lens = collections.namedtuple("Lens", "pitch focal ior pixels", defaults=[15])
PAPER = Lens(1.124, 3.03, 1.6)


def radius(lens):
    return lens.focal * (lens.ior - 1.0) / lens.ior


def widest(part, focal=3.03, ior=1.6, pixels=15):
    """A lens whose pitch is that part of the widest one, a half circle."""
    return Lens(part * 2.0 * focal * (ior - 1.0) / ior, focal, ior, pixels)


def refracted(way, normal, ratio):
    """Unit vectors; the normal is on the side that the ray goes to. None: total reflection."""
    cosine = way[0] * normal[0] + way[1] * normal[1]
    along = [ratio * (w - cosine * m) for w, m in zip(way, normal)]
    left = 1.0 - along[0]**2 - along[1]**2
    if left <= 0.0:
        return None
    return [a + math.sqrt(left) * m for a, m in zip(along, normal)]


def thick_ray(lens, offset, across):
    """(x, z, slope) where the ray leaves the sheet, or None: it shows nothing. z is behind the vertices."""
    r, half = radius(lens), lens.pitch / 2.0

    def depth(x):
        return r - math.sqrt(max(r * r - x * x, 0.0))
    if abs(offset) > half:  # the straight way to the point must pass below the edge
        part = (math.copysign(half, offset) - across) / (offset - across)
        if depth(across) + part * (lens.focal - depth(across)) < depth(half):
            return None
    axis, place = 0.0, [across, depth(across)]
    way = [across - offset, place[1] - lens.focal]
    way = [w / math.hypot(*way) for w in way]
    way = refracted(way, [place[0] / r, (place[1] - r) / r], lens.ior)
    while way:
        side = math.copysign(lens.pitch, way[0])  # the next lens on the way
        from_middle = [place[0] - axis - side, place[1] - r]
        towards = -(from_middle[0] * way[0] + from_middle[1] * way[1])
        under = towards**2 - (from_middle[0]**2 + from_middle[1]**2 - r * r)
        if towards <= 0.0 or under <= 0.0:
            return (place[0], place[1], way[0] / way[1]) if way[1] < 0.0 else None
        axis += side
        distance = towards - math.sqrt(under)
        place = [p + distance * w for p, w in zip(place, way)]
        inwards = [(axis - place[0]) / r, (r - place[1]) / r]
        way = refracted(way, inwards, 1.0 / lens.ior)
        chord = 2.0 * r * (way[0] * inwards[0] + way[1] * inwards[1])
        place = [p + chord * w for p, w in zip(place, way)]
        if abs(place[0] - axis) > half or place[1] >= r:
            return None  # down to the print
        way = refracted(way, [(place[0] - axis) / r, (place[1] - r) / r], lens.ior)
    return None


def model_slope(model, lens, offset):
    """None: total reflection."""
    if model == "paraxial":
        return lens.ior * offset / lens.focal
    sine = lens.ior * math.sin(math.atan(offset / lens.focal))
    return math.tan(math.asin(sine)) if abs(sine) < 1.0 else None


def offsets(lens):
    return [((k + 0.5) / lens.pixels - 0.5) * lens.pitch for k in range(int(lens.pixels))]


def rays_of(lens, offset, points=POINTS, within=0.5):
    """Each through its own part of the aperture, at that place within the part."""
    return [thick_ray(lens, offset, ((j + within) / points - 0.5) * lens.pitch) for j in range(points)]


def mean(values):
    return sum(values) / len(values) if values else math.nan


def spread(values):
    middle = mean(values)
    return math.sqrt(mean([(v - middle)**2 for v in values])) if values else math.nan


# Of a lens's pixels: the models' errors and the blur, root mean square and largest, and the share of dark rays.
Errors = collections.namedtuple("Errors", "paraxial pinhole blur paraxial_most pinhole_most blur_most dark")
Pixel = collections.namedtuple("Pixel", "offset paraxial pinhole blur dark")


def at_infinity(lens, offset):
    """Slopes, in steps from pixel to pixel."""
    step = lens.ior * lens.pitch / lens.pixels / lens.focal
    rays = rays_of(lens, offset)
    slopes = [ray[2] for ray in rays if ray]
    errors = [(model_slope(model, lens, offset) - mean(slopes)) / step for model in ("paraxial", "pinhole")]
    return Pixel(offset, *errors, spread(slopes) / step, rays.count(None) / len(rays))


def at_depth(lens, offset, depth):
    """Places at a depth behind the sheet (mm), in pixels of a view, which are as wide as a lens."""
    rays = [ray for ray in rays_of(lens, offset) if ray]
    places = [x + slope * (depth - z) for x, z, slope in rays]
    errors = [(model_slope(model, lens, offset) * depth - mean(places)) / lens.pitch
              for model in ("paraxial", "pinhole")]
    return Pixel(offset, *errors, spread(places) / lens.pitch, 0.0)


def summed(pixels):
    columns = [[abs(p[i]) for p in pixels] for i in (1, 2, 3)]
    squares = [math.sqrt(mean([v * v for v in column])) for column in columns]
    return Errors(*squares, *map(max, columns), mean([p.dark for p in pixels]))


def far(lens):
    return summed([at_infinity(lens, o) for o in offsets(lens)])


def near(lens, depth):
    return summed([at_depth(lens, o, depth) for o in offsets(lens)])


# The check of a program's rays.

SHEETS = [(PAPER, 16, 45, 0.0), (Lens(25.4 / 60.0, 0.7, 1.57, 10), 7, 40, 0.0), (Lens(1.8, 2.0, 1.9, 12), 33, 36, 0.0),
          (Lens(0.9, 2.2, 1.5, 7.37), 1, 40, 0.1), (Lens(0.923, 2.0, 1.3, 12), 65, 36, 0.5)]


def scene(lens, rays, columns, slope):
    width = columns / lens.pixels * lens.pitch
    return (f"#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\nsphere {{ -1000, 1 }}\n"
            f"camera {{ lenticular location 0 direction <{slope!r}, 0, 1> right {width!r}*x up y\n"
            f"lens_pitch {lens.pitch!r} lens_focal_length {lens.focal!r} lens_ior {lens.ior!r} "
            f"lens_pixels {lens.pixels!r}\nlens_front 3 view_distance 0 lens_model thick lens_rays {rays} }}\n")


def expected(lens, rays, columns, slope):
    """(origin x, origin z, slope) of every ray of the first row, or None."""
    sine = slope / math.hypot(1.0, slope) / lens.ior
    shift = lens.focal * sine / math.sqrt(1.0 - sine * sine)
    out = []
    numbers = [math.floor((column + 0.5) / lens.pixels) for column in range(columns)]
    for column, number in enumerate(numbers):
        # In steps of 1e-5: that of a view, and that of a lens.
        turns = 50000 + 81917 * (column - numbers.index(number)) + 43260 * number
        within = turns % 100000 / 100000 if rays > 1 else 0.5
        offset = ((column + 0.5) / lens.pixels - number - 0.5) * lens.pitch + shift
        axis = (number + 0.5 - columns / lens.pixels / 2.0) * lens.pitch
        for ray in rays_of(lens, offset, rays, within):
            out.append(ray and (axis + ray[0] - ray[2] * (3.0 + ray[1]), -3.0, ray[2]))
    return out


def farthest(program):
    """The largest difference of the rays that the program writes from the trace, in mm and slopes."""
    largest = 0.0
    for lens, rays, columns, slope in SHEETS:
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "scene.pov").write_text(scene(lens, rays, columns, slope))
            done = subprocess.run([program, "+Iscene.pov", f"+W{columns}", "+H1", "-F", "-V", "--dump-rays", "rays"],
                                  cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(done.stderr)
            lines = [line.split()[2:] for line in pathlib.Path(folder, "rays").read_text().splitlines()
                     if not line.startswith("#")]
        truth = expected(lens, rays, columns, slope)
        if len(lines) != len(truth):
            sys.exit(f"{len(lines)} rays instead of {len(truth)}")
        for words, ray in zip(lines, truth):
            if (words == ["dark"]) != (ray is None):
                return math.inf
            if ray:
                x, _, z, dx, _, dz = map(float, words)
                scale = max(1.0, ray[2]**2)
                largest = max(largest, abs(x - ray[0]) / scale, abs(z - ray[1]), abs(dx / dz - ray[2]) / scale)
    return largest


# Sweeps, tables and charts.

PARTS = [0.02 * i for i in range(1, 51)]
FOCALS = [1.6 * 1.06**i for i in range(0, 38)]
INDICES = [1.26 + 0.02 * i for i in range(0, 38)]
DEPTHS = [10.0**(-1.0 + 0.1 * i) for i in range(0, 41)]
SHOWN = [("the paper's lens", PAPER), ("60 lpi, 0.7 mm thick", Lens(25.4 / 60.0, 0.7, 1.57, 10)),
         ("a quarter of the widest", widest(0.25)), ("half the widest", widest(0.5)),
         ("0.8 of the widest", widest(0.8)), ("0.95 of the widest", widest(0.95)),
         ("the widest, half circles", widest(1.0)),
         ("n = 1.9, 0.8 of the widest", widest(0.8, ior=1.9))]


def sweeps():
    """{name: [(value, Errors)]}, of the paper's lens but for what is varied."""
    return {"pitch": [(lens.pitch, far(lens)) for lens in map(widest, PARTS)],
            "focal length": [(f, far(PAPER._replace(focal=f))) for f in FOCALS],
            "index": [(n, far(PAPER._replace(ior=n))) for n in INDICES
                      if PAPER.pitch <= 2.0 * radius(PAPER._replace(ior=n))],
            "depth behind the sheet": [(d, near(PAPER, d)) for d in DEPTHS],
            "depth before the sheet": [(-d, near(PAPER, -d)) for d in DEPTHS]}


def number(value):
    return "0" if abs(value) < 5e-4 else f"{value:.3g}"


def rows(lines):
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def table():
    lines = [["lens", "P, mm", "P/2R", "paraxial", "largest", "pinhole", "largest", "blur", "largest", "dark rays, %"],
             ["---"] * 10]
    for name, lens in SHOWN:
        e = far(lens)
        lines.append([name, f"{lens.pitch:.3f}", f"{lens.pitch / 2.0 / radius(lens):.2f}", number(e.paraxial),
                      number(e.paraxial_most), number(e.pinhole), number(e.pinhole_most), number(e.blur),
                      number(e.blur_most), number(100.0 * e.dark)])
    return rows(lines)


def depth_table():
    lines = [["lens", "depth, mm", "paraxial", "pinhole", "blur"], ["---"] * 5]
    for name, lens in (SHOWN[0], SHOWN[1], SHOWN[4]):
        for depth in (0.5, 2.0, 10.0, 50.0, 250.0):
            e = near(lens, depth)
            lines.append([name, f"{depth:g}", number(e.paraxial), number(e.pinhole), number(e.blur)])
    return rows(lines)


def spreadsheet(all_sweeps):
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["varied", "value", *Errors._fields])
    for name, points in all_sweeps.items():
        for value, errors in points:
            writer.writerow([name, f"{value:.6g}", *(f"{e:.6g}" for e in errors)])
    return out.getvalue()


LINES = [(2, "paraxial"), (3, "pinhole"), (4, "blur of thick")]


def draw(all_sweeps, path):
    data, plots = [], []
    titles = {"pitch": "pitch, mm (f = 3.03 mm, n = 1.6)", "focal length": "focal length, mm (P = 1.124 mm, n = 1.6)",
              "index": "index (P = 1.124 mm, f = 3.03 mm)", "depth behind the sheet": "depth behind the sheet, mm",
              "depth before the sheet": "depth before the sheet, mm"}
    for name, points in all_sweeps.items():
        is_depth = "depth" in name
        label = "pixels of a view, rms" if is_depth else "pixels of the print, rms"
        scale = "set logscale xy" if is_depth or name == "focal length" else "unset logscale x\nset logscale y"
        low = 1e-4 if is_depth else 1e-3
        plots.append(f"{scale}\nset xlabel '{titles[name]}'\nset ylabel '{label}'\nplot [] [{low}:10] "
                     + ", ".join(f"'data' index {len(data)} using 1:{column} with lines lw 2 lc {column - 1} "
                                 f"title '{title}'" for column, title in LINES))
        data.append("\n".join(f"{abs(v):.6g} " + " ".join(f"{max(error, 1e-9):.6g}" for error in e[:3])
                              for v, e in points))
    across = [at_infinity(lens, o) for lens in (PAPER, widest(0.8)) for o in offsets(lens._replace(pixels=60))]
    plots.append("unset logscale\nset key bottom left\nset xlabel 'place behind the lens, pitches'\n"
                 "set ylabel 'pixels of the print'\n"
                 f"plot [-0.5:0.5] [-2:2] 'data' index {len(data)} using 1:2 with lines lw 2 lc 1 title 'paraxial', "
                 f"'' index {len(data)} using 1:3 with lines lw 2 lc 2 title 'pinhole', "
                 f"'' index {len(data)} using 1:4 with lines lw 2 lc 3 title 'blur of thick', "
                 f"'' index {len(data) + 1} using 1:2 with lines dt 2 lc 1 title 'P = 1.818 mm', "
                 f"'' index {len(data) + 1} using 1:3 with lines dt 2 lc 2 notitle, "
                 f"'' index {len(data) + 1} using 1:4 with lines dt 2 lc 3 notitle")
    for i, lens in enumerate((PAPER, widest(0.8))):
        data.append("\n".join(f"{p.offset / lens.pitch:.6g} {p.paraxial:.6g} {p.pinhole:.6g} {p.blur:.6g}"
                              for p in across[60 * i:60 * (i + 1)]))
    gnuplot("1200,720", "set key top left samplen 2 font ',9'\nset format y '%g'\nset multiplot layout 2,3\n"
            + "\n".join(plots), data, path)


SECTION = """`thick` follows K rays a pixel through a round surface ([lens/formulae.md](../lens/formulae.md)). The other
two models have one ray each. An error here is how far that ray is from the mean of {points} rays of the
thick lens: the root of the mean square over the pixels of a lens, or the largest. *Blur* is the spread of
the thick lens's own rays (rms), which neither model has. V is infinite. *Pixels of the print* are steps of
the slope from one pixel to the next, and show what is far from the sheet. *Pixels of a view* are as wide
as a lens.

![Errors against pitch, focal length, index, depth and the place behind the lens](lens_models.png)

f = 3.03 mm, n = 1.6 and 15 pixels a lens where nothing else is said. R = f (n - 1)/n is the radius of the
lens's surface, so that P = 2R is the widest lens, a half circle. Pixels of the print:

{table}

- **`paraxial`** is off most at the edges of a lens, the more the higher the index is.
- **`pinhole`** has the direction through the vertex right, by Snell's law. What it lacks is that the outer
  parts of a round lens bend light more. It stays within {pinhole_worst} pixels in all of these settings.
- **Blur** is the larger part of the error: wide lenses do not focus. One ray is then sharper than the real
  sheet, and no antialiasing brings this back.
- **Near total reflection**, which the outer parts of lenses reach from two thirds of the widest on, rays are dark:
  in the outer pixels of the widest lenses a quarter of them. The cheaper models show these pixels too bright
  by as much.

At a depth behind the sheet, in pixels of a view:

{depths}

- **Near the sheet** only the width of the lens counts, over which a pixel's rays are spread evenly: 0.289.
  The single ray lies in the middle of it; `+A` takes places over the whole width.
- **Far from it** errors and blur grow with the depth. Before the sheet they are much the same, but the rays
  of a pixel first come together there: the blur is least some way before the sheet, 16 mm with the
  paper's lens.

Where each may be used. Within a quarter of a pixel of the print everywhere, the mean direction of `paraxial`
is right up to {paraxial_part} of the widest pitch, that of `pinhole` up to {pinhole_part}. The blur is
below a quarter of a pixel up to {sharp_part}, and below one pixel up to {blur_part}. Beyond that, and wherever the
blur and darkness of the real sheet are to be seen, only `thick` shows them. The report's *cheapest model*
compares `paraxial` with Snell's law through the vertex; it says nothing of blur.
"""


def last_within(points, field, most):
    """The largest value of a sweep up to which the error stays within."""
    inside = 0.0
    for value, errors in points:
        if getattr(errors, field) > most:
            break
        inside = value
    return inside


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lentray", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    difference = farthest(args.lentray.resolve())
    print(f"The program's rays are at most {difference:.1e} from the trace.")
    if not difference < 1e-12:
        sys.exit("That is more than 1e-12.")
    all_sweeps = sweeps()
    half_circle = 2.0 * radius(PAPER)
    worst = max(errors.pinhole_most for name in ("pitch", "focal length", "index") for _, errors in all_sweeps[name])
    limits = {"paraxial": ("paraxial_most", 0.25), "pinhole": ("pinhole_most", 0.25), "sharp": ("blur_most", 0.25),
              "blur": ("blur_most", 1.0)}
    parts = {f"{name}_part": f"{last_within(all_sweeps['pitch'], *limit) / half_circle:.2g}"
             for name, limit in limits.items()}
    text = SECTION.format(points=POINTS, table=table(), depths=depth_table(), pinhole_worst=f"{worst:.2g}", **parts)
    print(text)
    if args.write:
        draw(all_sweeps, CHARTS / "lens_models.png")
        (CHARTS / "lens_models.csv").write_text(spreadsheet(all_sweeps))
        page = PAGE.read_text()
        before, rest = page.split(MARKS[0])
        PAGE.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{rest.split(MARKS[1])[1]}")


if __name__ == "__main__":
    main()
