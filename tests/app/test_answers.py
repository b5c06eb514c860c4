# SPDX-License-Identifier: BSD-2-Clause
"""Answers that beginners might give to lessons, graded through the real command. Each was written for one
misunderstanding, before its output was known. Those with names that begin with f to j were written by authors who had
not read the hints. Later, hints were added for misunderstandings that were not named, so these are no longer blind tests.
A right answer must pass. For a wrong answer, the first sentence of `soarbox learn check` must name the misunderstanding."""
import concurrent.futures
import json
import pathlib
import re
import shutil
import tempfile
import unittest

from soarbox_command import Run

HERE = pathlib.Path(__file__).resolve().parent
LESSONS = HERE.parents[1] / "lessons"
ANSWERS = json.loads((HERE / "answers" / "answers.json").read_text(encoding="utf-8"))

# Answers with a headline that names only a part of the cause, a symptom, or something else.
HALF = {"7c-gds.soar", "f4b-operator-gone.soar", "h10-reversed-variables.soar", "h21-food-on-state.soar"}


def lesson_of(answer):
    course, _, number = answer["lesson"].rpartition(" ")
    if "-" in number:  # The name of a folder: the numbers of this course follow its course.toml.
        return [course], number, LESSONS / course / number
    folder = next((LESSONS / course).glob(f"{course[:1]}{number}-*" if course else f"{int(number):02}-*"))
    return ([course] if course else []), number, folder


def grade(answer):
    """The exit code, the output and the headline."""
    course, number, lesson = lesson_of(answer)
    with tempfile.TemporaryDirectory() as home:
        mine = pathlib.Path(home) / lesson.name
        mine.mkdir()
        for file in lesson.iterdir():
            if file.is_file() and file.name != "lesson.toml":
                shutil.copy(file, mine)
        shutil.copy(HERE / "answers" / answer["file"], mine / answer["rules"])
        run = Run("learn", *course, "check", number, "--headless", "--folder", home, code=None)
    # A rule that cannot be read is shown with its line and a note.
    headline = run.out if "error:" in run.out.split("\n", 1)[0] else run.out.split("\n\n", 1)[0]
    return run.code, run.out, headline


class Answers(unittest.TestCase):
    def test_the_headline_names_the_misunderstanding(self):
        with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
            graded = list(pool.map(grade, ANSWERS))
        named, wrong = 0, []
        for answer, (code, out, headline) in zip(ANSWERS, graded):
            with self.subTest(answer["file"]):
                self.assertEqual(code, 0 if answer["passes"] else 1, f"{answer['misunderstanding']}\n{out}")
            if answer["passes"]:
                continue
            if re.search(answer["names"], headline):
                named += 1
            elif answer["file"] not in HALF:
                wrong.append(f"{answer['file']}: {answer['misunderstanding']}\n{headline}")
        must_fail = sum(not answer["passes"] for answer in ANSWERS)
        self.assertEqual(wrong, [], "\n".join(wrong))
        self.assertGreaterEqual(named, must_fail - len(HALF), "all headlines but those of HALF name the cause")


if __name__ == "__main__":
    unittest.main()
