# SPDX-License-Identifier: BSD-2-Clause
"""An untrusted lesson folder with each kind of request in a file: grading, hints, beginning again and running have only the
permissions of a run."""
import os

import strangers_folder
from soarbox_command import COMMAND
from strangers_folder import write
from test_stranger import requests

LESSON, RULES = "02-operators", "mower.soar"


class StrangersLesson(strangers_folder.StrangersFolder):
    def setUp(self):
        super().setUp()
        # Progress is stored in the user's own state folder, not in the opened folder.
        before = os.environ.get("XDG_STATE_HOME")
        os.environ["XDG_STATE_HOME"] = str(self.mine)
        self.addCleanup(os.environ.pop if before is None else os.environ.__setitem__, "XDG_STATE_HOME", *[before or None])

    def begin(self):
        """A folder as `soarbox learn` makes it."""
        self.lay({})
        done = strangers_folder.run([COMMAND, "learn", "2", "--headless", "--folder", self.folder], self.folder)
        self.assertEqual(done.code, 0, done.out)
        return self.folder / LESSON

    def put(self, lesson, request):
        """Puts a request into the lesson's folder: the learner's rules source the file that the hero would source."""
        (lesson / RULES).unlink()
        if callable(request):
            request(lesson)
        else:
            write(lesson, request)
        if (lesson / "hero.soar").exists():
            (lesson / "hero.soar").rename(lesson / RULES)

    def doors(self, lesson):
        return {
            "grade": ["learn", "check", "2", "--folder", self.folder],
            "hint": ["learn", "hint", "2", "--folder", self.folder],
            "list": ["learn", "--folder", self.folder],
            "run": ["run", lesson, "--headless", "--seconds", "0.3"],
            "check": ["check", lesson],
        }

    def test_every_door_of_a_lesson(self):
        for asked, request in requests(self.outside).items():
            lesson = self.begin()
            self.put(lesson, request)
            for door, arguments in self.doors(lesson).items():
                with self.subTest(door=door, asked=asked):
                    self.check(f"{door}, {asked}", [COMMAND, *arguments], codes=(0, 1, 2, 3, 4, 5))

    def test_a_lesson_writes_through_no_link(self):
        for target in (self.outside / "new", self.outside / "secret.soar", "/dev/zero", self.folder):
            lesson = self.begin()
            (lesson / RULES).unlink()
            (lesson / RULES).symlink_to(target)
            with self.subTest(target=str(target)):
                done = self.check("begin again", [COMMAND, "learn", "2", "--headless", "--folder", self.folder])
                self.assertTrue((lesson / RULES).is_symlink(), done.out)
                done = self.check("grade", [COMMAND, "learn", "check", "2", "--folder", self.folder])
                self.assertNotEqual(done.code, 0, done.out)
                if os.path.isfile(target):
                    self.assertIn("a link to a file outside the lesson's folder", done.out)

    def test_a_pipe_in_the_place_of_the_rules_is_refused(self):
        lesson = self.begin()
        (lesson / RULES).unlink()
        os.mkfifo(lesson / RULES)
        done = self.check("grade", [COMMAND, "learn", "check", "2", "--folder", self.folder])
        self.assertNotEqual(done.code, 0, done.out)
        self.assertIn(RULES, done.out)
