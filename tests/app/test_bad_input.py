# SPDX-License-Identifier: BSD-2-Clause
"""Each mistake of a user is reported with its place, and everything else continues."""
import socket
import unittest

from soarbox_command import WALKER, Run, ScenarioCase, run_json

SANDBOX = """
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 200, 200);
    Sandbox.CreateAgent(sandbox, "Good.lua");
    %s
end
"""


class CommandLine(unittest.TestCase):
    def test_missing_scenario_is_named_with_its_near_miss(self):
        run = Run("run", "thesys", "--headless", code=3)
        self.assertIn("there is no scenario 'thesys'", run.err)
        self.assertIn("did you mean 'thesis'?", run.err)

    def test_wrong_options_exit_with_2(self):
        for arguments in (["run", "--sped", "3"], ["run", "--seconds", "-1"], ["rum"], []):
            with self.subTest(arguments=arguments):
                run = Run(*arguments, code=2)
                self.assertTrue(run.err)

    def test_taken_port_is_named(self):
        with socket.socket() as holder:
            holder.bind(("127.0.0.1", 0))
            holder.listen()
            port = holder.getsockname()[1]
            run = run_json("thesis", "--seconds", 1, "--port", port)
        self.assertEqual(run.code, 3)
        self.assertIn(f"port {port}", run.err)

    def test_no_kernel_at_the_address_is_named(self):
        with socket.socket() as holder:
            holder.bind(("127.0.0.1", 0))
            port = holder.getsockname()[1]
        run = run_json("thesis", "--seconds", 1, "--kernel", f"127.0.0.1:{port}", code=3)
        self.assertIn(f"127.0.0.1:{port}", run.err)

    def test_without_a_display_it_runs_headless_and_says_so(self):
        run = Run("run", "thesis", "--seconds", 1, code=0)
        self.assertIn("headless", run.err)
        self.assertIn("soarbox: scenario thesis, seed 1, headless", run.out)

    def test_a_headless_run_takes_no_picture_and_says_so(self):
        run = Run("run", "thesis", "--headless", "--screenshot", "x.png", code=2)
        self.assertIn("a headless run draws nothing", run.err)

    def test_a_picture_needs_a_display(self):
        run = Run("run", "thesis", "--screenshot", "x.png", code=3)
        self.assertIn("no picture", run.err)


