# SPDX-License-Identifier: BSD-2-Clause
"""The later lessons of the first course, through the real command. They take as long as all that test_learn.py tests."""
from mission_case import REPOSITORY, MissionCase
from test_learn import LATER, tried_as_it_should


class LaterLessons(MissionCase):
    def test_starters_fail_solutions_pass_and_wrong_answers_get_their_own_hint(self):
        numbers = [*range(LATER, 24), *range(25, 28)]
        self.assertEqual(len(list((REPOSITORY / "lessons").glob("*/lesson.toml"))), len(numbers) + LATER)  # Those before, and the world of one's own.
        tried_as_it_should(self, numbers, wrong=80)

    def test_worlds_of_ones_own_lack_what_they_are_there_to_show(self):
        tried_as_it_should(self, [24], wrong=7)
