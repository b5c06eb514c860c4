#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks the links of documents: relative links of Markdown files with their headings, and the source files that docs/dev/kernel.md names.

usage: check_links.py PROJECT_DIR
"""
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"`[^`\n]*`")
FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)
SOURCE_FILE = re.compile(r"(?<![\w/.])((?:[a-z_]+/)*[a-z_]+\.(?:h|cpp))\b")
SOURCE_ROOTS = (".", "src/kernel", "src/kernel/rules", "src/sml")  # Paths in kernel.md are relative to this folder.


def anchor(heading):
    """The anchor that code hosts create for a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower().replace("`", "")).replace(" ", "-")


def has_anchor(page, name):
    return name in map(anchor, HEADING.findall(FENCE.sub("", page.read_text(encoding="utf-8"))))


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    root = pathlib.Path(arguments[0]).resolve()
    found = []
    pages = [page for folder in ("docs", "tests", "bench") for page in sorted((root / folder).rglob("*.md"))]
    for page in [*sorted(root.glob("*.md")), *pages]:
        text = page.read_text(encoding="utf-8")
        for link in LINK.findall(CODE.sub("", FENCE.sub("", text))):
            target, _, heading = link.partition("#")
            place = page.parent / target if target else page
            if "://" in link:
                continue
            if not place.exists():
                found.append(f"{page.relative_to(root)}: there is no {target}")
            elif heading and place.suffix == ".md" and not has_anchor(place, heading):
                found.append(f"{page.relative_to(root)}: {target or 'this page'} has no heading #{heading}")
    kernel = root / "docs" / "dev" / "kernel.md"
    for name in sorted(set(SOURCE_FILE.findall(kernel.read_text(encoding="utf-8")))):
        if not any((root / place / name).exists() for place in SOURCE_ROOTS):
            found.append(f"docs/dev/kernel.md: there is no {name}")
    print("\n".join(found) or "all links lead somewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
