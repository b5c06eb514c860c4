# SPDX-License-Identifier: BSD-2-Clause
"""The minutes of the lessons are computed from the text to read and the lines to write: `python3 test_lesson_minutes.py` prints them."""
import pathlib
import re
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = (ROOT / "docs" / "lessons" / "README.md").read_text(encoding="utf-8")
ESTIMATED = {24, 27}  # The work of users in these lessons cannot be computed from the solution.


def rules_of(text):
    return {found[1]: found[0] for found in re.finditer(r"^sp \{(\S+).*?^\}", text, re.DOTALL | re.MULTILINE)}


def minutes(number, folder):
    """One minute for 150 words, 12 lines of an example or 15 lines of the starter; 1.2 for a line to write; 8 for the world and hints."""
    lesson = tomllib.loads((folder / "lesson.toml").read_text(encoding="utf-8"))
    page = next((ROOT / "docs" / "lessons").glob(f"{number}-*/README.md")).read_text(encoding="utf-8")
    words = len(re.findall(r"\w+", re.sub(r"```.*?```", "", page, flags=re.DOTALL))) + len((lesson["idea"] + lesson["task"]).split())
    example = sum(len(block.splitlines()) for block in re.findall(r"```(.*?)```", page, re.DOTALL))
    starter = (folder / lesson["rules"]).read_text(encoding="utf-8")
    before, after = rules_of(starter), rules_of((folder / "solution" / lesson["rules"]).read_text(encoding="utf-8"))
    written = sum(len(text.splitlines()) for name, text in after.items() if before.get(name) != text)
    return 5 * round((words / 150 + example / 12 + len(starter.splitlines()) / 15 + 1.2 * written + 8) / 5)


def lessons():
    return enumerate(sorted(path for path in (ROOT / "lessons").glob("[0-9]*")), 1)


class Minutes(unittest.TestCase):
    def test_the_list_has_the_minutes_that_are_counted(self):
        listed = {int(number): int(told) for number, told in re.findall(r"^\| (\d+) \| .* \| (\d+) \|$", LIST, re.MULTILINE)}
        self.assertEqual(set(listed), {number for number, _folder in lessons()})
        counted = {number: minutes(number, folder) for number, folder in lessons() if number not in ESTIMATED}
        self.assertEqual({number: told for number, told in listed.items() if number not in ESTIMATED}, counted)


if __name__ == "__main__":
    for each, place in lessons():
        print(each, place.name, minutes(each, place))
