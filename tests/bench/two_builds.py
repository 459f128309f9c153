"""What same_pictures.py and same_cost.py share: arguments, two programs, runs that end, many scenes, progress."""
import argparse
import collections
import concurrent.futures
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = pathlib.Path("/usr/share/doc/povray/examples")
SPD = ["balls", "gears", "mount", "rings", "teapot", "tetra", "tree"]

# A scene in one way of rendering: options are lentray's, beyond those that a command gives to all.
Scene = collections.namedtuple("Scene", "kind name path options")

sys.path.insert(0, str(ROOT / "tests" / "compat"))
running = set()


def program(parser, text):
    """The lentray that is meant: a file, or the one in a folder's bin or in the folder itself."""
    given = pathlib.Path(text)
    for path in (given / "bin" / "lentray", given / "lentray", given):
        if path.is_file() and os.access(path, os.X_OK):
            return path.resolve()
    parser.error(f"no lentray: neither {given / 'bin' / 'lentray'} nor {given} is a program")


def two_programs(parser, args):
    """Both of the command line; says so where a comparison cannot find anything."""
    before, after = program(parser, args.before), program(parser, args.after)
    if before.read_bytes() == after.read_bytes() and not args.before_option:
        print("note: both programs are the same file or copies of it", file=sys.stderr)
    return before, after


def parser_of(description, kinds, limit, limited):
    """With what both commands are told; `limited` has limit seconds by default."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    where = "a folder with bin/lentray in it, or a path to a lentray program"
    parser.add_argument("before", metavar="BEFORE", help=where)
    parser.add_argument("after", metavar="AFTER", help="the same of the other build")
    parser.add_argument("--only", action="append", choices=list(kinds),
                        help="this kind of scenes alone; may be given several times")
    parser.add_argument("--before-option", action="append", default=[], metavar="OPTION",
                        help="for BEFORE alone; may be given several times")
    parser.add_argument("--match", default="", metavar="WORD", help="only scenes whose name contains WORD")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="scenes at a time (default 1)")
    parser.add_argument("--limit", type=float, default=limit, metavar="S",
                        help=f"processor seconds {limited} may take (default {limit:g})")
    return parser


def read_arguments(parser):
    """The command line, with both programs, and these with their own options."""
    args = parser.parse_args()
    if args.jobs < 1:
        parser.error("--jobs must be at least 1")
    if args.limit <= 0:
        parser.error("--limit must be above 0")
    args.only = args.only or []
    args.programs = two_programs(parser, args)
    args.sides = list(zip(args.programs, (args.before_option, [])))
    return args


def examples(parser, names=None):
    """Scenes of povray-examples by their path without .pov, all without names."""
    if not EXAMPLES.is_dir():
        parser.error(f"no folder {EXAMPLES}: install Debian's packages povray-examples and povray-includes, or "
                     "leave such scenes out with --only")
    if names is None:
        names = sorted(str(p.relative_to(EXAMPLES))[:-len(".pov")] for p in EXAMPLES.rglob("*.pov"))
    missing = [name for name in names if not (EXAMPLES / (name + ".pov")).is_file()]
    if missing or not names:
        parser.error(f"{EXAMPLES} lacks " + ", ".join(name + ".pov" for name in missing or ["*"]))
    return [(name, EXAMPLES / (name + ".pov")) for name in names]


def end(process):
    """With all that it started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def run(command, folder, seconds):
    """Exit status, None where it took more seconds of processors; and what was said.

    Processors' seconds, so that a busy machine decides nothing; what hangs without work is ended, too.
    """
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([str(word) for word in command], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=said, stderr=subprocess.STDOUT, start_new_session=True)
        running.add(process)
        given_up = []

        def give_up():
            given_up.append(True)
            end(process)

        hangs = threading.Timer(20*seconds, give_up)
        hangs.start()
        most = math.ceil(seconds)
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (most, most))
        _, ended, usage = os.wait4(process.pid, 0)
        status = process.returncode = os.waitstatus_to_exitcode(ended)
        running.discard(process)
        late = given_up or (status != 0 and usage.ru_utime + usage.ru_stime > most - .5)
        hangs.cancel()
        end(process)
        said.seek(0)
        return None if late else status, said.read().decode(errors="replace")


def each(scenes, jobs, work):
    """(scene, work's answer) in the scenes' order; work returns (answer, words for a line of progress)."""
    answers = [None] * len(scenes)
    begun = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        tasks = {pool.submit(work, scene): k for k, scene in enumerate(scenes)}
        try:
            for count, task in enumerate(concurrent.futures.as_completed(tasks), 1):
                k = tasks[task]
                answers[k], words = task.result()
                print(f"[{count}/{len(scenes)}] {time.monotonic() - begun:6.1f} s  {scenes[k].kind} "
                      f"{scenes[k].name}: {words}", file=sys.stderr, flush=True)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for process in list(running):
                end(process)
            raise
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{len(scenes)} scenes in {time.monotonic() - begun:.0f} s, "
          f"{used.ru_utime + used.ru_stime:.0f} s of processors", file=sys.stderr)
    return list(zip(scenes, answers))


def of_all(parser, args, makers, work_on, first=None):
    """(scene, work_on's answer) of the scenes that are chosen, behind the one that `first` makes.

    makers has a function for each kind of scenes. All of them may write to args.work, which is gone afterwards.
    """
    with tempfile.TemporaryDirectory(prefix=pathlib.Path(parser.prog).stem + "-") as folder:
        args.work = pathlib.Path(folder)
        scenes = [scene for kind, maker in makers.items() if kind in (args.only or makers)
                  for scene in maker(parser, args) if args.match in scene.name]
        if not scenes:
            parser.error("no scenes are chosen")
        if first:
            scenes.insert(0, first(args))
        return each(scenes, args.jobs, lambda scene: work_on(scene, args))


def main(command):
    """Runs a command's main function; Ctrl-C is no error of the program's."""
    try:
        sys.exit(command())
    except KeyboardInterrupt:
        sys.exit("stopped")
