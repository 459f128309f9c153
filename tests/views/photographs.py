#!/usr/bin/env python3
"""Photographs and sheets as people have them, through lentray-views and lentray-print: a telephone's picture that is
stored lying, wide gamuts, views named by a shell, sheets that were resized, eyes in two zones. What comes out is read
and reckoned here, by tests/support/pictures.py and colours.py.

    photographs.py [--bin build/release/bin] [word ...]

With words only the checks whose name has one. Status: 0 all as it should be, 1 something is not.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import traceback

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import colours  # noqa: E402
import pictures  # noqa: E402

RED, GREEN, BLUE, GREY = (200, 40, 30), (30, 160, 60), (40, 50, 210), (128, 128, 128)
SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,0,-5> look_at 0 right x*image_width/image_height }
background { rgb <0.1,0.1,0.3> }
sphere { <-0.3,0.6,-1.2>, 0.4 pigment { rgb <0,1,0> } finish { ambient 1 diffuse 0 } }
sphere { <0.4,-1.2,3>, 0.8 pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } }
"""


class Bench:
    """A folder, and the programs."""

    def __init__(self, programs, folder):
        self.programs, self.folder = programs, pathlib.Path(folder)

    def write(self, name, data):
        (self.folder / name).write_bytes(data)
        return name

    def run(self, program, *words, status=0):
        done = subprocess.run([str(self.programs / program), *map(str, words)], cwd=self.folder,
                              capture_output=True, text=True, timeout=100)
        assert done.returncode == status, f"{program} {words}: status {done.returncode}: {done.stdout}{done.stderr}"
        return done.stdout + done.stderr

    def views(self, *words, status=0):
        return self.run("lentray-views", *words, status=status)

    def png(self, name):
        return pictures.read_png((self.folder / name).read_bytes())[0]

    def sheet(self, name, *words):
        self.write("scene.pov", SCENE.encode())
        self.run("lentray", "+Iscene.pov", "-D", "-V", "Lenticular=On", "+O" + name, *words)


def equal(found, wanted, what):
    assert found == wanted, f"{what}: {found}, expected {wanted}"


def near(found, wanted, most, what):
    far = max(abs(a - b) for a, b in zip(found, wanted))
    assert len(found) == len(wanted) and far <= most, f"{what}: {found}, expected {wanted} within {most}"


