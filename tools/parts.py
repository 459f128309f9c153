#!/usr/bin/env python3
"""The list of the parts in a Debian package of this project, as SPDX 2.3 in JSON.

  tools/parts.py PACKAGE.deb OUT.spdx.json

Parts are the program, the libraries that it loads and the packages of headers that are compiled into it. Packages, versions and
licences are those of the Debian system that it runs on, which is the one that the package was made on. A licence is declared
where Debian's copyright file has one for all files whose SPDX name is known; the names in that file are in the comment.
The same package gives the same list. Times are of SOURCE_DATE_EPOCH. Status 1: the package or a part of it is not there.
"""
import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

COMPILED_IN = ("libboost-dev", "libxxhash-dev", "nlohmann-json3-dev")
LICENCES = {"apache-2.0": "Apache-2.0", "bsd-2-clause": "BSD-2-Clause", "bsd-3-clause": "BSD-3-Clause", "bsl-1.0": "BSL-1.0",
            "expat": "MIT", "mit": "MIT", "ftl": "FTL", "zlib": "Zlib", "libpng": "Libpng", "ijg": "IJG", "lgpl-2.1": "LGPL-2.1-only",
            "lgpl-2.1+": "LGPL-2.1-or-later", "gpl-2": "GPL-2.0-only", "gpl-2+": "GPL-2.0-or-later", "gpl-3+": "GPL-3.0-or-later"}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def installed(package):
    """Version, source, home page, architecture."""
    return output("dpkg-query", "-W", "-f", "${Version}\t${source:Package}\t${Homepage}\t${Architecture}", package).split("\t")


def licences(package):
    """The one of all files in SPDX's words, and all names in Debian's copyright file."""
    path = pathlib.Path("/usr/share/doc", package.split(":")[0], "copyright")
    text = path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
    names = sorted(set(re.findall(r"^License:[ \t]*(\S.*?)\s*$", text, re.MULTILINE)))
    whole = re.search(r"^Files:[ \t]*\*[ \t]*\n(?:(?!\n\n)[\s\S])*?^License:[ \t]*(\S.*?)\s*$", text, re.MULTILINE)
    return LICENCES.get(whole.group(1).lower(), "NOASSERTION") if whole else "NOASSERTION", names


def word(package):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", package)


def part(package):
    version, source, home, architecture = installed(package)
    declared, names = licences(package)
    return {"SPDXID": word(package), "name": package, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "homepage": home or "NOASSERTION", "filesAnalyzed": False, "sourceInfo": f"Debian's source package {source}",
            "licenseDeclared": declared, "licenseConcluded": "NOASSERTION", "copyrightText": "NOASSERTION",
            "licenseComments": f"/usr/share/doc/{package}/copyright names: {', '.join(names) or 'no licence by a short name'}",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:deb/debian/{package}@{version}?arch={architecture}"}]}


def loaded(deb):
    """The packages that it depends on, the first of alternatives."""
    depends = output("dpkg-deb", "-f", deb, "Depends")
    return sorted({re.split(r"[\s(|]", one.strip())[0] for one in depends.split(",") if one.strip()})


def document(deb):
    control = dict(line.split(": ", 1) for line in output("dpkg-deb", "-f", deb, "Package", "Version").splitlines())
    name, version = control["Package"], control["Version"]
    checksum = hashlib.sha256(pathlib.Path(deb).read_bytes()).hexdigest()
    when = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), datetime.timezone.utc)
    program = {"SPDXID": word(name), "name": name, "versionInfo": version, "packageFileName": pathlib.Path(deb).name,
               "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseDeclared": "Apache-2.0",
               "licenseConcluded": "Apache-2.0", "copyrightText": "Copyright 2026 The Lentray project",
               "checksums": [{"algorithm": "SHA256", "checksumValue": checksum}]}
    related = [(package, "DYNAMIC_LINK") for package in loaded(deb)] + [(package, "STATIC_LINK") for package in COMPILED_IN]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"{name}-{version}",
            "documentNamespace": f"https://lentray.invalid/spdx/{name}-{version}-{checksum}",
            "creationInfo": {"created": when.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Organization: The Lentray project"]},
            "documentDescribes": [word(name)], "packages": [program] + [part(package) for package, _ in related],
            "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                               "relatedSpdxElement": word(name)}]
            + [{"spdxElementId": word(name), "relationshipType": how, "relatedSpdxElement": word(package)}
               for package, how in related]}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        text = json.dumps(document(sys.argv[1]), indent=1, sort_keys=True) + "\n"
    except subprocess.CalledProcessError as error:
        sys.exit(f"parts: {' '.join(error.cmd)}: {error.stderr.strip()}")
    pathlib.Path(sys.argv[2]).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
