#!/usr/bin/env python3
"""The list of parts that tools/parts.py makes of a package: whole, by Debian's words, and the same each time.
Status: 0 all is well, 1 something is not, 77 dpkg is not here."""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools/parts.py"
CONTROL = """Package: lentray
Version: 1.2.3
Architecture: all
Maintainer: Nobody <nobody@localhost>
Description: nothing
Depends: libc6 (>= 2.14), libpng16-16 (>= 1.6) | libpng-other, zlib1g
"""
LOADED = ["libc6", "libpng16-16", "zlib1g"]


def expect(is_so, text):
    if not is_so:
        sys.exit(f"FAILED: {text}")


def version(package):
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True, check=True).stdout


def main():
    if not shutil.which("dpkg-deb"):
        return 77
    with tempfile.TemporaryDirectory() as name:
        tree, deb, out = (pathlib.Path(name, part) for part in ("tree", "lentray.deb", "out.json"))
        (tree / "DEBIAN").mkdir(parents=True)
        (tree / "DEBIAN/control").write_text(CONTROL)
        subprocess.run(["dpkg-deb", "--root-owner-group", "-b", tree, deb], check=True, capture_output=True)
        texts = []
        for _ in range(2):
            subprocess.run([sys.executable, TOOL, deb, out], check=True, env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
            texts.append(out.read_text())
        checksum = hashlib.sha256(deb.read_bytes()).hexdigest()
    expect(texts[0] == texts[1], "two lists of one package differ")
    parts = json.loads(texts[0])
    packages = {part["name"]: part for part in parts["packages"]}
    expect(parts["spdxVersion"] == "SPDX-2.3" and parts["dataLicense"] == "CC0-1.0", "the head")
    expect(parts["creationInfo"]["created"] == "2023-11-14T22:13:20Z", "the time of SOURCE_DATE_EPOCH")
    expect(packages["lentray"]["versionInfo"] == "1.2.3", "the program's version")
    expect(packages["lentray"]["checksums"][0]["checksumValue"] == checksum, "the package's checksum")
    expect("libpng-other" not in packages, "an alternative that is not installed")
    for package in LOADED:
        expect(packages[package]["versionInfo"] == version(package), f"the version of {package}")
    expect(packages["libpng16-16"]["licenseDeclared"] == "Libpng", "the licence of libpng")
    words = {part["SPDXID"] for part in parts["packages"]} | {"SPDXRef-DOCUMENT"}
    expect(len(words) == len(packages) + 1, "two parts of one name")
    for one in parts["relationships"]:
        expect({one["spdxElementId"], one["relatedSpdxElement"]} <= words, f"a relation to nothing: {one}")
    loaded = [one["relatedSpdxElement"] for one in parts["relationships"] if one["relationshipType"] == "DYNAMIC_LINK"]
    expect(loaded == [f"SPDXRef-{package}" for package in LOADED], "the libraries that it loads")
    print(f"parts: {len(packages)} packages, all is well")
    return 0


if __name__ == "__main__":
    sys.exit(main())
