"""Peak memory of scenes whose objects share nested textures: Lentray beside stock POV-Ray.

Ten ways to give one nested pigment, normal or texture to 2,000 objects, each of which moves it, or is
moved with it. What is moved has its place for itself; the maps behind it are the same for all. Whole
processes at 80 x 60 pixels on one thread.

  tests/bench/shared_textures.py [--objects N] [--bin FOLDER] [way ...]

Prints a table. Exit status 1 where Lentray takes more than 1.2 of stock's memory and more than 20 MB
above it.
"""
import argparse
import pathlib
import shutil
import sys
import tempfile

from building import HEAD, PLACE, ROOT, commands, loop, run

MOST_TIMES, MOST_MORE = 1.2, 20e6

# Each macro gives what stands inside the braces of its statement.
PIGMENT = """
#macro Pigment(Depth) bozo pigment_map {
  #if (Depth > 0) [.3 Pigment(Depth - 1) scale .6] [.7 Pigment(Depth - 1)]
  #else [0 rgb rand(R)] [1 rgb <rand(R), 1, 0>] #end } scale .8
#end
"""
NORMAL = """
#macro Normal(Depth) gradient y normal_map {
  #if (Depth > 0) [.2 Normal(Depth - 1) scale .7] [.8 Normal(Depth - 1)]
  #else [0 bumps rand(R)] [1 dents rand(R)] #end } scale .9
#end
"""
TEXTURE = """
#macro Texture(Depth)
  #if (Depth > 0) radial texture_map { [.4 Texture(Depth - 1) scale .7] [.6 Texture(Depth - 1)] }
    rotate x*20
  #else pigment { wood color_map { [0 rgb rand(R)] [1 rgb 1] } } normal { bumps .2 scale .3 }
    finish { phong rand(R) } #end
#end
"""


def moved_pigment(n):
    return PIGMENT + "#declare T = texture { pigment { Pigment(6) } }\n" + loop(
        n, "box { -.2, .2 texture { T } " + PLACE + " }")


def scaled_texture(n):
    return TEXTURE + "#declare T = texture { Texture(6) }\n" + loop(
        n, "sphere { <rand(R)*80 - 40, 0, rand(R)*80 - 40>, .3 texture { T scale .5 + rand(R) } }")


def turned_copies(n):
    return TEXTURE + "#declare Part = box { -.3, .3 texture { Texture(6) } };\n" + loop(
        n, "object { Part rotate y*rand(R)*360 " + PLACE + " }")


def unions(n):
    return PIGMENT + TEXTURE + """
#declare Pair = union {
  box { -.2, 0 texture { Texture(5) } }
  sphere { .2, .2 pigment { Pigment(5) } } };
""" + loop(n // 2, "object { Pair scale .5 + rand(R) " + PLACE + " }")


def one_union(n):
    return TEXTURE + "#declare T = texture { Texture(6) }\nunion {\n" + loop(
        n, "box { -.2, .2 texture { T } " + PLACE + " }") + "rotate y*10 }\n"


def array_of_textures(n):
    return TEXTURE + "#declare A = array[3];\n" + loop(
        3, "#declare A[I - 1] = texture { Texture(5) }") + loop(
            n, "cone { 0, .3, y, 0 texture { A[mod(I, 3)] translate rand(R)*9 } " + PLACE + " }")


def macro_of_layers(n):
    return PIGMENT + NORMAL + """
#declare P = pigment { Pigment(5) }
#declare N = normal { Normal(5) }
#macro Layers(Turn)
  texture { pigment { P rotate Turn } normal { N rotate Turn } }
  texture { pigment { P rotate -Turn } finish { phong .4 } }
#end
""" + loop(n, "sphere { 0, .3 Layers(y*rand(R)*90) " + PLACE + " }")


def own_map(n):
    return TEXTURE + "#declare T = texture { Texture(5) }\n" + loop(
        n, "box { -.3, .3 texture { checker texture { T scale .3 + rand(R) }"
           " texture { pigment { rgb rand(R) } } rotate rand(R)*90 } " + PLACE + " }")


def averages(n):
    return PIGMENT + NORMAL + """
#declare P = pigment { average pigment_map { [1 Pigment(4)] [2 Pigment(4)] [1 rgb .5] } }
#declare N = normal { average normal_map { [1 Normal(4)] [3 Normal(4)] } }
#declare T = texture { average texture_map {
  [1 pigment { P }]
  [2 pigment { Pigment(5) } normal { N }]
  [1 pigment { P } finish { phong 1 }] } }
""" + loop(n, "box { -.2, .2 texture { T } rotate x*rand(R)*90 " + PLACE + " }")


def both_sides(n):
    return TEXTURE + """
#declare T = texture { Texture(5) }
#declare Inner = texture { Texture(5) }
""" + loop(n, "difference { box { -.3, .3 } plane { x, rand(R)*.1 } texture { T }"
              " interior_texture { Inner } rotate z*rand(R)*90 " + PLACE + " }")


WAYS = {
    "moved_pigment": (moved_pigment, "boxes that move a nested pigment"),
    "scaled_texture": (scaled_texture, "a texture of maps, scaled in each statement"),
    "turned_copies": (turned_copies, "turned copies of one object"),
    "unions": (unions, "scaled copies of a union of two nested looks"),
    "one_union": (one_union, "parts of one union, moved in it and with it"),
    "array_of_textures": (array_of_textures, "four textures in an array, moved twice"),
    "macro_of_layers": (macro_of_layers, "layers that a macro turns"),
    "own_map": (own_map, "a map of each object's own around the shared texture"),
    "averages": (averages, "averages of pigments, normals and textures"),
    "both_sides": (both_sides, "differences with an interior texture"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--objects", type=int, default=2000)
    parser.add_argument("--bin", default=str(ROOT / "build" / "release" / "bin"))
    parser.add_argument("ways", nargs="*")
    args = parser.parse_args()
    for name in args.ways:
        if name not in WAYS:
            sys.exit(f"no scene '{name}': one of {', '.join(WAYS)}")
    folder = pathlib.Path(tempfile.mkdtemp())
    too_much = False
    print("| 2,000 objects".replace("2,000", f"{args.objects:,}") +
          " | Lentray | stock | CPU time, Lentray / stock | |\n|---|---:|---:|---:|---|")
    try:
        for name in args.ways or WAYS:
            scene, says = WAYS[name]
            (folder / "scene.pov").write_text(HEAD + scene(args.objects))
            cost = {key: run(command, folder) for key, command in
                    commands(pathlib.Path(args.bin).resolve() / "lentray").items()}
            ours, stock = cost["lentray"], cost["stock"]
            holds = ours.bytes <= max(MOST_TIMES * stock.bytes, stock.bytes + MOST_MORE)
            too_much = too_much or not holds
            print(f"| {says} (`{name}`) | {ours.bytes / 1e6:.0f} MB | {stock.bytes / 1e6:.0f} MB "
                  f"| {ours.seconds:.2f} / {stock.seconds:.2f} s | {'' if holds else 'too much'} |",
                  flush=True)
    finally:
        shutil.rmtree(folder)
    sys.exit(1 if too_much else 0)


if __name__ == "__main__":
    main()
