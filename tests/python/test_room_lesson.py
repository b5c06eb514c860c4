# SPDX-License-Identifier: BSD-2-Clause
"""The second half of lesson 27: the output of check.py for the starter, a right answer, and wrong ones."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

LESSON = pathlib.Path(__file__).resolve().parents[2] / "docs" / "lessons" / "27-other-programs"
RIGHT = (LESSON / "answers" / "right.py").read_text(encoding="utf-8")
# The mistake, the edit that makes it, and the first requirement that fails.
WRONG = [
    ("a new element in each minute", ('agent.Update(felt, temperature)', 'agent.CreateFloatWME(link, "temperature", temperature)'),
     "the mind perceives one temperature"),
    ("the temperature of the beginning", ("        agent.Update(felt, temperature)\n", ""), "it is the temperature of now"),
    ("true and false", ('"yes" if heating else "no")', '"true" if heating else "false")'), "the mind perceives whether the heater is on"),
    ("no command is looked at", ("agent.GetNumberCommands()", "0"), "it never gets colder than 18.5 degrees"),
    ("any command switches on", ('heating = to == "on"', "heating = True"), "it never gets warmer than 21.5 degrees"),
    ("no answer", ("                command.AddStatusComplete()\n", ""), "commands are answered"),
]


class Room(unittest.TestCase):
    def grade(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "room.py"
            file.write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, LESSON / "check.py", file], capture_output=True, text=True, timeout=120, check=False)
            self.assertEqual(done.stderr, "")
            return done.returncode, done.stdout

    def test_the_starter_fails_and_a_right_answer_passes(self):
        code, told = self.grade((LESSON / "room.py").read_text(encoding="utf-8"))
        self.assertEqual(code, 1, told)
        self.assertIn("CreateFloatWME", told.splitlines()[1])
        self.assertEqual(self.grade(RIGHT)[0], 0)

    def test_each_wrong_answer_fails_at_its_point_with_a_hint(self):
        for name, (old, new), point in WRONG:
            with self.subTest(name):
                self.assertEqual(RIGHT.count(old), 1)
                code, told = self.grade(RIGHT.replace(old, new))
                self.assertEqual(code, 1, told)
                first = next(i for i, line in enumerate(told.splitlines()) if line.startswith("no   "))
                self.assertEqual(told.splitlines()[first], "no   " + point, told)
                self.assertTrue(told.splitlines()[first + 1].startswith("     "), told)


if __name__ == "__main__":
    unittest.main()
