# SPDX-License-Identifier: BSD-2-Clause
"""The answers to *why* in many situations. tests/why contains an agent for each situation, with the expected sentences.

Each situation is inspected in four ways: in the run itself (live), in a recording that is simulated again (again), from
the recorded data alone (recorded), and with a mind in a kernel in another process (elsewhere). Comments in the file of an
agent contain the expectations:

    # at 2                       the moment, in seconds (default: 1)
    # operators: TEXT            this view of `soarbox inspect` contains TEXT, in all four ways
    # why go: TEXT               the same for a view with an argument
    # why go: not TEXT           the view does not contain TEXT
    # recorded operators: TEXT   only in this way: live, again, recorded or elsewhere
    # asked why: TEXT            only in the three ways in which there is a mind: live, again, elsewhere
"""
import os
import pathlib
import re

from soarbox_command import Run, ScenarioCase, end, start_kernel

SITUATIONS = pathlib.Path(__file__).resolve().parent.parent / "why"
WAYS = ("live", "again", "recorded", "elsewhere")
ASKED = ("live", "again", "elsewhere")
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
FIGHT = """
[[agent]]
name = "victim"
rules = "hero.soar"
body = "soldier"
position = [0, 10]

[[agent]]
name = "rival"
rules = "rival.soar"
body = "soldier"
team = "red"
position = [0, 0]
"""
RIVAL = """
sp {rival*propose*shoot
   (state <s> ^superstate nil ^io.input-link.self -^shot yes)
-->
   (<s> ^operator <o> +)
   (<o> ^name shoot)
}
sp {rival*apply*shoot
   (state <s> ^operator.name shoot ^io.output-link <out>)
-->
   (<out> ^shoot <c>)
   (<c> ^agent victim ^rounds 20)
   (<s> ^shot yes)
}
"""
EXPECTED = re.compile(r"# (?:(live|again|recorded|elsewhere|asked) )?"
                      r"((?:why|operators|stack|io|rule|trace|learning|longterm)\b[^:]*): (not )?(.*)")


class Situation:
    def __init__(self, file):
        self.name, self.rules = file.stem, file.read_text(encoding="utf-8")
        self.at, self.expected = 1.0, []
        for line in self.rules.splitlines():
            if line.startswith("# at "):
                self.at = float(line.removeprefix("# at "))
            elif match := EXPECTED.fullmatch(line):
                self.expected.append(match.groups())

    def of(self, way):
        """The expectations in comments of this form: view, whether the text must be absent, text."""
        return [rest for only, *rest in self.expected
                if only in (None, way) or only == "asked" and way in ASKED]

    def views(self, way):
        return sorted({view for view, _, _ in self.of(way)})


class Why(ScenarioCase):
    @classmethod
    def setUpClass(cls):
        kernel, port = start_kernel()
        cls.port = str(port)
        cls.addClassCleanup(end, kernel)

    def look(self, situation, way, view, recording):
        source = recording if way in ("again", "recorded") else self.folder
        more = {"recorded": ["--recorded"], "elsewhere": ["--kernel", f"127.0.0.1:{self.port}"]}.get(way, [])
        shown = Run("inspect", source, "--agent", "hero", "--at", situation.at, "--view", view, *more)
        return shown.out + shown.err

    def test_every_situation_is_answered_truly_however_it_is_looked_at(self):
        files = sorted(SITUATIONS.glob("*.soar"))
        self.assertGreater(len(files), 30)
        for file in files:
            situation = Situation(file)
            for way in WAYS:
                self.assertTrue(situation.of(way), f"{file} expects nothing {way}")
            self.write("hero.soar", situation.rules)
            self.write("scenario.toml", WORLD)
            recording = self.folder / (situation.name + ".soarrec")
            made = Run("run", self.folder, "--headless", "--seconds", situation.at, "--record", recording)
            self.assertIn(made.code, (0, 1), made.err)  # Exit code 1: some rules did not parse.
            for way in WAYS:
                for view in situation.views(way):
                    shown = self.look(situation, way, view, recording)
                    if "WHY_SHOW" in os.environ:
                        print(f"--- {situation.name}, {way}, {view}\n{shown}")
                        continue
                    for of, is_absent, text in situation.of(way):
                        if of != view:
                            continue
                        with self.subTest(situation=situation.name, way=way, view=view):
                            (self.assertNotIn if is_absent else self.assertIn)(text, shown)

    def test_a_dead_agent_is_told_how_it_died_and_what_its_last_command_rested_on(self):
        walk = (SITUATIONS / "41-command-outlives-its-operator.soar").read_text(encoding="utf-8")
        self.write("hero.soar", walk.replace("hero*", "victim*").replace("^waypoint gate", "^x 40 ^z 10"))
        self.write("rival.soar", RIVAL)
        self.write("scenario.toml", FIGHT)
        recording = self.folder / "fight.soarrec"
        Run("run", self.folder, "--headless", "--seconds", 20, "--record", recording, code=0)
        for source in (self.folder, recording):
            told = Run("why", source, "--agent", "victim", "--at", 20, code=0).out
            self.assertRegex(told, r"^victim at 20\.00 s\ndied at \d+\.\d\d s: shot by rival\n")
            self.assertIn("command move-to", told)
            self.assertIn(": move-to failed: dead: ", told)
            self.assertIn("given by rule victim*apply*go at 0.03 s (decision 1), which applied operator go (O1)", told)
            self.assertNotIn("nothing is under way", told)
