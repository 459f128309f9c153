"""Scenes with media beside stock POV-Ray: what of a difference is noise, and what is not.

  tests/bench/noisy_scenes.py LENTRAY                    the table, on stdout
  ... noisy_scenes.py LENTRAY --write                    also between the marks of docs/media.md
  ... noisy_scenes.py LENTRAY --match fog --keep FOLDER  only scenes whose name has the word; keeps pictures

Stock renders every scene twice: as it is, and with four times its samples (intervals where it names no
samples; with another number of threads where it names neither). Lentray renders it once. Errors are the
root of the mean square over means of blocks of 16 x 16 pixels, of file values 0..1: noise of single
pixels has little weight in them. A scene is graded

  match    if at most 0.1 % of the pixels differ by more than 1/255,
  noise    else if lentray differs from stock by at most twice what stock's own pictures differ by, or 1/255,
  differs  else.

One thread, no antialiasing; seconds are user + system time of the process, the least of two runs of
less than 2 s. Photons are not compared: scenes that have them are rendered without, and the benchmark
without its area lights, whose jitter is other noise. The exit status is 1 if a scene differs.
"""
import argparse
import collections
import itertools
import math
import os
import pathlib
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "stability"))
from pictures import unfilter  # noqa: E402

EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
BLOCK = 16
LEAST = 1.0 / 255.0
PAGE = ROOT / "docs" / "media.md"
MARKS = ("<!-- noisy scenes: begin -->", "<!-- noisy scenes: end -->")

# So that media alone are compared: (pattern, what takes its place, what the table says).
EDITS = ((r"(?s)    photons \{\s*//[^{}]*\}", "", "no photons"),
         (r"#declare use_photons = true", "#declare use_photons = false", "no photons"),
         (r"#declare use_area_light = true", "#declare use_area_light = false", "no area lights"))
MEDIA = [f"interior/media/{name}" for name in ("galaxy", "hollow1", "hollow2", "hollow3", "media1", "media2",
                                               "media3", "media4", "media5", "micro")]
Scene = collections.namedtuple("Scene", "name text folder")
Row = collections.namedtuple("Row", "name verdict share ours noise stock_seconds our_seconds")

