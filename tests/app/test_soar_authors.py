# SPDX-License-Identifier: BSD-2-Clause
"""Agents that consist of Soar rules only: percepts, commands, scenario files, starters."""
import math
import os
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase, run_json

FORGET = """
sp {forget*answered-command
   (state <s> ^superstate nil ^operator <o> ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^status)
-->
   (<out> ^<name> <command> -)
}
"""

SCOUT = """
sp {scout*propose*move-to
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name> ^here no)
-->
   (<s> ^operator <o> + =)
   (<o> ^name move-to ^waypoint <name>)
}
sp {scout*apply*move-to
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name move-to ^waypoint <name>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint <name>)
   (write |I go to | <name> (crlf))
}
""" + FORGET

# Gives these commands once, at the start. `{commands}`: right-hand side actions on <out>.
ONCE = """
sp {{once*propose
   (state <s> ^superstate nil -^said)
-->
   (<s> ^operator <o> +)
   (<o> ^name once)
}}
sp {{once*apply
   (state <s> ^operator.name once ^io.output-link <out>)
-->
   (<s> ^said true)
   {commands}
}}
sp {{once*tell*answer
   (state <s> ^superstate nil ^io.output-link <out>)
   (<out> ^{{ <name> <> io }} <command>)
   (<command> ^status <status>)
-->
   (write |answer: | <name> | | <status> (crlf))
}}
sp {{once*tell*reason
   (state <s> ^superstate nil ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^reason <reason>)
-->
   (write |reason: | <name> | | <reason> (crlf))
}}
"""

WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
body = "soldier"
position = [0, 0]
"""


def once(*commands):
    return ONCE.format(commands="\n   ".join(commands))


def logs(run, agent):
    return [event["text"] for event in run.of("log", agent=agent)]


class RulesAlone(ScenarioCase):
    def test_open_a_world_with_one_agent_that_perceives_and_acts(self):
        for seed in (1, 2, 3):
            run = run_json(self.write("scout.soar", SCOUT), "--seconds", 40, "--report", 1, "--seed", seed, code=0)
            self.assertEqual(run.of("agent")[0]["agent"], "scout")
            self.assertGreaterEqual(len([text for text in logs(run, "scout") if text.startswith("I go to ")]), 3)
            self.assertGreaterEqual(len(run.of("command", agent="scout", command="move-to")), 3)
            far = max(math.hypot(state["agents"][0]["position"][0], state["agents"][0]["position"][2]) for state in run.of("state"))
            self.assertGreater(far, 15)

    def test_are_the_same_run_each_time(self):
        scout = self.write("scout.soar", SCOUT)
        first, again = (Run("run", scout, "--headless", "--json", "--seconds", 20).out for _ in range(2))
        self.assertEqual(first, again)

    def test_that_are_not_there_are_an_error_that_names_them(self):
        run = Run("run", self.folder / "scot.soar", "--headless", code=3)
        self.assertIn("scot.soar", run.err)

    def test_misnamed_in_a_scenario_are_an_error_with_the_nearest_name(self):
        self.write("scout.soar", SCOUT)
        self.write("scenario.toml", '[[agent]]\nrules = "scuot.soar"\n')
        run = Run("run", self.folder, "--headless", code=3)
        self.assertIn("scuot.soar", run.err)
        self.assertIn("did you mean 'scout.soar'?", run.err)

    def test_misnamed_beside_a_script_do_not_let_the_thesis_rules_run(self):
        self.write("seekingagnet.soar", SCOUT)
        self.write("Body.lua", "function Agent_Initialize(agent) end")
        self.write("Sandbox.lua", "function Sandbox_Initialize(sandbox) Sandbox.CreateSoarSeekingAgent(sandbox, 'Body.lua') end")
        run = run_json(self.folder, "--seconds", 1, code=1)
        self.assertIn("did you mean 'seekingagnet.soar'?", run.diagnostics()[0]["hint"])
        self.assertEqual(run.of("command"), [])


class Commands(ScenarioCase):
    def run_hero(self, rules, world=WORLD, seconds=5, *more):
        self.write("hero.soar", rules)
        self.write("scenario.toml", world)
        run = run_json(self.folder, "--seconds", seconds, *more, code=0)
        return run

    def test_are_carried_out_once_though_nobody_removes_them(self):
        run = self.run_hero(once("(<out> ^say <c>) (<c> ^to hero ^about hello)"))
        self.assertEqual(len(run.of("news", news="says")), 1)
        self.assertEqual(logs(run, "hero"), ["answer: say complete"])

    def test_that_no_body_knows_get_an_error_with_the_nearest_name(self):
        run = self.run_hero(once("(<out> ^folow <c>) (<c> ^agent hero)"))
        self.assertIn("did you mean ^follow?", run.of("outcome", command="folow")[0]["text"])
        self.assertIn("reason: folow unknown-command", logs(run, "hero"))

    def test_with_bad_parameters_get_an_error_with_a_reason(self):
        run = self.run_hero(once("(<out> ^set-speed <c> ^move-to <m>) (<c> ^speed fast) (<m> ^waypoint nowhere)"))
        self.assertIn("reason: set-speed bad-value", logs(run, "hero"))
        self.assertIn("reason: move-to no-such-waypoint", logs(run, "hero"))

    def test_for_one_part_interrupt_each_other_and_others_go_on(self):
        run = self.run_hero(once("(<out> ^wander <w> ^move-to <m> ^face <f>) (<m> ^x 5 ^z 5) (<f> ^heading 90)"), seconds=10)
        answers = logs(run, "hero")
        self.assertEqual(sum("interrupted" in text for text in answers), 1, answers)
        self.assertIn("answer: face complete", answers)

    def test_move_to_goes_round_a_wall_and_arrives(self):
        wall = WORLD + '[[obstacle]]\nposition = [0, 6]\nsize = [8, 2, 0.5]\n'
        for seed in (1, 2, 3):
            run = self.run_hero(once("(<out> ^move-to <m>) (<m> ^x 0 ^z 12)"), wall, 20, "--report", 0.1, "--seed", seed)
            self.assertIn("answer: move-to complete", logs(run, "hero"))
            track = [state["agents"][0]["position"] for state in run.of("state")]
            self.assertLess(math.hypot(track[-1][0], track[-1][2] - 12), 1)
            for x, _, z in track:
                self.assertFalse(abs(x) < 4 and abs(z - 6) < 0.25, (x, z))

    def test_shots_hit_kill_and_use_up_ammunition(self):
        target = '[[agent]]\nname = "dummy"\nteam = "red"\nposition = [0, 10]\n'
        run = self.run_hero(once("(<out> ^shoot <c>) (<c> ^agent dummy ^rounds 10)"), WORLD + target, 20, "--report", 1)
        self.assertTrue(run.of("news", news="dies", agent="dummy"), run.out[-2000:])
        self.assertLessEqual(run.of("state")[-1]["agents"][1]["health"], 0)
        self.assertIn("answer: shoot complete", logs(run, "hero"))

    def test_messages_reach_the_one_they_are_for_with_their_parameters(self):
        self.write("other.soar", """
sp {other*tell
   (state <s> ^superstate nil ^io.input-link.message <m>)
   (<m> ^from <from> ^about <about> ^where <where>)
-->
   (write |heard: | <from> | | <about> | | <where> (crlf))
}""")
        world = WORLD + '[[agent]]\nname = "other"\nrules = "other.soar"\nposition = [3, 0]\n'
        run = self.run_hero(once("(<out> ^say <c>) (<c> ^to other ^about enemy ^where gate)"), world)
        self.assertEqual(logs(run, "other"), ["heard: hero enemy gate"])


class FromOutside(ScenarioCase):
    def run_hero(self, rules, inputs):
        self.write("hero.soar", rules)
        self.write("scenario.toml", WORLD)
        run = run_json(self.folder, "--seconds", 3, "--input", self.write("inputs.txt", inputs), code=0)
        return run

    def test_orders_of_a_user_are_perceived_with_their_words(self):
        run = self.run_hero("""
