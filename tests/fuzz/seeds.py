"""Seeds for the fuzzer: every language case, our scenes, stock's small examples and includes.

  seeds.py FOLDER      writes one file a seed
"""
import pathlib
import sys

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


def main():
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    seeds = []
    for path in sorted((ROOT / "tests/compat/language").glob("*.cases")):
        seeds += cases(path)
    seeds += whole(ROOT / "scenes", "*.pov")
    seeds += whole(ROOT / "tests/fuzz/inputs", "*.pov")
    seeds += whole(EXAMPLES, "*.pov")
    seeds += whole(INCLUDES, "*.inc")
    for number, text in enumerate(seeds):
        (out / f"{number:05}.pov").write_text(text, encoding="latin-1", errors="replace")
    print(f"{len(seeds)} seeds")


if __name__ == "__main__":
    main()