# Small scenes: what all share, what POST and LAMP stand for, and the rest of each below its name.
START = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 0.7, 0> right 1.25*x }
plane { y, -0.5 pigment { checker rgb 0.8 rgb <0.3, 0.4, 0.7> } hollow }
"""
POST = "cylinder { <-0.6, -0.5, 0.3>, <-0.6, 1.2, 0.3>, 0.15 pigment { rgb <0.9, 0.5, 0.3> } }"
LAMP = "light_source { <2, 3, -1>, rgb <1, 0.95, 0.8> }"
SMALL = r"""== fog, a point light
POST
LAMP
media { scattering { 1, rgb 0.1 } method 3 samples 6 }
== fog, attenuation in the air
POST
light_source { <2, 3, -1>, rgb <1, 0.95, 0.8>  media_attenuation on }
media { scattering { 1, rgb <0.05, 0.1, 0.2> } samples 6 }
== fog, a spotlight, method 1
POST
light_source { <2, 3, 0.5>, rgb 1.5 spotlight radius 15 falloff 20 point_at <-0.6, 0, 0.3> }
media { scattering { 1, rgb 0.3 } method 1 intervals 8 samples 3, 12 confidence 0.95 variance 1/500 }
== fog, a spotlight, method 2
POST
light_source { <2, 3, 0.5>, rgb 1.5 spotlight radius 15 falloff 20 point_at <-0.6, 0, 0.3> }
media { scattering { 1, rgb 0.3 } method 2 intervals 6 samples 4 jitter 0.5 }
== fog, a spotlight, method 3
POST
light_source { <2, 3, 0.5>, rgb 1.5 spotlight radius 15 falloff 20 point_at <-0.6, 0, 0.3> }
media { scattering { 1, rgb 0.3 } method 3 intervals 2 samples 8 }
== fog, two spotlights, ratio
POST
light_source { <2, 3, 0.5>, rgb 1.5 spotlight radius 15 falloff 20 point_at <-0.6, 0, 0.3> }
light_source { <-2, 3, 0>, rgb 1.5 spotlight radius 15 falloff 20 point_at <-0.6, 0, 0.3> }
media { scattering { 1, rgb 0.3 } method 3 intervals 7 samples 3 ratio 0.6 }
== fog, a cylinder light
POST
light_source { <2, 3, 0.5>, rgb 1.5 cylinder radius 0.3 falloff 0.5 tightness 2 point_at <-0.6, 0, 0.3> }
media { scattering { 1, rgb 0.3 } samples 8 }
== fog, a parallel light
POST
light_source { <2, 3, -1>, rgb <1, 0.95, 0.8> parallel point_at <0, 0, 0> }
media { scattering { 1, rgb 0.1 } samples 8 }
== fog, an area light
POST
light_source { <2, 3, -1>, rgb <1, 0.95, 0.8> area_light x, z, 3, 3 }
media { scattering { 1, rgb 0.1 } samples 4 }
== fog, a fading light
POST
light_source { <2, 3, -1>, rgb <1, 0.95, 0.8> fade_distance 1 fade_power 2 }
media { scattering { 1, rgb 0.5 } samples 12 }
== fog, a fill light and one without media
POST
light_source { <2, 3, -1>, rgb <1, 0.95, 0.8> shadowless }
light_source { <-2, 3, -1>, rgb <1, 0.95, 0.8> media_interaction off }
media { scattering { 1, rgb 0.1 } samples 6 }
== fog, coloured glass before the light
LAMP
box { <0.5, -0.4, -1>, <0.6, 2, 1> hollow pigment { rgbf <1, 0.4, 0.2, 0.9> } }
media { scattering { 1, rgb 0.15
  } samples 10 }
== fog, background of sky
sky_sphere { pigment { gradient y color_map { [0 rgb <0.7, 0.8, 1>] [1 rgb <0.1, 0.2, 0.7>] } } }
POST
LAMP
media { absorption rgb <1e-3, 2e-3, 4e-3> scattering { 4, rgb 1e-3 } samples 4 }
== fog, a solid ball and a hollow one
LAMP
sphere { <-0.8, 0.7, 0>, 0.7 pigment { rgbt 0.7 } }
sphere { <0.8, 0.7, 0>, 0.7 hollow pigment { rgbt 0.7 } }
media { scattering { 1, rgb 0.2 } samples 6 }
== a bag of densities, jitter
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, <2, 3, 4> } method 3
  intervals 2 samples 6 jitter 0.7 density { spherical translate 0.7*y color_map { [0 rgb 0] [0.5 rgb 1] [1 rgb
  2] } } } } }
== clouds, method 1
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 3 extinction 0.5 } emission
  0.2 method 1 intervals 4 samples 2, 6 density { bozo turbulence 0.5 scale 0.4 color_map { [0.4 rgb 0] [0.6 rgb
  1] } } } } }
== clouds, method 2, jitter
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 3 extinction 0.5 } emission
  0.2 method 2 intervals 4 samples 4 jitter 1 density { bozo turbulence 0.5 scale 0.4 color_map { [0.4 rgb 0]
  [0.6 rgb 1] } } } } }
== clouds, method 3, levels
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { absorption 1 emission <1, 0.6, 0.2> method
  3 samples 6 aa_level 5 aa_threshold 0.02 density { bozo turbulence 0.5 scale 0.4 color_map { [0.4 rgb 0] [0.6
  rgb 1] } } } } }
== two densities multiplied
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { absorption 2 emission 1 samples 8 density {
  gradient y scale 2 } density { cells scale 0.4 } } } }
