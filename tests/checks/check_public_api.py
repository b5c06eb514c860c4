#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that the client API contains no additions to Soar 9.6.3 if SOARBOX_PUBLIC_API_ONLY is defined.

usage: check_public_api.py ROOT

Each public function of Kernel, Agent and the elements of working memory must be inside such a guard, or be named in
docs/spec/sml_client_api.md. A function with a comment that it is not part of Soar's interface must be inside. The exit status
is 1 if a function violates this; each is printed.
"""
import pathlib
import re
import sys

HEADERS = ["Kernel", "Agent", "Identifier", "IntElement", "FloatElement", "StringElement", "WMElement"]
GUARD = "#ifndef SOARBOX_PUBLIC_API_ONLY"
# These functions are ours, and only our library uses them.
INSIDE = {"GetSymbol", "Name"}


def functions(text):
    """Each public function: line, name, comment above, whether it is guarded."""
    public, guarded, comment = False, False, []
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if bare == GUARD:
            guarded = True
        elif bare.startswith("#endif"):
            guarded = False
        elif bare in ("public:", "private:", "protected:"):
            public = bare == "public:"
        elif bare.startswith("class ") and bare.endswith("{"):
            public = False
        elif bare.startswith("///"):
            comment.append(bare[3:].strip())
            continue
        elif public and (match := re.search(r"(?<![~\w])([A-Z]\w+)\(", bare.split("//")[0])):
            yield number, match[1], " ".join(comment), guarded
        comment = []


def offences(root):
    spec = (root / "docs/spec/sml_client_api.md").read_text(encoding="utf-8")
    seen = 0
    for name in HEADERS:
        path = root / f"src/sml/client/sml_Client{name}.h"
        for line, function, comment, guarded in functions(path.read_text(encoding="utf-8")):
            seen += 1
            ours = "Not part of the interface of Soar" in comment
            if ours and not guarded:
                yield f"{path}:{line}: {function} is not part of Soar's interface: put it inside {GUARD}"
            if not guarded and function not in INSIDE and not re.search(rf"\b{function}\b", spec):
                yield f"{path}:{line}: {function} is not in docs/spec/sml_client_api.md: is it part of Soar's interface?"
    if seen < 100:
        yield f"only {seen} functions were found: this check no longer reads the headers"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = list(offences(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
