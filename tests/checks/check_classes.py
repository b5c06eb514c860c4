#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""No class of the source has more than fifteen public functions but those that did when this check began.

usage: check_classes.py SOURCE_DIR [--list]

Functions are counted by name: overloads once, constructors, destructors and operators not at all. The client API
(src/sml/client/sml_*.h) has the functions that Soar's has. ALLOWED says how many each of the old classes may have; a
class that has fewer now takes the smaller number in the same commit. Exit status 1 names each offence.
"""
import pathlib
import re
import sys

MOST = 15
ALLOWED = {
}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
TEXT = re.compile(r'"(?:\\.|[^"\\\n])*"')
HEAD = re.compile(r"\b(class|struct)\s+(?:\[\[[^\]]*\]\]\s*)?(?:[A-Z]+\s+)?((?:\w+::)*\w+)(?:\s+final)?\s*(?::[^:;{][^;{]*)?\{")
ACCESS = re.compile(r"(public|protected|private)\s*:(?!:)")
NAME = re.compile(r"([~\w]+)\s*\($")


def functions_of(body, name, is_public):
    """The names of the public functions in the text between a class's braces."""
    names, at, depth, statement = set(), 0, 0, ""
    while at < len(body):
        access = ACCESS.match(body, at) if depth == 0 and not statement.strip() else None
        if access:
            is_public = access[1] == "public"
            at = access.end()
            continue
        char = body[at]
        if char == "(" and depth == 0:
            found = NAME.search(statement + "(")
            declares = re.search(r"[\w>&*\]]\s+[&*]*[~\w]+\s*\($", statement + "(")
            if is_public and found and declares and found[1] != name and "operator" not in statement \
                    and not re.match(r"\s*(using|friend|typedef|enum|static_assert)\b", statement):
                names.add(found[1])
            at = end_of(body, at, "(", ")")
            # The rest of the declaration, up to its end or its body.
            while at < len(body) and body[at] not in ";{":
                at = end_of(body, at, "(", ")") if body[at] == "(" else at + 1
            at = end_of(body, at, "{", "}") if at < len(body) and body[at] == "{" else at + 1
            statement = ""
            continue
        if char == "{":
            at = end_of(body, at, "{", "}")
            statement += " "
            continue
        statement = "" if char in ";" else statement + char
        at += 1
    return names


def end_of(text, at, opening, closing):
    """Behind the bracket that closes the one at `at`."""
    depth = 0
    for place in range(at, len(text)):
        depth += (text[place] == opening) - (text[place] == closing)
        if depth == 0:
            return place + 1
    return len(text)


def classes_in(text):
    text = TEXT.sub('""', COMMENT.sub("", text))
    for head in HEAD.finditer(text):
        if re.search(r"\benum\s+$", text[:head.start()]):
            continue
        opening = head.end() - 1
        body = text[opening + 1:end_of(text, opening, "{", "}") - 1]
        name = head[2].split("::")[-1]
        yield name, len(functions_of(body, name, head[1] == "struct"))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    faults, counted = [], {}
    for header in sorted(root.glob("**/*.h")):
        file = header.relative_to(root).as_posix()
        if re.match(r"sml/client/sml_", file):
            continue
        for name, count in classes_in(header.read_text()):
            if count > MOST:
                counted[f"{file} {name}"] = count
    for key, count in counted.items():
        if key not in ALLOWED:
            faults.append(f"{key} has {count} public functions; {MOST} are enough: which second concept is in it?")
        elif count > ALLOWED[key]:
            faults.append(f"{key} has {count} public functions and had {ALLOWED[key]}: add no more")
        elif count < ALLOWED[key]:
            faults.append(f"{key} has {count} public functions, fewer than before: write {count} into ALLOWED")
    faults += [f"{key} is as small as others now: take it out of ALLOWED" for key in ALLOWED if key not in counted]
    if "--list" in sys.argv:
        for key, count in sorted(counted.items(), key=lambda item: (-item[1], item[0])):
            print(f'    "{key}": {count},')
        return 0
    print("\n".join(faults) if faults else f"{len(counted)} classes have more than {MOST} public functions, as many as are allowed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
