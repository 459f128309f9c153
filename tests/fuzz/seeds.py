"""Seeds for the fuzzers.

  seeds.py KIND FOLDER      writes one file a seed
    scene    every language case, our scenes, stock's small examples and includes
    picture  small pictures that are installed, and one that stock writes in each of its file types
    data     small fonts that are installed, and density files of each width
    ini      our option groups, stock's INI files, profiles of lens sheets
    manifest rows of pictures, frames, views, comparisons, and broken ones
    journal  journals and passes, empty and with records; where lentray is built, what it keeps of radiosity too
What was found before, tests/fuzz/inputs/KIND, is among them.
"""
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
INCLUDES = pathlib.Path("/usr/share/povray-3.7/include")
LARGEST = 12000   # bytes: long seeds are slow, and change little of what is reached


def cases(path):
    """The setup and the cases of a .cases file, as scenes."""
    setup, scenes, kind = "", [], None
    for line in path.read_text().splitlines():
        if not line or line.startswith("//"):
            continue
        if line.startswith(" "):
            if kind == "setup":
                setup += line + "\n"
            elif scenes:
                scenes[-1] += "\n" + line
            continue
        kind, _, body = line.lstrip("~").partition(" ")
        if kind == "setup":
            setup += body + "\n"
        elif kind == "p":
            scenes.append(body)
        elif kind.startswith("v"):
            scenes.append(f'#debug vstr({kind[1:]},({body})," ",0,9)')
        elif kind == "n":
            scenes.append(f"#debug str(({body}),0,9)")
        else:
            scenes.append(f"#debug {body}")
    macro = "#macro W(Text_) #debug Text_ #end\n"
    return [macro + setup + scene + "\n" for scene in scenes]


def whole(folder, pattern):
    for path in sorted(folder.rglob(pattern)):
        text = path.read_text(encoding="latin-1")
        if len(text) <= LARGEST:
            yield text


def scenes():
    texts = []
    for path in sorted((ROOT / "tests/compat/language").glob("*.cases")):
        texts += cases(path)
    texts += whole(ROOT / "scenes", "*.pov")
    texts += whole(ROOT / "tests/fuzz/inputs", "*.pov")
    texts += whole(EXAMPLES, "*.pov")
    texts += whole(INCLUDES, "*.inc")
    return [text.encode("latin-1", errors="replace") for text in texts]


def installed(suffixes, most, largest=LARGEST):
    """Files below /usr/share, no more than `most` of a suffix, the smallest first."""
    for suffix in suffixes:
        paths = [p for p in pathlib.Path("/usr/share").rglob("*" + suffix) if p.is_file()]
        sizes = sorted((p.stat().st_size, str(p)) for p in paths)
        for size, path in [pair for pair in sizes if pair[0] <= largest][:most]:
            yield pathlib.Path(path).read_bytes()


def targa(kind, bits, flags, body, colours=0):
    """A picture of 4 x 3, with a palette of `colours`."""
    head = struct.pack("<BBBHHBHHHHBB", 0, 1 if colours else 0, kind, 0, colours, 24 if colours else 0, 0, 0, 4, 3, bits, flags)
    return head + bytes(range(colours * 3)) + body


def targas():
    for bits in (8, 15, 16, 24, 32):
        size = (bits + 7) // 8
        pixels = bytes(k * 37 % 256 for k in range(12 * size))
        runs = b"".join(bytes([0x82]) + pixels[k:k + size] + b"\0" + pixels[k:k + size] for k in range(0, 3 * size, size))
        kinds = ((1, 9, 4), (3, 11, 0)) if bits == 8 else ((2, 10, 0),)
        for plain, packed, colours in kinds:
            for flags in (0, 0x20, 0x10):
                some = bytes(b % 4 for b in pixels) if colours else pixels
                yield targa(plain, bits, flags, some, colours)
                yield targa(packed, bits, flags, bytes(b % 4 if colours and k % 4 in (1, 3) else b for k, b in enumerate(runs)), colours)


