# SPDX-License-Identifier: BSD-2-Clause
"""Files, names and values that were passed by mistake: each is reported with a helpful message, and nothing else is affected."""
import os
import signal
import subprocess

from soarbox_command import COMMAND, WALKER, Run, ScenarioCase, run_json

SANDBOX = """
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 200, 200);
    walker = Sandbox.CreateAgent(sandbox, "Walker.lua");
    %s
end
"""
AGENT = '[[agent]]\nname = "hero"\nrules = "hero.soar"\n'
RULES = "sp {hero*go (state <s> ^superstate nil ^io.output-link <o>) --> (<o> ^wander <c>)}\n"

# What exists instead of the file, and the message.
OTHER_FILES = {
    "UTF-16": (lambda path: path.write_bytes(RULES.encode("utf-16")), "this file is UTF-16: save it as UTF-8"),
    "binary": (lambda path: path.write_bytes(bytes(range(256))), "this is not a text file: line 1 holds a zero byte"),
    "folder": (lambda path: path.mkdir(), "a folder"),
    "pipe": (os.mkfifo, "no plain file"),
    "dangling link": (lambda path: path.symlink_to("nowhere"), "a link that leads"),
    "link to a device": (lambda path: path.symlink_to("/dev/zero"), "a link that leads"),
}


class Files(ScenarioCase):
    def put(self, name, make):
        path = self.folder / name
        if path.is_dir():
            path.rmdir()
        elif path.is_symlink() or path.exists():
            path.unlink()
        make(path)

    def test_what_is_no_file_of_rules_is_told_with_its_name(self):
        self.write("scenario.toml", AGENT)
        for name, (make, said) in OTHER_FILES.items():
            with self.subTest(name):
                self.put("hero.soar", make)
                run = Run("run", self.folder, "--headless", "--seconds", 0.1)
                self.assertIn(run.code, (1, 3), run.err)
                self.assertIn(said, run.err)
                self.assertIn("hero.soar", run.err)

    def test_what_is_no_script_is_told_with_its_name_and_the_world_goes_on(self):
        lines = ""
        for number, (name, (make, _)) in enumerate(OTHER_FILES.items()):
            self.put(f"Bad{number}.lua", make)
            lines += f'print(pcall(Sandbox.CreateAgent, sandbox, "Bad{number}.lua"));\n'
        self.put("Large.lua", lambda path: path.write_text("--" + "x" * (9 << 20)))
        self.write("Sandbox.lua", SANDBOX % (lines + 'Sandbox.CreateAgent(sandbox, "Large.lua");'))
        self.write("Walker.lua", WALKER)
        run = run_json(self.folder, "--seconds", 0.5, code=1)
        told = [event["text"] for event in run.of("log")]
        for number, (_, said) in enumerate(OTHER_FILES.values()):
            said = "no plain file" if "device" in list(OTHER_FILES)[number] else said
            self.assertIn(said, told[number])
            self.assertIn(f'"Bad{number}.lua"', told[number])
        self.assertIn('"Large.lua" is too large: 9 MB', run.diagnostics()[0]["message"])

    def test_a_byte_order_mark_and_foreign_line_ends_are_no_mistake(self):
        mark = "\ufeff"
        self.write("scenario.toml", mark + AGENT.replace("\n", "\r\n"))
        self.write("hero.soar", mark + RULES.replace("\n", "\r\n"))
        self.write("keys.txt", mark + "1 key f1_key press\r\n")
        run = run_json(self.folder, "--seconds", 0.1, "--input", self.folder / "keys.txt")
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertTrue(run.of("command", command="wander"))

    def test_signs_in_the_name_of_a_folder_are_part_of_the_name(self):
        for name in ("a}}b", "{a", "two words", "#1", "a;b", 'say "a"', "back\\slash", "|bar|"):
            with self.subTest(name):
                (self.folder / name).mkdir()
                self.write(f"{name}/scenario.toml", AGENT)
                file = self.write(f"{name}/hero.soar", RULES)
                check = Run("check", self.folder / name)
                self.assertEqual((check.code, check.out), (0, "0 errors, 0 warnings\n"), check.err)
                self.assertTrue(run_json(self.folder / name, "--seconds", 0.1).of("command", command="wander"))
                self.assertEqual(Run("check", file).code, 0)

    def test_files_that_source_each_other_are_told_once(self):
        self.write("a.soar", "source b.soar\n")
        self.write("b.soar", "source a.soar\n")
        run = Run("check", self.folder / "a.soar")
        self.assertEqual(run.out.count("This file sources itself"), 1, run.out)

    def test_other_files_are_no_scenarios(self):
        (self.folder / "x.png").write_bytes(b"\x89PNG")
        run = Run("run", self.folder / "x.png", "--headless", code=3)
        self.assertIn("this is not a file of rules, script or scenario", run.err)