== nested containers
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { absorption <0.2, 0.5, 1> samples 6 } } }
sphere { <0.2, 0.8, -0.1>, 0.5 hollow pigment { rgbt 1 } interior { media { emission <0.8, 0.3, 0.1> scattering
  { 1, 1 } samples 6 density { wood scale 0.3 } } } }
== containers that cross
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { absorption <0.2, 0.5, 1> intervals 3
  samples 4 } } }
box { <-1, -0.3, -0.4>, <1.6, 0.5, 0.4> hollow pigment { rgbt <0.9, 1, 0.9, 0.95> } interior { media {
  scattering { 5, 1 eccentricity 0.3 } samples 6 } } }
== the camera inside
POST
LAMP
sphere { <0, 0, 0>, 6 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.1 } absorption <0, 0.02,
  0.05> samples 6 density { spherical scale 7 } } } }
== a density file
LAMP
box { 0, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 5 } samples 20 density { density_file
  df3 "ball.df3" interpolate 1 } } } scale 1.4 translate <-0.7, -0.1, -0.3> }
== a density file, cubic
LAMP
box { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1.5 absorption 1 samples 20 density {
  density_file df3 "ball.df3" interpolate 2 color_map { [0 rgb 0] [1 rgb <1, 0.5, 2>] } } } } rotate 20*y scale
  1.4 translate <-0.7, -0.1, -0.3> }
== several media
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 2, <1, 0.5, 0.2> } samples 6 }
  media { scattering { 5, 0.5 eccentricity -0.4 } intervals 2 samples 4 density { spherical translate 0.7*y } }
  media { emission 0.1 absorption 0.3 } } }
== a light group
POST
light_group {
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 1 } samples 6 } } }
}
light_source { <-3, 3, -2>, rgb <0.1, 0.2, 0.6> }
== under a mirror
LAMP
sphere { <0, 0.7, 0>, 1 hollow pigment { rgbt 1 } interior { media { emission <0.5, 0.3, 0.1> scattering { 1, 1
  } samples 6 density { spherical translate 0.7*y } } } }
plane { -z, -2 pigment { rgb 0.1 } finish { reflection 0.8 } rotate 25*y }
plane { -y, -3 hollow pigment { rgb 0.1 } finish { reflection 0.5 } no_shadow }
== glass with absorption and refraction
POST
LAMP
sphere { <0.4, 0.7, -0.5>, 0.8 hollow pigment { rgbt 1 } finish { reflection 0.1 } interior { ior 1.4 media {
  absorption <1, 0.3, 0.6> samples 4 } } }
== glass that fades and scatters
POST
LAMP
box { <-1, -0.4, -1>, <1, 1, 0.2> hollow pigment { rgbf <1, 0.9, 0.8, 0.9> } interior { ior 1.2 fade_distance 1
  fade_power 1001 fade_color <0.3, 0.6, 0.9> media { scattering { 3, 0.5 } samples 6 } } rotate 20*y }
== shadows of a container
LAMP
box { <-1, 1, -0.5>, <1, 1.6, 1.5> hollow pigment { rgbt 1 } interior { media { absorption <1, 2, 4> samples 10
  density { cylindrical rotate 90*x scale 1.5 translate 1.3*y } } } }
== a bag turned and stretched
LAMP
sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { scattering { 1, 2 } samples 8 density { gradient x
  turbulence 0.2 scale 0.3 } } } scale <1.2, 0.6, 0.8> rotate <10, 30, 40> translate 0.7*y }
== a bag cut from two
LAMP
difference { sphere { <0, 0.7, 0>, 1 } box { <-2, 0.6, -0.4>, <2, 1, 2> } hollow pigment { rgbt 1 } interior {
  media { scattering { 4, <0.5, 1, 2> } samples 6 } } }
