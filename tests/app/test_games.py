# SPDX-License-Identifier: BSD-2-Clause
"""Board games: the percepts of each turn equal the stored ones, our agents play to the end, and --rules works."""
import json
import os
import pathlib
import re
import shlex

from soarbox_command import Run, ScenarioCase, page_missing, run_json

GOLDEN = pathlib.Path(__file__).parent / "games"
TURNS = 6
TICKS_PER_TURN = 10

NORTH = """
sp {north*propose
   (state <s> ^io.input-link.eater <e>)
   (<e> ^x <x> ^y <y>)
-->
   (<s> ^operator.name north)}
sp {north*apply
   (state <s> ^operator.name north ^io.output-link <out>)
-->
   (<out> ^move.direction north)}
"""


class Games(ScenarioCase):
    def percepts(self, scenario, *arguments):
        """The percepts and commands of the minds in the first turns, as text."""
        recording = self.folder / "game.soarrec"
        seconds = TURNS * TICKS_PER_TURN / 30
        run_json(scenario, "--seconds", seconds, "--record", recording, *arguments, code=0)
        exported = Run("export", recording, "--json", code=0)
        lines = []
        for line in exported.out.splitlines():
            tick = json.loads(line)
            for mind in tick.get("minds", []):
                told = mind.get("percepts", []) + mind.get("commands", [])
                if not told:
                    continue
                lines.append(f"turn {(tick['tick'] - 1) // TICKS_PER_TURN + 1} {mind['agent']}")
                lines += [f"  {one if isinstance(one, str) else json.dumps(one)}" for one in told]
        return "\n".join(lines) + "\n"

    def test_the_first_turns_are_as_they_were(self):
        for scenario in ("eaters", "simple-eaters", "tanksoar"):
            with self.subTest(scenario=scenario):
                found = self.percepts(scenario, "--seed", 4)
                golden = GOLDEN / f"{scenario}.txt"
                if "SOARBOX_NEW_GOLDEN" in os.environ:
                    golden.write_text(found)
                self.assertEqual(found, golden.read_text())

    def test_agents_of_all_strengths_play_without_a_problem(self):
        for scenario, seat, agents in (("eaters", "eater", ("wanderer", "greedy", "learner")),
                                       ("simple-eaters", "eater", ("wanderer", "seeker", "learner")),
                                       ("tanksoar", "tank", ("wanderer", "hunter", "learner"))):
            folder = pathlib.Path(__file__).parents[2] / "scenarios" / scenario
            for agent in agents:
                with self.subTest(scenario=scenario, agent=agent):
                    run = run_json(scenario, "--seconds", 40, "--rules", f"{seat}={folder / agent}.soar", code=0)
                    self.assertEqual(run.diagnostics(), [])
                    self.assertGreater(len(run.of("command", agent=seat)), 3)

    def test_a_game_ends_when_all_is_eaten(self):
        self.write("Board.lua", 'require "Eaters";\nEaters.Settings = { map = { "1..*" } };\n')
        self.write("scenario.toml", 'script = "Board.lua"\n[[agent]]\nname = "eater"\nrules = "east.soar"\nby = "sandbox"\n')
        self.write("east.soar", NORTH.replace("north", "east"))
        run = run_json(self.folder)
        self.assertEqual([event["text"] for event in run.of("reached")], ["all is eaten"])

    def test_other_rules_take_the_place_of_an_agents_own(self):
        rules = self.write("north.soar", NORTH)
        run = run_json("eaters", "--seconds", 5, "--rules", f"eater={rules}")
        self.assertEqual({event["parameters"] for event in run.of("command", agent="eater")}, {"^direction north"})

    def test_a_tank_of_the_tutorial_drives_with_the_rules_of_the_page_that_name_the_top_state(self):
        page = (pathlib.Path(__file__).parents[2] / "docs" / "tanksoar.md").read_text(encoding="utf-8")
        named = re.search(r"```soar\n(.*?)```", page, re.S)[1]
        turns = """
sp {tanksoar*propose*turn
   (state <s> ^name tanksoar ^io.input-link.clock <n>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name turn ^clock <n>)}
sp {tanksoar*apply*turn
   (state <s> ^operator.name turn ^io.output-link <out>)
-->
   (<out> ^rotate.direction left)}
"""
        for rules, moves in ((turns, False), (named + turns, True)):
            run = run_json("tanksoar", "--seconds", 5, "--rules", f"tank={self.write('tank.soar', rules)}")
            self.assertEqual(bool(run.of("command", agent="tank")), moves)

    def test_a_recording_of_other_rules_is_verified(self):
        rules = self.write("north.soar", NORTH)
        recording = self.folder / "run.soarrec"
        run_json("eaters", "--seconds", 5, "--rules", f"eater={rules}", "--record", recording, code=0)
        Run("verify", recording, code=0)
        # The recording contains them, even if the file changes.
        rules.write_text(NORTH.replace("direction north", "direction south"))
        self.assertEqual(Run("verify", recording, "--as-recorded").code, 0)

    def test_a_slip_in_the_option_is_told(self):
        rules = self.write("north.soar", NORTH)
        for word, told in ((f"eatr={rules}", "did you mean 'eater'?"), ("eater", "--rules takes NAME=FILE"),
                           ("eater=nowhere.soar", "there is no such file of rules")):
            with self.subTest(word=word):
                run = Run("run", "eaters", "--headless", "--seconds", 1, "--rules", word)
                self.assertNotEqual(run.code, 0)
                self.assertIn(told, run.err)

    def test_a_faulty_board_is_told_with_its_line(self):
        self.write("Board.lua", 'require "Eaters";\nEaters.Settings = { map = { "1..", ".?." } };\n')
        self.write("scenario.toml", 'script = "Board.lua"\n[[agent]]\nname = "eater"\nrules = "north.soar"\nby = "sandbox"\n')
        self.write("north.soar", NORTH)
        run = run_json(self.folder, "--seconds", 1)
        self.assertIn("line 2 of the map has '?'", run.out + run.err)

    def test_maps_of_the_former_program_are_played(self):
        agent = '[[agent]]\nname = "eater"\nby = "sandbox"\nrules = "any.soar"\n'
        self.write("scenario.toml", 'script = "Board.lua"\n' + agent)
        self.write("any.soar", "sp {any*propose*move\n   (state <s> ^io.input-link.my-location.east.content bonusfood)\n-->\n"
                   "   (<s> ^operator <o> +)\n   (<o> ^name east)}\n"
                   "sp {any*apply*east\n   (state <s> ^operator.name east ^io.output-link <out>)\n-->\n"
                   "   (<out> ^move.direction east)}\n")
        self.write("Board.lua", 'require "Eaters";\nEaters.Settings = { mapFile = "small.cnf" };\n')
        self.write("small.cnf", 'general { game = "eaters"; map = "config/maps/small.txt"; }\n')
        rows = "cells {\n size = 4;\n rows {\n  0 = [w,w,w,w];\n  1 = [w,-,%s,w];\n  2 = [w,w,w,w];\n  3 = [w,w,w,w];\n }\n}\n"
        self.write("small.txt", rows % "b")
        played = [run_json(self.folder, "--seconds", 2, "--seed", seed) for seed in (1, 2, 3, 4)]
        self.assertTrue(any("all is eaten" in run.out for run in played), played[0].out + played[0].err)
        self.write("small.txt", rows % "cake")
        refused = run_json(self.folder, "--seconds", 1)
        told = [line for line in map(json.loads, refused.out.splitlines()) if line["event"] == "diagnostic"]
        self.assertEqual(len(told), 1, refused.out)
        self.assertIn("the object 'cake' is not described", told[0]["diagnostic"]["message"])
        self.assertEqual(told[0]["diagnostic"]["line"], 5)
        (self.folder / "small.txt").unlink()
        missing = run_json(self.folder, "--seconds", 1)
        self.assertIn("small.txt", missing.out + missing.err)

    def test_what_a_game_refuses_is_told_once_with_what_there_is(self):
        rules = self.write("strange.soar", """
            sp {go
               (state <s> ^io.input-link.random <r>)
            -->
               (<s> ^operator <o> + =)
               (<o> ^name go ^random <r>)}
            sp {apply*go
               (state <s> ^operator <o> ^io.output-link <out>)
               (<o> ^name go ^random <r>)
            -->
               (<out> ^mvoe.direction north ^move.direction nroth ^jump.where north ^dont-eat <d> ^move <m1> <m2>)
               (<m1> ^direction north)
               (<m2> ^direction south)}
            """)
        run = run_json("eaters", "--seconds", 3, "--rules", f"eater={rules}")
        told = sorted(event["text"] for event in run.of("outcome", agent="eater"))
        self.assertEqual(told, [
            "error no-such-direction: ^direction of ^move is nroth: did you mean north?",
            "error no-such-direction: ^jump requires ^direction (north, east, south, west), and has ^where",
            "error one-move-a-turn: it has given a move or a jump in this turn",
            "error unknown-command: there is no command ^mvoe: did you mean move?"])

    def test_what_a_tank_cannot_do_is_told(self):
        rules = self.write("strange.soar", """
            sp {go
               (state <s> ^io.input-link.clock <c>)
            -->
               (<s> ^operator <o> + =)
               (<o> ^name go ^clock <c>)}
            sp {apply*go
               (state <s> ^operator <o> ^io.output-link <out>)
               (<o> ^name go ^clock <c>)
            -->
               (<out> ^radar-power.setting 99 ^radar.switch maybe ^sheilds.switch on ^fire.weapon missile
                      ^move.direction forward ^rotate.direction left)}
            """)
        run = run_json("tanksoar", "--seconds", 8, "--rules", f"tank={rules}")
        told = sorted(event["text"] for event in run.of("outcome", agent="tank"))
        self.assertEqual(told, [
            "complete: a radar's power is 0 to 14: it is set to 14", "complete: it has no missiles",
            "error move-or-rotate: a tank that rotates does not move in that turn",
            "error no-such-switch: ^switch of ^radar is maybe: it takes on, off",
            "error unknown-command: there is no command ^sheilds: did you mean shields?"])

    def test_boards_of_tanks_are_ours_or_made_by_the_seed(self):
        for board in ("halls", "lanes", "random"):
            runs = [run_json(f"tanksoar/{board}", "--seconds", 20, "--seed", seed) for seed in (1, 1, 2)]
            for run in runs:
                self.assertEqual(run.code, 0, run.err)
                self.assertEqual(run.diagnostics(), [])
            self.assertEqual(runs[0].out, runs[1].out)
            self.assertNotEqual(runs[0].out, runs[2].out)

    def test_agents_open_the_boxes_of_a_map_of_xml(self):
        self.write("scenario.toml", 'script = "Board.lua"\nturn = 10\n[[agent]]\nname = "eater"\nby = "sandbox"\nrules = "open.soar"\n')
        self.write("Board.lua", 'require "Eaters";\nEaters.Settings = { mapFile = "boxes.emap" };\n')
        wall = "<cell><object>wall</object></cell>"
        self.write("boxes.emap", '<map>\n<cell-object name="wall"><property name="block" value="true"/></cell-object>\n'
                   '<cell-object name="chest"><property name="box" value="true"/>'
                   '<apply><property name="points" value="20"/></apply></cell-object>\n'
                   f'<cells world-size="4">\n<row>{wall * 4}</row>\n<row>{wall}<cell/><cell><object>chest</object></cell>{wall}</row>\n'
                   f'<row>{wall * 4}</row>\n<row>{wall * 4}</row>\n</cells></map>\n')
        self.write("open.soar", """
            sp {propose*open
               (state <s> ^io.input-link.my-location.box <b>)
               (<b> -^status open)
            -->
               (<s> ^operator <o> + >)
               (<o> ^name open)}
            sp {apply*open
               (state <s> ^operator.name open ^io.output-link <out>)
            -->
               (<out> ^open <o>)}
            sp {propose*go
               (state <s> ^io.input-link.my-location.<way>.box <b>)
            -->
               (<s> ^operator <o> + =)
               (<o> ^name go ^way <way>)}
            sp {apply*go
               (state <s> ^operator <o> ^io.output-link <out>)
               (<o> ^name go ^way <way>)
            -->
               (<out> ^move.direction <way>)}
            """)
        run = run_json(self.folder, "--seconds", 5)
        self.assertEqual([event["text"] for event in run.of("reached")], ["all boxes are open"], run.out + run.err)

    def test_four_play_a_tournament(self):
        seat = '[[agent]]\nname = "eater"\nby = "sandbox"\nrules = "still.soar"\n'
        world = self.folder / "world"
        world.mkdir()
        (world / "scenario.toml").write_text('script = "Board.lua"\n' + seat * 4)
        (world / "Board.lua").write_text('require "Eaters";\nEaters.Settings = { map = { "...#...", "1.3#2.4", "...#..." } };\n')
        (world / "still.soar").write_text("")
        self.write("still.soar", "# Does nothing.\n")
        for way in ("north", "south", "east", "west"):
            self.write(f"{way}.soar", NORTH.replace("north", way))
        spec = self.write("cup.toml", 'scenario = "world"\nseeds = "1..2"\nseconds = 2\n[tournament]\n'
                          'seats = ["eater", "eater-2", "eater-3", "eater-4"]\nagents = { still = "still.soar", '
                          'north = "north.soar", south = "south.soar", east = "east.soar", west = "west.soar" }\n')
        played = Run("sweep", spec, code=0)
        # Each four of the five, with each of them once in each seat: 5 * 4 games, with two seeds.
        self.assertIn("40 runs made", played.err)
        head, *rows = [line.split() for line in played.out.splitlines()[:6]]
        self.assertEqual(head[-5:], ["lost", "place", "points", "per", "game"])
        table = {row[0]: row for row in rows}
        # An eater that goes west runs into walls and loses points; one that does not move loses none.
        self.assertEqual((rows[0][0], rows[-1][0]), ("still", "west"), played.out)
        self.assertEqual(sorted(table), ["east", "north", "south", "still", "west"])
        for row in rows:
            self.assertEqual((row[5], sum(map(int, row[6:9]))), ("32", 32), played.out)
            self.assertTrue(1 <= float(row[9]) <= 4, played.out)
        with self.subTest("report"):
            if page_missing():
                self.skipTest(page_missing())
            Run("report", spec, "-o", self.folder / "cup.html", code=0)
            text = (self.folder / "cup.html").read_text()
            self.assertIn('"standings":[{"agent":"', text)
            self.assertIn("score of eater-4", text)
        for slip, told in (('seats = ["eater", "eater-2", "eater"]', "a tournament has 2 to 8 seats"),
                           ('seats = ["eater", "eater-2", "eater-3", "eater-9"]', "there is no agent 'eater-9'")):
            faulty = self.write("faulty.toml", re.sub("seats = .*", slip, spec.read_text()))
            refused = Run("sweep", faulty)
            self.assertNotEqual(refused.code, 0, refused.out)
            self.assertIn(told, refused.err)
        few = self.write("few.toml", spec.read_text().replace('south = "south.soar", east = "east.soar", west', 'west'))
        self.assertIn("there are 4 seats and 3 agents", Run("sweep", few).err)

    def test_agents_play_a_tournament(self):
        seat = '[[agent]]\nname = "eater"\nby = "sandbox"\nrules = "still.soar"\n'
        world = self.folder / "world"
        world.mkdir()
        (world / "scenario.toml").write_text('script = "Board.lua"\n' + seat + seat)
        board = 'require "Eaters";\nEaters.Settings = { map = { "...#...", "...#...", "1..#2.." } };\n'
        (world / "Board.lua").write_text(board)
        (world / "still.soar").write_text("")
        self.write("north.soar", "source north/rules.soar\n")
        (self.folder / "north").mkdir()
        (self.folder / "north" / "rules.soar").write_text(NORTH)
        self.write("still.soar", "# Does nothing.\n")
        self.write("east.soar", NORTH.replace("north", "east"))
        spec = self.write("cup.toml", 'scenario = "world"\nseeds = "1..2"\nseconds = 3\n'
                          '[tournament]\nseats = ["eater", "eater-2"]\nagents = '
                          '{ still = "still.soar", north = "north.soar", east = "east.soar" }\n')
        played = Run("sweep", spec, code=0)
        self.assertIn("12 runs made", played.err)
        table = [line.split() for line in played.out.splitlines()[1:4]]
        self.assertEqual(table[-1][0], "still", played.out)
        self.assertEqual(table[-1][5:9], ["8", "0", "0", "8"], played.out)
        self.assertEqual(table[0][5:9], ["8", "4", "4", "0"], played.out)
        self.assertGreater(int(table[0][1]), 1550)
        self.assertIn("score of eater-2", (self.folder / "cup.sweep" / "results.csv").read_text())
        with self.subTest("plots"):
            Run("report", spec, "--plots", self.folder / "plots", code=0)
            self.assertTrue((self.folder / "plots" / "ratings.png").is_file())
        with self.subTest("report"):
            if page_missing():
                self.skipTest(page_missing())
            Run("report", spec, "-o", self.folder / "cup.html", code=0)
            text = (self.folder / "cup.html").read_text()
            data = json.loads(re.search(r'<script type="application/json" id="data"[^>]*>(.*?)</script>', text, re.S)[1])[0]
            # The names of games have blanks; the command can be copied.
            command = shlex.split(data["command"])
            self.assertEqual(command[:2], ["soarbox", "run"])
            Run(*command[1:], "--headless", "--seconds", 1, code=0)
        for slip, told in (('seats = ["eater"]', "a tournament has 2 to 8 seats"),
                           ('seats = ["eater", "eater-3"]', "there is no agent 'eater-3'")):
            faulty = self.write("faulty.toml", spec.read_text().replace('seats = ["eater", "eater-2"]', slip))
            refused = Run("sweep", faulty)
            self.assertNotEqual(refused.code, 0, refused.out)
            self.assertIn(told, refused.err)

    def test_rules_for_a_game_can_be_checked_alone(self):
        scenarios = pathlib.Path(__file__).resolve().parents[2] / "scenarios"
        self.write("drive.soar", (scenarios / "tanksoar" / "drive.soar").read_text(encoding="utf-8"))
        for scenario, rules in (("tanksoar", "hunter.soar"), ("eaters", "wanderer.soar")):
            alone = self.write(rules, (scenarios / scenario / rules).read_text(encoding="utf-8"))
            self.assertIn("0 errors, 0 warnings", Run("check", alone, code=0).out)
        # No game has this command.
        drive = (scenarios / "tanksoar" / "drive.soar").read_text(encoding="utf-8")
        self.assertIn("rotate", drive)
        self.write("drive.soar", drive.replace("rotate", "rotat"))
        alone = self.folder / "hunter.soar"
        self.assertIn("these rules seem to be written for another world", Run("check", alone).out)

    def test_a_script_that_is_not_there_is_told(self):
        self.write("scenario.toml", 'script = "Bord.lua"\n[[agent]]\nname = "eater"\nby = "sandbox"\n')
        run = Run("run", self.folder, "--headless", "--seconds", 1)
        self.assertNotEqual(run.code, 0)
        self.assertIn("there is no script 'Bord.lua'", run.err)

    def test_each_step_with_tanks_is_graded_as_it_should(self):
        self.assertIn("soarbox learn tanks lists another course", Run("learn").out)
        self.assertIn(" 4  Attack what the radar shows", Run("learn", "tanks").out)
        tested = Run("learn", "tanks", "test", code=0)
        self.assertEqual(len(re.findall("solution: as it should", tested.out)), 8)
        self.assertGreaterEqual(len(re.findall("wrong/.*: as it should", tested.out)), 30)

    def test_each_step_of_the_course_is_graded_as_it_should(self):
        listed = Run("learn", "eaters", code=0)
        self.assertIn(" 8  Jump and move, by value", listed.out)
        self.assertIn("soarbox learn eaters N begins a lesson, soarbox learn eaters next begins the first that is not done", listed.out)
        self.assertIn("soarbox learn eaters lists another course", Run("learn").out)
        tested = Run("learn", "eaters", "test", code=0)
        self.assertEqual(len(re.findall("solution: as it should", tested.out)), 8)
        self.assertGreaterEqual(len(re.findall("wrong/.*: as it should", tested.out)), 32)

    def test_the_files_of_a_step_lead_back_to_the_course(self):
        begun = Run("learn", "eaters", "3", "--folder", self.folder, "--headless", code=0)
        self.assertIn("Grade: soarbox learn eaters check 3", begun.out)
        self.assertTrue((self.folder / "e3-move-north" / "Board.lua").is_file())
        graded = Run("learn", "eaters", "check", "3", "--folder", self.folder, code=1)
        self.assertRegex(graded.out, r"operator move-north is selected in S\d+ and no rule applies it")

    def test_missions_ask_for_scores(self):
        for scenario in ("eaters", "tanksoar", "simple-eaters"):
            Run("test", scenario, "--seeds", "1", "--no-keep", code=0)