sp {hero*told
   (state <s> ^superstate nil ^io.input-link.order <order>)
   (<order> ^from <from> ^action <action>)
-->
   (write |ordered by | <from> |: | <action> (crlf))
}
sp {hero*propose*obey
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^order.action stroll -^path.command wander)
-->
   (<s> ^operator <o> +)
   (<o> ^name stroll)
}
sp {hero*apply*stroll
   (state <s> ^operator.name stroll ^io.output-link <out>)
-->
   (<out> ^wander <c>)
}""", "30 order hero stroll\n")
        self.assertEqual(logs(run, "hero"), ["ordered by user: stroll"])
        self.assertEqual([event["tick"] for event in run.of("command", command="wander")], [30])

    def test_a_trace_that_a_debugger_asked_for_is_not_in_the_agents_log(self):
        run = self.run_hero(SCOUT.replace("I go to ", "off to ") + """
sp {hero*say
   (state <s> ^superstate nil ^io.input-link.time <t>)
-->
   (write |it is | <t> (crlf))
}""", "10 command hero watch 5\n")
        self.assertGreater(len(logs(run, "hero")), 20)
        self.assertTrue(all(text.startswith("it is ") for text in logs(run, "hero")), logs(run, "hero"))


class Perception(ScenarioCase):
    WATCH = """
sp {watch*seen
   (state <s> ^superstate nil ^io.input-link.agent <a>)
   (<a> ^name <name> ^visible <visible> ^relation <relation>)
-->
   (write |agent: | <name> | | <relation> | | <visible> (crlf))
}"""

    def watch(self, extra, senses=""):
        self.write("hero.soar", self.WATCH)
        self.write("scenario.toml", WORLD + senses + "[[agent]]\nname = \"other\"\nteam = \"red\"\n" + extra)
        run = run_json(self.folder, "--seconds", 2, code=0)
        return logs(run, "hero")

    def test_sees_who_is_in_view(self):
        self.assertEqual(self.watch("position = [0, 10]\n"), ["agent: other enemy yes"])

    def test_sees_nobody_behind_a_wall_behind_its_back_or_too_far(self):
        wall = "[[obstacle]]\nposition = [0, 5]\nsize = [6, 3, 0.5]\n"
        self.assertEqual(self.watch("position = [0, 10]\n" + wall), [])
        self.assertEqual(self.watch("position = [0, -10]\n"), [])
        self.assertEqual(self.watch("position = [0, 30]\n", "senses = { sight = 20 }\n"), [])

    def test_looks_only_with_the_senses_that_its_author_chose(self):
        self.assertEqual(self.watch("position = [0, 10]\n", 'senses = { only = ["self"] }\n'), [])


class LuaScenarios(ScenarioCase):
    def test_add_percepts_and_get_parameters(self):
        self.write("Lamp.lua", """
function Agent_Sense(agent) return { lamp = { on = true, level = 3, spots = { 1, 2 } } } end
function Agent_Update(agent, dt, command, parameters)
    if command then print(command .. " " .. tostring(parameters.level) .. " " .. parameters.how.fast) end
end""")
        self.write("lamp.soar", """
