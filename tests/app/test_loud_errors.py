# SPDX-License-Identifier: BSD-2-Clause
"""Errors of rules, scripts and files fail missions and sweeps, and are reported with their place. An interrupted test has not failed."""
import json
import pathlib
import signal
import subprocess
import xml.etree.ElementTree as xml

from mission_case import RULES, SWEEP, WORLD, MissionCase
from soarbox_command import COMMAND, Run, end_with, wait_until

GOOD = '[[check]]\nname = "off"\nagent = "scout"\nprints = "off*"\n'
# A rule that cannot be read, next to a mission that passes without it.
SPOILT = RULES + "sp {scout*spoilt\n   (state <s> ^name\n"
LOOP = RULES + """
sp {scout*a
   (state <s> ^superstate nil)
   -(<s> ^flag on)
-->
   (<s> ^flag on)
}
"""
# The script of a scenario that stops after a few ticks.
SCRIPT = """
local ticks = 0
function Sandbox_Update(sandbox, deltaTimeInMillis)
    ticks = ticks + 1;
    if ticks > 5 then
        local nothing = nil
        nothing.there = 1
    end
end
"""
SCRIPTED = 'script = "world.lua"\n' + WORLD


class LoudErrors(MissionCase):
    def test_a_rule_that_cannot_be_read_fails_a_mission_with_its_place(self):
        junit = self.folder / "out.xml"
        run = self.judge('[mission]\nseeds = "1..3"\n' + GOOD, "--junit", junit, rules=SPOILT)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, r"0 of 3 +FAILED")
        self.assertRegex(run.out, r"reported +seed 1: .*scout\.soar:\d+:\d+: error: ")
        error = xml.parse(junit).getroot().find("testsuite/testcase/error")
        self.assertRegex(error.text, r"scout\.soar:\d+:\d+: error: ")
        lines = Run("test", self.folder, "--json").of("run")
        self.assertEqual([line["passed"] for line in lines], [False] * 3)
        self.assertRegex(lines[0]["problems"][0], r"scout\.soar:\d+:\d+: error: ")

    def test_a_mission_that_asks_for_problems_judges_them_itself(self):
        asks = '[[check]]\nname = "%s"\nproblem = "%s"\nnever = true\n'
        run = self.judge(GOOD + asks % ("no warning", "warning"), rules=SPOILT)
        self.assertEqual(run.code, 0, run.out + run.err)
        run = self.judge(GOOD + asks % ("nothing", "any"), "--json", rules=SPOILT)
        self.assertEqual(run.code, 1, run.out + run.err)
        check = next(each for each in run.of("run")[0]["checks"] if each["name"] == "nothing")
        self.assertRegex(check["was"], r"it was .*scout\.soar:\d+:\d+: error: ")
        run = self.judge(GOOD + asks % ("nothing", "any"), rules=SPOILT)
        self.assertRegex(run.out, r"nothing .*it was .*scout\.soar:\d+:\d+: error: ")

    def test_a_script_that_stops_fails_a_mission_with_its_line(self):
        self.write("world.lua", SCRIPT)
        run = self.judge(GOOD + '[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\n', world=SCRIPTED)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, r"reported +seed 1: .*world\.lua:7")

    def test_a_file_that_is_missing_fails_a_mission(self):
        run = self.judge(GOOD, world=WORLD.replace("scout.soar", "absent.soar"))
        self.assertNotEqual(run.code, 0, run.out + run.err)
        self.assertIn("absent.soar", run.out + run.err)

    def test_rules_that_make_each_other_match_again_are_named_by_the_mission_that_fails(self):
        run = self.judge('[[check]]\nname = "there"\nagent = "scout"\nat = "mill"\nby = 2\n', rules=LOOP)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, r"reported +seed 1: .*scout\*a")

    def test_a_sweep_refuses_rules_that_cannot_be_read_before_the_first_run(self):
        self.mission("", rules=SPOILT)
        run = Run("sweep", self.write("sweep.toml", SWEEP), code=3)
        self.assertRegex(run.err, r"variant 'slow' has an error before its first tick\n.*scout\.soar:\d+:\d+: error: ")
        self.assertEqual([path.read_text() for path in (self.folder / "sweep.sweep" / "parts").glob("*.rows")], [])
        # After the correction, the sweep continues in the same folder.
        self.mission("")
        self.assertIn("12 runs made, 0 were there", Run("sweep", self.folder / "sweep.toml", code=0).err)

    def test_a_broken_file_of_one_variant_stops_a_sweep_that_was_under_way(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        Run("sweep", spec, code=0)
        self.write("bold.soar", SPOILT)
        more = SWEEP + '[[variant]]\nname = "bold"\nrules = { "scout" = "bold.soar" }\n'
        run = Run("sweep", self.write("sweep.toml", more), code=3)
        self.assertIn("variant 'bold' has an error before its first tick", run.err)
        self.assertRegex(run.err, r"bold\.soar:\d+:\d+: error: |scout\.soar:\d+:\d+: error: ")
        self.write("bold.soar", RULES)
        self.assertIn("6 runs made, 12 were there", Run("sweep", spec, code=0).err)

    def test_an_error_in_the_middle_of_runs_is_told_by_the_sweep(self):
        self.write("world.lua", SCRIPT)
        self.mission("", world=SCRIPTED)
        run = Run("sweep", self.write("sweep.toml", SWEEP), code=1)
        self.assertRegex(run.out, r"slow: 6 runs reported errors, and failed; seed 1:\n .*world\.lua:7")

    def test_any_of_several_is_told_of_all(self):
        other = WORLD + '[[agent]]\nname = "other"\nrules = "scout.soar"\nposition = [3, 0]\n'
        run = self.judge('[[check]]\nagent = ["scout", "other"]\nprints = "never said"\nwho = "any"\n', world=other)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, "none of scout, other did")
        self.assertNotIn("it never did", run.out)

    def test_what_is_not_there_and_times_beyond_the_end_are_refused(self):
        run = Run("test", "/nonexistent", code=5)
        self.assertIn("there is no file, folder or scenario '/nonexistent'", run.err)
        run = self.judge('[[check]]\nagent = "scout"\nat = "gate"\nby = 40\n')
        self.assertEqual(run.code, 3, run.out + run.err)
        self.assertRegex(run.err, r"scenario\.toml:\d+.*this has time until 40 s, and the run ends at 20 s")
        late = SWEEP.replace('at = "gate"', 'at = "gate"\nby = 9')
        run = Run("sweep", self.write("late.toml", late), code=3)
        self.assertRegex(run.err, r"late\.toml:\d+.*this has time until 9 s, and the run ends at 8 s")

    def test_lines_of_json_come_in_the_order_of_seeds_with_hashes_as_everywhere(self):
        kept = self.folder / "kept"
        run = self.judge('[mission]\nseeds = "1..6"\n[[check]]\nagent = "scout"\nat = "mill"\nby = 2\n', "--json", "--jobs", "2",
                         "--keep", kept)
        told = run.of("run")
        self.assertEqual([line["seed"] for line in told], [1, 2, 3, 4, 5, 6])
        for line in told:
            self.assertRegex(line["state_hash"], r"^[0-9a-f]{16}$")
            self.assertTrue(pathlib.Path(line["recording"]).exists())
            self.assertTrue(line["checks"][0]["reasons"])
        seen = json.loads(Run("export", told[0]["recording"], "--json").out.splitlines()[-1])
        self.assertEqual(seen["state"], told[0]["state_hash"])


