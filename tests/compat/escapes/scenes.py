"""Scenes that name what lies outside: what opens files times how a place can be named, by each program that renders."""
from escapes.ground import ON, SCENE, SMALL, Attempt, Fifo, Hard, Link

HEAD = "camera{location -5*z look_at 0}\n"
# What opens a file: kind, the file that it is after, the statement, whether it writes.
READERS = (
    ("#include", "secret.inc", "#include NAME", False),
    ("#fopen read", "text", "#fopen F NAME read #read (F, A) #debug A", False),
    ("picture", "secret.png", "sphere{0,1 pigment{image_map{png NAME}}}", False),
    ("picture of any type", "secret.tif", "sphere{0,1 normal{bump_map{tiff NAME}}}", False),
    ("height field", "secret.png", "height_field{png NAME}", False),
    ("font", "secret.ttf", 'text{ttf NAME "a" 1,0}', False),
    ("density file", "secret.df3", "sphere{0,1 pigment{density_file df3 NAME}}", False),
    ("photons", "secret.ph", "global_settings{photons{count 9 load_file NAME}}", False),
)
WRITERS = (
    ("#fopen write", "rc", '#fopen F NAME write #write (F, "alias ls=evil\\n") #fclose F', True),
    ("#fopen append", "rc", '#fopen F NAME append #write (F, "alias ls=evil\\n") #fclose F', True),
    ("photons", "rc", "global_settings{photons{count 9 save_file NAME}} sphere{0,1 interior{ior 1.5} photons{target refraction on}}"
     "light_source{9,1}", True),
)
OPENERS = READERS + WRITERS


def places(base):
    """How a scene can name a file of the folder victim: the expression in the scene, and what lies in its folder for it."""
    def text(name):
        return '"' + name.replace("\\", "\\\\") + '"'
    victim = f"../victim/{base}"
    return (
        ("absolute", text(f"ROOT/victim/{base}"), {}),
        ("..", text(victim), {}),
        (".. within", text(f"sub/../.{'/.' * 9}/../victim/{base}"), {}),
        ("link", text("link"), {"link": Link(victim)}),
        ("chain of links", text("chain"), {"chain": Link("sub/link"), "sub/link": Link("../link2"), "link2": Link(victim)}),
        ("link of a folder", text(f"folder/{base}"), {}),
        ("link of a folder above", text(f"sub/up/victim/{base}"), {}),
        ("own process", text(f"/proc/self/cwd/../victim/{base}"), {}),
        ("process's root", text(f"/proc/self/rootROOT/victim/{base}"), {}),
        ("thread's root", text(f"/proc/thread-self/rootROOT/victim/{base}"), {}),
        ("loose case", text(f"../VICTIM/{base.upper()}"), {}),
        ("backslashes", f'"..\\victim\\{base}"', {}),
        ("doubled strokes", text(f"//ROOT//victim//./sub//..//{base}"), {}),
        ("a byte that is no text", text(f"../od\udcff d/{base}"), {}),
        ("NUL", f'concat("../victim/{base}", chr(0), ".inc")', {}),
        ("~", text(f"~/private/{base}"), {}),
        ("library", text(f"../lib/../victim/{base}"), {}),
        ("link of a library", text("inside"), {"inside": Link("sub/../folder/" + base)}),
    )


HARD = ("hard link", '"hard"', {})


def statement(opener, place):
    return opener[2].replace("NAME", place[1])


def attempt(program, words, opener, place, cwd="strangers", more=None):
    files = {f"strangers/{name}": content for name, content in place[2].items()}
    if place is HARD:
        files["strangers/hard"] = Hard(f"victim/{opener[1]}")
    files["strangers/a.pov"] = HEAD + statement(opener, place) + "\n"
    return Attempt(f"{opener[0]} in a scene", place[0], program, list(words), {**files, **(more or {})}, cwd, is_refused=True)


def by_lentray():
    for opener in OPENERS:
        for place in places(opener[1]) + ((HARD,) if opener[3] else ()):
            # Half of them as the user in the scene's folder, half from elsewhere.
            yield attempt("lentray", [ON, "+L../lib", "+Ia.pov", "+Oa.png", *SMALL], opener, place)
        for place in places(opener[1])[:6]:
            one = attempt("lentray", [ON, "+L../lib", "+I../strangers/a.pov", "+Oa.png", *SMALL], opener, place, "here")
            one.is_refused = not opener[3]  # a name without a folder is written in the current one
            yield one


def by_batch():
    for opener in OPENERS:
        for place in places(opener[1]):
            # What a scene of a batch writes stays in memory, and photons are not saved: it may succeed, and writes nothing.
            one = attempt("lentray-batch", ["../strangers", "--out", "out", "+L../lib", "+W8", "+H6", "--quiet"], opener, place, "here")
            one.is_refused = not opener[3]
            yield one


def by_others():
    """Programs that hand their options to lentray."""
    ways = {"lentray-diff": ["a.pov", "--no-pictures", "+W8", "+H6", ON, "+L../lib"],
            "lentray-grouping": ["a.pov", "--orders", "rows", "--caches", "off", "--repeats", "1", "+W8", "+H6", ON, "+L../lib"],
            "lentray-chart": ["a.pov", "--out", "../here/out", "--quick", "--no-stock", "--only", "quality", "--repeats", "1", "+W8", "+H6",
                              ON, "+L../lib"]}
    for program, words in ways.items():
        for opener in (READERS[0], READERS[2], READERS[5], WRITERS[0], WRITERS[1]):
            for place in (places(opener[1])[0], places(opener[1])[3], places(opener[1])[5]):
                yield attempt(program, words, opener, place)