def written_by_stock():
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder, "s.pov")
        scene.write_text("#version 3.7;\nglobal_settings { assumed_gamma 1 }\nsphere { z*3, 1 pigment { bozo colour_map "
                         "{ [0 rgb x] [1 rgbt <0, 1, 1, 0.5>] } } finish { ambient 1 } }\n")
        for options in ("+FN", "+FN16", "+FN +UA", "+FT", "+FT +UA", "+FC", "+FC +UA", "+FJ", "+FB", "+FP", "+FP16",
                        "+FE", "+FH"):
            out = pathlib.Path(folder, "out")
            subprocess.run(["povray", "+Is.pov", "+Oout", "+W9", "+H7", "-D", "-GA", *options.split()], cwd=folder,
                           check=False, capture_output=True)
            for path in pathlib.Path(folder).glob("out*"):
                yield path.read_bytes()
                path.unlink()


def pictures():
    suffixes = (".png", ".gif", ".jpg", ".tga", ".bmp", ".ppm", ".pgm", ".tif", ".tiff", ".exr", ".hdr")
    return [*installed(suffixes, 40), *targas(), *written_by_stock()]


def data():
    out = list(installed((".ttf", ".otf"), 20, largest=40000))
    for width in (1, 2, 4):
        out.append(struct.pack(">HHH", 4, 3, 2) + bytes(k * 11 % 256 for k in range(24 * width)))
    return out


INI = ["""; a comment
[a]
Width=64
Height="48"
+A0.1 -D Antialias_Depth=2 # behind it
[b]
+W9 +H7
""", """Initial_Frame=1 
Final_Frame=12
Initial_Clock=0.5
Final_Clock=2
Cyclic_Animation=on
Subset_Start_Frame=0.25
Subset_End_Frame=9
Frame_Step=2
Clock=3
""", """Lenticular=On
Lens_LPI=60.02
Lens_Thickness=0.65mm
Lens_IOR=1.57
Views=8
View=3
Sheet_Width=10in
Sheet_Height=80mm
Lens_Sheet=a
[a]
Lens_LPI=75
Lens_Thickness=18mil
""", """Library_Path="some where"
Include_Header=h.inc
Declare=A=1.5
Declare=B="x"
Input_File_Name='a=b.pov'
Output_File_Name=out/
Output_File_Type=N16
File_Gamma=2.2
Restrict_IO=On
Permitted_Path=.
Post_Scene_Command=true %o
Post_Scene_Return=!F
Statistics_File=s.json
""", """Start_Column=0.2
End_Column=12
Start_Row=3
End_Row=0.9
Sampling_Method=2
Jitter_Amount=0.5
Max_Time=3
Max_Memory=1G
Pixel_Order=hilbert
Shadow_Cache=off
Create_Ini=x.ini
Append_File=On
Debug_File=d.txt
"""]


def inis():
    texts = [text.encode() for text in INI]
    texts += [text.encode("latin-1") for text in whole(EXAMPLES, "*.ini")]
    # Every name that the help knows, a few at a time: names are hard to come by.
    names = sorted(set(re.findall(r'"([A-Z][A-Za-z]*_[A-Za-z_]*)[="]', (ROOT / "parser/options/options_help.cpp").read_text())))
    for value in ("1", "On", "x"):
        texts += [f"{name}={value}\n".encode() for name in names]
    return texts


def manifests():
    still = {"name": "a/b", "source": "/s/a/b.pov", "state": "done", "attempts": 1, "files": {"/s/a/b.pov": [12, 34, 56]},
             "picture": "a/b.png", "width": 640, "height": 480, "bytes": 1000, "messages": ["a.pov:1:2: warning: x"],
             "warnings": 1, "wall_s": 1.5, "cpu_s": 1.25, "rendering_s": 1, "memory": 1 << 20, "key": "0123456789abcdef",
             "command": ["lentray", "+Ia.pov"], "finished": "2026-01-02T03:04:05Z", "missing": ["/s/x.inc"]}
    frame = {**still, "name": "a#07", "frame": 7, "views": ["v/0.png", "v/1.png"], "lens_pixels": 8.5, "left_out": ["media"]}
    verdict = {"grade": "close", "note": "n", "psnr": 41.5, "beyond_1": 0.1, "largest": 3, "noise_rms": 0.5, "stock": "c/s.png",
               "difference": "c/h.png", "stock_cpu_s": 2, "lens_grades": {"exact": 3}, "view_grades": {"close": 1}}
    failed = {"name": "\u00e4~2", "source": "/s/c.pov", "state": "failed", "attempts": 3, "files": {}, "reason": "no room",
              "status": 137, "limits": "60 s", "band": "2/16", "lacks_room": True}
    rows = [still, frame, {**still, "name": "d", "verdict": verdict}, failed, {**failed, "name": "e", "state": "skipped"}]
    lines = [json.dumps(row) for row in rows]
    return [line.encode() + b"\n" for line in lines] + ["\n".join(lines).encode(), lines[0][:90].encode() + b"\n" + lines[3].encode()]


