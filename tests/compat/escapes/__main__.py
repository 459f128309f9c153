"""Attempts to get out of Restrict_IO=On and of a batch, through every program: counted, with what got out.

  tests/compat/escapes --bin build/release/bin              all of them
  tests/compat/escapes --bin build/release/bin --part 7     every seventh
  tests/compat/escapes --bin build/release/bin WORD...      those whose kind, name or program contains one of the words
  ... --tell                                                each with its status and what the program said

A stranger's folder has the scenes and all that lies beside them; the user's words are harmless. Watched are the folders
outside: content, size, mode and time of every file, which names there are, and by the kernel whether anything in them
was read, written or renamed. Nothing that later runs obey is made in the user's own folder, and nothing secret is told. What is
refused has no success. Of the attempts of lentray and of batches is said how many get out where Restrict_IO=Off lets them.
The last line is "N attempts, M escapes"; the status is 1 if M is not 0.
"""
import argparse
import collections
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from escapes import files, inis, links, scenes  # noqa: E402
from escapes.ground import ON, Ground  # noqa: E402

PROGRAMS = ("lentray", "lentray-batch", "lentray-chart", "lentray-diff", "lentray-grouping", "lentray-merge", "lentray-model",
            "lentray-print", "lentray-views")


def attempts():
    for part in (scenes, inis, links, files):
        yield from part.attempts()


def unrestricted(attempt):
    """The same without the rules; None where a program has none."""
    if attempt.program == "lentray-batch":
        attempt.words = [*attempt.words, "Restrict_IO=Off"]
    elif ON in attempt.words:
        attempt.words = [word for word in attempt.words if word != ON]
    else:
        return None
    return attempt


def made(attempt, place, binaries):
    ground = Ground(place, binaries)
    try:
        return ground.escapes(attempt)
    finally:
        ground.close()


def table(counts, real):
    print(f"\n{'':<30}" + "".join(f"{name.replace('lentray', '').strip('-') or 'lentray':>10}" for name in PROGRAMS) + f"{'without':>10}")
    for kind in sorted({kind for kind, _ in counts}):
        row = "".join(f"{counts.get((kind, name), '') or '':>10}" for name in PROGRAMS)
        print(f"{kind:<30}{row}{real.get(kind, 0):>10}")
    totals = "".join(f"{sum(n for (_, name), n in counts.items() if name == program):>10}" for program in PROGRAMS)
    print(f"{'all':<30}{totals}{sum(real.values()):>10}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("words", nargs="*")
    parser.add_argument("--bin", type=pathlib.Path, required=True)
    parser.add_argument("--part", type=int, default=1, metavar="N", help="every Nth attempt")
    parser.add_argument("--tell", action="store_true", help="each attempt, its status and what was said")
    given = parser.parse_args()
    binaries = given.bin.resolve()
    counts, real, escapes = collections.Counter(), collections.Counter(), 0
    # Not below /tmp, where Debian's povray.conf lets scenes write.
    with tempfile.TemporaryDirectory(dir=binaries.parent) as place:
        for number, attempt in enumerate(attempts()):
            title = f"{attempt.program}: {attempt.kind}: {attempt.what}"
            if number % given.part or not (binaries / attempt.program).exists():
                continue
            if given.words and not any(word in title for word in given.words):
                continue
            found, status, said = made(attempt, place, binaries)
            counts[attempt.kind, attempt.program] += 1
            escapes += bool(found)
            if found:
                print(f"ESCAPED: {title}: {'; '.join(found)}", flush=True)
            if found or given.tell:
                print(f"    {title}: status {status}: {said[-600:]!r}", flush=True)
            free = unrestricted(attempt)
            real[attempt.kind] += bool(free and made(free, place, binaries)[0])
    table(counts, real)
    print(f"{sum(counts.values())} attempts, {escapes} escapes")
    return 1 if escapes else 0


if __name__ == "__main__":
    sys.exit(main())
