#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks the project's own rules for source files: size, licence line, no words that mark missing work.

usage: check_sizes.py PROJECT_DIR
"""
import pathlib
import re
import sys

MOST_LINES = 1000
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
SOURCES = {".h", ".cpp", ".lua", ".py"}


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    root = pathlib.Path(arguments[0])
    found = []
    for folder in ("src", "tests", "bench", "media", "scenarios"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SOURCES or not path.is_file() or path.name == "check_sizes.py":
                continue
            lines = path.read_text(encoding="utf-8").splitlines()
            if len(lines) > MOST_LINES:
                found.append(f"{path}: {len(lines)} lines; {MOST_LINES} is the most: which second concept lives here?")
            if path.suffix in {".h", ".cpp"} and not any("SPDX-License-Identifier" in line for line in lines[:3]):
                found.append(f"{path}:1: no SPDX-License-Identifier line")
            found += [f"{path}:{number}: unfinished: {line.strip()}" for number, line in enumerate(lines, 1) if UNFINISHED.search(line)]
    print("\n".join(found) or "all files keep the rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
