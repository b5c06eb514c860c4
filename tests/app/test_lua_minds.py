# SPDX-License-Identifier: BSD-2-Clause
"""Minds in Lua: their shown state, commands that take time, the console, and calls of undefined functions."""
import json

from soarbox_command import Run, ScenarioCase

BODY = """
local steps = 0;
function Agent_Sense() return { body = { steps = steps } }; end
function Agent_Update(agent, ms, command, parameters)
    if (command == "leap") then return "error", "too-high", "nobody leaps so high"; end
    parameters.left = (parameters.left or 3) - 1;
    if (parameters.left > 0) then return "running", 1 - parameters.left / 3; end
end
function Agent_Withdraw(agent, command) print("no more " .. command); end
function Agent_Tick() steps = steps + 1; end
"""
RULES = """
sp {propose*go (state <s> ^superstate nil -^did) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {apply*go (state <s> ^operator.name go ^io.output-link <out>) --> (<out> ^go <c>)}
sp {done*go (state <s> ^operator.name go ^io.output-link.go <c>) (<c> ^status complete) --> (<s> ^did go) (write |gone| (crlf))}
sp {propose*leap (state <s> ^superstate nil ^did go -^told) --> (<s> ^operator <o> +) (<o> ^name leap)}
sp {apply*leap (state <s> ^operator.name leap ^io.output-link <out>) --> (<out> ^leap <c>)}
sp {told*leap (state <s> ^operator.name leap ^io.output-link.leap <c>) (<c> ^status error ^reason <why>) -->
   (<s> ^told <why>) (write |no: | <why> (crlf))}
"""


class LuaMinds(ScenarioCase):
    def test_a_body_in_lua_takes_time_for_a_command_and_has_a_tick_of_its_own(self):
        self.write("Body.lua", BODY)
        self.write("body.soar", RULES)
        self.write("Sandbox.lua", "function Sandbox_Initialize(s) Sandbox.CreateSoarAgent(s, 'Body.lua', 'body.soar', { name = 'b' }) end")
        run = Run("run", self.folder, "--headless", "--seconds", 1)
        self.assertIn("gone", run.out)
        self.assertIn("leap: error too-high: nobody leaps so high", run.out)
        self.assertIn("no: too-high", run.out)
        view = json.loads(Run("inspect", self.folder, "--at", 1, "--agent", "b", "--view", "io", "--json").out)
        self.assertIn("steps", json.dumps(view))

    def test_what_scripts_show_is_seen_live_and_in_a_recording(self):
        shown = Run("inspect", "decisions", "--at", 3, "--view", "state").out
        self.assertIn("behavior tree", shown)
        self.assertRegex(shown, r"> \w+.*since \d")
        recording = self.folder / "flock.soarrec"
        Run("run", "sheepdog", "--headless", "--seconds", 3, "--record", recording)
        live = Run("inspect", "sheepdog", "--at", 3, "--agent", "Sheep-1", "--view", "state").out
        self.assertIn("wishes", live)
        self.assertEqual(Run("inspect", recording, "--at", 3, "--agent", "Sheep-1", "--view", "state").out, live)
        agents = json.loads(Run("inspect", "sheepdog", "--at", 3, "--view", "agents Sheep-1", "--json").out)
        self.assertIn(agents[0]["command"], ("flee", "flock", "graze"))

    def test_the_dog_brings_all_sheep_into_the_pen(self):
        run = Run("test", "sheepdog", "--seeds", "1..3")
        self.assertEqual(run.code, 0, run.out + run.err)

    def test_lua_that_is_typed_knows_the_sandbox_and_the_agent(self):
        inputs = self.write("typed.txt", "1 script sandbox #Sandbox.GetAgents(sandbox)\n2 script Sheep-1 agent:GetTeam()\n"
                                         "3 script sandbox Sandbox.Fly(sandbox)\n")
        run = Run("run", "sheepdog", "--headless", "--seconds", 1, "--input", inputs)
        self.assertRegex(run.out, r"sandbox +9\n")
        self.assertRegex(run.out, r"Sheep-1 +sheep\n")
        self.assertIn("console:1: error", run.err)

    def test_check_finds_calls_of_functions_that_nothing_defines(self):
        self.write("Sandbox.lua", 'require "Lib"\nfunction Sandbox_Update()\n    Lib_Help();\n    Lib_Hlep();\nend\n')
        self.write("Lib.lua", "function Lib_Help() end\n")
        out = Run("check", self.folder).out
        self.assertIn("Sandbox.lua:4:5: warning: nothing defines the function Lib_Hlep", out)
        self.assertIn("did you mean Lib_Help?", out)
        self.assertNotIn("Lib_Help;", out)

    def test_an_own_percept_is_not_taken_for_one_that_changes_all_the_time(self):
        rule = "sp {go*propose*go\n   (state <s> ^superstate nil ^io.input-link.%s 3)\n-->\n   (<s> ^operator <o> +)\n   (<o> ^name go)\n}\n"
        own, ours = self.write("own.soar", rule % "x"), self.write("ours.soar", rule % "time")
        self.assertNotIn("all the time", Run("check", own).out)
        self.assertIn("^time, which changes all the time", Run("check", ours).out)