# As the eye sees it: red upper left, green upper right, blue lower left, grey lower right, and wider than high.
def upright(columns, rows):
    return [[(RED, GREEN, BLUE, GREY)[(2 if y >= rows // 2 else 0) + (1 if x >= columns // 2 else 0)]
             for x in range(columns)] for y in range(rows)]


# What the sensor stores, by the words of the standard: where its row 0 and its column 0 are to the eye.
SIDES = {1: ("top", "left"), 2: ("top", "right"), 3: ("bottom", "right"), 4: ("bottom", "left"),
         5: ("left", "top"), 6: ("right", "top"), 7: ("right", "bottom"), 8: ("left", "bottom")}


def as_stored(rows, orientation):
    row_side, column_side = SIDES[orientation]
    lines = rows if row_side in ("top", "bottom") else [list(c) for c in zip(*rows)]
    if row_side in ("bottom", "right"):
        lines = lines[::-1]
    return [line[::-1] if column_side in ("right", "bottom") else list(line) for line in lines]


def turned_file(kind, orientation, columns=6, rows=4):
    stored = as_stored(upright(columns, rows), orientation)
    if kind == "png":
        return pictures.png(stored, before=[(b"eXIf", pictures.exif(orientation))])
    if kind == "late.png":
        return pictures.png(stored, after=[(b"eXIf", pictures.exif(orientation, "<"))])
    if kind == "tif":
        return pictures.tiff(stored, [(274, 3, [orientation])], "<" if orientation % 2 else ">")
    return pictures.jpeg(stored, [pictures.segment(0xE1, b"Exif\0\0" + pictures.exif(orientation))])


def photographs_upright(bench):
    """A photograph taken upright by a telephone: all eight ways to hold it, in sheets, quilts and prints."""
    for kind in ("png", "late.png", "tif", "jpg"):
        columns, rows = (48, 32) if kind == "jpg" else (6, 4)
        wanted = upright(columns, rows)
        names = [bench.write(f"{i}.{kind}", turned_file(kind, i)) for i in SIDES]

        def all_near(found, picture_of, what):
            """`picture_of`: rows of the picture at that place among the names."""
            equal((len(found[0]), len(found)), (len(names) * columns, rows), what)
            for j, name in enumerate(names):
                near([v for r in picture_of(found, j) for p in r for v in p], [v for r in wanted for p in r for v in p], 1,
                     f"{name} of {what}")

        def side_by_side(found, j):
            return [row[j * columns:(j + 1) * columns] for row in found]

        bench.views("--interlace", *names, "--lens-pixels", len(names), "--out", "sheet.png")
        all_near(bench.png("sheet.png"), lambda found, j: [row[j::len(names)] for row in found], "a sheet")
        bench.views(*names, "--quilt", f"{len(names)}x1", "--out", "quilt.png")
        all_near(bench.png("quilt.png"), side_by_side, "a quilt")
        bench.run("lentray-print", "sheet", *names, "--grid", f"{len(names)}x1", "--gap", "0mm", "--pixels", "2", "--dpi", "300",
                  "--marks", "none", "--margin", "0mm", "--out", "page.png")
        all_near(bench.png("page.png"), side_by_side, "a page")


def scenes_stay_as_stored(bench):
    """Pictures in scenes are those of the file, as in POV-Ray."""
    for kind, words in (("png", "png"), ("jpg", "jpeg"), ("tif", "tiff")):
        pixels = []
        for orientation in (1, 6):
            stored = as_stored(upright(6, 4), 6)
            data = turned_file(kind, 6)
            if orientation == 1:
                data = {"png": lambda: pictures.png(stored), "jpg": lambda: pictures.jpeg(stored),
                        "tif": lambda: pictures.tiff(stored)}[kind]()
            bench.write("map." + kind, data)
            bench.write("map.pov", f"""#version 3.7; global_settings {{ assumed_gamma 1 }}
              camera {{ orthographic location <0.5,0.5,-1> look_at <0.5,0.5,0> right x up y }}
              plane {{ z, 0 pigment {{ image_map {{ {words} "map.{kind}" once }} }} finish {{ ambient 1 }} }}""".encode())
            bench.run("lentray", "+Imap.pov", "+W24", "+H24", "-D", "-V", "+Omapped.png")
            pixels.append(bench.png("mapped.png"))
        equal(pixels[0], pixels[1], kind)


WIDE = colours.rgb_profile(colours.ADOBE, 563 / 256)
P3 = colours.rgb_profile(colours.DISPLAY_P3, 0, version=4)
COLOURS = [(200, 40, 30), (128, 128, 128), (12, 3, 250), (90, 200, 60), (255, 255, 255), (0, 0, 0)]


def patches(values):
    return [[v] * 4 for v in values for _ in range(2)]


def in_srgb(colour, primaries, decode, most=255):
    return [most * v for v in colours.srgb_of([v / most for v in colour], primaries, decode)]


def adobe_decode(v):
    return v ** (563 / 256)


def wide_gamut_files():
    """Name, file, and what its colours are in sRGB."""
    in_adobe = [in_srgb(c, colours.ADOBE, adobe_decode) for c in COLOURS]
    in_p3 = [in_srgb(c, colours.DISPLAY_P3, colours.decoded) for c in COLOURS]
    in_power = [in_srgb(c, colours.DISPLAY_P3, lambda v: v ** 2.2) for c in COLOURS]
    rows = patches(COLOURS)
    blocks = [[c] for c in COLOURS]
    iccp = (b"iCCP", b"wide\0\0" + pictures.zlib.compress(WIDE))
    chrm = pictures.struct.pack(">8I", *(round(100000 * v) for p in (colours.D65, *colours.DISPLAY_P3) for v in p))
    gama = (b"gAMA", pictures.struct.pack(">I", 45455))
    parts = pictures.profile_segments(P3, 150)
    interop = pictures.tiff_block([(34665, 4, [26])])[:26]
    # Exif's own directory, and in it the mark of Adobe RGB.
    marks = interop + pictures.struct.pack("<HHHII", 1, 40965, 4, 1, 44) + b"\0" * 4
    marks += pictures.struct.pack("<HHHI", 1, 1, 2, 4) + b"R03\0" + b"\0" * 4
    return [("v2.png", pictures.png(rows, before=[iccp]), in_adobe),
            ("v4.png", pictures.png(rows, before=[(b"iCCP", b"p3\0\0" + pictures.zlib.compress(P3))]), in_p3),
            ("chrm.png", pictures.png(rows, before=[gama, (b"cHRM", chrm)]), in_power),
            ("wide.tif", pictures.tiff(rows, [(34675, 7, P3)]), in_p3),
            ("parts.jpg", pictures.jpeg(blocks, parts[::-1]), in_p3),
            ("camera.jpg", pictures.jpeg(blocks, [pictures.segment(0xE1, b"Exif\0\0" + marks)]), in_adobe)]


def wide_gamuts(bench):
    """Colours of wide gamuts are sRGB's in sheets, quilts and prints: rounded once, not to eight bits before that."""
    for name, data, wanted in wide_gamut_files():
        bench.write(name, data)
        bench.write("other" + pathlib.Path(name).suffix, data)
        rows = 8 if name.endswith("jpg") else 2
        pair = [name, "other" + pathlib.Path(name).suffix]
        bench.views("--interlace", *pair, "--lens-pixels", "2", "--out", "out.png")
        bench.views(*pair, "--quilt", "2x1", "--out", "quilt.png")
        bench.run("lentray-print", "sheet", name, "--pixels", "2", "--dpi", "300", "--marks", "none",
                  "--margin", "0mm", "--out", "page.png")
        for out in ("out.png", "quilt.png", "page.png"):
            found = bench.png(out)
            for i, colour in enumerate(wanted):
                # JPEG itself rounds, and profiles hold their numbers to 16 bits.
                near(found[i * rows + 1][1], colour, 1.5 if rows == 8 else 0.56, f"{name} {out}")


def fine_and_grey(bench):
    """16 bits, greys, alpha, inks."""
    fine = [tuple(257 * v for v in c) for c in COLOURS]
    iccp = (b"iCCP", b"p3\0\0" + pictures.zlib.compress(P3))
    bench.write("fine.png", pictures.png(patches(fine), 16, [iccp]))
    bench.views("fine.png", "fine.png", "--quilt", "2x1", "--out", "out.png")
    for i, colour in enumerate(fine):
        # Profiles hold their numbers to 16 bits.
        near(bench.png("out.png")[2 * i][0], in_srgb(colour, colours.DISPLAY_P3, colours.decoded, 65535), 24, "fine")
    linear = (b"iCCP", b"grey\0\0" + pictures.zlib.compress(colours.grey_profile(1.0)))
    greys = [(0,), (3,), (60,), (128,), (255,)]
    bench.write("grey.png", pictures.png(patches(greys), 8, [linear]))
    bench.views("grey.png", "grey.png", "--quilt", "2x1", "--out", "out.png")
    for i, (v,) in enumerate(greys):
        near(bench.png("out.png")[2 * i][0], [255 * colours.encoded(v / 255)], 0.56, "grey")
    clear = [c + (a,) for c, a in zip(COLOURS, (255, 128, 7, 1, 200, 0))]
    bench.write("clear.png", pictures.png(patches(clear), 8, [iccp]))
    bench.views("clear.png", "clear.png", "--quilt", "2x1", "--out", "out.png")
    for i, colour in enumerate(clear):
        found = bench.png("out.png")[2 * i][0]
        equal(found[3], colour[3], "alpha")
        near(found[:3], in_srgb(colour[:3], colours.DISPLAY_P3, colours.decoded), 0.56, "beside alpha")
    inks = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (1, 1, 0, 0)]
    for adobe in (True, False):
        stored = [[tuple(255 - 255 * v if adobe else 255 * v for v in c)] for c in inks]
        bench.write("inks.jpg", pictures.jpeg(stored, pictures.profile_segments(colours.inks_profile(), 200), adobe))
        bench.views("inks.jpg", "inks.jpg", "--quilt", "2x1", "--out", "out.png")
        for i, c in enumerate(inks):
            near(bench.png("out.png")[8 * i][0], [255 * v for v in colours.srgb_of_xyz(colours.inks_xyz(c))], 1.5,
                 f"inks {c}")


def profiles_kept(bench):
    """--profile keep: samples stay, and the profile goes along; pictures with others do not go with it."""
    iccp = (b"iCCP", b"wide\0\0" + pictures.zlib.compress(WIDE))
    other = (b"iCCP", b"p3\0\0" + pictures.zlib.compress(P3))
    rows = patches(COLOURS)
    for j in range(2):
        bench.write(f"w{j}.png", pictures.png(rows, before=[iccp]))
    bench.write("p3.png", pictures.png(rows, before=[other]))
    bench.write("plain.png", pictures.png(rows))
    keep = ("--profile", "keep")
    bench.views("--interlace", "w0.png", "w1.png", "--lens-pixels", "2", *keep, "--out", "out.png")
    equal(pictures.profile_in_png((bench.folder / "out.png").read_bytes()), WIDE, "profile")
    equal([row[0] for row in bench.png("out.png")], [row[0] for row in rows], "samples")
    print_it = ("lentray-print", "sheet", "w0.png", "--pixels", "2", "--dpi", "300", *keep)
    bench.run(*print_it, "--out", "page.png", "--marks", "none", "--margin", "0mm")
    equal(pictures.profile_in_png((bench.folder / "page.png").read_bytes()), WIDE, "profile of a page")
    equal([row[0] for row in bench.png("page.png")], [row[0] for row in rows], "samples of a page")
    for out in ("page.pdf", "page.tif"):
        bench.run(*print_it, "--out", out)
        assert WIDE in (bench.folder / out).read_bytes(), out
    for out in ("out.tif", "out.jpg"):
        bench.views("w0.png", "w1.png", "--quilt", "2x1", *keep, "--out", out)
        assert WIDE in (bench.folder / out).read_bytes(), out
    for pair in (("w0.png", "p3.png"), ("w0.png", "plain.png")):
        for task in (("--interlace", *pair, "--lens-pixels", "2"), (*pair, "--quilt", "2x1"), (*pair, "--stereo")):
            said = bench.views(*task, *keep, "--out", "no.png", status=1)
            assert "different colour profiles" in said, said
            assert not (bench.folder / "no.png").exists()
            bench.views(*task, "--out", "converted.png")
        sheet = ("lentray-print", "sheet", *pair, "--pixels", "2", "--dpi", "300")
        said = bench.run(*sheet, *keep, "--out", "no.png", status=1)
        assert "different colour profiles" in said, said
        assert not (bench.folder / "no.png").exists()
        bench.run(*sheet, "--out", "converted.png")
    assert "sRGB alone" in bench.views("w0.png", "w1.png", "--wiggle", "a.gif", *keep, status=1)
    assert "no colour profile" in bench.views("w0.png", "w1.png", "--stereo", *keep, "--out", "a.exr", status=1)


def broken_profiles(bench):
    """A warning, and the colours as they are."""
    rows = patches(COLOURS)
    grey = colours.grey_profile(2.2)
    missing = pictures.profile_segments(P3, 150)
    del missing[1]
    files = [("cut.png", pictures.png(rows, before=[(b"iCCP", b"x\0\0" + pictures.zlib.compress(WIDE[:200]))])),
             ("packed.png", pictures.png(rows, before=[(b"iCCP", b"x\0\0nonsense")])),
             ("grey.png", pictures.png(rows, before=[(b"iCCP", b"x\0\0" + pictures.zlib.compress(grey))])),
             ("words.tif", pictures.tiff(rows, [(34675, 7, b"no profile at all")])),
             ("part.jpg", pictures.jpeg([[c] for c in COLOURS], missing))]
    for name, data in files:
        bench.write(name, data)
        said = bench.views(name, name, "--quilt", "2x1", "--out", "out.png")
        equal(said.count("warning"), 1, said)
        assert "colour profile" in said and name in said, said
        step = 8 if name.endswith("jpg") else 2
        for i, colour in enumerate(COLOURS):
            near(bench.png("out.png")[step * i][0], colour, 1 if step == 8 else 0, name)


def srgb_stays(bench):
    """Pictures of sRGB keep every bit, whether they say it or not."""
    srgb = colours.rgb_profile(colours.SRGB, 0)
    rows = [[((7 * x + y) % 256, (x * y) % 256, (255 - x) % 256) for x in range(64)] for y in range(64)]
    for before in ([], [(b"iCCP", b"s\0\0" + pictures.zlib.compress(srgb))], [(b"sRGB", b"\0")]):
        bench.write("s.png", pictures.png(rows, before=before))
        equal(bench.views("s.png", "s.png", "--quilt", "1x2", "--out", "out.png").count("warning"), 0, "words")
        equal(bench.png("out.png")[:64], rows, before)


def pages_of_tiff(bench):
    """A file of several pages is refused by name, wherever it stands; small copies and masks are no pages."""
    rows = [[(20, 90, 200)] * 4] * 3
    bench.write("one.png", pictures.png(rows))
    out = ("--lens-pixels", "2", "--out", "out.png")
    for kinds, pages, order in (([None], 2, "<"), ([2, 2], 3, "<"), ([0, None, 0], 4, ">"), ([1, None], 2, "<"),
                                ([None, 4], 2, ">")):
        bench.write("more.tif", pictures.more_pages(pictures.tiff(rows, order=order), kinds, order))
        for given in (("one.png", "more.tif"), ("more.tif", "one.png")):
            said = bench.views("--interlace", *given, *out, status=1)
            assert f"'more.tif' has {pages} pages" in said, (kinds, said)
        for words in (("--quilt", "1x2", "one.png", "more.tif"), ("--wiggle", "one.png", "more.tif"),
                      ("--anaglyph", "one.png", "more.tif"), ("more.tif", "--views", "0..1", "--lens-pixels", "2")):
            said = bench.views(*words, "--out", "w.png", status=1)
            assert f"'more.tif' has {pages} pages" in said, (kinds, words, said)
    for kinds in ([1], [4], [1, 5], [1, 1, 1], []):
        bench.write("more.tif", pictures.more_pages(pictures.tiff(rows), kinds))
        bench.views("--interlace", "one.png", "more.tif", *out)


def too_wide_for_jpeg(bench):
    """Refused by name and limit, with nothing left."""
    bench.write("one.png", pictures.png([[(20, 90, 200)] * 10] * 2))
    said = bench.views("--interlace", "one.png", "one.png", "--lens-pixels", "2", "--size", "66000x2", "--out", "wide.jpg", status=1)
    assert "'wide.jpg'" in said and "65500 pixels a side" in said, said
    left = [path.name for path in bench.folder.iterdir() if "wide" in path.name]
    equal(left, [], "files")


def pages_of_others(bench):
    """A preview replaces a preview, and no other page."""
    bench.sheet("sheet.png", "Lens_Pixels=4", "Lens_LPI=40", "View_Distance=300", "+W40", "+H20")
    bench.write("index.html", b"<p>mine</p>\n")
    said = bench.views("sheet.png", "--preview", "index.html", status=1)
    assert "'index.html' is not of lentray-views" in said, said
    equal((bench.folder / "index.html").read_bytes(), b"<p>mine</p>\n", "it stays")
    for text in (b"", None, None):
        if text is not None:
            bench.write("index.html", text)
        bench.views("sheet.png", "--preview", "index.html")


def natural_order(bench):
    """Twelve views named by a shell."""
    names = [f"IMG_{i}.png" for i in range(1, 13)]
    for i, name in enumerate(names):
        bench.write(name, pictures.png([[(20 * i + 5,) * 3] * 2] * 2))

    def taken(given, *words):
        said = bench.views("--interlace", *given, "--lens-pixels", "12", "--out", "out.png", *words)
        return [p[0] // 20 + 1 for p in bench.png("out.png")[0][:12]], said

    by_bytes = sorted(names)
    by_language = names[9:] + [names[0]] + names[1:9]
    for given in (by_bytes, by_language):
        order, said = taken(given)
        equal(order, list(range(1, 13)), given)
        assert "pictures taken in natural order: IMG_1.png, IMG_2.png, ..., IMG_12.png" in said, said
        order, said = taken(given, "--order", "given")
        equal([f"IMG_{i}.png" for i in order], given, "--order given")
        assert "natural" not in said, said
    for chosen in (names[::-1], names[1:] + names[:1], by_bytes[::-1]):
        order, said = taken(chosen)
        equal([f"IMG_{i}.png" for i in order], chosen, "chosen by hand")
        assert "natural" not in said, said
    for kind in ("a%02d.png", "cam%d/x.png", "p%d_7.png", "plain%s.png"):
        given = []
        for i in range(12):
            name = kind % ("abcdefghijkl"[i] if "%s" in kind else i + 1)
            (bench.folder / name).parent.mkdir(exist_ok=True)
            bench.write(name, pictures.png([[(20 * i + 5,) * 3] * 2] * 2))
            given.append(name)
        order, said = taken(sorted(given))
        equal(order, list(range(1, 13)), kind)
        equal("natural" in said, "%d" in kind, kind)


def refit(data, rows):
    """Another picture with all that the file says."""
    pixels = pictures.chunks_of(pictures.png(rows))
    others = [c for c in pictures.chunks_of(data) if c[0] not in (b"IHDR", b"IDAT", b"IEND")]
    return (b"\x89PNG\r\n\x1a\n" + pictures.chunk(*pixels[0]) + b"".join(pictures.chunk(*c) for c in others) +
            b"".join(pictures.chunk(*c) for c in pixels[1:]))


def resized_sheets(bench):
    """Every task refuses a sheet whose strips no longer lie behind its lenses, as lentray-print does."""
    tasks = [[], ["--view", "1"], ["--all"], ["--views", "1..2"], ["--lens", "3"], ["--eye", "2"], ["--stereo"],
             ["--stereo", "--pair", "3,1"], ["--anaglyph"], ["--wiggle", "no.gif"], ["--quilt", "2x2"],
             ["--preview", "no.html"]]
    for words in (["Lens_Pixels=6", "+W120", "+H90"], ["Lens_Pixels=6.4", "+W130", "+H90"],
                  ["Lens_Pixels=6", "Lens_Slant=9", "+W120", "+H90"]):
        bench.sheet("sheet.png", *words)
        rows = bench.png("sheet.png")
        data = (bench.folder / "sheet.png").read_bytes()
        is_slanted = "Lens_Slant=9" in words
        width = len(rows[0])
        changes = {"smaller": [[r[x * 3 // 2] for x in range(width * 2 // 3)] for r in rows[::2]],
                   "larger": [[r[x // 2] for x in range(2 * width)] for r in rows],
                   "cut left": [r[7:] for r in rows], "cut right": [r[:-6] for r in rows],
                   "turned": [list(c) for c in zip(*rows)]}
        if is_slanted:
            changes["cut above"] = rows[5:]
        for how, changed in changes.items():
            bench.write("changed.png", refit(data, changed))
            for task in tasks:
                out = ["--out", "no.png"] if task and not task[-1].startswith("no.") else []
                said = bench.views("changed.png", *task, *out, status=1)
                assert "resizing and cropping" in said, (how, task, said)
                assert not list(bench.folder.glob("no*")), (how, task)
            said = bench.run("lentray-print", "sheet", "changed.png", "--out", "no.pdf", status=1)
            assert "resizing and cropping" in said or is_slanted, said
            assert "resizing" in bench.views("--interlace", "changed.png", "changed.png", "--like", "changed.png",
                                             status=1)
        said = bench.views("sheet.png", "--view", "1", "--out", "out.png")
        assert "warning" not in said, said
        if not is_slanted:
            bench.write("changed.png", refit(data, rows[5:]))
            assert "pixels high" in bench.views("changed.png", "--view", "1", "--out", "out.png")
        bench.write("changed.png", refit(data, changes["cut right"]))
        bench.views("changed.png", "--view", "1", "--lens-pixels", "6", "--out", "out.png")


def sheets_in_jpeg(bench):
    """What lentray writes into a JPEG file of a sheet is found there."""
    bench.write("scene.pov", SCENE.encode())
    bench.run("lentray", "+Iscene.pov", "-D", "-V", "Lenticular=On", "+FJ", "+Osheet.jpg", "Lens_Pixels=6", "+W120",
              "+H90")
    assert "20 lenses of 6 pixels" in bench.views("sheet.jpg")
    bench.run("lentray-print", "sheet", "sheet.jpg", "--out", "page.pdf")


def middle_of(rows, channel):
    """The middle column of what has that channel's colour alone."""
    columns = [x for row in rows for x, p in enumerate(row) if p[channel] > 150 and max(p[channel - 1], p[channel - 2]) < 90]
    return sum(columns) / len(columns)


def depth_in(rows):
    """How much farther right the near ball, which is green, is to the left eye, beside the far one; below 0: depth is
    reversed."""
    width = len(rows[0]) // 2
    left, right = ([r[:width] for r in rows], [r[width:] for r in rows])
    return middle_of(left, 1) - middle_of(left, 0) - middle_of(right, 1) + middle_of(right, 0)


def eyes_in_two_zones(bench):
    """That the eyes are in two zones is told, and whether depth is reversed; --one-zone puts it right."""
    size = ["--size", "300x200"]
    far = ["+W300", "+H200", "View_Distance=500", "Lens_Focal_Length=2"]
    # The sheet's size decides how wide its zone is.
    for words, is_told, is_reversed in ((["+W600", "+H400"], True, True), (["+W750", "+H500"], True, False),
                                        (["+W600", "+H400", "Lens_Slant=9"], True, True), (far, False, False)):
        bench.sheet("sheet.png", "Lens_Pixels=15", *words)
        for eye in ([], ["--eye", "2"], ["--eye", "-1"]):
            said = bench.views("sheet.png", "--stereo", *size, *eye, "--out", "out.png")
            equal(("two zones" in said, "depth is reversed" in said), (is_told, is_reversed), (words, eye, said))
            equal(depth_in(bench.png("out.png")) < 0, is_reversed, (words, eye))
            said = bench.views("sheet.png", "--anaglyph", *size, *eye, "--out", "ana.png")
            equal("two zones" in said, is_told, (words, eye, said))
            said = bench.views("sheet.png", "--stereo", "--one-zone", *size, *eye, "--out", "out.png")
            depth = depth_in(bench.png("out.png"))
            assert depth > 0.5 and "zones" not in said, (words, eye, said, depth)
    for pair, is_reversed in (("3,9", True), ("9,3", False)):
        said = bench.views("sheet.png", "--stereo", "--pair", pair, *size, "--out", "out.png")
        equal(("reversed" in said, depth_in(bench.png("out.png")) < 0), (is_reversed, is_reversed), pair)


CHECKS = [photographs_upright, scenes_stay_as_stored, wide_gamuts, fine_and_grey, profiles_kept, broken_profiles,
          srgb_stays, pages_of_tiff, too_wide_for_jpeg, pages_of_others, natural_order, resized_sheets, sheets_in_jpeg, eyes_in_two_zones]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("words", nargs="*")
    arguments = parser.parse_args()
    failed = 0
    for check in CHECKS:
        if arguments.words and not any(word in check.__name__ for word in arguments.words):
            continue
        with tempfile.TemporaryDirectory() as folder:
            try:
                check(Bench(arguments.bin.resolve(), folder))
                print(check.__name__, "ok")
            except Exception:  # the others are worth knowing too
                failed += 1
                print(check.__name__, "FAILED")
                traceback.print_exc()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
