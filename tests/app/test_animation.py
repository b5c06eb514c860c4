# SPDX-License-Identifier: BSD-2-Clause
"""The scenario with all movements: every soldier moves, the patrols walk in circles, and all runs are equal."""
import unittest

from soarbox_command import run_json


class Animation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.first = run_json("animation", "--seconds", 20, "--report", 1, "--seed", 5)

    def positions(self, name):
        return [agent["position"] for state in self.first.of("state") for agent in state["agents"]
                if agent["name"] == name]

    def test_nothing_goes_wrong(self):
        self.assertEqual(self.first.code, 0, self.first.err)
        self.assertEqual(self.first.diagnostics(), [])

    def test_the_patrols_walk_and_run(self):
        names = {agent["name"] for state in self.first.of("state") for agent in state["agents"]}
        self.assertEqual(len(names), 2)
        ways = []
        for name in sorted(names):
            places = self.positions(name)
            ways.append(sum(((a[0] - b[0]) ** 2 + (a[2] - b[2]) ** 2) ** 0.5 for a, b in zip(places, places[1:])))
        self.assertGreater(ways[0], 15)
        self.assertGreater(ways[1], 1.5 * ways[0])

    def test_the_state_with_all_movements_is_the_same_in_every_run(self):
        again = run_json("animation", "--seconds", 20, "--report", 1, "--seed", 5)
        self.assertEqual(self.first.of("end")[0]["state"], again.of("end")[0]["state"])
