# SPDX-License-Identifier: BSD-2-Clause
"""Worlds from Python: time, agents, percepts, commands, reasons, rules, and errors."""
import os
import pathlib
import subprocess
import tempfile
import unittest
from unittest import mock

import soarbox

GO = """sp {go
   (state <s> ^superstate nil ^io.output-link <out>)
-->
   (<out> ^move-to <m>)
   (<m> ^x 5 ^z 0)}
"""


def story(seed, steps):
    """The ticks, percepts and decisions of a world, as Python reports them."""
    with soarbox.World("soar_hallway", seed=seed) as world:
        seen = []
        for ticks in steps:
            world.step(ticks)
            seen.append((world.tick, [repr(agent.percepts) for agent in world], [agent.decisions for agent in world]))
        return seen


class Time(unittest.TestCase):
    def test_a_world_stands_still_until_it_is_stepped(self):
        with soarbox.World("soar_hallway", seed=3) as world:
            self.assertEqual((world.tick, world.seed), (0, 3))
            world.why("anna")
            self.assertEqual(world.tick, 0)
            world.step()
            self.assertEqual(world.tick, 1)
            world.step(0)
            world.run(seconds=2)
            self.assertEqual(world.tick, 61)
            self.assertAlmostEqual(world.time, 61 / 30, places=5)

    def test_the_same_seed_gives_the_same_run_however_it_is_stepped(self):
        self.assertEqual(story(5, [1, 1, 58])[-1], story(5, [60])[-1])

    def test_it_is_the_run_that_the_command_makes(self):
        with soarbox.World("soar_hallway", seed=3) as world:
            world.step(60)
            z = world["anna"].percepts["self"]["position"]["z"]
        shown = subprocess.run([os.environ["SOARBOX"], "inspect", "soar_hallway", "--seed", "3", "--agent", "anna", "--at",
                                "2", "--view", "io"], capture_output=True, text=True, check=True).stdout
        self.assertRegex(shown, rf"\^z {z}(0+)?\b")

    def test_a_game_goes_on_turn_by_turn(self):
        with soarbox.World("eaters", seed=3) as world:
            self.assertEqual(world.turn_ticks, 10)
            world.step_turns()
            self.assertEqual(world.tick, 10)
            world.step(3)
            world.step_turns(2)
            self.assertEqual(world.tick, 30)
            world.step_turns(0)
            self.assertEqual(world.tick, 30)
            with self.assertRaises(TypeError):
                world.step_turns(-1)
        with soarbox.World("soar_hallway", seed=3) as world:
            world.step_turns(2)
            self.assertEqual((world.turn_ticks, world.tick), (1, 2))

    def test_amounts_of_time_that_are_none_are_refused(self):
        with soarbox.World("soar_hallway") as world:
            for ticks in (-1, 1.5, "3", None, True):
                with self.assertRaises(TypeError):
                    world.step(ticks)
            for seconds in (-1.0, float("nan")):
                with self.assertRaises(ValueError):
                    world.run(seconds)
            self.assertEqual(world.tick, 0)


class Agents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.world = soarbox.World("soar_hallway", seed=3)
        cls.world.step(30)

    @classmethod
    def tearDownClass(cls):
        cls.world.close()

    def test_agents_are_found_by_name(self):
        self.assertEqual(list(self.world.agents), ["anna", "bert"])
        self.assertEqual(len(self.world), 2)
        with self.assertRaisesRegex(KeyError, "there is no agent 'carl'; there are: anna, bert"):
            self.world["carl"]
        with self.assertRaises(KeyError):
            self.world.why("carl")

    def test_what_is_seen_of_an_agent_is_a_value(self):
        anna, bert = self.world["anna"], self.world["bert"]
        self.assertEqual((anna.alive, anna.health, anna.team, anna.has_mind), (True, 100.0, "team1", True))
        self.assertGreater(anna.decisions, 0)
        self.assertTrue(anna.operator.startswith("go"))
        self.assertEqual((anna.percepts["self"]["name"], bert.percepts["self"]["name"]), ("anna", "bert"))
        self.assertIsInstance(anna.percepts["self"]["speed"], float)
        self.assertEqual({each["name"] for each in anna.percepts.all("object")}, {"wall-east", "wall-west"})
        self.assertEqual(anna.percepts.all("nothing"), [])
        with self.assertRaises(KeyError):
            anna.percepts["nothing"]
        [command] = anna.commands
        self.assertEqual((command.name, command.parameters["waypoint"]), ("move-to", "north"))
        self.assertEqual(anna.output["move-to"]["waypoint"], "north")

    def test_reasons_are_a_tree(self):
        reasons = self.world["anna"].why()
        self.assertEqual(reasons.kind, "agent")
        self.assertTrue(reasons.find("passer*apply*go"))
        self.assertIn("\n  command move-to", str(reasons))
        with self.assertRaises(soarbox.WorldError):
            self.world.why("anna", "no such question")