sp {lamp*propose (state <s> ^superstate nil -^said ^io.input-link.lamp <l>) (<l> ^on yes ^level <n> ^spots 1 ^spots 2)
--> (<s> ^operator <o> +) (<o> ^name shine ^level <n>)}
sp {lamp*apply (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name shine ^level <n>)
--> (<s> ^said true) (<out> ^shine <c>) (<c> ^level <n> ^how <h>) (<h> ^fast very)}""")
        self.write("Sandbox.lua", "function Sandbox_Initialize(s) Sandbox.CreateSoarAgent(s, 'Lamp.lua', 'lamp.soar', {name = 'lamp'}) end")
        run = run_json(self.folder, "--seconds", 2, code=0)
        self.assertEqual([event["text"] for event in run.of("log")], ["Lamp.lua: shine 3 very"])

    def test_make_agents_without_a_script_and_learn_of_unknown_options(self):
        self.write("scout.soar", SCOUT)
        make = "function Sandbox_Initialize(s) Sandbox.CreateSoarAgent(s, {rules = 'scout.soar', %s}) end"
        self.write("Sandbox.lua", make % "name = 'anna', body = 'soldier', team = 'blue', position = Vector.new(3, 0, 4)")
        run = run_json(self.folder, "--seconds", 1, "--report", 1, code=0)
        first = run.of("state")[0]["agents"][0]
        self.assertEqual((first["name"], round(first["position"][0]), round(first["position"][2])), ("anna", 3, 4))
        self.write("Sandbox.lua", make % "bodi = 'soldier'")
        run = run_json(self.folder, "--seconds", 1, code=1)
        self.assertIn("did you mean 'body'?", run.diagnostics()[0]["hint"])


class ScenarioFiles(ScenarioCase):
    def test_tell_what_is_wrong_with_line_and_suggestion(self):
        for text, message, hint in (
            ('sead = 3\n', "a scenario has no 'sead'", "did you mean 'seed'?"),
            ('[[agent]]\nbody = "soldir"\n', "there is no body 'soldir'", "did you mean 'soldier'?"),
            ('[[waypoint]]\nposition = [1]\n', "'position' takes [x, z]", ""),
            ('[[agent]\n', "", "TOML"),
            ('[[agent]]\nname = "x"\n[[end]]\nagent = "x"\nregion = "y"\n', "there is no region 'y'", ""),
        ):
            self.write("scenario.toml", text)
            run = Run("run", self.folder, "--headless", "--seconds", 1, code=3)
            self.assertIn("scenario.toml:", run.err)
            self.assertIn(message, run.err)
            self.assertIn(hint, run.err)

    def test_end_a_headless_run(self):
        self.write("scenario.toml", '[[end]]\nname = "time is up"\nafter = 2\n')
        run = run_json(self.folder)
        self.assertEqual(run.of("reached")[0]["text"], "time is up")
        self.assertLess(run.of("end")[0]["time"], 2.1)


class Starters(ScenarioCase):
    def test_pass_their_own_tests(self):
        for kind in ((), ("--lua",), ("--team",)):
            folder = self.folder / ("my" + "".join(kind))
            Run("new", folder, *kind, code=0)
            Run("check", folder, code=0)
            Run("test", folder, "--no-keep", code=0)

    def test_of_a_scripted_world_says_its_command_once(self):
        folder = self.folder / "stroller"
        self.assertEqual(Run("new", folder, "--lua").code, 0)
        run = run_json(folder, "--seconds", 1)
        self.assertEqual(len(run.of("command", agent="stroller", command="wander")), 1, run.out)

    def test_tell_the_next_steps_as_they_are_to_be_typed(self):
        for called, command in (("", "soarbox"), ("./dev soarbox", "./dev soarbox")):
            with self.subTest(called):
                name = "a" if called else "b"
                done = subprocess.run([COMMAND, "new", name], cwd=self.folder, capture_output=True, text=True, check=True,
                                      env=dict(os.environ, SOARBOX_CALLED_AS=called))
                self.assertIn(f"run it:   {command} run {name}\n", done.stdout)
                self.assertIn(f"test it:  {command} test {name}\n", done.stdout)

    def test_overwrite_nothing(self):
        self.assertEqual(Run("new", self.folder).code, 3)

    def test_take_no_name_that_gives_two_files_the_same_name(self):
        for name in ("lamp", "Lamp"):
            run = Run("new", self.folder / name, "--lua", code=3)
            self.assertIn(f"'lamp.soar' and 'stroller.soar' would both become '{name}.soar'", run.err)
            self.assertIn("choose another name", run.err)
            self.assertFalse((self.folder / name).exists())
        Run("new", self.folder / "lamp", code=0)

    def test_leave_no_folder_if_a_file_of_them_cannot_be_read(self):
        data = self.folder / "data"
        (data / "scenarios").mkdir(parents=True)
        team = data / "media" / "starters" / "two_teams"
        team.mkdir(parents=True)
        (team / "fighter.soar").touch()
        os.truncate(team / "fighter.soar", 2 << 30)  # Larger than files that the program reads.
        for kind, message in (((), "this folder cannot be read"), (("--team",), "fighter.soar: error: this file cannot be read")):
            run = Run("new", self.folder / "mine", *kind, code=3, variables={"SOARBOX_DATA": str(data)})
            self.assertIn(message, run.err)
            self.assertFalse((self.folder / "mine").exists())


class Listing(unittest.TestCase):
    def test_describes_each_scenario_in_a_line(self):
        lines = Run("list").out.splitlines()
        self.assertTrue(all(len(line.split(None, 1)) == 2 for line in lines), lines)