class Scripts(ScenarioCase):
    def scenario(self, line):
        self.write("Sandbox.lua", SANDBOX % line)
        self.write("Good.lua", WALKER)
        return self.folder

    def check_world_goes_on(self, run):
        """Expects exit code 1, and that the agent without mistakes has walked to the end."""
        self.assertEqual(run.code, 1, run.err)
        last = run.of("state")[-1]
        self.assertGreater(last["time"], 2.9)
        self.assertGreater(last["agents"][0]["position"][0], 1)

    def run_(self):
        return run_json(self.folder, "--seconds", 3, "--report", 0.1)

    def test_syntax_error_in_the_sandbox_script_names_file_and_line(self):
        self.write("Sandbox.lua", "function Sandbox_Initialize(sandbox)\n  local x = = 3\nend\n")
        run = run_json(self.folder, "--seconds", 1, code=3)
        self.assertRegex(run.err, r"Sandbox\.lua:2")

    def test_syntax_error_in_an_agent_script_stops_that_agent_only(self):
        self.scenario('Sandbox.CreateAgent(sandbox, "Bad.lua");')
        self.write("Bad.lua", "function Agent_Initialize(agent)\n  if then\nend\n")
        run = self.run_()
        self.check_world_goes_on(run)
        self.assertTrue(any(d.get("file", "").endswith("Bad.lua") and d.get("line") == 2 for d in run.diagnostics()), run.out)

    def test_forms_of_other_languages_and_names_of_nothing_are_told_with_what_to_write(self):
        good = "function Agent_Initialize(agent) end\nfunction Agent_Update(agent)\n  %s\nend\n"
        for text, line, said, hint in (
                (good % "if 1 != 2 then end", 3, "'then' expected", "not equal is written ~="),
                (good % "n += 1", 3, "'=' expected", "n = n + 1"),
                ("// mine\n" + good % "", 1, "unexpected symbol", "comments start with --"),
                (good % "if true then", 5, "'end' expected", "look from line 2 on"),
                (good % "print('hello)", 3, "unfinished string", "with the quote that it began with"),
                (good % "Agent.Walk(agent)", 3, "Agent has no function 'Walk': did you mean 'WalkTo'?", ""),
                (good % "Agent.SetTarget(agent, target.position)", 3, "global 'target' (a nil value)", "nothing has given target a value"),
                (good % "GoThere(agent)", 3, "global 'GoThere' (a nil value)", "is its script loaded with require?")):
            with self.subTest(text):
                self.scenario('Sandbox.CreateAgent(sandbox, "Bad.lua");')
                self.write("Bad.lua", text)
                run = self.run_()
                self.check_world_goes_on(run)
                told = [d for d in run.diagnostics() if d.get("line") == line and d.get("file", "").endswith("Bad.lua")][0]
                self.assertIn(said, told["message"])
                self.assertIn(hint, told.get("hint", ""))
                self.assertNotIn("=script", told["message"])
        check = Run("check", self.write("Bad.lua", good % "n += 1"))
        self.assertIn("note: write the sum out: n = n + 1", check.out)

    def test_a_script_without_its_ending_is_found(self):
        self.scenario('Sandbox.CreateAgent(sandbox, "Good");')
        self.assertIn('did you mean \\"Good.lua\\"?', self.run_().out)

    def test_run_time_error_costs_one_call(self):
        self.scenario('for i = 1, 3 do Sandbox.CreateAgent(sandbox, "Bad.lua"); end')
        self.write("Bad.lua", "local ticks = 0\nfunction Agent_Update(agent)\n  ticks = ticks + 1\n  if ticks == 10 then\n    error_here.x = 1\n  end\n"
                              "  if ticks == 11 then print('on') end\nend\n")
        run = self.run_()
        self.check_world_goes_on(run)
        self.assertEqual(run.of("failed"), [])
        told = run.of("diagnostic")
        self.assertEqual(len(told), 1, run.out)
        self.assertEqual(told[0]["diagnostic"]["line"], 5)
        self.assertIn("error_here", told[0]["diagnostic"]["message"])
        self.assertIn("(Agent_Update of Bad-1, Bad-2, Bad-3)", told[0]["diagnostic"]["message"])
        self.assertEqual(len(run.of("log")), 3, "all three go on")

    def test_a_callback_that_fails_each_tick_is_told_so_once_and_when_it_works_again(self):
        self.scenario('Sandbox.CreateAgent(sandbox, "Bad.lua");')
        self.write("Bad.lua", "local ticks = 0\nfunction Agent_Update(agent)\n  ticks = ticks + 1\n  if ticks < 40 then error('no') end\nend\n")
        run = self.run_()
        self.check_world_goes_on(run)
        told = [(event["tick"], event["diagnostic"]["severity"]) for event in run.of("diagnostic")]
        self.assertEqual(told, [(1, "error"), (3, "warning"), (40, "note"), (90, "note")], run.out)

    def test_nothing_is_told_of_an_agent_before_it_joins(self):
        self.scenario('Sandbox.CreateAgent(sandbox, "Bad.lua");')
        self.write("Bad.lua", "this is no Lua")
        run = self.run_()
        told = [event["event"] for event in run.events if event.get("agent") == "Bad-1"]
        self.assertEqual(told, ["agent", "failed", "finding"])

    def test_endless_loop_stops_that_agent_only(self):
        self.scenario('Sandbox.CreateAgent(sandbox, "Bad.lua");')
        self.write("Bad.lua", "function Agent_Update(agent)\n  while true do end\nend\n")
        self.check_world_goes_on(self.run_())

    def test_missing_agent_script_is_named(self):
        self.scenario('pcall(Sandbox.CreateAgent, sandbox, "Absent.lua"); Sandbox.CreateAgent(sandbox, "AbsentToo.lua");')
        run = self.run_()
        self.check_world_goes_on(run)
        self.assertIn("AbsentToo.lua", run.out)

    def test_unknown_mesh_and_material_get_a_stand_in_and_a_warning_each(self):
        self.scenario('local o = Sandbox.CreateObject(sandbox, "models/no_such.mesh"); Core.SetMaterial(o, "NoSuchMaterial");')
        run = self.run_()
        self.assertEqual(run.code, 0, run.out)
        warnings = [d for d in run.diagnostics() if d["severity"] == "warning"]
        self.assertTrue(any("models/no_such.mesh" in d["message"] for d in warnings), warnings)
        self.assertTrue(any("NoSuchMaterial" in d["message"] for d in warnings), warnings)


class Rules(ScenarioCase):
    def setUp(self):
        super().setUp()
        self.write("Sandbox.lua", SANDBOX % 'Sandbox.CreateSoarSeekingAgent(sandbox, "Good.lua");')
        self.write("Good.lua", WALKER)

    def run_(self):
        return run_json(self.folder, "--seconds", 2, "--every-command")

    def test_rule_with_a_syntax_error_is_placed_and_the_others_load(self):
        self.write("seekingagent.soar",
                   "sp {say\n   (state <s> ^superstate nil ^io <io>)\n   (<io> ^output-link <out>)\n-->\n   (<out> ^walk <w>)\n}\n\n"
                   "sp {broken\n   (state <s> ^superstate nil\n-->\n   (<s> ^x 1)\n}\n")
        run = self.run_()
        self.assertEqual(run.code, 1, run.out)
        placed = [d for d in run.diagnostics() if d.get("file", "").endswith("seekingagent.soar")]
        self.assertTrue(placed, run.out)
        self.assertEqual(placed[0].get("line"), 10)
        self.assertIn("column", placed[0])
        self.assertTrue(run.of("command", command="walk"), "the good rule acts")

    def test_missing_rules_are_named_and_the_world_goes_on(self):
        self.write("Sandbox.lua", SANDBOX % 'Sandbox.CreateSoarAgent(sandbox, "Good.lua", "absent.soar");')
        run = self.run_()
        self.assertEqual(run.code, 1, run.out)
        self.assertIn("absent.soar", run.out)
        self.assertGreater(run.of("end")[0]["time"], 1.9)

    def test_gap_in_the_rules_is_told_and_stalls_nothing(self):
        self.write("seekingagent.soar", "sp {idle\n   (state <s> ^superstate nil)\n-->\n   (<s> ^idle yes)\n}\n")
        run = self.run_()
        self.assertEqual(run.code, 0, run.out)
        self.assertEqual(len(run.of("gap")), 1, run.out)
        self.assertGreater(run.of("end")[0]["time"], 1.9)
