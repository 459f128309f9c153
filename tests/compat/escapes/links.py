"""Links that came with scenes, where the user's outputs, journals and pages go; journals and states of strangers."""
import json
import os
import shutil

from escapes.ground import ON, SCENE, SMALL, Attempt, Hard, Link

SAYS = SCENE + '#debug "alias ls=evil\\n"\n'
SLOW = """#include "functions.inc"
camera{location -5*z look_at 0} light_source{<2,4,-8>,1 area_light x,y,LAMPS,LAMPS}
plane{y,-1 pigment{granite scale .02}} sphere{0,1 pigment{function{f_noise_generator(x*99,y*99,z*99,2)}}}
""".replace("LAMPS", "28")
# The user's words, and where they write: where a link may lie.
OUTPUTS = (
    ([], "a.png"), (["+Ob.png"], "b.png"), (["+O./"], "a.png"), (["+Osub/b.png"], "sub/b.png"), (["+OROOT/strangers/"], "a.png"),
    (["Debug_File=true"], "debug.out"), (["Debug_File=w.txt"], "w.txt"), (["Append_File=On", "Debug_File=w.txt"], "w.txt"), (["All_File=w.txt"], "w.txt"),
    (["Statistics_File=s.json"], "s.json"), (["Dependencies_File=s.json"], "s.json"), (["Create_Ini=On"], "a.ini"),
    (["+RFO", "+RFx"], "x"), (["-F", "--dump-rays", "rays"], "rays"), (["+KFF2", "+Ob.png"], "b2.png"), (["+Oa.exr", "+FE"], "a.exr"),
    (["Lenticular=On", "Lens_Pixels=4", "View_Cameras=v.json"], "v.json"), (["Lenticular=On", "Lens_Pixels=4", "--depth-view", "d.html"], "d.html"))


def outputs():
    for words, name in OUTPUTS:
        for kind, link in (("links at outputs", Link("ROOT/victim/rc")), ("links at outputs", Link("ROOT/victim/made")),
                           ("hard links at outputs", Hard("victim/rc"))):
            yield Attempt(kind, f"{name} of {' '.join(words)}", "lentray", [ON, "+Ia.pov", *SMALL, *words],
                          {"strangers/a.pov": SAYS, f"strangers/{name}": link}, are_reads_told=not isinstance(link, Hard))
    for words in ([], ["+KFF2"], ["+C"]):
        for name in ("a.png.lentray-state", "a.png.lentray-passes", "a.png.lentray-passes.part", "a1.png.lentray-state", "a1.png"):
            for link in (Link("ROOT/victim/rc"), Hard("victim/rc"), Link("ROOT/victim/made")):
                yield Attempt("journals", f"{name} is a {'hard ' if isinstance(link, Hard) else ''}link, {' '.join(words)}", "lentray",
                              [ON, "+Ia.pov", "+W200", "+H150", "-V", *words], {"strangers/a.pov": SLOW, f"strangers/{name}": link},
                              are_reads_told=not isinstance(link, Hard))
    for swaps in (("a.png", ("x", Link("../victim/rc"))), ("a.png", (None, Hard("victim/rc"))), ("sub/a.png", ("x", Link("../../victim/rc"))),
                  ("a.png.lentray-state", (None, Link("../victim/rc"))), ("o", ({}, Link("../victim")))):
        words = ["+O" + ("o/a.png" if swaps[0] == "o" else "sub/a.png" if swaps[0].startswith("sub") else "a.png")]
        for turn in range(3):
            yield Attempt("links at outputs", f"race {turn} at {swaps[0]}", "lentray", [ON, "+Ia.pov", *SMALL, "+KFF9", *words],
                          {"strangers/a.pov": SAYS}, swaps=swaps)


SHEET = ["a.pov", "+W8", "+H6", "Lenticular=On", "Lens_Pixels=2", ON]


def other_outputs():
    """Names that programs choose themselves, in a folder that came from a stranger."""
    for program, words, name in (
            ("lentray-diff", ["a.pov", "+W8", "+H6", ON], "a-diff-ours.png"), ("lentray-diff", ["a.pov", "+W8", "+H6", ON], "a-diff-heat.png"),
            ("lentray-diff", ["a.pov", "+W8", "+H6", ON], "a-diff-stock.png"), ("lentray-diff", ["a.pov", "+W8", "+H6", ON], "a-diff-side.png"),
            ("lentray-diff", [*SHEET, "--keep", "k", "--no-pictures"], "k/view0.pov"),
            ("lentray-diff", [*SHEET, "--write-wrappers", "k"], "k/view0.pov"),
            ("lentray-diff", ["a.pov", "+W8", "+H6", ON, "--no-pictures", "--json", "j.json"], "j.json")):
        for link in (Link("ROOT/victim/rc"), Hard("victim/rc"), Link("ROOT/victim/made")):
            yield Attempt("links at outputs", f"{name} of {' '.join(words)}", program, words, {f"strangers/{name}": link},
                          are_reads_told=not isinstance(link, Hard))