IDENTITY = json.dumps({"program": "0.1.0 0", "options": "Width=12\nclock 0 of 0 to 0, delta 0, on 0\n", "files": {"": [1]},
                       "missing": ["a.inc"], "now": 9.5}).encode()
PASSING = """#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.3 media 0 }
radiosity { count 8 error_bound 1 recursion_limit 2 } }
camera { location <0, 1, -4> look_at 0 } light_source { <3, 5, -4>, 1 }
plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 }
photons { target refraction on reflection on } }
"""


def piece(data):
    """With its length; the fuzzer mends checksums."""
    return struct.pack("<QQ", len(data), 0) + data


def work(kind, *records):
    """A file of work that is kept: tools/session/work_file.cpp. Records: a number and bytes."""
    out = kind.ljust(16, b"\0") + struct.pack("<Q", 3) + piece(IDENTITY)
    return out + b"".join(struct.pack("<II", 0x4c52574b, number) + piece(data) for number, data in records)


def journal(*records):
    """Records: a stage and pixels."""
    return work(b"lentray journal", *((stage, b"".join(struct.pack("<II", *pixel) for pixel in pixels) +
                                       struct.pack("<4f", 0.25, 0.5, 1, 0) * len(pixels)) for stage, pixels in records))


def passes(*records):
    """Records: the pass's number and its bytes."""
    return work(b"lentray passes", *records)


def kept_radiosity():
    """What lentray keeps of the scene that the fuzzer renders, and the samples in it as the records of a pass."""
    program = next((p for p in (ROOT / "build/release/bin/lentray", ROOT / "build/fuzz/bin/lentray", shutil.which("lentray"))
                    if p and pathlib.Path(p).exists()), None)
    if program is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "s.pov").write_text(PASSING)
        for name in ("kept.lentray-light", "kept.rca"):
            subprocess.run([program, "s.pov", "+W12", "+H9", f"+RF{name}", "+RFO"], cwd=folder, check=False, capture_output=True,
                           env={**os.environ, "HOME": folder})
            path = pathlib.Path(folder, name)
            if path.exists():
                yield path.read_bytes()


def journals():
    row = [(column, 4) for column in range(12)]
    all_pixels = [(column, r) for r in range(9) for column in range(12)]
    photon = struct.pack("<3f4B4b", 0.1, -1, 0.2, 128, 128, 128, 250, 1, 5, 7, 0)
    told = [photon + struct.pack("<II", kind, 3) for kind in range(4)]
    sample = struct.pack("<9d6f", *[0.1] * 9, *[0.5] * 6)
    counts = struct.pack("<QQQQdQ", 2, 1, 1, 8, 1, 0)
    gather = struct.pack("<3fdBQf", 1, 1, 1, 0.5, 1, 3, 1) + (counts + struct.pack("<Q", 1) + sample) * 2
    return [journal(), work(b"lentray done"), journal((0, row)), journal((0, row), (1, row)), journal((0, all_pixels), (1, all_pixels)),
            passes(), passes((0, b"")), passes((0, b"".join(told))), passes((0, told[0]), (0, told[2]), (1, gather)),
            passes((1, gather), (1, gather)), *kept_radiosity()]


def found_before(kind):
    folder = ROOT / "tests/fuzz/inputs" / kind
    return [path.read_bytes() for path in sorted(folder.iterdir())] if folder.is_dir() else []


def main():
    kind, out = sys.argv[1], pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    seeds = {"scene": scenes, "picture": pictures, "data": data, "ini": inis, "manifest": manifests, "journal": journals}[kind]()
    seeds += found_before(kind)
    for number, seed in enumerate(seeds):
        (out / f"{number:05}").write_bytes(seed)
    print(f"{len(seeds)} seeds")


if __name__ == "__main__":
    main()
