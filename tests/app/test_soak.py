# SPDX-License-Identifier: BSD-2-Clause
"""The short form of soak.py, for every submission: the first scenario of the README, a crowd and a fight run in a window at
full speed until the panels are full, and their recordings are replayed. Memory and the number of drawn corners must not
grow. Only `./dev soak` compares times, because they depend on the load of the machine."""
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
