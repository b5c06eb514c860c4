# SPDX-License-Identifier: BSD-2-Clause
"""The panel Mission: checks that tick off in a run and in its recording, and lessons beside their scenes.

SOARBOX_PICTURES=FOLDER keeps pictures of it to look at."""
import os
import pathlib
import subprocess
import unittest

from soarbox_command import Run
from virtual_display import can_draw
from window_user import WindowUser

PICTURES = os.environ.get("SOARBOX_PICTURES")
CHECKS = """
[[check]]
name = "it sets out"
agent = "walker"
command = "seek"
by = 1

[[check]]
name = "it goes north"
agent = "walker"
at = "north"
by = 30

[[check]]
name = "the idler rests"
agent = "idler"
impasse = "tie"
never = true

[[check]]
name = "it goes east as well"
agent = "walker"
at = "east"
after = "it goes north"
within = 40
"""


def picture(name):
    return f'picture {pathlib.Path(PICTURES) / (name + ".png")}' if PICTURES else ""


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Missions(WindowUser):
    def test_checks_tick_off_and_lead_to_their_moments_live_and_recorded(self):
        with open(self.folder / "scenario.toml", "a", encoding="utf-8") as file:
            file.write(CHECKS)
        recording = self.folder / "run.soarrec"
        script = f"""
            until 0.5
            key Alt+K
            expect "of 4 checks, 1 failed"
            expect "it was tie"
            expect "walker should be at north by 30 s"
            {picture("mission-early")}
            key P
            expect "Paused"
            audit "panel Mission"
            {picture("mission")}
            click "0:00.03"
            expect "Resume here"
            expect "walker should be at north by 30 s"
            """
        self.play(script, "--speed", "4", record="--record=" + str(recording))
        self.show(recording, f"""
            key Alt+K
            expect "it goes north"
            key End
            expect "the idler rests"
            {picture("mission-replay")}
            """, size=(1920, 1080))

    def show(self, recording, script, size):
        done = subprocess.run(self.window(script, "replay", str(recording), size=size), capture_output=True, text=True,
                              timeout=280, check=False, cwd=self.folder, env=self.surroundings(size))
        self.assertEqual(done.returncode, 0, done.stderr)


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Lessons(WindowUser):
    def surroundings(self, size):
        return super().surroundings(size) | {"HOME": str(self.folder)}

    def test_a_lesson_stands_beside_its_scene_and_gives_hints(self):
        mine = self.folder / "soarbox-lessons"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        lesson = mine / "01-a-rule"
        for size in ((1280, 720), (1920, 1080)):
            self.play(f"""
                until 0.5
                expect "1. A rule fires once for each match"
                expect "Greet each visitor by name"
                expect "anna is greeted"
                audit "a lesson"
                {picture("lesson-%d" % size[0])}
                """, str(lesson), size=size)
        self.play("""
            until 0.5
            click "Hint 1 of 3"
            expect "1. Run it, select the porter"
            click "Hint 2 of 3"
            expect "2. The rule needs an element"
            """, str(lesson))

    def play(self, script, scenario, size=(1280, 720)):
        done = subprocess.run(self.window(script, "run", scenario, "--no-record", "--port", "0", size=size),
                              capture_output=True, text=True, timeout=280, check=False, cwd=self.folder,
                              env=self.surroundings(size))
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
