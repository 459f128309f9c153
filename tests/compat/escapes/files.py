"""Pictures that are lists of more files, and runs on a cluster that came with the scenes."""
import json

from escapes.ground import Attempt, Link
from escapes.inis import strangers

LISTS = {
    "HTTP live": "#EXTM3U\n#EXTINF:1,\nfile://ROOT/victim/secret.png\n#EXT-X-ENDLIST\n",
    "ffconcat": "ffconcat version 1.0\nfile 'ROOT/victim/secret.png'\n",
    "ffconcat by dots": "ffconcat version 1.0\nfile '../victim/secret.png'\nduration 1\n",
    "SMIL": '<smil><body><img src="../victim/secret.png"/></body></smil>\n',
    "DASH": '<?xml version="1.0"?><MPD><Period><AdaptationSet><Representation><BaseURL>ROOT/victim/secret.png</BaseURL></Representation>'
            "</AdaptationSet></Period></MPD>\n",
    "SVG": '<svg xmlns:xlink="http://www.w3.org/1999/xlink" width="4" height="4"><image xlink:href="../victim/secret.png"/></svg>\n',
}
NAMES = ("p.png", "p.jpg", "p.tif", "p.m3u8", "p.mp4")


def pictures():
    for title, text in LISTS.items():
        for name in NAMES:
            files = {f"strangers/{name}": text}
            for program, words in (("lentray-views", [name, "--lens-pixels", "2", "--view", "0", "--out", "o.png"]),
                                   ("lentray-print", ["sheet", name, "--lpi", "40", "--out", "o.pdf"]),
                                   ("lentray-merge", [name, name, "--out", "o.png"]),
                                   ("lentray-diff", [name, name, "--no-pictures"])):
                yield Attempt("pictures that are lists", f"{title} as {name}", program, words, files, is_refused=True)


WORDS = ["../strangers", "--out", "../strangers/out", "+W8", "+H6", "--quiet", "--slurm"]
RUN = "strangers/out/.lentray-batch/slurm/run/"


def slurm():
    tools = {"slurm/sinfo": "#!/bin/sh\necho 0/2/0/2\n", "slurm/squeue": "#!/bin/sh\n", "slurm/sbatch": strangers.SBATCH}
    item = {"name": "a", "band": 0, "bands": 1, "first_row": 1, "last_row": 0, "seconds": 1.0, "source": "ROOT/strangers/a.pov",
            "scene": "a", "ini": ""}
    command = {"words": WORDS, "folder": "ROOT/here"}
    row = {"name": "a", "source": "ROOT/strangers/a.pov", "state": "done", "picture": "a.png", "files": {}, "attempts": 1}
    cases = [("a script", {}, {}, {}, "run 7")]
    for member, value in (("source", "ROOT/victim/secret.pov"), ("source", "../victim/secret.pov"), ("source", "ROOT/strangers/../victim/secret.pov"),
                          ("source", "ROOT/strangers/folder/secret.pov"), ("scene", "../../victim/x"), ("name", "../../victim/x"),
                          ("ini", "ROOT/victim/secret.ini"), ("ini", "ROOT/strangers/folder/secret.ini")):
        cases.append((f"{member} is {value}", {member: value}, {}, {}, "run 7"))
    for member, value in (("folder", "ROOT/victim"), ("words", [*WORDS, "Restrict_IO=Off"]), ("words", [*WORDS, "--lentray", "../strangers/evil"])):
        cases.append((f"{member} is {value}", {}, {member: value}, {}, "run 7"))
    for member, value in (("picture", "../../victim/rc"), ("picture", "ROOT/victim/rc"), ("name", "../../victim/x"), ("views", ["../../victim/rc"]),
                          ("key", "/../../../../victim/rc")):
        cases.append((f"a row's {member} is {value}", {}, {}, {member: value}, "run 7"))
        cases.append((f"a band's {member} is {value}", {"bands": 2}, {}, {"band": "0", "name": "a~0", member: value}, "run 7"))
    cases += [("the run is ../../../victim", {}, {}, {}, "../../../victim 7"), ("the run is a link", {}, {}, {}, "away 7")]
    for title, items, commands, rows, current in cases:
        files = {**tools, RUN + "tasks.jsonl": json.dumps([{**item, **items}]) + "\n", RUN + "command.json": json.dumps({**command, **commands}),
                 RUN + "task.sh": "touch ROOT/victim/touched\n", RUN + "results/r.jsonl": json.dumps({**row, **rows}) + "\n" if rows else "",
                 RUN + "scratch/x": "", RUN + "logs/x": "", RUN + "../current": current,
                 "strangers/evil": "#!/bin/sh\ntouch ROOT/victim/touched\n"}
        if "link" in title:
            files[RUN + "../away"] = Link("ROOT/victim")
        yield Attempt("runs of Slurm", title, "lentray-batch", WORDS, files, "here", before=make_executable, path="slurm")


def make_executable(ground):
    for name in ("sinfo", "squeue", "sbatch"):
        (ground.root / "slurm" / name).chmod(0o755)
    (ground.root / "strangers/evil").chmod(0o755)


def attempts():
    yield from pictures()
    yield from slurm()
