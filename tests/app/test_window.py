# SPDX-License-Identifier: BSD-2-Clause
"""The window shows the thesis' world: sky, ground, agents, debug lines and the scripts' text panel."""
import subprocess
import unittest

from png_picture import Picture
from soarbox_command import COMMAND, new_folder
from virtual_display import can_draw, environment

WIDTH, HEIGHT = 1280, 720


def is_far(r, g, b):
    """Whether a pixel shows the sky or distant hills in the haze."""
    return b > 110 and max(r, g, b) - min(r, g, b) < 70


def is_ground(r, g, b):
    return r > b + 15 and 90 < r < 220 and abs(r - g) < 40


def is_follower(r, g, b):
    return b > 110 and b > 2 * r and b > g + 20


def is_leader(r, g, b):
    return r > 170 and 90 < g < 200 and b < 70


def is_green_line(r, g, b):
    return g > 220 and r < 90 and b < 90


def is_text(r, g, b):
    return min(r, g, b) > 200


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Window(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        path = new_folder(cls) / "picture.png"
        # Soon after the beginning all agents are still in the picture, because the first view shows all of them.
        cls.done = subprocess.run(
            [COMMAND, "run", "thesis", "--screenshot", str(path), "--at", "2"],
            capture_output=True, text=True, timeout=240, check=False, env=environment(WIDTH, HEIGHT))
        cls.picture = Picture(path) if path.exists() else None

    def setUp(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertIsNotNone(self.picture)

    def test_picture_has_the_size_asked_for(self):
        self.assertEqual((self.picture.width, self.picture.height), (WIDTH, HEIGHT))

    def test_the_horizon_is_above_and_ground_below(self):
        far = self.picture.count(is_far, (0, 30, WIDTH, 54), step=4)
        self.assertGreater(far, 0.7 * (WIDTH // 4) * (24 // 4))
        self.assertLess(self.picture.count(is_far, (0, 560, 900, HEIGHT), step=4), 0.1 * (900 // 4) * (160 // 4))
        ground = self.picture.count(is_ground, (0, 560, 900, HEIGHT), step=4)
        self.assertGreater(ground, 0.7 * (900 // 4) * (160 // 4))

    def test_agents_of_both_kinds_are_there(self):
        scene = (0, 150, WIDTH, 480)
        self.assertGreater(self.picture.count(is_follower, scene), 1000)
        self.assertGreater(self.picture.count(is_leader, scene), 200)

    def test_debug_lines_are_there(self):
        self.assertGreater(self.picture.count(is_green_line), 300)

    def test_help_panel_holds_text(self):
        self.assertGreater(self.picture.count(is_text, (940, 495, 1260, 685)), 400)
