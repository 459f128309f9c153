"""What checks of whole programs share: folders with a home of their own, expectations that are counted, a verdict."""
import argparse
import os
import pathlib
import subprocess

failures = 0


def expect(condition, *what):
    global failures
    if not condition:
        failures += 1
        print("FAILED:", *what)


class Folders:
    """A folder, the programs, and the folder home below it, where a povray.conf of its own may lie."""

    def __init__(self, root, binaries):
        self.root, self.bin = pathlib.Path(root), binaries

    def run(self, program, *words, cwd=".", seconds=120):
        """Its status and all that it says."""
        done = subprocess.run([self.bin / program, *map(str, words)], cwd=self.root / cwd, capture_output=True, text=True,
                              errors="replace", env=dict(os.environ, HOME=str(self.root / "home"), POVINI=""), timeout=seconds)
        return done.returncode, done.stdout + done.stderr


def programs():
    """The folder that --bin names."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", required=True, type=pathlib.Path)
    return parser.parse_args().bin.resolve()


def verdict(all_well):
    """Says what failed or that all is well; the status to end with."""
    print(f"failed: {failures}" if failures else all_well)
    return 1 if failures else 0
