#!/usr/bin/env python3
"""Every page of the docs: its links lead somewhere, and its first paragraph names a reader and a question.

    pages.py

The exit status is 1 if a page has a fault.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WITHOUT_QUESTION = {"scenes.md"}  # lentray-batch writes it


def anchors(page):
    heads = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def faults(page):
    text = page.read_text(encoding="utf-8")
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        name, _, part = target.partition("#")
        file = page.parent / name if name else page
        if "://" in target:
            continue
        if not file.exists():
            yield f"there is no {name}"
        elif part and file.suffix == ".md" and part not in anchors(file):
            yield f"{name or page.name} has no part #{part}"
    if page.parent == ROOT or page.name in WITHOUT_QUESTION:
        return
    first = text.split("\n\n")[1]
    if not first.startswith("For ") or "?" not in first:
        yield "the first paragraph names no reader and question"


def main():
    pages = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted(ROOT.glob("docs/**/*.md"))]
    found = [f"{page.relative_to(ROOT)}: {fault}" for page in pages for fault in faults(page)]
    print("\n".join(found) or f"{len(pages)} pages are good")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
