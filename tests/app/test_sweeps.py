# SPDX-License-Identifier: BSD-2-Clause
"""Sweeps through the real command."""
import csv
import fcntl
import os
import resource
import shutil
import signal
import sqlite3
import subprocess
import unittest
from unittest import mock

from mission_case import REPOSITORY, RULES, SWEEP, WORLD, MissionCase
from soarbox_command import COMMAND, Run, end_with, page_missing, wait_until


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


class Sweeps(MissionCase):
    def begin(self, spec, *words):
        return end_with(self, subprocess.Popen([COMMAND, "sweep", spec, *words], stdout=subprocess.DEVNULL,
                                               stderr=subprocess.DEVNULL))

    def rows(self, name="sweep.sweep"):
        with open(self.folder / name / "results.csv", newline="", encoding="utf-8") as file:
            return [{key: value for key, value in row.items() if key not in ("cpu_s", "peak_mb")} for row in csv.DictReader(file)]

    def test_seeds_times_variants_become_a_table(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        run = Run("sweep", spec, code=0)
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
        Run("run", self.folder / "sweep.sweep" / "variants" / "slow", "--headless", "--seed", "3", "--seconds", "8",
            "--json", code=0)

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
        named = Run("test", self.folder / "sweep.toml", code=3)
        self.assertIn("this is a sweep, not a mission", named.err)

    def test_a_sweep_that_comes_with_the_program_is_found_by_name(self):
        for name, results, variants in (("soar_skirmish", "soar_skirmish.sweep", {"unchanged", "short-sighted", "bold"}),
                                        ("soar_skirmish/sweep.toml", "sweep.sweep", {"unchanged", "short-sighted", "bold"})):
            run = Run("sweep", name, cwd=self.folder, code=0)
            self.assertIn(f"tables: {results}/results.csv", run.out)
            rows = self.rows(results)
            self.assertEqual({row["variant"] for row in rows}, variants)
            self.assertEqual({row["outcome"] for row in rows}, {"ok"})
        shutil.copytree(REPOSITORY / "scenarios" / "soar_skirmish", self.folder / "mine")
        self.assertIn("tables: mine/sweep.sweep/results.csv", Run("sweep", "mine", cwd=self.folder, code=0).out)
        self.assertEqual(Run("check", self.folder / "mine").out, "0 errors, 0 warnings\n", "the copy of the sweep is not a sweep to check")
        self.assertIn("there is no such file", Run("sweep", "soar_skirmish/no.toml", cwd=self.folder, code=3).err)

    def test_what_was_killed_goes_on_and_comes_to_the_same_table(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..12"))
        parts = self.folder / "sweep.sweep" / "parts"
        for rows in (1, 6, 12):
            child = self.begin(spec)
            wait_until(lambda: child.poll() is not None or sum(made.read_text().count("\n") for made in parts.glob("*.rows")) >= rows)
            child.send_signal(signal.SIGKILL)
            child.wait()
        with open(sorted(parts.glob("*.rows"))[0], "a", encoding="utf-8") as file:
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
        Run("sweep", spec.name, cwd=self.folder, code=0)
        rows = self.rows("thesis.sweep")
        self.assertEqual([(row["seed"], row["outcome"]) for row in rows], [("1", "ok"), ("2", "ok")])
        self.assertGreater(float(rows[0]["decisions"]), 0)
        self.assertTrue((self.folder / "thesis.sweep" / "variants" / "default" / "Sandbox.lua").exists())
        # The same for a mission. Both find the scenario that comes with the program.
        self.write("soar_hallway.toml", 'scenario = "soar_hallway"\n[[check]]\nname = "off"\nagent = "anna"\ncommand = "move-to"\nby = 5\n')
        Run("test", "soar_hallway.toml", "--no-keep", cwd=self.folder, code=0)
        self.assertEqual(Run("run", "thesis", "--headless", "--seconds", "1", cwd=self.folder).code, 0)
        # A user's own scenario with this name has priority.
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
            run = Run("sweep", self.write("wrong.toml", wrong), "--folder", self.folder / "w", code=3)
            self.assertIn(message, run.err)
            shutil.rmtree(self.folder / "w", ignore_errors=True)
        spec = self.write("sweep.toml", SWEEP)
        self.assertEqual(Run("sweep", spec).code, 0)
        other = Run("sweep", self.write("other.toml", SWEEP.replace("8", "7")), "--folder",
                    self.folder / "sweep.sweep", code=3)
        self.assertIn("this folder belongs to another sweep", other.err)

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
        again = Run("sweep", spec, code=0)
        self.assertRegex(again.err, r"runs made, [1-9]\d* were there")
        self.assertEqual(len(self.rows()), 12)

    def test_what_a_row_rests_on_cannot_change_under_it(self):
        self.mission("")
        bold = self.write("bold.soar", RULES)
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..2") + '[[variant]]\nname = "bold"\nrules = { "scout" = "bold.soar" }\n')
        self.assertEqual(Run("sweep", spec).code, 0)
        kept = spec.read_text(encoding="utf-8")
        # A changed check, metric or setting: the existing rows were made with the previous one.
        for old, new in (('at = "gate"', 'at = "gate"\nby = 3'), ('time_of = "there"', 'max = "distance"'), ("seconds = 8", "seconds = 7")):
            self.write("sweep.toml", kept.replace(old, new))
            run = Run("sweep", spec, code=3)
            self.assertIn("this folder belongs to another sweep", run.err)
        self.write("sweep.toml", "# A comment changes nothing.\n" + kept)
        bold.write_text(RULES + "# changed\n", encoding="utf-8")
        run = Run("sweep", spec, code=3)
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
        run = Run("sweep", spec, code=0)
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
        self.assertEqual({(self.folder / "sweep.sweep" / row["recording"]).is_file() for row in self.rows()}, {True})
        self.assertIn("0 runs made, 12 were there", Run("sweep", spec).err)

    def test_a_sweep_says_that_a_variant_has_the_numbers_of_the_first(self):
        self.mission("")
        spec = self.write("sweep.toml", 'mission = "go.toml"\n[[variant]]\nname = "a"\n[[variant]]\nname = "tough"\n'
                          'parameters = { "agent.scout.health" = 90 }\n')
        self.write("go.toml", 'scenario = "."\nseeds = "1..3"\nseconds = 8\n[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\n')
        run = Run("sweep", spec, code=0)
        self.assertRegex(run.out, "tough(-90)? and a have the same numbers on each seed")
        self.assertNotIn("e+0", run.out)

    def test_a_folder_of_a_sweep_can_be_taken_elsewhere(self):
        self.mission("")
        rules = self.write("fast.soar", RULES)
        mission = self.write("go.toml", 'scenario = "."\nseeds = "1..3"\nseconds = 8\n[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\n')
        spec = self.write("sweep.toml", 'mission = "go.toml"\n[[variant]]\nname = "a"\n[[variant]]\nname = "b"\nrules = { "scout" = "fast.soar" }\n')
        run = Run("sweep", spec, "--folder", self.folder / "made", code=0)
        self.assertIn("b never differs from a", run.out)
        (self.folder / "made").rename(self.folder / "taken")
        for gone in (rules, mission, spec, self.folder / "scenario.toml"):
            gone.unlink()
        if page_missing():
            self.skipTest(page_missing())
        page = self.folder / "page.html"
        Run("report", self.folder / "taken", "-o", page, code=0)
        self.assertIn("taken: 6 runs", page.read_text(encoding="utf-8"))

    def test_a_folder_that_cannot_be_made_is_told(self):
        self.mission("")
        run = Run("sweep", self.write("sweep.toml", SWEEP), "--folder", self.write("file", "") / "below", code=3)
        self.assertIn("name another with --folder", run.err)

    @unittest.skipIf(shutil.which("sbatch"), "Slurm is installed")
    def test_a_sweep_keeps_others_out_of_its_folder(self):
        self.mission("")
        # The run is so long that it lasts until it is interrupted, on any machine.
        spec = self.write("sweep.toml", SWEEP.replace("seconds = 8", "seconds = 1000000"))
        first = self.begin(spec, "--jobs", "1")
        lock = spec.with_suffix(".sweep") / "lock"
        wait_until(lambda: first.poll() is not None or is_locked(lock))
        second = Run("sweep", spec, code=3)
        self.assertIn("another sweep is making runs here", second.err)
        first.send_signal(signal.SIGINT)
        self.assertEqual(first.wait(60), 130)

    def test_a_sweep_that_goes_on_makes_no_run_twice(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP.replace("1..6", "1..100"))
        first = self.begin(spec, "--jobs", "1")
        parts = spec.with_suffix(".sweep") / "parts"
        wait_until(lambda: first.poll() is not None or list(parts.glob("*.rows")))
        # The first sweep may have finished all runs. Then the second one has nothing to do.
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
