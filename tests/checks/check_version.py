#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that all files have the same version of the project as CMakeLists.txt.

usage: check_version.py PROJECT_DIR
"""
import pathlib
import re
import sys

NUMBER = r"(\d+\.\d+\.\d+)"
PLACES = [
    ("web/package.json", rf'^  "version": "{NUMBER}"'),
    ("web/package-lock.json", rf'^  "version": "{NUMBER}"'),
    ("editors/vscode/package.json", rf'^  "version": "{NUMBER}"'),
    ("editors/vscode/package-lock.json", rf'^  "version": "{NUMBER}"'),
    ("packaging/npm/package.json", rf'^  "version": "{NUMBER}"'),
    ("CITATION.cff", rf"^version: {NUMBER}$"),
    ("CHANGELOG.md", rf"^## {NUMBER}"),
    ("packaging/debian/changelog", rf"^soarbox \({NUMBER}-"),
    ("README.md", rf"\bVersion {NUMBER}"),
]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    root = pathlib.Path(arguments[0]).resolve()
    version = re.search(rf"project\(Soarbox VERSION {NUMBER}", (root / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
    found = []
    for name, pattern in PLACES:
        stated = re.search(pattern, (root / name).read_text(encoding="utf-8"), re.MULTILINE)
        if stated is None:
            found.append(f"{name}: it states no version; CMakeLists.txt says {version}")
        elif stated.group(1) != version:
            found.append(f"{name}: it states {stated.group(1)}; CMakeLists.txt says {version}")
    print("\n".join(found) or f"the version is {version} everywhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
