# SPDX-License-Identifier: BSD-2-Clause
"""Removes single letters in complete programs, and counts how many of these slips `soarbox check` reports.

The programs are the solutions of the lessons and the rules of scenarios in which `check` finds nothing. Each loses one
letter of one variable or one attribute, at positions that are drawn with a fixed seed.
"""
import pathlib
import random
import re
import shutil

from soarbox_command import Run, ScenarioCase

ROOT = pathlib.Path(__file__).resolve().parents[2]
VARIABLE = re.compile(r"<([a-z][a-z-]+)>")
ATTRIBUTE = re.compile(r"(?<=[\^.])([a-z][a-z-]{2,})")
PER_PROGRAM = 4


def programs():
    found = sorted(ROOT.glob("lessons/*/solution/*.soar")) + sorted(ROOT.glob("scenarios/soar_*/*.soar"))
    return [file for file in found if "source " not in file.read_text(encoding="utf-8")]


def beside(file):
    """The scenario and the scripts that a program belongs to."""
    folder = file.parent.parent if file.parent.name == "solution" else file.parent
    return [one for one in sorted(folder.iterdir()) if one.suffix in {".toml", ".lua"}]


def without_comments(text):
    return re.sub(r"#.*", lambda match: " " * len(match[0]), text)


def rule_at(text, place):
    begin = text.rfind("\nsp {", 0, place)
    end = text.find("\nsp {", place)
    return text[max(begin, 0):end if end > 0 else len(text)]


class PlantedSlips(ScenarioCase):
    def plant(self, folder, file, text):
        folder.mkdir(parents=True)
        for other in beside(file):
            shutil.copy(other, folder)
        (folder / file.name).write_text(text, encoding="utf-8")
        return folder / file.name

    def told(self, files):
        out = Run("check", *files).out
        return [any(line.startswith(f"{file}:") for line in out.splitlines()) for file in files]

    def found_of(self, pattern):
        sound = [self.plant(self.folder / "sound" / str(number), file, file.read_text(encoding="utf-8"))
                 for number, file in enumerate(programs())]
        files, planted = [], []
        for file, is_told in zip(programs(), self.told(sound)):
            text = file.read_text(encoding="utf-8")
            places = [] if is_told else list(pattern.finditer(without_comments(text)))
            # A separate one for each program, so that a new lesson does not change the random choices of the others.
            dice = random.Random(f"48 {file.relative_to(ROOT)}")
            # A variable that occurs once in its rule may have any name.
            places = [place for place in places if pattern is ATTRIBUTE or rule_at(text, place.start()).count(place[0]) > 1]
            for place in dice.sample(places, min(PER_PROGRAM, len(places))):
                lost = dice.randrange(place.start(1), place.end(1))
                broken = text[:lost] + text[lost + 1:]
                files.append(self.plant(self.folder / str(len(files)), file, broken))
                line = text.count("\n", 0, lost)
                planted.append(f"{file.relative_to(ROOT)}:{line + 1}: {broken.splitlines()[line].strip()}")
        self.assertGreater(len(files), 80)
        told = self.told(files)
        missed = [what for what, is_told in zip(planted, told) if not is_told]
        return sum(told) / len(told), f"{sum(told)} of {len(told)}; not found:\n" + "\n".join(missed)

    def test_a_letter_lost_in_a_variable(self):
        share, what = self.found_of(VARIABLE)
        print(f"letters lost in variables: {share:.0%}, {what}")
        self.assertGreaterEqual(share, 0.9, what)

    def test_a_letter_lost_in_an_attribute(self):
        share, what = self.found_of(ATTRIBUTE)
        print(f"letters lost in attributes: {share:.0%}, {what}")
        self.assertGreaterEqual(share, 0.75, what)