BATCH = ["../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet", "--retry"]
CHART = ["a.pov", "--out", "out", "--quick", "--no-stock", "--only", "quality", "--repeats", "1", "+W8", "+H6", ON]


def state_names(program):
    if program == "lentray-batch":
        return ["a.png", "manifest.jsonl", "index.html", ".lentray-batch/lock", ".lentray-batch/reserve", ".lentray-batch/runs",
                ".lentray-batch", ".lentray-batch/thumbnails", "a.png.lentray-state", ".lentray-batch/slurm"]
    return ["index.html", "chart.csv", "pictures", "pictures/reference.png", ".lentray-chart", ".lentray-chart/lock", ".lentray-chart/state.json",
            ".lentray-chart/log", ".lentray-chart/statistics.json"]


def states():
    """All that a run leaves, made links to outside: by name, and each file that a run before really left."""
    for program, words in (("lentray-batch", BATCH), ("lentray-chart", CHART)):
        for name in state_names(program):
            folder = "." not in name.split("/")[-1].lstrip(".") and not name.endswith(("lock", "log", "reserve"))
            for link in (Link("ROOT/victim" if folder else "ROOT/victim/rc"), Link("ROOT/victim/made"), Hard("victim/rc")):
                if isinstance(link, Hard) and folder:
                    continue
                yield Attempt("states and pages", f"{name} is a {'hard ' if isinstance(link, Hard) else ''}link", program, words,
                              {f"strangers/out/{name}": link}, are_reads_told=not isinstance(link, Hard))
        for is_hard in (False, True):
            for change in ("nothing", "scene"):
                yield Attempt("states and pages", f"every file of a run before is a {'hard ' if is_hard else ''}link, {change} changes",
                              program, words, before=lambda ground, w=words, p=program, h=is_hard, c=change: relink(ground, p, w, h, c),
                              are_reads_told=not is_hard)


def relink(ground, program, words, is_hard, change):
    ground.run(Attempt("", "", program, words))
    out = ground.root / "strangers/out"
    for number, place in enumerate(sorted(p for p in out.rglob("*") if p.is_file())):
        to = ground.root / "victim/sub" / str(number)
        shutil.copy(place, to)
        place.unlink()
        (os.link if is_hard else os.symlink)(to, place)
    if change == "scene":
        (ground.root / "strangers/a.pov").write_text(SCENE + "sphere{x,1}\n")


def forged_states():
    """Rows, states and journals whose places lead out."""
    places = ("../../victim/rc", "ROOT/victim/rc", "sub/../../../victim/rc", "../folder/rc")
    for place in places:
        for member in ("name", "picture", "source", "views", "stock", "key", "missing", "files"):
            row = {"name": "a", "source": "ROOT/strangers/a.pov", "state": "done", "picture": "a.png", "files": {}, "attempts": 1}
            row[member] = {"views": [place], "missing": [place], "files": {place: [1, 1, 1]}}.get(member, place)
            if member == "stock":
                row["verdict"] = {"grade": "exact", "stock": place, "difference": place}
            yield Attempt("manifests", f"{member} is {place}", "lentray-batch", BATCH,
                          {"strangers/out/manifest.jsonl": json.dumps(row) + "\n"})
        yield Attempt("states and pages", f"pictures of a chart at {place}", "lentray-chart", CHART,
                      before=lambda ground, to=place: forge_chart(ground, to))
    for n, bytes_ in enumerate((b"lentray journal\0" + b"\1\0\0\0\0\0\0\0" + b"\xff" * 16, b"lentray journal\0" + bytes(64), b"\0" * 4096,
                                b"lentray passes\0\0\1" + b"\xff" * 64)):
        for name in ("a.png.lentray-state", "a.png.lentray-passes.part", "a.png.lentray-passes"):
            yield Attempt("journals", f"{name} is forged ({n})", "lentray", [ON, "+Ia.pov", *SMALL, "+C"],
                          {f"strangers/{name}": bytes_})


def forge_chart(ground, to):
    ground.run(Attempt("", "", "lentray-chart", CHART))
    state = ground.root / "strangers/out/.lentray-chart/state.json"
    text = json.loads(state.read_text())
    to = to.replace("ROOT", str(ground.root))
    for point in text["chart"]["points"]:
        point["picture"] = point["difference"] = to
    text["chart"]["reference"]["picture"] = to
    state.write_text(json.dumps(text))


def attempts():
    for maker in (outputs, other_outputs, states, forged_states):
        yield from maker()
