#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks the project's statements about licences.

usage: check_licences.py PROJECT_DIR

* Every source file names its licence (SPDX) in its first lines.
* docs/licences.md names every package that the page for browsers needs and every library that the build installs.
* If the page has been built (web/dist/page), it contains the notices of the programs in it. The programs are recognised by
  words in the bundles, independent of the list that the build has created.
"""
import json
import pathlib
import re
import subprocess
import sys

SOURCE = re.compile(r"(\.(h|cpp|py|ts|mjs|js|java|i|cmake|css|html|glsl|vert|frag)|(^|/)CMakeLists\.txt|^dev|^\.ci/run)$")
FIRST_BYTES = 400
# Words that a bundle contains only if it includes this program, and the words of its notice.
EMBEDDED = [("THREE.", "three.js authors"), ("uplot", "Leon Sorokin"), ("cm-editor", "Marijn Haverbeke")]


def without_licence(root):
    listed = subprocess.run(["git", "ls-files"], cwd=root, capture_output=True, text=True, check=False).stdout.splitlines()
    for name in listed:
        # A corpus contains unchanged inputs that once caused a failure.
        if not SOURCE.search(name) or "_corpus/" in name or name.startswith("scenarios/") or not (root / name).exists():
            continue
        if b"SPDX-License-Identifier: BSD-2-Clause" not in (root / name).read_bytes()[:FIRST_BYTES]:
            yield f"{name}: begin with SPDX-License-Identifier: BSD-2-Clause"
    if not listed:
        yield "git lists no file here"


def not_named(root):
    page = (root / "docs" / "licences.md").read_text(encoding="utf-8")
    for package in json.loads((root / "web" / "package.json").read_text(encoding="utf-8"))["dependencies"]:
        if f"`{package}`" not in page:
            yield f"docs/licences.md: the page for browsers needs `{package}`, which is not named"
    script = (root / "dev").read_text(encoding="utf-8")
    for group in ("build_packages", "window_packages"):
        packages = re.search(rf"^{group}=\((.*?)\)", script, re.MULTILINE | re.DOTALL).group(1).split()
        for package in packages:
            if (package.startswith("lib") or package.endswith("-dev") or package.startswith("fonts")) and f"`{package}`" not in page:
                yield f"docs/licences.md: ./dev installs `{package}`, which is not named"


def without_notice(folder):
    """The notices that are missing in a built page."""
    assets = folder / "assets"
    pairs = [(sorted(assets.glob("*.js")), assets / "licences.txt"),
             ([folder / "report.js", folder / "report_scene.js"], folder / "report.html")]
    for scripts, notices in pairs:
        code = "".join(script.read_text(encoding="utf-8") for script in scripts)
        said = notices.read_text(encoding="utf-8") if notices.exists() else ""
        for word, notice in [*EMBEDDED, ("", "the Soarbox authors")]:
            if word in code and notice not in said:
                yield f"{notices}: the notice \"{notice}\" is missing; the page contains code of that program"
        if "Permission is hereby granted" not in said:
            yield f"{notices}: the text of the MIT licence is missing"


def main(arguments):
    if len(arguments) != 1:
        print(__doc__)
        return 2
    root = pathlib.Path(arguments[0]).resolve()
    found = [*without_licence(root), *not_named(root)]
    built = root / "web" / "dist" / "page"
    if (built / "index.html").exists():
        found += without_notice(built)
    print("\n".join(found) or "all licences are named")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
