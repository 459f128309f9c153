"""Seeds for the fuzzers.

  seeds.py KIND FOLDER      writes one file a seed
    scene    every language case, our scenes, stock's small examples and includes
    picture  small pictures that are installed, and one that stock writes in each of its file types
    data     small fonts that are installed, and density files of each width
"""
import pathlib
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


def main():
    kind, out = sys.argv[1], pathlib.Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    seeds = {"scene": scenes, "picture": pictures, "data": data}[kind]()
    for number, seed in enumerate(seeds):
        (out / f"{number:05}").write_bytes(seed)
    print(f"{len(seeds)} seeds")


if __name__ == "__main__":
    main()
