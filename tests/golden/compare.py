#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Compare a conformance transcript with that of Soar 9.6.3.

usage: compare.py [--verbatim] EXPECTED ACTUAL

Semantic comparison (the default) ignores what Soar leaves to the implementation:
identifier numbers, timetags, the order of attributes in a printed object, the order
of rule firings and working-memory changes within one wave, the order of preferences
of one kind, blank lines and padding, the numbers of identities in explanations (equal
identities must stay equal), the total number of identities, and the order of tests within
braces. --verbatim compares the text letter by letter. Exit status 0: same, 1: different (a diff
is printed), 2: usage.
"""
import difflib
import pathlib
import re
import sys

IDENTIFIER = re.compile(r"\b[A-Z]+[0-9]+\b")
TIMETAG = re.compile(r"\((\d+): ")
WAVE_LINE = re.compile(r"^\s*(Firing |Retracting |=>WM|<=WM|\+ |- |\(#: )|^\S.* :[IO]( |$)")
EPISODE_IDENTIFIER = re.compile(r"<id[0-9]+>")
NODE = r"(?:[A-Z]+[0-9]+(?: \(@[0-9]+\))?|@[0-9]+|<id[0-9]+>)"
OBJECT_START = re.compile(r"^\s*\(" + NODE + r" \^")
MASKED_OBJECT = re.compile(r"^(\((?:@[0-9]*(?: \(@[0-9]+\))?|<id>)) \^(.*?)( \[[-+.0-9]+\])?\)$")


def is_balanced(text):
    """Whether the parentheses outside |bars| are balanced."""
    text = re.sub(r"\|(?:[^|\\]|\\.)*\|", "", text)
    return text.count("(") <= text.count(")")


def join_objects(lines):
    """Put an object that was printed over several lines on one line."""
    joined, open_object = [], None
    for line in lines:
        if open_object is not None:
            open_object += " " + line.strip()
        elif OBJECT_START.match(line):
            open_object = line
        else:
            joined.append(line)
            continue
        if is_balanced(open_object):
            joined.append(open_object)
            open_object = None
    if open_object is not None:
        joined.append(open_object)
    return joined


IDENTITY = re.compile(r"\[(?:[0-9]+->)?([0-9]+)\]")
BOOKKEEPING = re.compile(r"^(Identities (created|joined|participating)|Identity propagations|Variables (used|in)|"
                         r"Operational constraints|Distinct identities)")
BRACES = re.compile(r"\{ ([^{}]+) \}")
COMPARISONS = ("<", ">", "<=", ">=", "<>", "<=>", "=")


def sort_tests(match):
    """Puts the tests of a conjunctive test in order: { state <s1> }, { > 0 <o2> }."""
    words, tests = match.group(1).split(), []
    while words:
        word = words.pop(0)
        if word in COMPARISONS and words:
            word += " " + words.pop(0)
        tests.append(word)
    return "{ " + " ".join(sorted(tests)) + " }"


def mask_identities(lines):
    seen = {}

    def mask(match):
        return f"[#{seen.setdefault(match.group(1), len(seen) + 1)}]"
    return [BRACES.sub(sort_tests, IDENTITY.sub(mask, line)) for line in lines]


def sort_attributes(line):
    match = MASKED_OBJECT.match(line)
    if not match:
        return line
    head, attributes, activation = match.groups()
    attributes = sorted(part.strip() for part in attributes.split(" ^"))
    return head + " ^" + " ^".join(attributes) + (activation or "") + ")"


def normalise(text):
    lines = [line.rstrip() for line in text.splitlines() if line.strip()]
    lines = join_objects(lines)
    lines = [re.sub(r"[ \t]+", " ", TIMETAG.sub("(#: ", line)).strip() for line in lines]
    lines = [sort_attributes(IDENTIFIER.sub("@", EPISODE_IDENTIFIER.sub("<id>", line))) for line in lines]
    lines = [line for line in mask_identities(lines) if not BOOKKEEPING.match(line)]
    result, wave = [], []
    for line in lines:
        if WAVE_LINE.match(line):
            wave.append(line)
            continue
        result += sorted(wave)
        wave = []
        result.append(line)
    return result + sorted(wave)


def main(arguments):
    verbatim = "--verbatim" in arguments
    paths = [a for a in arguments if not a.startswith("--")]
    if len(paths) != 2:
        print(__doc__)
        return 2
    expected, actual = (pathlib.Path(path).read_text(encoding="utf-8", errors="replace") for path in paths)
    prepare = (lambda text: text.splitlines()) if verbatim else normalise
    difference = list(difflib.unified_diff(prepare(expected), prepare(actual), paths[0], paths[1], lineterm="", n=2))
    print("\n".join(difference))
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
