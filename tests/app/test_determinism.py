# SPDX-License-Identifier: BSD-2-Clause
"""One seed, one run."""
import unittest

from soarbox_command import Run


def run(seed, *more):
    return Run("run", "thesis/mixed.lua", "--headless", "--json", "--every-command", "--report", 1, "--seconds", 30, "--seed", seed, *more)


class Determinism(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.first = run(3)

    def test_one_seed_prints_the_same_twice(self):
        self.assertEqual(self.first.code, 0, self.first.err)
        self.assertGreater(len(self.first.events), 1000)
        self.assertEqual(self.first.out, run(3).out)

    def test_two_seeds_differ(self):
        other = run(4)
        self.assertNotEqual(self.first.of("end")[0]["state"], other.of("end")[0]["state"])

    def test_the_number_of_threads_changes_nothing(self):
        for threads in (1, 2, 4):
            self.assertEqual(self.first.out, run(3, "--threads", threads).out)

    def test_the_speed_asked_for_changes_nothing(self):
        self.assertEqual(self.first.out, run(3, "--speed", 1000).out)
