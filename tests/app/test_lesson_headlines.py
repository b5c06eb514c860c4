# SPDX-License-Identifier: BSD-2-Clause
"""Wrong answers to lessons that nobody foresaw, and the first thing that `soarbox learn check` says of them: it has to be true.

Each was made by deleting, swapping, misspelling or misplacing something in the solution, before anybody saw what it is told."""
import pathlib
import re
import unittest

from soarbox_command import Run, ScenarioCase

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "lessons"

# Lesson, what is replaced in its solution by what, and how the headline begins.
ANSWERS = [
    (1, "^visible yes", "^visible no", r"It greeted at .* but not within 1 s when a visitor came into view"),
    (1, "(<a> ^name <name> ^visible yes)", "(<a> ^name <name>)\n  -(<a> ^visible yes)", r"It greeted at .* but not within 1 s"),
    (1, "^io.input-link.agent <a>", "^io.output-link.agent <a>",
     r"rule porter\*greet never fired: it requires \^io\.output-link\.agent <a>, but no percept is there"),
    (3, "(<gold> ^where gold)", "(<gold> ^name gold)", r"rule runner\*prefer\*gold never fired"),
    (3, "<gold> > <other>", "<other> > <gold>", r"At .* before the gold, a preference chose another place"),
    (3, "^where gold)", "^where silver)", r"At .* before the gold, a preference chose another place"),
    (4, "(<w> ^index <n> ^name <name> ^here no)", "(<w> ^index <m> ^name <name> ^here no)",
     r"At 1\.0 s watchman has nothing to do.*operator tie in S1"),
    (6, "^range < 8", "^range > 8", r"At 1\.0 s sheep has nothing to do.*operator flee has been applied"),
    (6, "^until 14", "^until far", r"sheep\.soar:28: rule sheep\*apply\*flee: \^until of flee is far"),
    (6, "^agent <name> ^until 14", "^name <name> ^until 14", r"sheep\.soar:25: .* flee has no parameter \^name"),
    (6, "^until 14", "^until 4", r"The wolf had the sheep at .*: .*Did \^danger come .* \^until 14\?"),
    (7, "(<above> ^holds soup)\n}", "(<s> ^holds soup)\n}",
     r"At 5\.4 s cook has nothing to do.*operator fetch has been applied .* and this rule change what it tests"),
    (10, "^toll > <low>", "^toll < <low>", r"The muleteer came over the stone bridge at .* which costs most"),
    (12, "(<r> ^value <n>)", "(<r> ^value 1)", r"The numbers learn, and the bee still visited the red flower"),
    (12, "= 6)", "= 0)", r"The bee never tried the (blue|white|red) flower"),
]


class Headlines(ScenarioCase):
    def headline(self, number, old, new):
        lesson = next(LESSONS.glob(f"{number:02}-*"))
        solution = next((lesson / "solution").iterdir())
        right = solution.read_text(encoding="utf-8")
        self.assertIn(old, right)
        mine = self.folder / f"{number}"
        self.assertEqual(Run("learn", number, "--headless", "--folder", mine).code, 0)
        (mine / lesson.name / solution.name).write_text(right.replace(old, new), encoding="utf-8")
        run = Run("learn", "check", number, "--headless", "--folder", mine)
        self.assertEqual(run.code, 1, run.out)
        said = re.search(r"this was seed .*\n\n(?:What this run shows of your rules:\n)?((?:.+\n)+)", run.out)
        self.assertTrue(said, f"nothing is said: {run.out}")
        return said.group(1).removeprefix("- ").replace("\n- ", " ")

    def test_the_first_thing_said_is_true(self):
        for number, old, new, wanted in ANSWERS:
            with self.subTest(number, new=new):
                self.assertRegex(self.headline(number, old, new), re.compile("^(?:" + wanted + ")", re.S))


if __name__ == "__main__":
    unittest.main()
