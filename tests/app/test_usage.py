# SPDX-License-Identifier: BSD-2-Clause
"""The messages for wrong command lines."""
import os
import pathlib
import shutil
import subprocess

from soarbox_command import COMMAND, Run, ScenarioCase

SUB_COMMANDS = ("run", "soar", "kernel", "new", "replay", "verify", "export", "resume", "compare", "check", "why", "list")


class Usage(ScenarioCase):
    def refused(self, *arguments):
        run = Run(*arguments)
        self.assertEqual((run.code, run.out), (2, ""), arguments)
        return run.err

    def test_suggests_the_sub_command_that_was_meant(self):
        self.assertIn("did you mean soarbox run?", self.refused("rnu", "thesis"))
        self.assertIn("did you mean soarbox list?", self.refused("lst"))
        self.assertIn("there are: run", self.refused("xyzzy"))

    def test_suggests_run_for_a_scenario_alone(self):
        self.assertIn("did you mean soarbox run thesis?", self.refused("thesis"))
        self.assertIn("did you mean soarbox run scout.soar?", self.refused("scout.soar"))

    def test_suggests_the_option_that_was_meant(self):
        for arguments, meant in ((("run", "--headles"), "--headless"), (("run", "-headless"), "--headless"),
                                 (("run", "thesis", "--sceonds=3"), "--seconds"), (("check", "--jsn", "x"), "--json"),
                                 (("why", "x", "--agnet", "y"), "--agent"), (("new", "--tem", "x"), "--team"),
                                 (("kernel", "--prt", 3), "--port"), (("soar", "--jso"), "--json"),
                                 (("resume", "x", "--rule", "y"), "--rules"), (("export", "x", "--cvs"), "--csv"),
                                 (("replay", "x", "--headles"), "--headless"), (("--hepl",), "--help")):
            self.assertIn(f"did you mean {meant}?", self.refused(*arguments), arguments)

    def test_knows_the_option_of_another_sub_command(self):
        self.assertIn("soarbox run --headless", self.refused("--headless", "run", "thesis"))
        self.assertIn("soarbox run has it", self.refused("check", "x", "--screenshot", "y"))

    def test_says_how_to_ask_about_a_run_with_other_rules(self):
        for command in ("why", "inspect"):
            told = self.refused(command, "soar_seek", "--rules", "seeker=mine.soar")
            self.assertIn("soarbox run SCENARIO --rules AGENT=FILE --record run.soarrec; soarbox " + command + " run.soarrec", told)

    def test_tells_each_sub_command_that_does_not_know_an_option_or_a_word(self):
        for command in SUB_COMMANDS:
            self.assertIn(f"soarbox {command} has no option --zzzzzz", self.refused(command, "--zzzzzz"))
        self.assertIn("takes no further argument 'other'", self.refused("list", "other"))
        self.assertIn('--view "memory S2"', self.refused("inspect", "soar_flee", "--view", "memory", "S2"))

    def test_says_what_a_value_may_be(self):
        for arguments, said in ((("--seconds", "abc"), "--seconds takes a number from 0 to 10000000, not 'abc'"),
                                (("--seconds", "nan"), "not 'nan'"), (("--width", 5), "a number from 160 to 7680, not '5'"),
                                (("--seed", -1), "--seed takes a whole number, not '-1'"),
                                (("--seconds",), "--seconds takes a value, and none is given")):
            self.assertIn(said, self.refused("run", "thesis", *arguments))

    def test_says_what_is_missing(self):
        self.assertIn("the argument files is missing", self.refused("check"))
        self.assertIn("--at is missing", self.refused("resume", "x"))

    def test_takes_no_option_for_the_value_of_another(self):
        self.assertIn("--record takes a value, and none is given", self.refused("run", "thesis", "--record", "--headless"))
        self.assertIn("--seconds takes a value", self.refused("run", "thesis", "--seconds", "--seed", 3))

    def test_names_what_a_folder_or_a_file_is_instead_of_what_was_wanted(self):
        for folder in ("two/a", "two/b", "rules", "small"):
            (self.folder / folder).mkdir(parents=True)
        self.write("two/a/scenario.toml", "")
        self.write("two/b/Sandbox.lua", "")
        self.write("rules/hero.soar", "")
        self.write("small/sandbox.lua", "")
        for folder, hint in (("two", "there are scenarios in it: "), ("rules", "hero.soar runs these rules in a world"),
                             ("small", "rename sandbox.lua to Sandbox.lua")):
            run = Run("run", self.folder / folder, "--headless", code=3)
            self.assertIn("neither scenario.toml nor Sandbox.lua", run.err)
            self.assertIn(hint, run.err)
        run = Run("sweep", self.folder / "nowhere.toml", code=3)
        self.assertIn("nowhere.toml: error: there is no such file\n   note: a sweep is a .toml file", run.err)

    def test_says_that_rules_run_without_the_scenario_beside_them(self):
        self.write("scenario.toml", '[[agent]]\nrules = "hero.soar"\n')
        for name in ("hero.soar", "other.soar"):
            run = Run("run", self.write(name, "sp {a (state <s> ^superstate nil) --> (<s> ^b c)}\n"), "--headless",
                      "--seconds", 0.1, code=0)
            self.assertEqual(f"soarbox run {self.folder} runs it in the scenario beside it" in run.err, name == "hero.soar", run.err)

    def test_runs_as_long_as_the_scenario_says_where_there_is_no_display(self):
        self.write("hero.soar", "sp {a (state <s> ^superstate nil) --> (<s> ^b c)}\n")
        self.write("scenario.toml", 'seconds = 2\n[[agent]]\nrules = "hero.soar"\n')
        for more in ([], ["--headless"]):
            self.assertIn(" 2.0 s simulated", Run("run", self.folder, *more).out)

    def test_looks_over_a_scenario_by_its_name(self):
        run = Run("check", "soar_hallway")
        self.assertEqual((run.code, run.out), (0, "0 errors, 0 warnings\n"))

    def test_without_any_argument_is_told_what_there_is(self):
        text = self.refused()
        for command in SUB_COMMANDS:
            self.assertIn(f"\n  {command} ", text)

    def test_a_moment_for_a_picture_needs_a_picture(self):
        self.assertRegex(self.refused("run", "thesis", "--headless", "--at", "3"), "--at .*--screenshot")

    def test_runs_headless_where_the_program_with_the_window_is_not_beside_it(self):
        alone = pathlib.Path(self.folder) / "soarbox"
        shutil.copy(COMMAND, alone)
        done = subprocess.run([alone, "run", "soar_seek", "--seconds", "0.1"], capture_output=True, text=True, timeout=60, check=False,
                              env={**os.environ, "DISPLAY": ":4711", "SOARBOX_DATA": str(pathlib.Path(__file__).resolve().parents[2])})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("this build has no window: the world runs headless", done.stderr)
        self.assertIn("soarbox-window beside this program", done.stderr)

    def test_the_program_with_the_window_runs_worlds_and_leaves_other_commands_to_soarbox(self):
        window = pathlib.Path(COMMAND).with_name("soarbox-window")
        if not window.exists():
            self.skipTest("this build has no window")
        without_display = {name: value for name, value in os.environ.items() if name != "DISPLAY"}

        def done(program, *words):
            return subprocess.run([program, *words], capture_output=True, text=True, timeout=60, check=False,
                                  env={**without_display, "SOARBOX_DATA": str(pathlib.Path(__file__).resolve().parents[2])})

        run = ["run", "soar_seek", "--seconds", "0.5", "--headless"]
        self.assertEqual(done(window, *run).stdout, done(COMMAND, *run).stdout)
        self.assertEqual(done(window, "check", "soar_hallway").stdout, "0 errors, 0 warnings\n")
        alone = pathlib.Path(self.folder) / "soarbox-window"
        shutil.copy(window, alone)
        refused = done(alone, "check", "soar_hallway")
        self.assertEqual((refused.returncode, refused.stdout), (3, ""), refused.stderr)
        self.assertIn("soarbox has it", refused.stderr)

    def test_says_where_the_server_comes_from_where_it_is_not_beside_it(self):
        alone = pathlib.Path(self.folder) / "soarbox"
        shutil.copy(COMMAND, alone)
        for words in (["serve"], ["run", "soar_seek", "--browser"]):
            done = subprocess.run([alone, *words], capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual((done.returncode, done.stdout), (3, ""), done.stderr)
            self.assertIn("this build has no server for browsers", done.stderr)
            self.assertIn("soarbox-serve beside this program", done.stderr)
