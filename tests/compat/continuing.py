"""Renders that are killed (-9) at any moment and gone on with by +C: the same pixels as undisturbed?

  tests/compat/continuing.py [--bin FOLDER] [--still 50] [--animation 20] [--seconds 4]

A scene has as many lamps as make its undisturbed render last so many seconds: less than a second is never kept. Each
kill of a picture comes later than the one before may have come, so that it is done in the end.
The kills of the still go round: no antialiasing, methods 1 and 2, a lens sheet. Besides, what is done must
count: a picture that was killed is finished in fewer rays than a whole one takes. The exit status is 1 if
a picture differs.
"""
import argparse
import hashlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = """#version 3.7; global_settings { assumed_gamma 1 subsurface { samples 10, 10 } }
camera { location <0, 1, -6> look_at 0 right 4/3*x }
light_source { <-9, 12, -9> rgb 1 area_light 4*x, 4*z, LAMPS, LAMPS jitter }
sphere { <2*clock - 1, 0, 0>, 1 pigment { rgb 1 } finish { reflection 0.3 } }
plane { y, -1 pigment { checker rgb 1, rgb 0.3 } }
box { <1, -1, 1>, <2, 1, 2> pigment { granite } finish { subsurface { translucency 1 } } interior { ior 1.3 } }
"""
WAYS = ([], ["+A0.1", "+AM1", "+R2"], ["+A0.1", "+AM2", "+R2"], ["Lenticular=On", "+A0.2", "+AM1", "+R2"],
        ["Lenticular=On", "+A0.2", "+AM3"])


def pictures(where):
    return {p.name: hashlib.md5(p.read_bytes()).hexdigest() for p in sorted(where.glob("*.png"))}


def run(command, where):
    start = time.monotonic()
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr}")
    return time.monotonic() - start


def undisturbed(command, where, least):
    """The lamps of a scene that takes long enough, which is written there and rendered; and how long it took."""
    lamps = 5
    while True:
        (where / "scene.pov").write_text(SCENE.replace("LAMPS", str(lamps)))
        seconds = run(command, where)
        if seconds >= least:
            return lamps, seconds
        lamps = int(lamps * min(max(1.1, (1.2 * least / seconds) ** 0.5), 4)) + 1


def kill_and_go_on(command, where, seconds, chance):
    """How often it was killed before it was done."""
    kills = 0
    while True:
        patience = seconds * 1.1 ** kills
        process = subprocess.Popen([*command, "+C"], cwd=where, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            _, text = process.communicate(timeout=chance.uniform(0.05, 0.75) * patience)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            kills += 1
            continue
        if process.returncode != 0:
            sys.exit(text.decode())
        return kills


def check(title, command, wanted, chance, folder, least):
    """Kills until there are as many as wanted; False if a picture differs."""
    whole = folder / "whole"
    whole.mkdir()
    lamps, seconds = undisturbed(command, whole, least)
    text = SCENE.replace("LAMPS", str(lamps))
    kills = runs = 0
    good = True
    while kills < wanted:
        where = folder / f"killed{runs}"
        where.mkdir()
        (where / "scene.pov").write_text(text)
        kills += kill_and_go_on(command, where, seconds, chance)
        runs += 1
        good = good and pictures(where) == pictures(whole) and (where / "scene.pov").read_text() == text
        left = [p.name for p in where.iterdir() if "lentray-state" in p.name]
        if left:
            print("left behind:", *left)
            good = False
    print(f"{title}: {seconds:.1f} s undisturbed; {kills} kills of {runs} runs, "
          f"{'the same pixels' if good else 'PIXELS DIFFER'}", flush=True)
    return good


def saves_work(program, folder, least):
    """The rays of a picture that was killed at two thirds and gone on with, and of a whole one."""
    folder.mkdir()
    command = [program, "+Iscene.pov", "-D", "-V", "+W400", "+H300", "Statistics_File=s.json", "+A0.1"]
    _, seconds = undisturbed([*command, "+Owhole.png"], folder, least)
    rays = json.loads((folder / "s.json").read_text())["rays"]
    whole = sum(v for v in rays.values() if isinstance(v, (int, float)))
    process = subprocess.Popen([*command, "+Okilled.png"], cwd=folder)
    time.sleep(0.67 * seconds)
    process.kill()
    process.wait()
    run([*command, "+Okilled.png", "+C"], folder)
    rays = json.loads((folder / "s.json").read_text())["rays"]
    rest = sum(v for v in rays.values() if isinstance(v, (int, float)))
    print(f"killed at 67 % of {seconds:.1f} s: the rest took {100 * rest / whole:.0f} % of the rays", flush=True)
    return rest < 0.8 * whole


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "release" / "bin")
    parser.add_argument("--still", type=int, default=50)
    parser.add_argument("--animation", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=4.0, help="of an undisturbed render")
    args = parser.parse_args()
    program = args.bin.resolve() / "lentray"
    chance = random.Random(7)
    good = True
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for i, way in enumerate(WAYS):
            place = folder / f"still{i}"
            place.mkdir()
            kills = args.still // len(WAYS) + (1 if i < args.still % len(WAYS) else 0)
            command = [program, "+Iscene.pov", "-D", "-V", "+W480", "+H360", *way]
            good = check("still " + " ".join(way), command, kills, chance, place, args.seconds) and good
        place = folder / "animation"
        place.mkdir()
        command = [program, "+Iscene.pov", "-D", "-V", "+W240", "+H180", "+KFF10", "+A0.1", "+R2"]
        good = check("animation of 10 frames", command, args.animation, chance, place, args.seconds) and good
        good = saves_work(program, folder / "work", args.seconds) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
