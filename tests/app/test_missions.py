# SPDX-License-Identifier: BSD-2-Clause
"""Missions, sweeps, reports and lessons through the real command."""
import csv
import fcntl
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import sqlite3
import subprocess
import time
import tomllib
import unittest
import xml.etree.ElementTree as xml
from unittest import mock

from soarbox_command import COMMAND, Run, ScenarioCase

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

WORLD = """
seconds = 20
[[agent]]
name = "scout"
rules = "scout.soar"
position = [0, 0]
[[waypoint]]
name = "gate"
position = [0, -12]
[[waypoint]]
name = "mill"
position = [9, 0]
"""
RULES = """
sp {scout*propose*go
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name gate ^here no)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {scout*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint gate)
   (write |off I go| (crlf))
}
"""


class MissionCase(ScenarioCase):
    def setUp(self):
        super().setUp()
        os.environ["XDG_STATE_HOME"] = str(self.folder / "state")
        self.addCleanup(os.environ.pop, "XDG_STATE_HOME")

    def mission(self, checks, world=WORLD, rules=RULES):
        self.write("scout.soar", rules)
        return self.write("scenario.toml", world + checks)

    def judge(self, checks, *arguments, **more):
        return Run("test", self.mission(checks, **more), *arguments)


class Missions(MissionCase):
    def test_what_agents_do_passes_and_what_they_do_not_fails_with_its_reason(self):
        good = ('[[check]]\nagent = "scout"\nat = "gate"\nby = 10\n'
                '[[check]]\nagent = "scout"\noperator = "go"\nby = 1\n'
                '[[check]]\nagent = "scout"\ncommand = "move-to"\nwith = { waypoint = "gate" }\ntimes = 1\n'
                '[[check]]\nagent = "scout"\nprints = "off*"\ntimes = 1\n'
                '[[check]]\nagent = "scout"\nrule = "scout*apply*go"\ntimes = 1\n'
                '[[check]]\nagent = "scout"\nimpasse = "tie"\nnever = true\n'
                '[[check]]\nagent = "scout"\nelement = "io.input-link.waypoint.name"\nis = "gate"\nby = 1\n'
                '[[check]]\nagent = "scout"\ndecisions = { min = 1 }\n'
                '[[check]]\nagent = "scout"\ndistance = { min = 8, max = 14 }\n')
        run = self.judge(good)
        self.assertEqual(run.code, 0, run.out + run.err)
        run = self.judge(good + '[[check]]\nname = "to the mill"\nagent = "scout"\nat = "mill"\nby = 15\n')
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, r"to the mill +seed 1, 15\.0 s: scout should be at mill by 15 s; it came within [\d.]+ m, at ")
        replay = re.search(r"soarbox replay (\S+) --from (\d+) --select scout", run.out)
        self.assertTrue(replay, run.out)
        self.assertEqual(Run("verify", replay[1]).code, 0)

    def test_the_mind_is_asked_at_the_moment_of_the_failure(self):
        run = self.judge('[[check]]\nagent = "scout"\noperator = "rest"\nby = 2\n',
                         rules=RULES + "sp {scout*propose*rest (state <s> ^io.input-link.self.health < 50) --> (<s> ^operator <o> +) (<o> ^name rest)}")
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertIn("health", run.out, "the rule that would propose it stops there")

    def test_exit_codes_tell_what_is_wrong(self):
        self.assertEqual(self.judge('[[check]]\nagent = "scuot"\nat = "gate"\n').code, 3)
        refused = self.judge('[[check]]\nagent = "scout"\nat = "gtae"\n')
        self.assertEqual(refused.code, 3)
        self.assertIn("there is no waypoint 'gtae'", refused.err)
        self.assertIn("did you mean 'gate'?", refused.err)
        self.assertIn("there is no waypoint 'gtae'", Run("check", self.folder / "scenario.toml").out)
        self.mission("")
        self.assertEqual(Run("test", self.folder / "nothing").code, 5)
        (self.folder / "empty").mkdir()
        self.assertEqual(Run("test", self.folder / "empty").code, 5)
        self.assertEqual(Run("test", "--seeds", "x", self.folder).code, 2)

    def test_what_can_never_come_true_is_refused_with_its_line(self):
        for check, message in (
                ('agent = "scout"\ncommand = "move-to"\nwith = { waypont = "gate" }\n', "did you mean 'waypoint'?"),
                ('agent = "scout"\ncommand = "move-to"\nreason = "bloked"\nnever = true\n', "did you mean 'blocked'?"),
                ('agent = "scout"\nelement = "io.input-link.waypont"\n', "did you mean 'waypoint'?"),
                ('agent = "scout"\nmessage = "fire"\n', "there is no message in the rules about 'fire'"),
                ('agent = "scout"\nsees = "gatee"\n', "there is no agent or thing 'gatee'"),
                ('agent = "scout"\nat = "gate"\nwho = 2\n', "asks for 2 in one tick, and this check is about 1"),
                ('agent = "scout"\nat = "gate"\nafter = 9\nby = 3\n', "this ends before it begins"),
                ('agent = "scout"\nat = "gate"\nafter = 25\n', "the run ends at 20 s"),
                ('agent = "scout"\nat = "gate"\nfor = 9\nby = 3\n', "too little time is left"),
                ('agent = "scout"\nat = "gate"\nfor = 9\nafter = 2\nwithin = 3\n', "this cannot last for 9 s within 3 s"),
                ('agent = "scout"\nat = "gate"\nfor = 21\n', "the run ends at 20 s"),
                ('agent = "scout"\nat = "gate"\nfor = 9\nfrom = 15\n', "the run ends at 20 s"),
                ('name = "a"\nagent = "scout"\nat = "gate"\nbefore = "a"\n', "refers to itself"),
                ('agent = "scout"\ncommand = "move-to"\ntimes = 1.5\n', "'times' takes whole numbers"),
                ('agent = "scout"\ncommand = "move-to"\ntimes = { max = -1 }\n', "fewer than 0 times"),
                ('agent = "scout"\noperator = "go"\nselected_by = "luck"\n', "'selected_by' is")):
            file = self.mission("[[check]]\n" + check)
            for words in (("test", "--no-keep"), ("check",)):
                run = Run(words[0], file, *words[1:])
                told = run.out + run.err
                self.assertNotEqual(run.code, 0, check)
                self.assertIn(message, told)
                self.assertRegex(told, r"scenario\.toml:\d+", check)

    def test_names_are_looked_up_in_a_scenario_that_comes_with_the_program(self):
        """The mission names it, as `soarbox run` takes it: no folder beside the mission."""
        check = 'scenario = "soar_hallway"\n[[check]]\nagent = "%s"\nalive = true\n'
        file = self.write("far.toml", check % "nobody")
        for command in ("check", "test"):
            run = Run(command, file)
            self.assertNotEqual(run.code, 0)
            self.assertRegex(run.out + run.err, r"far\.toml:2.*there is no agent 'nobody'")
        run = Run("check", self.write("far.toml", (check % "*").replace("hallway", "halway")))
        self.assertRegex(run.out, r"far\.toml:1.*soar_halway")
        self.assertEqual(Run("check", self.write("far.toml", check % "*")).code, 0)

    def test_seen_things_and_how_operators_were_selected_can_be_asked_for(self):
        crate = '[[obstacle]]\nname = "crate"\nposition = [2, -9]\nsize = [1, 1, 1]\n'
        two = RULES.replace("(<s> ^operator <o> +)", "(<s> ^operator <o> + =)") + (
            "sp {scout*propose*rest (state <s> ^superstate nil ^io.input-link.waypoint <w>) (<w> ^name gate ^here no) --> "
            "(<s> ^operator <o> + =) (<o> ^name rest)}")
        run = self.judge(crate + '[[check]]\nagent = "scout"\nsees = "crate"\nby = 5\n'
                         '[[check]]\nagent = "scout"\noperator = ["go", "rest"]\nselected_by = "chance"\nby = 1\n'
                         '[[check]]\nagent = "scout"\noperator = "*"\nselected_by = "only"\nnever = true\n', rules=two)
        self.assertEqual(run.code, 0, run.out + run.err)
        tie = two.replace("+ =)", "+)")
        run = self.judge('[[check]]\nagent = "scout"\nimpasse = "tie"\nwith = { operator = "rest" }\nby = 1\n'
                         '[[check]]\nname = "free"\nagent = "scout"\nimpasse = "tie"\nnever = true\n', rules=tie)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertRegex(run.out, "free .*tie impasse: no preference decides among")

    def test_an_enemy_in_view_can_be_asked_for(self):
        other = '[[agent]]\nname = "other"\nrules = "scout.soar"\nposition = [0, -6]\nteam = "%s"\n'
        scout = WORLD.replace('name = "scout"\n', 'name = "scout"\nteam = "red"\n')
        check = '[[check]]\nagent = "scout"\nsees = "enemy"\nby = 5\n'
        for team, code in (("blue", 0), ("red", 1)):
            run = self.judge(other % team + check, world=scout)
            self.assertEqual(run.code, code, run.out + run.err)

    def test_results_are_told_as_json_and_to_servers(self):
        report = self.folder / "out.xml"
        run = self.judge('[mission]\nseeds = "1..3"\npass = 0\n[[check]]\nname = "a < b"\nagent = "scout"\nat = "mill"\nby = 2\n',
                         "--json", "--junit", report, "--jobs", "2")
        self.assertEqual(run.code, 0, run.err)
        self.assertEqual(sorted(event["seed"] for event in run.of("run")), [1, 2, 3])
        self.assertEqual(run.of("mission")[0]["runs_passed"], 0)
        case = xml.parse(report).getroot().find("testsuite/testcase")
        self.assertEqual(case.get("name"), "a < b")

    def test_one_job_or_two_give_the_same(self):
        self.mission('[mission]\nseeds = "1..6"\n[[check]]\nagent = "scout"\nat = "gate"\nby = 10\n')
        def told(jobs):
            run = Run("test", self.folder, "--json", "--jobs", jobs)
            return sorted((event["seed"], event["state_hash"], json.dumps(event["checks"])) for event in run.of("run"))
        self.assertEqual(told(1), told(2))

    def test_a_run_that_takes_too_long_is_told_and_the_others_are_not_lost(self):
        run = self.judge('[mission]\nseeds = "1..2"\nwall = 1\nseconds = 100000\n[[check]]\nagent = "scout"\nat = "mill"\n')
        self.assertEqual(run.code, 4, run.out + run.err)
        self.assertIn("HH", run.out)

    def test_a_run_that_crashes_costs_itself_only(self):
        self.mission('[mission]\nseeds = "1..3"\nseconds = 20\n[[check]]\nagent = "scout"\nat = "gate"\nby = 10\n'
                     '[[check]]\nagent = "scout"\nat = "mill"\nnever = true\n')
        tester = subprocess.Popen([COMMAND, "test", self.folder, "--jobs", "1", "--no-keep"], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        children = pathlib.Path(f"/proc/{tester.pid}/task/{tester.pid}/children")
        killed = False
        while tester.poll() is None and not killed:
            for child in children.read_text(encoding="utf-8").split():
                os.kill(int(child), signal.SIGSEGV)
                killed = True
        out, err = tester.communicate(timeout=240)
        self.assertTrue(killed)
        self.assertEqual(tester.returncode, 4, out + err)
        self.assertRegex(out, r"C\.\.  2 of 3")
        self.assertIn("signal 11", out)

    def test_what_cannot_be_written_is_told_and_the_results_are_printed(self):
        good = '[[check]]\nagent = "scout"\nat = "gate"\nby = 10\n'
        nowhere = self.write("file", "") / "below"
        run = self.judge(good, "--junit", nowhere / "out.xml")
        self.assertEqual(run.code, 3, run.out + run.err)
        self.assertIn("1 of 1", run.out)
        self.assertIn("out.xml", run.err)
        run = self.judge(good + '[[check]]\nagent = "scout"\nat = "mill"\nby = 2\n', "--keep", nowhere)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertIn("the recording was not kept", run.out)
        self.assertIn("it came within", run.out)
        run = Run("learn", "1", "--headless", "--folder", nowhere)
        self.assertEqual(run.code, 3, run.out)
        self.assertIn("--folder", run.err)

    def test_every_scenario_of_soar_agents_has_a_mission_that_passes_and_fails_without_rules(self):
        folders = sorted(path.parent.name for path in (REPOSITORY / "scenarios").glob("soar_*/scenario.toml"))
        for folder in folders:
            self.assertTrue((REPOSITORY / "scenarios" / folder / "mission.toml").exists(), folder)
        missions = [REPOSITORY / "scenarios" / folder / "mission.toml" for folder in folders]
        run = Run("test", *missions, "--seeds", "1", "--no-keep")
        self.assertEqual(run.code, 0, run.out + run.err)
        empty = Run("test", *missions, "--seeds", "1", "--no-keep", "--empty", "--json")
        self.assertEqual([event["mission"] for event in empty.of("mission") if event["passed"]], [])

    def test_every_other_scenario_has_a_mission_that_passes(self):
        folders = sorted(path.parent for path in (REPOSITORY / "scenarios").glob("*/Sandbox.lua"))
        missions = [folder / "mission.toml" for folder in folders if not folder.name.startswith("soar_")]
        self.assertGreater(len(missions), 8)
        run = Run("test", *missions, "--seeds", "1", "--no-keep")
        self.assertEqual(run.code, 0, run.out + run.err)

    def test_the_starter_passes_its_own_mission(self):
        self.assertEqual(Run("new", self.folder / "mine").code, 0)
        run = Run("test", self.folder / "mine", "--no-keep")
        self.assertEqual(run.code, 0, run.out + run.err)


def is_locked(file):
    """Whether another process holds the lock of this file."""
    try:
        with open(file, "r+b") as opened:
            fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except FileNotFoundError:
        pass
    return False


class Watch(MissionCase):
    def begin(self, *words):
        """Starts `soarbox test --watch`; what it prints goes into a file that can be read at any time."""
        self.log = open(self.folder / "watch.log", "w+", encoding="utf-8")
        self.addCleanup(self.log.close)
        watch = subprocess.Popen([COMMAND, "test", *map(str, words), "--watch", "--no-keep"], stdout=self.log,
                                 stderr=subprocess.STDOUT)
        self.addCleanup(watch.kill)
        return watch

    def told(self):
        return (self.folder / "watch.log").read_text(encoding="utf-8")

    def wait_for(self, text, times=1, limit_s=60):
        end = time.monotonic() + limit_s
        while self.told().count(text) < times and time.monotonic() < end:
            time.sleep(0.05)
        self.assertGreaterEqual(self.told().count(text), times, self.told())

    def wait_for_a_run(self, watch, limit_s=60):
        """Until a run of its own process has begun."""
        def children():
            tables = pathlib.Path("/proc").glob("[0-9]*/stat")
            return [table for table in tables if self.parent_in(table) == watch.pid]
        end = time.monotonic() + limit_s
        while not children() and time.monotonic() < end:
            time.sleep(0.01)
        self.assertTrue(children(), self.told())

    @staticmethod
    def parent_in(table):
        try:
            return int(table.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[1])
        except OSError:
            return 0  # It has ended meanwhile.

    def end(self, watch):
        watch.send_signal(signal.SIGINT)
        return watch.wait(60)

    def test_a_saved_file_is_tested_again_until_it_is_interrupted(self):
        checks = '[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n'
        self.mission(checks)
        watch = self.begin(self.folder)
        waiting = "waiting for a file to be saved"
        self.wait_for(waiting)
        self.assertIn("1 mission, all passed", self.told())
        # A rule that goes elsewhere fails ...
        self.write("scout.soar", RULES.replace("(<command> ^waypoint gate)", "(<command> ^waypoint mill)"))
        self.wait_for(waiting, 2)
        self.assertIn("it came within", self.told())
        # ... a scenario that cannot be read is told and does not end it ...
        self.write("scenario.toml", WORLD + checks.replace("at = ", "att = "))
        self.wait_for("none was run, 1 cannot be used")
        # ... and what was mended passes again.
        self.write("scout.soar", RULES)
        self.write("scenario.toml", WORLD + checks)
        self.wait_for("all passed", 2)
        self.wait_for(waiting, 4)
        # A mission that was not there before is tested, too.
        self.write("second.toml", 'scenario = "scenario.toml"\n' + checks)
        self.wait_for("2 missions, all passed")
        # What was saved while a round was under way may have asked for another.
        rounds = -1
        while rounds != self.told().count(waiting) or not self.told().rstrip().endswith(waiting):
            rounds = self.told().count(waiting)
            time.sleep(1)
        time.sleep(1.5)
        self.assertEqual(self.told().count(waiting), rounds, "nothing was saved: nothing is tested")
        self.assertEqual(self.end(watch), 0, self.told())
        self.assertNotIn("crashed", self.told())

    def test_what_is_saved_while_missions_run_is_not_missed(self):
        self.mission('[mission]\nseeds = "1..4"\nseconds = 1500\n[[check]]\nname = "far"\nagent = "scout"\n'
                     'distance = { min = 5000 }\n')
        watch = self.begin(self.folder, "--jobs", "1")
        self.wait_for_a_run(watch)
        self.assertNotIn("waiting", self.told(), "the first round is under way")
        self.write("scout.soar", RULES + "# saved meanwhile\n")
        self.wait_for("1 mission, 1 failed", 2, 200)
        self.assertEqual(self.end(watch), 1, self.told())

    def test_rules_in_the_folder_of_a_mission_elsewhere_are_watched(self):
        self.mission("")
        (self.folder / "missions").mkdir()
        mission = self.folder / "missions" / "go.toml"
        mission.write_text('scenario = ".."\n[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n',
                           encoding="utf-8")
        watch = self.begin(mission)
        self.wait_for("all passed")
        self.wait_for("waiting")
        self.write("scout.soar", RULES.replace("(<command> ^waypoint gate)", "(<command> ^waypoint mill)"))
        self.wait_for("1 failed")
        # Interrupted while it waits, it ends with what the last round came to.
        self.wait_for("waiting", 2)
        self.assertEqual(self.end(watch), 1, self.told())


SWEEP = """
scenario = "scenario.toml"
seeds = "1..6"
seconds = 8
[[check]]
name = "there"
agent = "scout"
at = "gate"
[[variant]]
name = "slow"
parameters = { "agent.scout.speed" = 2 }
[[variant]]
name = "fast"
parameters = { "agent.scout.speed" = 5, "agent.scout.senses.noise" = 0.5 }
[[metric]]
name = "arrival"
time_of = "there"
"""


class Sweeps(MissionCase):
    def rows(self, name="sweep.sweep"):
        with open(self.folder / name / "results.csv", newline="", encoding="utf-8") as file:
            return [{key: value for key, value in row.items() if key not in ("cpu_s", "peak_mb")} for row in csv.DictReader(file)]

    def test_seeds_times_variants_become_a_table(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        run = Run("sweep", spec)
        self.assertEqual(run.code, 0, run.out + run.err)
        rows = self.rows()
        self.assertEqual(len(rows), 12)
        self.assertEqual({row["variant"] for row in rows}, {"slow", "fast"})
        self.assertEqual({row["outcome"] for row in rows}, {"ok"})
        slow = [float(row["arrival"]) for row in rows if row["variant"] == "slow" and row["arrival"]]
        fast = [float(row["arrival"]) for row in rows if row["variant"] == "fast" and row["arrival"]]
        self.assertLess(max(fast), min(slow or [99]))
        with sqlite3.connect(self.folder / "sweep.sweep" / "results.sqlite") as database:
            told = database.execute('SELECT variant, seed, "check: there", state_hash FROM runs').fetchall()
        self.assertEqual([(row["variant"], float(row["seed"]), row["check: there"], row["state_hash"]) for row in rows], told)
        self.assertIn("on equal seeds", run.out)
        again = Run("sweep", spec)
        self.assertIn("0 runs made, 12 were there", again.err)
        replay = Run("run", self.folder / "sweep.sweep" / "variants" / "slow", "--headless", "--seed", "3", "--seconds", "8", "--json")
        self.assertEqual(replay.code, 0, replay.err)

    def test_a_folders_missions_leave_out_sweeps_and_worlds_that_join_others(self):
        self.mission('[[check]]\nagent = "scout"\nat = "gate"\n')
        self.assertEqual(Run("sweep", self.write("sweep.toml", SWEEP)).code, 0)
        own = self.folder / "scenario.toml"
        self.write("joint.toml", own.read_text() + '\n[dis]\naddress = "127.0.0.1"\nport = 3000\n')
        run = Run("test", self.folder, "--seeds", "1..2")
        self.assertNotIn("error", run.err)
        self.assertIn("joint.toml: note: left out, because it takes part in an exercise", run.err)
        self.assertIn("\n1 mission, ", "\n" + run.out)
        self.assertEqual(Run("check", self.folder / "sweep.toml").out, "0 errors, 0 warnings\n")
        wrong = self.write("wrong.toml", SWEEP.replace("seeds", "sedes"))
        self.assertIn("a sweep has no 'sedes'", Run("check", wrong).out)
        named = Run("test", self.folder / "sweep.toml")
        self.assertEqual(named.code, 3)
        self.assertIn("this is a sweep, not a mission", named.err)

    def test_what_was_killed_goes_on_and_comes_to_the_same_table(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..12"))
        for delay in (0.4, 0.8, 1.2):
            child = subprocess.Popen([COMMAND, "sweep", spec], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(delay)
            child.send_signal(signal.SIGKILL)
            child.wait()
        part = sorted((self.folder / "sweep.sweep" / "parts").glob("*.rows"))
        if part:
            with open(part[0], "a", encoding="utf-8") as file:
                file.write("0123456789abcdef {\"half a li")
        self.assertEqual(Run("sweep", spec).code, 0)
        self.assertEqual(Run("sweep", spec, "--folder", self.folder / "whole").code, 0)
        drop = lambda rows: [{key: value for key, value in row.items() if key != "tries"} for row in rows]
        self.assertEqual(drop(self.rows()), drop(self.rows("whole")))

    def test_runs_that_took_too_long_are_made_again_when_asked_for(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.split("[[variant]]")[0].replace("1..6", "1").replace("seconds = 8", "seconds = 900000\nwall = 0.3"))
        for words, told in (((), "1 runs made, 0 were there"), ((), "0 runs made, 1 were there"), (("--retry",), "1 runs made, 0 were there")):
            run = Run("sweep", spec, *words)
            self.assertIn(told, run.err)
            self.assertEqual([row["outcome"] for row in self.rows()], ["hung"])

    def test_a_sweep_may_be_named_like_its_scenario(self):
        spec = self.write("thesis.toml", 'scenario = "thesis"\nseeds = "1..2"\nseconds = 2\n')
        run = Run("sweep", spec.name, cwd=self.folder)
        self.assertEqual(run.code, 0, run.out + run.err)
        rows = self.rows("thesis.sweep")
        self.assertEqual([(row["seed"], row["outcome"]) for row in rows], [("1", "ok"), ("2", "ok")])
        self.assertGreater(float(rows[0]["decisions"]), 0)
        self.assertTrue((self.folder / "thesis.sweep" / "variants" / "default" / "Sandbox.lua").exists())
        # So may a mission; and the scenario of the program is found beside both.
        self.write("soar_hallway.toml", 'scenario = "soar_hallway"\n[[check]]\nname = "off"\nagent = "anna"\ncommand = "move-to"\nby = 5\n')
        test = Run("test", "soar_hallway.toml", "--no-keep", cwd=self.folder)
        self.assertEqual(test.code, 0, test.out + test.err)
        self.assertEqual(Run("run", "thesis", "--headless", "--seconds", "1", cwd=self.folder).code, 0)
        # A scenario of one's own of this name still comes first.
        self.write("thesis.toml", WORLD)
        self.write("scout.soar", RULES)
        self.assertIn("scout", Run("run", "thesis", "--headless", "--seconds", "1", cwd=self.folder).out)

    def test_what_is_wrong_with_a_sweep_is_told(self):
        self.mission("")
        for wrong, message in ((SWEEP.replace("agent.scout.speed", "agent.scuot.speed", 1), "there is no parameter 'agent.scuot.speed'"),
                               (SWEEP.replace("senses.noise", "senses.niose"), "niose"),
                               (SWEEP.replace('seeds = "1..6"', ""), "this sweep has no seeds"),
                               (SWEEP.replace('time_of = "there"', 'time_of = "here"'), "there is no check 'here'"),
                               (SWEEP.replace('time_of = "there"', 'max = "distance"\nagent = "scuot"'), "there is no agent 'scuot'"),
                               (SWEEP.replace('time_of = "there"', 'max = "distance"\nmean = "speed"'), "a metric is one of"),
                               (SWEEP.replace('at = "gate"', 'at = "gtae"'), "there is no waypoint 'gtae'")):
            run = Run("sweep", self.write("wrong.toml", wrong), "--folder", self.folder / "w")
            self.assertEqual(run.code, 3, run.out + run.err)
            self.assertIn(message, run.err)
            shutil.rmtree(self.folder / "w", ignore_errors=True)
        spec = self.write("sweep.toml", SWEEP)
        self.assertEqual(Run("sweep", spec).code, 0)
        other = Run("sweep", self.write("other.toml", SWEEP.replace("8", "7")), "--folder", self.folder / "sweep.sweep")
        self.assertEqual(other.code, 3)
        self.assertIn("another sweep lives in this folder", other.err)

    def test_a_full_disk_stops_it_and_what_was_made_stays(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (9000, 9000))
        full = subprocess.run([COMMAND, "sweep", spec, "--jobs", "1"], capture_output=True, text=True, timeout=240, check=False,
                              preexec_fn=little_room)
        self.assertEqual(full.returncode, 3, full.stdout + full.stderr)
        self.assertIn("rows cannot be written", full.stderr)
        self.assertIn("run the same command again when there is room", full.stderr)
        again = Run("sweep", spec)
        self.assertEqual(again.code, 0, again.out + again.err)
        self.assertRegex(again.err, r"runs made, [1-9]\d* were there")
        self.assertEqual(len(self.rows()), 12)

    def test_what_a_row_rests_on_cannot_change_under_it(self):
        self.mission("")
        bold = self.write("bold.soar", RULES)
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..2") + '[[variant]]\nname = "bold"\nrules = { "scout" = "bold.soar" }\n')
        self.assertEqual(Run("sweep", spec).code, 0)
        kept = spec.read_text(encoding="utf-8")
        # A check, a metric or the rules of a variant: the rows that are there were made with others.
        for old, new in (('at = "gate"', 'at = "gate"\nby = 3'), ('time_of = "there"', 'max = "distance"'), ("seconds = 8", "seconds = 7")):
            self.write("sweep.toml", kept.replace(old, new))
            run = Run("sweep", spec)
            self.assertEqual(run.code, 3, run.out + run.err)
            self.assertIn("another sweep lives in this folder", run.err)
        self.write("sweep.toml", "# A comment changes nothing.\n" + kept)
        bold.write_text(RULES + "# changed\n", encoding="utf-8")
        run = Run("sweep", spec)
        self.assertEqual(run.code, 3, run.out + run.err)
        self.assertRegex(run.err, r"variant '\w+' has changed since this sweep began")
        bold.write_text(RULES, encoding="utf-8")
        self.write("page.html", "a page beside it changes nothing")
        self.assertIn("0 runs made, 6 were there", Run("sweep", spec).err)

    def test_rules_of_one_name_from_two_folders_stay_apart(self):
        self.mission("", world=WORLD + '[[agent]]\nname = "other"\nrules = "scout.soar"\n')
        for folder, said in (("calm", "calm"), ("bold", "bold")):
            (self.folder / folder).mkdir()
            self.write(f"{folder}/scout.soar", RULES.replace("off I go", said))
        checks = "".join(f'[[check]]\nname = "{agent} {said}"\nagent = "{agent}"\nprints = "{said}"\n'
                         for agent, said in (("scout", "calm"), ("other", "bold")))
        spec = self.write("sweep.toml", 'scenario = "scenario.toml"\nseeds = "1..2"\nseconds = 4\n' + checks
                          + '[[variant]]\nname = "plain"\n[[variant]]\nname = "both"\n'
                          + 'rules = { "scout" = "calm/scout.soar", "other" = "bold/scout.soar" }\n')
        run = Run("sweep", spec)
        self.assertEqual(run.code, 0, run.out + run.err)
        passed = {(row["variant"], row["passed"]) for row in self.rows()}
        self.assertEqual(passed, {("plain", "0"), ("both", "1")}, run.out)

    def test_seeds_variants_and_recordings_may_be_added(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..2"))
        self.assertEqual(Run("sweep", spec).code, 0)
        more = SWEEP.replace("1..6", "1..3, 2, 12345678901") + '[[variant]]\nname = "still"\nparameters = { "agent.scout.speed" = 3 }\n'
        run = Run("sweep", self.write("sweep.toml", more))
        self.assertIn("8 runs made, 4 were there", run.err)
        self.assertEqual(sorted({row["seed"] for row in self.rows()}), ["1", "12345678901", "2", "3"])
        with sqlite3.connect(self.folder / "sweep.sweep" / "results.sqlite") as database:
            told = database.execute('SELECT DISTINCT seed FROM runs WHERE "agent.scout.speed" > 2.5 ORDER BY seed').fetchall()
        self.assertEqual(told, [(1,), (2,), (3,), (12345678901,)])
        run = Run("sweep", self.write("sweep.toml", more.replace("seconds = 8", 'seconds = 8\nrecord = "all"')))
        self.assertIn("12 runs made, 0 were there", run.err)
        self.assertEqual({pathlib.Path(row["recording"]).exists() for row in self.rows()}, {True})
        self.assertIn("0 runs made, 12 were there", Run("sweep", spec).err)

    def test_a_sweep_says_that_a_variant_has_the_numbers_of_the_first(self):
        self.mission("")
        spec = self.write("sweep.toml", 'mission = "go.toml"\n[[variant]]\nname = "a"\n[[variant]]\nname = "tough"\n'
                          'parameters = { "agent.scout.health" = 90 }\n')
        self.write("go.toml", 'scenario = "."\nseeds = "1..3"\nseconds = 8\n[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\n')
        run = Run("sweep", spec)
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertRegex(run.out, "tough(-90)? and a have the same numbers on each seed")
        self.assertNotIn("e+0", run.out)

    def test_a_folder_of_a_sweep_can_be_taken_elsewhere(self):
        self.mission("")
        rules = self.write("fast.soar", RULES)
        mission = self.write("go.toml", 'scenario = "."\nseeds = "1..3"\nseconds = 8\n[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\n')
        spec = self.write("sweep.toml", 'mission = "go.toml"\n[[variant]]\nname = "a"\n[[variant]]\nname = "b"\nrules = { "scout" = "fast.soar" }\n')
        run = Run("sweep", spec, "--folder", self.folder / "made")
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertIn("b never differs from a", run.out)
        (self.folder / "made").rename(self.folder / "taken")
        for gone in (rules, mission, spec, self.folder / "scenario.toml"):
            gone.unlink()
        page = self.folder / "page.html"
        run = Run("report", self.folder / "taken", "-o", page)
        self.assertEqual(run.code, 0, run.err)
        self.assertIn("taken: 6 runs", page.read_text(encoding="utf-8"))

    def test_a_folder_that_cannot_be_made_is_told(self):
        self.mission("")
        run = Run("sweep", self.write("sweep.toml", SWEEP), "--folder", self.write("file", "") / "below")
        self.assertEqual(run.code, 3)
        self.assertIn("name another with --folder", run.err)

    @unittest.skipIf(shutil.which("sbatch"), "Slurm is installed")
    def test_a_sweep_keeps_others_out_of_its_folder(self):
        self.mission("")
        # A run that lasts until it is ended, however fast the machine is.
        spec = self.write("sweep.toml", SWEEP.replace("seconds = 8", "seconds = 1000000"))
        first = subprocess.Popen([COMMAND, "sweep", str(spec), "--jobs", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(first.wait)
        self.addCleanup(first.kill)
        lock = spec.with_suffix(".sweep") / "lock"
        while first.poll() is None and not is_locked(lock):
            time.sleep(0.05)
        second = Run("sweep", spec)
        self.assertEqual(second.code, 3, second.out + second.err)
        self.assertIn("another sweep is making runs here", second.err)
        first.send_signal(signal.SIGINT)
        self.assertEqual(first.wait(60), 130)

    def test_a_sweep_that_goes_on_makes_no_run_twice(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..100"))
        first = subprocess.Popen([COMMAND, "sweep", str(spec), "--jobs", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(first.wait)
        self.addCleanup(first.kill)
        parts = spec.with_suffix(".sweep") / "parts"
        while first.poll() is None and not list(parts.glob("*.rows")):
            time.sleep(0.05)
        # It may have made all of them by now: then the second has nothing to do.
        first.send_signal(signal.SIGINT)
        self.assertIn(first.wait(60), (0, 130))
        self.assertEqual(Run("sweep", spec).code, 0)
        made = sum(len(part.read_text(encoding="utf-8").splitlines()) for part in parts.glob("*.rows"))
        self.assertEqual(made, 200)

    def test_without_slurm_that_is_said(self):
        self.mission("")
        with mock.patch.dict(os.environ, PATH="/nowhere"):
            run = Run("sweep", self.write("sweep.toml", SWEEP), "--on", "slurm")
        self.assertEqual(run.code, 3)
        self.assertIn("is not installed", run.err)


class Reports(MissionCase):
    def test_what_is_meant_over_seeds_is_no_failure_of_one_run(self):
        self.mission('[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n'
                     '[[check]]\nname = "now and then"\nagent = "scout"\nat = "mill"\nby = 1\npass = 0\n')
        recording, page = self.folder / "run.soarrec", self.folder / "report.html"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "12", "--record", recording).code, 0)
        self.assertEqual(Run("report", recording, "-o", page).code, 0)
        data = json.loads(re.search(r'<script type="application/json"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.S)[1])[0]
        self.assertEqual(data["verdict"], "passed: all of 1 checks")
        self.assertEqual([check["mark"] for check in data["checks"]], ["passed", "over seeds"])
        self.assertIn("not in this run; it is to be true in 0 runs", data["checks"][1]["text"])

    def test_a_page_stands_alone_and_texts_stay_texts(self):
        evil = "x</script><script>alert(1)</script>\" onload='alert(2)'"
        self.mission('[[check]]\nname = "%s"\nagent = "scout"\nat = "mill"\nby = 5\n' % evil.replace('"', '\\"'),
                     rules=RULES + 'sp {scout*say (state <s> ^superstate nil ^io.input-link.self) --> (write |<script>alert(3)</script> {{data}} {{script}}| (crlf))}')
        recording = self.folder / "run.soarrec"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "6", "--record", recording).code, 0)
        page = self.folder / "report.html"
        run = Run("report", recording, "-o", page)
        self.assertEqual(run.code, 0, run.err)
        text = page.read_text(encoding="utf-8")
        self.assertEqual(text.count("<script"), 3, "the data, the scene's and the page's own")
        self.assertEqual(text.count("</script>"), 3)
        self.assertNotRegex(text, r"(src|href)=[\"']?http")
        data = json.loads(re.search(r'<script type="application/json"[^>]*>(.*?)</script>', text, re.S)[1])[0]
        self.assertEqual(data["checks"][0]["name"], evil)
        self.assertEqual(data["checks"][0]["state"], "false")
        self.assertTrue(data["same"], "simulated again it comes to the recorded state")
        self.assertEqual(data["spans"][0][3], "go")
        fired = {rule["name"]: rule["firings"] for rule in data["agents"][0]["rules"]}
        self.assertEqual(fired["scout*apply*go"], 1)

    def test_an_hour_of_ten_busy_agents_is_at_most_10_mb(self):
        self.write("Walker.lua", """
local ticks = 0
function Agent_Initialize(agent) end
function Agent_Update(agent, deltaTimeInMillis, command)
    ticks = ticks + 1
    agent:SetTarget(Vector.new(60 * math.sin(ticks / 140), 0, 60 * math.cos(ticks / 177)))
    agent:ApplyForce(agent:ForceToPosition(agent:GetTarget()) * 50)
    if ticks % 10 == 0 then
        print("I have walked for " .. ticks .. " ticks, and there is nothing to be seen of the <gate> yet")
    end
end
""")
        self.write("teller.soar", """
sp {teller*propose*tell
   (state <s> ^superstate nil ^io.input-link.time <t>)
-->
   (<s> ^operator <o> +)
   (<o> ^name tell ^time <t>)
}
sp {teller*apply*tell
   (state <s> ^operator <o>)
   (<o> ^name tell ^time <t>)
-->
   (<s> ^told <t>)
   (write |second | <t> (crlf))
}
""")
        self.write("Sandbox.lua", """
require "SandboxUtilities"
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 4000, 4000)
    for i = 1, 9 do
        local agent = Sandbox.CreateAgent(sandbox, "Walker.lua")
        agent:SetPosition(Vector.new(4 * i, 0, 0))
    end
    Sandbox.CreateSoarAgent(sandbox, { name = "teller", rules = "teller.soar", position = Vector.new(0, 0, 10) })
end
function Sandbox_Update(sandbox, deltaTimeInMillis) end
""")
        recording, page = self.folder / "hour.soarrec", self.folder / "hour.html"
        made = subprocess.run([COMMAND, "run", self.folder, "--headless", "--seconds", "3600", "--record", recording, "--record-level",
                               "world"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=280, check=False)
        self.assertEqual(made.returncode, 0, made.stderr)
        run = Run("report", recording, "-o", page)
        self.assertEqual(run.code, 0, run.err)
        self.assertLessEqual(page.stat().st_size, 10_000_000)
        text = page.read_text(encoding="utf-8")
        data = json.loads(re.search(r'<script type="application/json"[^>]*>(.*?)</script>', text, re.S)[1])[0]
        self.assertTrue(data["same"])
        self.assertEqual(len(data["agents"]), 10)
        # What is left out could not be seen, is told, and is spread over the hour.
        told = next(line for line in data["thinned"] if "events, commands and prints" in line)
        said = int(re.search(r"Of (\d+) events", told)[1])
        self.assertGreater(said, 9 * 3600 * 3)
        self.assertGreater(said * 110, 10_000_000, "all of them would be too much")
        prints = [event for event in data["events"] if event["k"] == "print"]
        self.assertGreater(len(prints), 5000)
        for begin in range(0, 3600, 300):
            self.assertGreater(sum(begin <= event["t"] < begin + 300 for event in prints), len(prints) / 24)
        # Ways are as exact as before, to the end.
        csv_file = self.folder / "end.csv"
        self.assertEqual(Run("export", recording, "--csv", "--from", "3599.99", "-o", csv_file).code, 0)
        with open(csv_file, newline="", encoding="utf-8") as file:
            ends = {row["agent"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(data["times"]), 18001)
        for agent in data["agents"]:
            self.assertEqual(len(agent["x"]), len(data["times"]) - agent["from"])
            if agent["name"] in ends:
                self.assertGreater(agent["distance"], 100)
                self.assertAlmostEqual(sum(agent["x"]) / 100, float(ends[agent["name"]]["x_m"]), delta=0.006)
        self.assertEqual(data["agents"][9]["name"], "teller")

    def test_a_sweep_becomes_a_page(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        self.assertEqual(Run("sweep", spec).code, 0)
        page = self.folder / "sweep.html"
        self.assertEqual(Run("report", spec, "-o", page).code, 0)
        data = json.loads(re.search(r'<script type="application/json"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.S)[1])[0]
        self.assertEqual([variant["runs"] for variant in data["variants"]], [6, 6])
        self.assertEqual(len(data["rows"]), 12)

    def test_what_cannot_be_read_or_written_is_told(self):
        self.assertEqual(Run("report", self.folder / "nothing").code, 3)
        self.assertEqual(Run("report", self.folder).code, 3)
        self.mission("")
        recording = self.folder / "run.soarrec"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "1", "--record", recording).code, 0)
        run = Run("report", recording, "-o", self.write("file", "") / "page.html")
        self.assertEqual(run.code, 3)
        self.assertIn("page.html", run.err)
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        run = Run("report", recording, "-o", pipe)
        self.assertEqual(run.code, 3)
        self.assertIn("not a plain file", run.err)
        self.assertTrue(pipe.is_fifo(), "it is still what it was")

    def test_the_page_reads_nothing_as_markup(self):
        script = (REPOSITORY / "media" / "report" / "page.js").read_text(encoding="utf-8")
        for word in ("innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "Function("):
            self.assertNotIn(word, script)


class Lessons(MissionCase):
    def test_starters_fail_solutions_pass_and_wrong_answers_get_their_own_hint(self):
        self.assertEqual(len(list((REPOSITORY / "lessons").glob("*/lesson.toml"))), 13)
        told = []
        for number in range(1, 14):
            run = Run("learn", "test", number)
            self.assertEqual(run.code, 0, run.out + run.err)
            self.assertEqual(len({line.split("  ")[0] for line in run.out.splitlines()}), 1, "one lesson alone is tried")
            told += run.out.splitlines()
        self.assertEqual(sum("  solution: as it should" in line for line in told), 13)
        self.assertGreaterEqual(sum("  wrong/" in line for line in told), 80)

    def test_each_mistake_of_these_lessons_has_a_wrong_answer_that_makes_it(self):
        for name in ("04-memory", "06-danger", "07-parts", "09-support", "10-results", "13-imagine"):
            lesson = REPOSITORY / "lessons" / name
            mistakes = {each["name"] for each in tomllib.loads((lesson / "lesson.toml").read_text(encoding="utf-8"))["mistake"]}
            self.assertEqual(mistakes, {file.read_text(encoding="utf-8").strip() for file in lesson.glob("wrong/*/expects")}, name)

    def test_each_panel_of_the_window_is_introduced_by_a_lesson(self):
        page = (REPOSITORY / "docs" / "window.md").read_text(encoding="utf-8")
        table = page.split("## The panels")[1].split("\n\n")[1]
        panels = {line.split("|")[1].strip() for line in table.splitlines()[2:]}
        panels.remove("Exercise")  # Of runs that take part in one alone.
        lessons = [tomllib.loads(file.read_text(encoding="utf-8")) for file in sorted((REPOSITORY / "lessons").glob("*/lesson.toml"))]
        first = [lesson["panel"] for lesson in lessons]
        self.assertEqual(len(set(first)), 12, first)
        self.assertEqual(set(first).union(*(lesson.get("also", []) for lesson in lessons)), panels)

    def test_a_wrong_answer_that_nobody_foresaw_is_explained_from_its_run(self):
        lesson = REPOSITORY / "lessons" / "01-a-rule"
        right = (lesson / "solution" / "porter.soar").read_text(encoding="utf-8")
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        for old, new, told in (
                ("^visible yes", "^visible true", r"rule porter\*greet never fired: it requires \^.*visible true"),
                ("^visible yes", "^visibel yes", r"did you mean \^visible\?"),
                ("|Good day, | <name>", "|Good day,| <name>", 'It printed "Good day,anna"'),
                ("<name> (crlf)", "<a> (crlf)", "That is the identifier of the percept")):
            self.assertEqual(right.count(old), 1)
            (mine / "01-a-rule" / "porter.soar").write_text(right.replace(old, new), encoding="utf-8")
            run = Run("learn", "check", "1", "--folder", mine)
            self.assertEqual(run.code, 1, run.out + run.err)
            self.assertRegex(run.out, told)

    def test_what_a_learner_wrote_stays(self):
        mine = self.folder / "mine"
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        rules = mine / "01-a-rule" / "porter.soar"
        run = Run("learn", "check", "1", "--folder", mine)
        self.assertEqual(run.code, 1, run.out + run.err)
        shutil.copy(REPOSITORY / "lessons" / "01-a-rule" / "solution" / "porter.soar", rules)
        self.assertEqual(Run("learn", "1", "--headless", "--folder", mine).code, 0)
        self.assertIn("^visible yes", rules.read_text(encoding="utf-8"), "nothing is overwritten")
        run = Run("learn", "check", "1", "--folder", mine)
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertRegex(Run("learn").out, r"done   1  ")
        rules.write_text("sp {broken", encoding="utf-8")
        run = Run("learn", "check", "1", "--folder", mine)
        self.assertEqual(run.code, 1)
        self.assertIn("does not count", run.out)
        self.assertEqual(Run("learn", "reset", "1", "--folder", mine).code, 0)
        self.assertTrue((mine / "01-a-rule.2" / "porter.soar").exists())
        self.assertIn("1. ", Run("learn", "hint", "1", "--folder", mine).out)
        progress = self.folder / "state" / "soarbox" / "learn" / "progress.json"
        progress.write_text("{ damaged", encoding="utf-8")
        self.assertEqual(Run("learn").code, 0)
        self.assertTrue(progress.with_name("progress.json.damaged").exists())


if __name__ == "__main__":
    unittest.main()
