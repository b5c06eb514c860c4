# SPDX-License-Identifier: BSD-2-Clause
"""What Soarbox answers to *why*, situation by situation: tests/why holds an agent for each, with what must be said.

Each situation is looked at in three ways: in the run itself, in a recording that is simulated again, and with a mind in a
kernel elsewhere. The comments of an agent say what is expected:

    # at 2                       the moment, in seconds (1 unless it says so)
    # operators: TEXT            TEXT is in this view of `soarbox inspect`, however it is looked at
    # why go: TEXT               likewise; the view may have a name behind it
    # why go: not TEXT           TEXT is not
    # recorded operators: TEXT   only in that way: live, again, elsewhere
"""
import os
import pathlib
import re
import socket
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase

SITUATIONS = pathlib.Path(__file__).resolve().parent.parent / "why"
WAYS = ("live", "again", "elsewhere")
WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
body = "soldier"
position = [0, 0]

[[waypoint]]
name = "gate"
position = [12, 0]

[[waypoint]]
name = "tower"
position = [0, 15]
"""
EXPECTED = re.compile(r"# (?:(live|again|elsewhere) )?((?:why|operators|stack|io|rule|trace|learning|longterm)\b[^:]*): "
                      r"(not )?(.*)")


class Situation:
    def __init__(self, file):
        self.name, self.rules = file.stem, file.read_text(encoding="utf-8")
        self.at, self.expected = 1.0, []
        for line in self.rules.splitlines():
            if line.startswith("# at "):
                self.at = float(line.removeprefix("# at "))
            elif match := EXPECTED.fullmatch(line):
                self.expected.append(match.groups())

    def views(self, way):
        return sorted({view for only, view, _, _ in self.expected if only in (None, way)})


class Why(ScenarioCase):
    @classmethod
    def setUpClass(cls):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            cls.port = str(free.getsockname()[1])
        cls.kernel = subprocess.Popen([COMMAND, "kernel", "--port", cls.port], stdout=subprocess.PIPE, text=True)
        cls.kernel.stdout.readline()

    @classmethod
    def tearDownClass(cls):
        cls.kernel.kill()
        cls.kernel.wait()
        cls.kernel.stdout.close()

    def look(self, situation, way, view, recording):
        source = recording if way == "again" else self.folder
        more = ["--kernel", f"127.0.0.1:{self.port}"] if way == "elsewhere" else []
        shown = Run("inspect", source, "--agent", "hero", "--at", situation.at, "--view", view, *more)
        return shown.out + shown.err

    def test_every_situation_is_answered_truly_however_it_is_looked_at(self):
        files = sorted(SITUATIONS.glob("*.soar"))
        self.assertGreater(len(files), 30)
        for file in files:
            situation = Situation(file)
            self.assertTrue(situation.expected, f"{file} expects nothing")
            self.write("hero.soar", situation.rules)
            self.write("scenario.toml", WORLD)
            recording = self.folder / (situation.name + ".soarrec")
            made = Run("run", self.folder, "--headless", "--seconds", situation.at, "--record", recording)
            self.assertIn(made.code, (0, 1), made.err)  # 1: rules that did not parse.
            for way in WAYS:
                for view in situation.views(way):
                    shown = self.look(situation, way, view, recording)
                    if "WHY_SHOW" in os.environ:
                        print(f"--- {situation.name}, {way}, {view}\n{shown}")
                        continue
                    for only, of, is_absent, text in situation.expected:
                        if of != view or only not in (None, way):
                            continue
                        with self.subTest(situation=situation.name, way=way, view=view):
                            (self.assertNotIn if is_absent else self.assertIn)(text, shown)


if __name__ == "__main__":
    unittest.main()