class Interrupted(MissionCase):
    """Ctrl-C while missions run."""

    CHECK = '[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n'

    def interrupt(self, checks, *words):
        """Interrupts `soarbox test` after a few runs, and returns its code, output and report."""
        self.mission('[mission]\nseeds = "1..100000"\n' + checks)
        told = self.folder / "told"
        with open(told, "w", encoding="utf-8") as out:
            child = end_with(self, subprocess.Popen([COMMAND, "test", self.folder, "--json", "--jobs", "1", "--no-keep", *map(str, words)],
                                                    stdout=out, stderr=subprocess.PIPE, text=True))
        wait_until(lambda: told.read_text(encoding="utf-8").count("\n") >= 3, "three runs")
        child.send_signal(signal.SIGINT)
        _, err = child.communicate(timeout=240)
        return child.returncode, [json.loads(line) for line in told.read_text(encoding="utf-8").splitlines()], err

    def test_it_is_no_failure_in_json_and_junit(self):
        junit = self.folder / "out.xml"
        code, events, err = self.interrupt(self.CHECK, "--junit", junit)
        self.assertEqual(code, 130, err)
        mission = events[-1]
        self.assertTrue(mission["interrupted"])
        self.assertEqual(mission["runs"], len(events) - 1)
        suite = xml.parse(junit).getroot().find("testsuite")
        self.assertEqual((suite.get("failures"), suite.get("errors"), suite.get("skipped")), ("0", "0", "1"))
        self.assertRegex(suite.find("testcase/skipped").get("message"), r"interrupted after \d+ of 100000")

    def test_what_failed_before_is_a_failure(self):
        junit = self.folder / "out.xml"
        code, _, err = self.interrupt('[[check]]\nname = "mill"\nagent = "scout"\nat = "mill"\nby = 2\n', "--junit", junit)
        self.assertEqual(code, 130, err)
        self.assertEqual(xml.parse(junit).getroot().find("testsuite").get("failures"), "1")

    def test_text_says_interrupted(self):
        self.mission('[mission]\nseeds = "1..100000"\n' + self.CHECK)
        child = end_with(self, subprocess.Popen([COMMAND, "test", self.folder, "--jobs", "1", "--no-keep"], stdout=subprocess.PIPE,
                                                stderr=subprocess.PIPE, text=True))
        children = pathlib.Path(f"/proc/{child.pid}/task/{child.pid}/children")
        seen = set()
        wait_until(lambda: seen.update(children.read_text().split()) or len(seen) > 3, "runs")
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=240)
        self.assertEqual(child.returncode, 130, out + err)
        self.assertRegex(out, r"\d+ of \d+, interrupted after \d+ of 100000")
        self.assertNotIn("FAILED", out)
        self.assertRegex(out, r"1 mission, interrupted, ")
