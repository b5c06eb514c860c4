# SPDX-License-Identifier: BSD-2-Clause
"""The short form of soak.py, for every submission: the first scenario of the README, a crowd and a fight in a window at full
speed, past the time in which the panels fill, and their recordings replayed. Memory and what is drawn must not grow; times,
which depend on what else the machine does, are compared by `./dev soak` alone."""
import pathlib
import tempfile
import unittest

import soak
from virtual_display import can_draw


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Soak(unittest.TestCase):
    def check(self, name, seconds):
        with tempfile.TemporaryDirectory() as folder:
            complaints, figures = soak.soak(name, seconds, pathlib.Path(folder), timed=False)
        print(name, figures)
        self.assertEqual(complaints, [])

    def test_the_first_command_of_the_readme(self):
        self.check("thesis", 120)

    def test_a_crowd(self):
        self.check("crowd", 60)

    def test_a_fight(self):
        self.check("soar_skirmish", 60)