class Rules(unittest.TestCase):
    def test_rules_become_a_world(self):
        with soarbox.World(rules=GO, seed=1) as world:
            world.step(10)
            [agent] = world
            self.assertEqual(agent.commands[0].name, "move-to")

    def test_errors_say_where_and_what_to_do(self):
        with self.assertRaises(soarbox.RuleError) as raised:
            soarbox.World(rules=GO + "sp {a (state <s> ^x) --> (<s> ^y <z>}\n")
        self.assertEqual((raised.exception.line, raised.exception.file), (6, "rules.soar"))
        self.assertIn("never closed", raised.exception.hint)
        self.assertEqual(raised.exception.diagnostics[0].severity, "error")

    def test_warnings_are_returned(self):
        self.assertEqual(soarbox.check_text(GO), [])
        [warning] = soarbox.check_text(GO.replace("move-to", "moev-to"))
        self.assertEqual((warning.severity, warning.line), ("warning", 4))

    def test_files_are_checked(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scout.soar"
            file.write_text("sp {a", encoding="utf-8")
            with self.assertRaises(soarbox.RuleError) as raised:
                soarbox.check(file)
            self.assertEqual(raised.exception.file, str(file))
            with self.assertRaises(soarbox.RuleError):
                soarbox.check(pathlib.Path(folder) / "nowhere.soar")
        with self.assertRaises(ValueError):
            soarbox.check()


class Tables(unittest.TestCase):
    def test_a_recording_is_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "run.soarrec"
            soarbox.record("soar_hallway", file, seconds=1, seed=3)
            table = soarbox.recording(file)
            self.assertEqual(len(soarbox.recording(file, start=0.5, end=0.6)), 2 * 4)
        self.assertEqual({row["agent"] for row in table}, {"anna", "bert"})
        ticks = table.column("tick")
        self.assertEqual((len(set(ticks)), len(table)), (max(ticks) + 1, 2 * (max(ticks) + 1)))

    def test_a_sweep_is_a_table(self):
        with tempfile.TemporaryDirectory() as folder:
            spec = pathlib.Path(folder) / "two.toml"
            spec.write_text('scenario = "soar_hallway"\nseeds = "1..2"\nseconds = 1\n[[variant]]\nname = "as it is"\n',
                            encoding="utf-8")
            table = soarbox.sweep(spec)
        self.assertEqual([(row["variant"], row["seed"]) for row in table], [("as it is", 1), ("as it is", 2)])

    def test_frames_are_for_those_who_have_pandas(self):
        table = soarbox.Table([{"a": 1}, {"a": 2}])
        with mock.patch.dict("sys.modules", {"pandas": mock.Mock(DataFrame=lambda rows: ("frame", rows))}):
            self.assertEqual(table.frame(), ("frame", [{"a": 1}, {"a": 2}]))
        with mock.patch.dict("sys.modules", {"pandas": None}), self.assertRaisesRegex(ImportError, "python3-pandas"):
            table.frame()

    def test_what_cannot_be_run_says_why(self):
        with self.assertRaisesRegex(soarbox.CommandError, "nowhere"):
            soarbox.record("nowhere", "/tmp/never.soarrec", seconds=1)
        with self.assertRaises(soarbox.CommandError):
            soarbox.recording("/nowhere.soarrec")
        with self.assertRaises(soarbox.CommandError):
            soarbox.sweep("/nowhere.toml")


class Mistakes(unittest.TestCase):
    def test_a_scenario_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(soarbox.WorldError, "there is no scenario 'nowhere'"):
            soarbox.World("nowhere")

    def test_arguments_are_checked(self):
        for arguments in ({}, {"scenario": "thesis", "rules": "x"}, {"scenario": "thesis", "seed": "3"},
                          {"scenario": "thesis", "seed": -1}, {"scenario": 3}):
            with self.assertRaises(TypeError):
                soarbox.World(**arguments)

    def test_a_closed_world_says_so(self):
        world = soarbox.World("soar_hallway")
        agent = world["anna"]
        world.close()
        world.close()
        for call in (world.step, lambda: world.tick, lambda: world.why("anna"), lambda: agent.health):
            with self.assertRaisesRegex(soarbox.WorldEnded, "closed"):
                call()

    def test_a_process_that_dies_is_an_exception(self):
        world = soarbox.World("soar_hallway")
        world._engine._process.kill()
        world._engine._process.wait()
        with self.assertRaises(soarbox.WorldEnded):
            world.step()
        world.close()

    def test_a_command_that_is_not_there_is_named(self):
        with mock.patch.dict(os.environ, {"SOARBOX": "/nowhere/soarbox"}):
            with self.assertRaisesRegex(soarbox.CommandError, "/nowhere/soarbox"):
                soarbox.World("soar_hallway")
            with self.assertRaises(soarbox.CommandError):
                soarbox.check_text(GO)


if __name__ == "__main__":
    unittest.main()