class Scenarios(ScenarioCase):
    def test_all_that_is_wrong_in_a_scenario_is_told_at_once_with_its_place(self):
        self.write("hero.soar", RULES)
        self.write("scenario.toml", AGENT + 'speed = "fast"\nheigth = 2\nteam = 5\nposition = ["a"]\nsenses.sight = -1\n'
                   'body = "persn"\ncount = 2.5\nscript = "x"\n[[agent]]\nname = "a\\nb"\n[[agent]]\nname = "' + "x" * 200 + '"\n')
        run = Run("run", self.folder, "--headless", code=3)
        for place, said in {"4:9": "'speed' takes a number", "5:10": "has an option 'heigth'", "6:8": "'team' takes a name",
                            "7:12": "'position' takes numbers", "8:16": "'senses.sight' is -1", "9:8": "no body 'persn'",
                            "10:9": "'count' takes a whole number", "11:10": "has an option 'script'",
                            "13:8": "this name has control characters", "15:8": "this name has 200 characters"}.items():
            self.assertRegex(run.err, rf"scenario\.toml:{place}: error: .*{said}")
        self.assertIn("did you mean 'height'?", run.err)

    def test_forms_of_other_languages_and_of_haste_are_told_at_their_place_with_what_to_write(self):
        self.write("hero.soar", RULES)
        for text, place, said, hint in (
                (AGENT + 'position = "1, 2"\n', "4:12", "'position' takes two numbers", ""),
                (AGENT + "position = (1, 2)\n", "4:", "", "in square brackets: [1, 2]"),
                (AGENT + "armed = yes\n", "4:", "", "write true or false"),
                (AGENT.replace("name =", "name:"), "2:5", "expected '='", "write = between a key and its value"),
                (AGENT.replace("hero.soar", "rules\\hero.soar"), "3:", "escape", "write / between folders"),
                ("// my world\n" + AGENT, "1:", "", "comments start with #"),
                (AGENT + "seconds = 60\n", "4:11", "no agent has an option 'seconds'", "on top of the file"),
                (AGENT + '[[waypoint]]\nposition = [1, 2]\nseconds = 60\n', "6:11", "a waypoint has no 'seconds'", "on top of the file"),
                ('seconds = "60"\n' + AGENT, "1:11", "a number from 0 to 1000000", ""),
                (AGENT.replace('"hero.soar"', '["hero.soar"]'), "3:9", "'rules' takes a text in quotes", ""),
                (AGENT + 'kind = "soldier"\n', "4:8", "no agent has an option 'kind'", "did you mean 'body'?"),
                (AGENT + 'looks = "duck.glb"\n', "4:9", "'looks' names the model duck.glb", 'Core.CreateMesh(agent, "duck.glb")'),
                (AGENT + 'leader = "boss"\n', "4:10", "the leader of hero, 'boss', is not above it", "comes before"),
                (AGENT.replace("hero.soar", "scout.soar"), "3", "scout.soar", "")):
            with self.subTest(text):
                self.write("scenario.toml", text)
                for run in (Run("check", self.folder), Run("run", self.folder, "--headless", "--seconds", 0.1)):
                    self.assertIn(run.code, (1, 3))
                    told = run.out + run.err
                    self.assertIn(f"scenario.toml:{place}", told)
                    self.assertIn(said, told)
                    self.assertIn(hint, told)
                    self.assertEqual(told.count("error: "), 1, told)

    def test_what_is_odd_in_a_scenario_is_told_by_check(self):
        self.write("hero.soar", RULES)
        for text, line, said, hint in ((AGENT + AGENT, 4, "another agent named 'hero' in line 1", "called hero-2"),
                                       ('description = "later"\n', 1, "this scenario has no agents", "[[agent]]")):
            self.write("scenario.toml", text)
            run = Run("check", self.folder, code=1)
            self.assertIn(f"scenario.toml:{line}: warning: ", run.out)
            self.assertIn(said, run.out)
            self.assertIn(hint, run.out)

    def test_a_faulty_scenario_says_nothing_about_the_places_that_rules_name(self):
        self.write("hero.soar", RULES.replace("(<o> ^wander <c>)", "(<o> ^move-to <c>) (<c> ^waypoint gate)"))
        self.write("scenario.toml", AGENT + "position = (1, 2)\n[[waypoint]]\nname = \"gate\"\nposition = [1, 2]\n")
        self.assertNotIn("which the scenario does not have", Run("check", self.folder).out)

    def test_a_parameter_with_two_values_is_told_as_the_mistake_that_it_is(self):
        self.write("scenario.toml", AGENT)
        self.write("hero.soar", RULES.replace("(<o> ^wander <c>)", "(<o> ^set-speed <c>) (<c> ^speed 1 + 2)"))
        run = run_json(self.folder, "--seconds", 0.1)
        self.assertTrue(any("^speed of set-speed has two values, 2 and 1" in event["text"] for event in run.of("outcome")),
                        run.out)

    def test_rules_that_fire_without_end_are_told_once(self):
        self.write("scenario.toml", AGENT)
        self.write("hero.soar", "sp {hero*count (state <s> ^superstate nil ^n <n>) --> (<s> ^n (+ <n> 1))}\n"
                                "sp {hero*begin (state <s> ^superstate nil) --> (<s> ^n 1)}\n")
        run = run_json(self.folder, "--seconds", 0.3)
        told = [event["text"] for event in run.of("log") if "fire again and again" in event["text"]]
        self.assertEqual(len(told), 1, run.out)
        named = [problem for problem in run.diagnostics() if "fire again and again" in problem["message"]]
        self.assertEqual([problem["line"] for problem in named], [1], run.out)
        self.assertIn("rule hero*count among them", named[0]["message"])

    def test_a_rule_that_failed_before_is_named_when_it_fires_without_end(self):
        self.write("scenario.toml", AGENT)
        self.write("hero.soar", "sp {hero*count (state <s> ^superstate nil ^n <n>) -->\n"
                                "   (<s> ^n (+ <n> 1) ^bad (/ 1 (- <n> <n>)))}\n"
                                "sp {hero*begin (state <s> ^superstate nil) --> (<s> ^n 1)}\n")
        run = run_json(self.folder, "--seconds", 0.3)
        for said in "divides by zero with /", "among them:":
            self.assertEqual(len([problem for problem in run.diagnostics()
                                  if said in problem["message"]]), 1, run.out)

    def test_a_mind_that_fires_ever_more_rules_is_halted_and_the_world_goes_on(self):
        self.write("scenario.toml", AGENT + '[[agent]]\nname = "other"\nrules = "other.soar"\n')
        self.write("other.soar", RULES)
        self.write("hero.soar", "sp {hero*begin (state <s> ^superstate nil) --> (<s> ^n 0)}\n"
                                "sp {hero*count (state <s> ^superstate nil ^n <n>) --> (<s> ^n (+ <n> 1) ^n <n> -)}\n")
        run = run_json(self.folder, "--seconds", 10)
        halted = [problem for problem in run.diagnostics() if "stops for good" in problem["message"]]
        self.assertEqual(len(halted), 1, run.out)
        self.assertRegex(halted[0]["message"], r"^hero stops for good: its rules fired 20\d{4} times in one tick, "
                                               r"most often 'hero\*count', which has fired \d+ times$")
        self.assertTrue(run.of("command", agent="other", command="wander"), run.out)
        self.assertEqual(run.of("end")[0]["ticks"], 300)
        self.assertIn("its rules fired", Run("why", self.folder, "--agent", "hero", "--at", 5).out)

    def test_an_action_that_fails_is_told_with_its_rule_once(self):
        self.write("scenario.toml", AGENT)
        self.write("hero.soar", RULES + "sp {hero*share (state <s> ^superstate nil ^io.input-link <in>)\n"
                   "   (<in> ^time <t>)\n-->\n   (<s> ^share (/ <t> (- <t> <t>)))\n}\n")
        run = run_json(self.folder, "--seconds", 0.3)
        told = [problem for problem in run.diagnostics() if "divides by zero" in problem["message"]]
        self.assertEqual([(problem["line"], problem["severity"]) for problem in told], [(5, "warning")], run.out)
        self.assertIn("rule hero*share divides by zero with /", told[0]["message"])
        self.assertIn("<> 0", told[0]["hint"])
        # Soar's output is printed unchanged.
        self.assertTrue(any(event["text"] == "Error: attempt to divide ('/') by zero." for event in run.of("log")))

    def test_a_full_disk_behind_standard_output_is_told(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([COMMAND, "list"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn("standard output cannot be written", done.stderr)

    def test_it_ends_quietly_if_nobody_reads_its_output(self):
        for ignored in (False, True):  # Some parent processes ignore the signal, and WebAssembly has none.
            for words in (["list"], ["help", "run"], ["check", self.write("hero.soar", RULES)]):
                with self.subTest(ignored=ignored, words=words[0]):
                    reader, writer = os.pipe()
                    os.close(reader)
                    done = subprocess.run([COMMAND, *words], stdout=writer, stderr=subprocess.PIPE, check=False, restore_signals=False,
                                          preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_IGN if ignored else signal.SIG_DFL))
                    os.close(writer)
                    self.assertEqual(done.stderr, b"")
                    self.assertEqual(done.returncode, 128 + signal.SIGPIPE if ignored else -signal.SIGPIPE)

    def test_an_option_that_is_given_twice_is_told(self):
        run = Run("run", "thesis", "--headless", "--seed", 1, "--seed", 2, code=2)
        self.assertIn("--seed is given more than once", run.err)


class Scripts(ScenarioCase):
    def run_(self, line, *arguments, **files):
        self.write("Sandbox.lua", SANDBOX % line)
        self.write("Walker.lua", WALKER)
        for name, text in files.items():
            self.write(f"{name}.lua", text)
        return Run("run", self.folder, "--headless", "--seconds", 0.1, *arguments)

    def test_no_text_of_a_scenario_steers_the_terminal_or_passes_for_a_message(self):
        run = self.run_("print('\\27[31mred'); walker:SetTeam('\\27[2J'); pcall(Sandbox.CreateObject, sandbox, '\\27[1m.mesh');\n"
                        "error('\\27[2Jlost\\nother.lua:1: error: you lost');")
        self.assertNotIn("\x1b", run.out + run.err)
        self.assertIn("\\x1b[31mred", run.out)
        self.assertIn("\n   other.lua:1: error: you lost", run.err)

    def test_functions_that_nothing_calls_are_told_by_a_run_too(self):
        run = self.run_("Sandbox.CreateAgent(sandbox, 'Other.lua');", Other="function Agent_handleEvent(agent, event)\nend\n")
        self.assertEqual(run.code, 0)
        self.assertIn("Other.lua:1:10: warning: nothing calls the function Agent_handleEvent", run.err)
        self.assertIn("did you mean Agent_HandleEvent?", run.err)

    def test_options_of_an_agent_are_told_with_the_line_that_asked_for_it(self):
        run = self.run_("\nSandbox.CreateSoarAgent(sandbox, 'Walker.lua', 'x.soar', { speed = 'a', foo = 1 });")
        self.assertRegex(run.err, r"Sandbox\.lua:6: error: no agent has an option 'foo'; the option 'speed' takes a number")

    def test_the_argument_that_is_wrong_is_named_within_pcall_and_tables(self):
        run = self.run_("print(pcall(Sandbox.CreateSoarAgent, sandbox, nil));\nlocal t = {}; t.t = t;\n"
                        "print(pcall(Sandbox.CreateSoarAgent, sandbox, 'Walker.lua', 'x.soar', t));")
        self.assertIn("bad argument #2 to 'Sandbox.CreateSoarAgent' (string expected, got nil)", run.out)
        self.assertIn("bad argument #4 to 'Sandbox.CreateSoarAgent' (these are too many options)", run.out)

    def test_why_tells_which_script_has_failed(self):
        (self.folder / "keeper.soar").write_text("sp {keeper*look\n   (state <s> ^superstate nil ^io.input-link.sky dark)\n"
                                                 "-->\n   (<s> ^operator <o> +)\n   (<o> ^name look)\n}\n")
        (self.folder / "scenario.toml").write_text('script = "world.lua"\n[[agent]]\nname = "keeper"\n'
                                                   'rules = "keeper.soar"\nby = "sandbox"\n')
        (self.folder / "world.lua").write_text("function Sandbox_Sense(sandbox, agent)\n"
                                               "    return { sky = Harbor.sky };\nend\n")
        run = Run("why", self.folder, "--at", 0.5)
        self.assertIn("world.lua:2: error: attempt to index global 'Harbor'", run.err)
        self.assertIn("rule keeper*look tests ^sky", run.out)

    def test_why_nobody_thinks_is_told(self):
        self.run_("")
        run = Run("why", self.folder, "--at", 0.1, code=3)
        self.assertIn("no agent of this scenario has a Soar mind", run.err)