== media in a blob
LAMP
blob { threshold 0.5 sphere { <-0.5, 0.7, 0>, 1, 1 } sphere { <0.5, 0.9, 0>, 1, 1 } hollow pigment { rgbt 1 }
  interior { media { emission 0.4 absorption <0, 1, 1> samples 6 } } }
== an open cup
LAMP
cylinder { 0, 1.2*y, 0.8 open hollow pigment { rgbt 0.8 } interior { media { scattering { 1, 1 } samples 6 } } }
"""


def examples():
    for name in ["advanced/abyss", "advanced/mediasky", "advanced/optics", "advanced/benchmark/benchmark", *MEDIA]:
        path = EXAMPLES / f"{name}.pov"
        text, shown = path.read_text(encoding="latin-1"), name
        for pattern, new, words in EDITS:
            text, count = re.subn(pattern, new, text)
            if count:
                shown += f", {words}"
        yield Scene(shown, text, path.parent)


def small_scenes():
    for section in SMALL.split("== ")[1:]:
        name, body = section.split("\n", 1)
        yield Scene(name, START + body.replace("POST", POST).replace("LAMP", LAMP), None)


def finer(text):
    """The scene with four times its samples, or None where it names none."""
    def more(found):
        return found[1] + re.sub(r"\d+", lambda number: str(4 * int(number[0])), found[2])

    code = re.sub(r"//[^\n]*|(?s:/\*.*?\*/)", "", text)
    for word in ("samples", "intervals"):
        pattern = rf"(\b{word}\s+)(\d+(?:\s*,\s*\d+)?)"
        if re.search(pattern, code):
            return re.sub(pattern, more, code)
    return None


def read_png16(data):
    """(width, height, flat numbers 0..1) of an RGB file of 16 bits."""
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
            if (depth, colours) != (16, 2):
                raise ValueError("a PNG of another kind")
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    raw, stride, values = zlib.decompress(packed), 6 * width, []
    above = bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        unfilter(raw[start], line, above, 6)
        values.extend(v / 65535.0 for v in struct.unpack(f">{3 * width}H", line))
        above = line
    return width, height, values


def blocks(picture):
    width, height, values = picture
    means = []
    for top, left in itertools.product(range(0, height, BLOCK), range(0, width, BLOCK)):
        rows = [values[3 * (y * width + left):3 * (y * width + min(left + BLOCK, width))]
                for y in range(top, min(top + BLOCK, height))]
        for channel in range(3):
            means.append(statistics.fmean(itertools.chain.from_iterable(row[channel::3] for row in rows)))
    return means


def rms(a, b):
    pairs = list(zip(blocks(a), blocks(b)))
    return math.sqrt(sum((x - y)**2 for x, y in pairs) / len(pairs))


def share_beyond(a, b):
    """Of the pixels that differ by more than 1/255 in any channel."""
    far = [abs(x - y) > LEAST for x, y in zip(a[2], b[2])]
    return sum(any(far[i:i + 3]) for i in range(0, len(far), 3)) / (len(far) / 3)


class Runs:
    def __init__(self, args, folder):
        self.args, self.folder = args, folder

    def once(self, program, scene, file, picture, threads):
        """Seconds of a run, or a string that says why there is no picture."""
        command = ["nice", "-n", "5", program, f"+I{file}", f"+O{picture}", "+FN16", f"+W{self.args.width}",
                   f"+H{self.args.height}", "-A", "-J", "-D", "-V", "-P", f"+WT{threads}", f"+L{self.folder}"]
        if scene.folder:
            command.append(f"+L{scene.folder}")
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen([str(word) for word in command], cwd=self.folder, stdin=subprocess.DEVNULL,
                                       stdout=said, stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            if process.returncode != 0 or not picture.is_file():
                said.seek(0)
                text = said.read().decode(errors="replace").splitlines()
                return next((line for line in text if "rror" in line), f"status {process.returncode}")[:120]
        return usage.ru_utime + usage.ru_stime

    def render(self, program, scene, text, name, threads=1):
        """(picture, seconds); text is what the scene says in this run."""
        file, picture = self.folder / f"{name}.pov", self.folder / f"{name}.png"
        file.write_text(text, encoding="latin-1")
        seconds = self.once(program, scene, file, picture, threads)
        if isinstance(seconds, str):
            sys.exit(f"{scene.name}, {program}: {seconds}")
        if seconds < 2.0 and threads == 1 and text is scene.text:
            seconds = min(seconds, self.once(program, scene, file, picture, threads))
        return read_png16(picture.read_bytes()), seconds

    def row(self, scene):
        name = re.sub(r"\W+", "-", scene.name)
        more = finer(scene.text)
        stock, stock_seconds = self.render("povray", scene, scene.text, f"{name}-stock")
        if more:
            other, _ = self.render("povray", scene, more, f"{name}-fine")
        else:
            other, _ = self.render("povray", scene, scene.text, f"{name}-fine", threads=2)
        ours, our_seconds = self.render(self.args.lentray, scene, scene.text, f"{name}-ours")
        share, error, noise = share_beyond(ours, stock), rms(ours, stock), rms(stock, other)
        verdict = "match" if share <= 1e-3 else "noise" if error <= max(2 * noise, LEAST) else "differs"
        return Row(scene.name, verdict, share, error, noise, stock_seconds, our_seconds)


def cells(row):
    return (f"| {row.name} | {row.verdict} | {100 * row.share:.2f} % | {row.ours:.5f} | {row.noise:.5f} | "
            f"{row.stock_seconds:.2f} | {row.our_seconds:.2f} | {row.our_seconds / row.stock_seconds:.2f} |")


def table(rows):
    ratios = {row.name: row.our_seconds / row.stock_seconds for row in rows}
    slowest = max(ratios, key=ratios.get)
    return "\n".join([
        "| scene | verdict | pixels beyond 1/255 | rms, Lentray - stock | rms, stock - stock with 4 x samples "
        "| CPU s, stock | CPU s, Lentray | ratio |", "|---|---|---|---|---|---|---|---|",
        *map(cells, rows), "",
        f"CPU time as a share of stock's: median {statistics.median(ratios.values()):.2f}, "
        f"most {ratios[slowest]:.2f} ({slowest})."])


def write(text):
    page = PAGE.read_text()
    before, rest = page.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    PAGE.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}")


def make_density(path):
    """A df3 file: a ball that fades, and a corner of its box that is full."""
    size = 16  # of powers of two both programs take the last voxel before the first

    def value(x, y, z):
        if min(x, y, z) > size - 4:
            return 255
        far = math.dist((x, y, z), (size / 2 - 0.5,) * 3) / (size / 2)
        return round(255 * max(0.0, 1.0 - far))

    path.write_bytes(struct.pack(">3H", size, size, size) + bytes(
        value(x, y, z) for z in range(size) for y in range(size) for x in range(size)))


def measure(args, folder):
    make_density(folder / "ball.df3")
    rows = []
    for scene in [*examples(), *small_scenes()]:
        if args.match in scene.name:
            rows.append(Runs(args, folder).row(scene))
            print(cells(rows[-1]), file=sys.stderr, flush=True)
    return rows or sys.exit("no scene has that word in its name")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lentray", type=pathlib.Path)
    parser.add_argument("--size", default="160x128", metavar="WxH")
    parser.add_argument("--match", default="", metavar="WORD")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER", help="where scenes and pictures stay")
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    args.width, args.height = (int(n) for n in args.size.split("x"))
    args.lentray = args.lentray.resolve()
    with tempfile.TemporaryDirectory() as temporary:
        folder = (args.keep or pathlib.Path(temporary)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        rows = measure(args, folder)
    print(table(rows))
    if args.write:
        write(table(rows))
    return 1 if any(row.verdict == "differs" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