def devices():
    names = ("/dev/ptmx", "/dev/tty", "/dev/mem", "/dev/kmsg", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/2", "/proc/self/mem",
             "/proc/self/environ", "/proc/1/environ", "/dev/shm/lentray-escape", "/dev/zero", "pipe", "sub/../pipe", "pipe.png")
    files = {"strangers/pipe": Fifo(), "strangers/pipe.png": Fifo()}
    for name in names:
        for opener in (READERS[0], READERS[1], READERS[2], WRITERS[0], WRITERS[1]):
            one = attempt("lentray", [ON, "+Ia.pov", "-F", "-V"], opener, (name, f'"{name}"', {}), more=files)
            one.kind = "devices and pipes"
            yield one


def obeyed():
    """Names in the user's own folder that later runs or shells obey."""
    for name in (".profile", ".bashrc", "povray.ini", "a.ini", "a.INI", "sub/../x.ini", ".lentray-batch/x", "a.png.lentray-state",
                 "a.png.lentray-passes", "manifest.jsonl", "state.json", "x.rca", "povray.conf", ".ssh/id", ".git/config"):
        for opener in WRITERS[:2]:
            one = attempt("lentray", [ON, "+I../strangers/a.pov", "+Oa.png", *SMALL], opener, (name, f'"{name}"', {}), "here",
                          {"here/sub/x": "", "here/.ssh/x": "", "here/.git/x": ""})
            one.kind = "what later runs obey"
            yield one


def races():
    """What a name means changes while scenes open it again and again."""
    read = {"plain": "#declare Plain = 1;\n"}
    loops = "#declare I = 0; #while (I < 400) WHAT #declare I = I + 1; #end\n"
    ways = (
        ("#include in a scene", '#include "r"', ("r", ("#declare Plain = 1;\n", Link("../victim/secret.inc")))),
        ("#include in a scene", '#include "f/secret.inc"', ("f", ({"secret.inc": "#declare Plain = 1;\n"}, Link("../victim")))),
        ("#fopen read in a scene", '#fopen F "r" read #read (F, A) #fclose F', ("r", ('"plain", 1\n', Link("../victim/text")))),
        ("#fopen write in a scene", '#fopen F "w" write #write (F, "x") #fclose F', ("w", ("plain\n", Link("../victim/rc"), None))),
        ("#fopen write in a scene", '#fopen F "w" write #write (F, "x") #fclose F', ("w", (None, Link("../victim/made"), None))),
        ("#fopen append in a scene", '#fopen F "w" append #write (F, "x") #fclose F', ("w", ("plain\n", Hard("victim/rc"), None))),
        ("#fopen write in a scene", '#fopen F "f/rc" write #write (F, "x") #fclose F', ("f", ({"rc": "plain\n"}, Link("../victim")))),
        ("picture in a scene", "sphere{0,1 pigment{image_map{ppm \"r\"}}}", ("r", ("P3 1 1 255 1 2 3\n", Link("../victim/secret.ppm")))),
        ("density file in a scene", 'sphere{0,1 pigment{density_file df3 "r"}}',
         ("r", ("\0\1\0\1\0\1\11", Link("../victim/secret.df3")))),
        ("font in a scene", 'text{ttf "r" "a" 1,0}', ("r", ("no font", Link("../victim/secret.ttf")))),
    )
    for kind, text, swaps in ways:
        for turn in range(3):
            scene = HEAD + (loops.replace("WHAT", text) if turn else text) + "\n"
            yield Attempt(kind, f"race {turn}", "lentray", [ON, "+Ia.pov", "+Oa.png", *SMALL], {"strangers/a.pov": scene, **{
                f"strangers/{name}": content for name, content in read.items()}}, swaps=swaps)
        scene = HEAD + loops.replace("WHAT", text) + "\n"
        yield Attempt(kind, "race", "lentray-batch", ["../strangers", "--out", "out", "+W8", "+H6", "--quiet"],
                      {"strangers/a.pov": scene}, "here", swaps=swaps)
    for turn in range(6):
        yield Attempt("scene that is a link", f"race {turn}", "lentray", [ON, "+Ib.pov", "+Oa.png", *SMALL],
                      swaps=("b.pov", (SCENE, Link("../victim/secret.pov"))))
        yield Attempt("scene that is a link", f"race {turn}", "lentray-batch", ["../strangers", "--out", "out", "+W8", "+H6", "--quiet"],
                      {f"strangers/s{i}.pov": SCENE for i in range(3)}, "here", swaps=("b.pov", (SCENE, Link("../victim/secret.pov"))))
        yield Attempt("folder that is a link", f"race {turn}", "lentray-batch", ["../strangers", "--out", "out", "+W8", "+H6", "--quiet"],
                      {f"strangers/s{i}.pov": SCENE for i in range(3)}, "here", swaps=("f", ({"a.pov": SCENE}, Link("../victim"))),
                      longest=0.02)
        beside = ("a.ini", ("Quality=5\n", Link("../victim/more.ini")))
        yield Attempt("options of INI files", f"race {turn}", "lentray", [ON, "+Ia.pov", *SMALL, "--scene-ini", "a.ini"], swaps=beside)
        yield Attempt("options of INI files", f"race {turn}", "lentray-diff", ["a.pov", "--no-pictures", "+W8", "+H6", ON, "--scene-ini", "a.ini"],
                      swaps=beside)
        yield Attempt("options of INI files", f"race {turn}", "lentray-batch", ["../strangers", "--out", "out", "+W8", "+H6", "--quiet"],
                      cwd="here", swaps=beside)


def attempts():
    for maker in (by_lentray, by_batch, by_others, devices, obeyed, races):
        yield from maker()
