# SPDX-License-Identifier: BSD-2-Clause
"""Missions through the real command."""
import json
import os
import pathlib
import re
import signal
import subprocess
import time
import xml.etree.ElementTree as xml

from mission_case import REPOSITORY, RULES, WORLD, MissionCase
from soarbox_command import COMMAND, Run, wait_until


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

    def test_a_mission_that_failed_begins_with_the_cause(self):
        check = '[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n'
        wrong = RULES.replace("^name gate ^here no", "^name gaet ^here no")
        run = self.judge(check, rules=wrong)
        self.assertEqual(run.code, 1, run.out + run.err)
        lines = run.out.splitlines()
        self.assertIn("FAILED", lines[0])
        self.assertRegex(lines[1], r"^  scout\.soar:4: rule scout\*propose\*go names the waypoint gaet, which the scenario does not have; did you mean gate\?$")
        self.assertRegex(lines[2], r"^  there +seed 1")
        done = self.judge(check, "--json", rules=wrong)
        ended = [json.loads(line) for line in done.out.splitlines() if '"event":"mission"' in line.replace(" ", "")]
        self.assertIn("rule scout*propose*go names the waypoint gaet", ended[0]["cause"])
        self.assertNotIn("cause", self.judge(check, "--json").out)

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
        """The mission names a scenario by a name that `soarbox run` accepts; there is no such folder next to the mission."""
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
        run = Run("learn", "1", "--headless", "--folder", nowhere, code=3)
        self.assertIn("--folder", run.err)

    def test_every_scenario_of_soar_agents_has_a_mission_that_passes_and_fails_without_rules(self):
        folders = sorted(path.parent.name for path in (REPOSITORY / "scenarios").glob("soar_*/scenario.toml"))
        for folder in folders:
            self.assertTrue((REPOSITORY / "scenarios" / folder / "mission.toml").exists(), folder)
        missions = [REPOSITORY / "scenarios" / folder / "mission.toml" for folder in folders]
        Run("test", *missions, "--seeds", "1", "--no-keep", code=0)
        empty = Run("test", *missions, "--seeds", "1", "--no-keep", "--empty", "--json")
        self.assertEqual([event["mission"] for event in empty.of("mission") if event["passed"]], [])

    def test_every_other_scenario_has_a_mission_that_passes(self):
        folders = sorted(path.parent for path in (REPOSITORY / "scenarios").glob("*/Sandbox.lua"))
        missions = [folder / "mission.toml" for folder in folders if not folder.name.startswith("soar_")]
        self.assertGreater(len(missions), 8)
        Run("test", *missions, "--seeds", "1", "--no-keep", code=0)

    def test_the_starter_passes_its_own_mission(self):
        self.assertEqual(Run("new", self.folder / "mine").code, 0)
        Run("test", self.folder / "mine", "--no-keep", code=0)


class Watch(MissionCase):
    def begin(self, *words):
        """Starts `soarbox test --watch`. Its output goes into a file that can be read at any time."""
        self.log = open(self.folder / "watch.log", "w+", encoding="utf-8")
        self.addCleanup(self.log.close)
        watch = subprocess.Popen([COMMAND, "test", *map(str, words), "--watch", "--no-keep"], stdout=self.log,
                                 stderr=subprocess.STDOUT)
        self.addCleanup(watch.kill)
        return watch

    def told(self):
        return (self.folder / "watch.log").read_text(encoding="utf-8")

    def wait_for(self, text, times=1, limit_s=60):
        wait_until(lambda: self.told().count(text) >= times, f"{times} times {text!r}", limit_s)

    def wait_for_a_run(self, watch, limit_s=60):
        """Waits until a run in a separate process has begun."""
        def children():
            tables = pathlib.Path("/proc").glob("[0-9]*/stat")
            return [table for table in tables if self.parent_in(table) == watch.pid]
        wait_until(children, "a run", limit_s)

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
        # ... a scenario that cannot be read is reported and does not end it ...
        self.write("scenario.toml", WORLD + checks.replace("at = ", "att = "))
        self.wait_for("none was run, 1 cannot be used")
        # ... and after the correction it passes again.
        self.write("scout.soar", RULES)
        self.write("scenario.toml", WORLD + checks)
        self.wait_for("all passed", 2)
        self.wait_for(waiting, 4)
        # A mission that was not there before is tested, too.
        self.write("second.toml", 'scenario = "scenario.toml"\n' + checks)
        self.wait_for("2 missions, all passed")
        # A file that was saved during a round may have started another round.
        rounds, end = -1, time.monotonic() + 60
        while time.monotonic() < end and (rounds != self.told().count(waiting) or waiting not in self.told().splitlines()[-1]):
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
        # If interrupted while it waits, it ends with the result of the last round.
        self.wait_for("waiting", 2)
        self.assertEqual(self.end(watch), 1, self.told())
