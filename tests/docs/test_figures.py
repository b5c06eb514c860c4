# SPDX-License-Identifier: BSD-2-Clause
"""The figures in README equal the contents of the project or its measurements. A comment with its name follows each figure: 29<!--lessons-->."""
import json
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
NOTES = (ROOT / "docs" / "dev" / "performance.md").read_text(encoding="utf-8")
MARKED = re.compile(r"([\d.,]*\d)<!--(\w+)-->")


def lessons(folder="."):
    """The number of lessons below this folder of lessons/, without solutions and wrong answers."""
    found = [path for path in (ROOT / "lessons" / folder).rglob("lesson.toml") if not {"solution", "wrong"} & set(path.parts)]
    return len(found)


def transcripts(kind):
    """Transcripts of Soar 9.6.3 that must agree; our own cases are not recorded from it."""
    minimum = json.loads((ROOT / "tests" / "golden" / "minimum.json").read_text(encoding="utf-8"))
    return sum(suite[kind] for suite in minimum.values() if isinstance(suite.get(kind), int))


def noted(pattern):
    """A figure in the laboratory notes, which ./dev bench prints."""
    return re.search(pattern, NOTES).group(1)


FIGURES = {
    "lessons": lambda: lessons(),
    "games": lambda: lessons("eaters") + lessons("tanks"),
    "transcripts": lambda: transcripts("semantic"),
    "verbatim": lambda: transcripts("verbatim"),
    "reasons": lambda: len(list((ROOT / "tests" / "why").glob("*.soar"))),
    "speed": lambda: noted(r"The geometric mean is ([\d.]+)\."),
    "agents": lambda: noted(r"Of the agents that come with Soar and its tutorial, (\d+) run on both kernels"),
    "build": lambda: noted(r"`\./dev run` spends most of its time compiling: (\d+) minutes on two idle cores"),
    "threads": lambda: noted(r"The run is the same on (\d), 2 and 4 threads"),
}


class Figures(unittest.TestCase):
    def test_each_figure_is_true(self):
        found = MARKED.findall(README)
        self.assertEqual({name for _figure, name in found}, set(FIGURES), "all that can be counted is shown, and all that is marked can be counted")
        for figure, name in found:
            self.assertEqual(figure, str(FIGURES[name]()), f"{name} in README.md")

    def test_reasons_to_use_it_have_no_figure_without_a_source(self):
        reasons = README[README.index("## Why"):README.index("## Start")]
        code = re.sub(r"^ {6}.*$", "", reasons, flags=re.MULTILINE)
        bare = re.sub(r"\]\([^)]*\)", "]", MARKED.sub("", code))
        bare = re.sub(r"Soar 9\.6(\.3)?|3D|2 or 4 threads", "", bare)
        self.assertEqual(re.findall(r"\d[\d.,]*", bare), [])

    def test_the_first_page_is_short(self):
        self.assertLessEqual(len(README.splitlines()), 120)

    def test_each_page_is_in_the_index(self):
        index = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
        for page in sorted((ROOT / "docs").glob("*.md")):
            if page.name != "README.md":
                self.assertIn(f"({page.name}", index, "docs/README.md lists every page for users")


if __name__ == "__main__":
    unittest.main()
