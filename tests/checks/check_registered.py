#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that every test is run: the build files of its folder or of a parent folder name each *_test.cpp and test_*.py.

usage: check_registered.py ROOT
"""
import pathlib
import re
import subprocess
import sys


def build_texts(root, folder):
    """The build files from a folder up to the root."""
    while True:
        for name in ("CMakeLists.txt", "sources.cmake"):
            if (folder / name).exists():
                yield (folder / name).read_text()
        if folder == root:
            return
        folder = folder.parent


def is_named(root, file):
    words = [re.escape(file.stem)]
    if file.suffix == ".py":
        words.append(re.escape(file.stem.removeprefix("test_")))
    for text in build_texts(root, file.parent):
        loops = [re.escape(file.stem.removesuffix("_test"))] if "${name}_test.cpp" in text else []
        if any(re.search(rf"(?<![\w.]){word}\b", text) for word in words + loops):
            return True
    return False


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    listed = subprocess.run(["git", "ls-files", "src", "tests", "bench"], cwd=root, capture_output=True, text=True, check=False)
    names = listed.stdout.splitlines() or [str(path.relative_to(root)) for path in root.glob("[stb]*/**/*")]
    tests = [root / name for name in names if re.search(r"(_test\.cpp|(^|/)test_[^/]*\.py)$", name)]
    if not tests:
        print("check_registered: no test was found", file=sys.stderr)
        return 1
    missing = [test for test in tests if test.exists() and not is_named(root, test)]
    for test in missing:
        print(f"{test.relative_to(root)}: no CMakeLists.txt runs this test; register it beside its neighbours")
    print(f"{len(tests)} tests looked at, {len(missing)} missing")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
