# SPDX-License-Identifier: BSD-2-Clause
"""The robot of docs/examples with its own world: the recording contains its picture."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMMAND = os.environ["SOARBOX"]
ROBOT = pathlib.Path(__file__).parents[2] / "docs" / "examples" / "robot" / "robot.py"


def soarbox(*arguments):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=240, check=True).stdout


class Robot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.file = pathlib.Path(cls.folder.name) / "robot.soarrec"
        subprocess.run([sys.executable, ROBOT, cls.file, "30"], check=True, timeout=240)

    def ticks(self):
        lines = map(json.loads, soarbox("export", self.file, "--json").splitlines())
        return [line for line in lines if line.get("agents")]

    def test_its_body_drives_through_the_room(self):
        places = [tick["agents"][0]["position"] for tick in self.ticks()]
        self.assertGreater(max(place[0] for place in places), 3.4)
        self.assertLess(max(place[0] for place in places), 4)
        # The y axis of the room points to the front, which is our -z.
        self.assertLess(min(place[2] for place in places), -2)
        self.assertGreater(min(place[2] for place in places), -3)

    def test_it_is_explained(self):
        why = soarbox("why", self.file, "--agent", "robot", "--at", 0.5)
        self.assertRegex(why, "drive|turn")
        rules = soarbox("inspect", self.file, "--agent", "robot", "--at", 0.5, "--view", "rules")
        self.assertIn("propose*drive", rules)

    def test_its_picture_is_drawn(self):
        pictures = pathlib.Path(self.folder.name) / "pictures"
        soarbox("replay", self.file, "--pictures", pictures, "--every", 0.5, "--plan")
        self.assertTrue(list(pictures.glob("*.png")))

    def test_it_thinks_the_same_again(self):
        soarbox("verify", self.file)
        again = self.file.with_name("again.soarrec")
        subprocess.run([sys.executable, ROBOT, again, "30"], check=True, timeout=240)
        soarbox("compare", self.file, again)

    def test_it_goes_another_way_with_another_rule(self):
        rules = self.file.with_name("other.soar")
        rules.write_text("sp {propose*drive (state <s> ^superstate nil ^io.input-link.step <n>)\n"
                         "   --> (<s> ^operator <o> + =) (<o> ^name wait ^step <n>)}\n", encoding="utf-8")
        other = self.file.with_name("other.soarrec")
        soarbox("resume", self.file, "--at", 0.3, "--rules", rules, "--agent", "robot", "--record", other)
        self.assertIn("wait", soarbox("why", other, "--agent", "robot", "--at", 0.4))

    def test_reports_and_coverage(self):
        page = self.file.with_name("robot.html")
        soarbox("report", self.file, "-o", page)
        self.assertIn("propose*drive", page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
