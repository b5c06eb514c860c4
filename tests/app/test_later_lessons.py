# SPDX-License-Identifier: BSD-2-Clause
"""The later lessons of the first course, through the real command. This takes as long as test_learn.py."""
import re
import shutil

from mission_case import REPOSITORY, MissionCase
from soarbox_command import Run
from test_learn import LATER, tried_as_it_should


class LaterLessons(MissionCase):
    def test_starters_fail_solutions_pass_and_wrong_answers_get_their_own_hint(self):
        numbers = [*range(LATER, 24), *range(25, 28)]
        self.assertEqual(len(list((REPOSITORY / "lessons").glob("*/lesson.toml"))), len(numbers) + LATER)  # Plus the earlier ones and lesson 24.
        tried_as_it_should(self, numbers, wrong=80)

    def test_worlds_of_ones_own_lack_what_they_are_there_to_show(self):
        tried_as_it_should(self, [24], wrong=7)


class Guide(MissionCase):
    """The course that lists lessons of other courses."""

    def test_it_has_their_lessons_in_its_order_and_tries_its_own(self):
        listed = re.findall(r"^(?:done)? +(\d+)  (.+)$", Run("learn", "guide").out, re.MULTILINE)
        self.assertEqual(len(listed), 12)
        self.assertIn(("6", "Commands and their answers"), [(number, title.split(":")[0]) for number, title in listed])
        for number in (7, 11):
            run = Run("learn", "guide", "test", number, code=0, limit_s=480)
            self.assertGreaterEqual(run.out.count("wrong/"), 5)

    def test_its_lessons_begin_and_are_graded_like_all_others(self):
        mine = self.folder / "mine"
        begun = Run("learn", "guide", "2", "--headless", "--folder", mine, code=0)
        self.assertIn("soarbox learn guide check 2", begun.out)
        shutil.copy(REPOSITORY / "lessons" / "01-a-rule" / "solution" / "porter.soar", mine / "01-a-rule" / "porter.soar")
        self.assertEqual(Run("learn", "guide", "check", "2", "--folder", mine).code, 0)
        self.assertRegex(Run("learn").out, r"done   1  ", "it counts in its own course, too")

    def test_a_course_that_lists_what_is_no_lesson_is_refused(self):
        course = self.folder / "lessons" / "mine"
        course.mkdir(parents=True)
        for text, told in (('lessons = ["1-nothing"]\n', r"course\.toml:1.*'1-nothing' is not a folder of a lesson"), ("lesson = []\n", "a course has no 'lesson'"),
                           ("lessons = [\n", r"course\.toml:\d+")):
            (course / "course.toml").write_text(text, encoding="utf-8")
            self.assertRegex(Run("learn", "--from", course, code=3).err, told)
