# SPDX-License-Identifier: BSD-2-Clause
"""The panel Mission: checks in a run and in its recording, and lessons next to their scenes.

SOARBOX_PICTURES=FOLDER stores screenshots there."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from soarbox_command import Run, wait_until
from virtual_display import can_draw
from window_user import WindowUser

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "lessons"
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
            key Alt+K
            expect "it was tie"
            {picture("mission-early")}
            until 4
            key P
            expect "Paused"
            expect "2 of 4 checks, 1 failed"
            expect-not "walker should be at north by 30 s"
            audit "panel Mission"
            {picture("mission")}
            click "0:00.03"
            expect "Resume here"
            expect "1 of 4 checks, 1 failed"
            expect "walker should be at north by 30 s"
            """
        self.play(script, record="--record=" + str(recording))
        self.show(recording, f"""
            key Alt+K
            expect "it goes north"
            key End
            expect "of 4 checks, 1 failed"
            expect "the idler rests"
            {picture("mission-replay")}
            """, size=(1920, 1080))

    def test_a_recording_counts_its_checks_and_a_click_on_one_goes_to_its_moment(self):
        with open(self.folder / "scenario.toml", "a", encoding="utf-8") as file:
            file.write(CHECKS)
        recording = self.folder / "run.soarrec"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "10", "--record", recording).code, 0)
        kept = self.folder / "kept"
        Run("test", self.folder, "--keep", kept, code=1)
        # `soarbox test` keeps the recordings that its output names.
        for file in (recording, next(kept.glob("*.soarrec"))):
            told = Run("replay", file, "--headless").out
            north = re.findall(r"([0-9.]+) s  tick (\d+)", told[:told.index("news check it goes north true")])[-1]
            tick, clock = north[1], f"0:{float(north[0]):05.2f}"
            self.show(file, f"""
                key P
                key Alt+K
                key End
                expect "2 of 4 checks, "
                expect "it was tie"
                click "{clock}"
                expect "tick {tick}"
                expect "2 of 4 checks, 1 failed"
                click "0:00.03"
                expect "tick 1"
                expect "1 of 4 checks, 1 failed"
                expect "walker should be at north by 30 s"
                audit "panel Mission of a recording"
                {picture("mission-" + file.stem)}
                """, size=(1280, 720))

    def show(self, recording, script, size):
        self.played(script, "replay", str(recording), size=size)


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
                expect "visitor by name"
                expect "anna is greeted"
                audit "a lesson"
                {picture("lesson-%d" % size[0])}
                """, str(lesson), size=size)
        self.play("""
            until 0.5
            click "Hint 1 of 3"
            expect "1. Run the lesson, select the porter"
            click "Hint 2 of 3"
            expect "2. The rule needs an element"
            """, str(lesson))

    def learn(self, script, *words, while_open=lambda window: None):
        """Begins a lesson as a learner does, in a window that a user plays."""
        window = subprocess.Popen(self.window(script, "learn", *map(str, words), "--no-record", "--port", "0"), text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=self.folder,
                                  env=self.surroundings((1280, 720)))
        try:
            while_open(window)
            out, _ = window.communicate(timeout=280)
        finally:
            window.kill()
        self.assertEqual(window.returncode, 0, out)

    def test_a_lesson_fails_is_mended_graded_again_and_leads_to_the_next(self):
        rules = self.folder / "soarbox-lessons" / "01-a-rule" / "porter.soar"
        failed = self.folder / "failed.png"

        def mend(window):
            wait_until(lambda: window.poll() is not None or failed.exists(), limit_s=280)
            self.assertIn("Somebody is there", rules.read_text(encoding="utf-8"), "the starter")
            shutil.copy(LESSONS / "01-a-rule" / "solution" / "porter.soar", rules)

        self.learn(f"""
            expect "1. A rule fires once for each match"
            expect-not "You have passed this lesson."
            click "Grade"
            expect "before the name." 200
            expect "anna is greeted"
            expect "it never did"
            audit "a lesson that failed"
            picture {failed}
            wait 400
            click "Begin again"
            expect "before the name."
            expect "Mission 1/4" 60
            click "Grade"
            expect-not "before the name."
            expect "Passed with all of 10" 200
            expect "You have passed this lesson."
            audit "a lesson that is done"
            {picture("lesson-done")}
            click "Next lesson"
            expect "2. Operators: propose, select," 30
            expect "Make the mowing robot mow"
            expect "Grade"
            expect "of 5 checks"
            expect-not "You have passed this lesson."
            {picture("lesson-next")}
            """, 1, while_open=mend)
        progress = json.loads((self.home / "state" / "soarbox" / "learn" / "progress.json").read_text(encoding="utf-8"))
        self.assertEqual(progress["01-a-rule"], {"attempts": 2, "passed": 1})
        self.assertTrue((self.folder / "soarbox-lessons" / "02-operators" / "mower.soar").exists())
        self.assertIn("^visible yes", rules.read_text(encoding="utf-8"), "what the learner wrote stays")
        # It is stored, and the next lesson is opened.
        self.learn("""
            expect "2. Operators: propose, select,"
            """, "next")
        self.learn("""
            expect "1. A rule fires once for each match"
            expect "You have passed this lesson."
            """, 1)

    def test_the_next_lesson_of_a_teacher_is_the_teachers(self):
        course = self.folder / "course"
        for name, lesson in (("a-porter", "01-a-rule"), ("b-mower", "02-operators")):
            shutil.copytree(LESSONS / lesson, course / name)
        self.learn("""
            expect "1. A rule fires once for each match"
            click "Next lesson"
            expect "2. Operators: propose, select," 30
            expect "of 5 checks"
            """, 1, "--from", course)
        self.assertTrue((self.folder / "soarbox-lessons" / "b-mower" / "mower.soar").exists())

    def play(self, script, scenario, size=(1280, 720)):
        self.played(script, "run", scenario, "--no-record", "--port", "0", size=size)
