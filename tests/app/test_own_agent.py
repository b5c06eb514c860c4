# SPDX-License-Identifier: BSD-2-Clause
"""Features that users' own agents need: carrying, giving, goals, remembering things, avoiding an agent."""
import json
import math

from soarbox_command import Run, ScenarioCase, run_json

BEGIN = """
sp {hero*propose*begin (state <s> ^superstate nil -^step) --> (<s> ^operator <o> + =) (<o> ^name begin)}
sp {hero*apply*begin (state <s> ^operator.name begin) --> (<s> ^step 1)}
"""

STEP = """
sp {{hero*propose*step*{n} (state <s> ^superstate nil ^step {n}) --> (<s> ^operator <o> + =) (<o> ^name step ^number {n})}}
sp {{hero*apply*step*{n} (state <s> ^operator <o> ^step {n} ^io.output-link <out>)
   (<o> ^name step ^number {n})
-->
   (<out> ^{command} <c>)
   (<c> {parameters})
   (<s> ^said <c>)
}}
sp {{hero*apply*next*{n} (state <s> ^operator <o> ^step {n} ^said <c>)
   (<o> ^name step ^number {n})
   (<c> ^status <status>)
-->
   (<s> ^step {n} - {next} ^said <c> -)
   (write |{n} {command} | <status> (crlf))
}}
sp {{hero*tell*{n} (state <s> ^step {n} ^said.reason <reason>) --> (write |{n} because | <reason> (crlf))}}
"""


def script(*commands):
    """Rules that give these commands one after the other, and print the status of each."""
    return BEGIN + "".join(STEP.format(n=n, next=n + 1, command=command, parameters=parameters)
                           for n, (command, parameters) in enumerate(commands, 1))


WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
position = [0, 0]

[[item]]
name = "parcel"
position = [4, 0]

[[region]]
name = "depot"
position = [0, 8]
radius = 2

[[waypoint]]
name = "door"
position = [0, 8]
"""

FRIEND = """
[[agent]]
name = "friend"
rules = "friend.soar"
position = [8, 0]
"""


class OwnAgent(ScenarioCase):
    def go(self, rules, world=WORLD, seconds=20, *more):
        self.write("hero.soar", rules)
        self.write("scenario.toml", world)
        run = run_json(self.folder, "--seconds", seconds, *more, code=0)
        self.texts = [event["text"] for event in run.of("log", agent="hero")]
        return run


class Carrying(OwnAgent):
    def test_a_thing_is_delivered_by_dropping_it_where_it_belongs(self):
        goals = '[[goal]]\nname = "taken"\nagent = "hero"\ncarries = "parcel"\n[[goal]]\nname = "delivered"\nitem = "parcel"\nregion = "depot"\n'
        run = self.go(script(("move-to", "^object parcel"), ("pick-up", "^object parcel"), ("move-to", "^waypoint door"),
                             ("drop", "^object parcel"), ("pick-up", "^object parcel")), WORLD + goals)
        self.assertEqual(self.texts, ["1 move-to complete", "2 pick-up complete", "3 move-to complete", "4 drop complete",
                                      "5 pick-up complete"])
        self.assertEqual([event["text"] for event in run.of("reached")], ["taken", "delivered"])
        self.assertEqual([event["news"] for event in run.of("news")], ["takes", "drops", "takes"])

    def test_a_thing_is_handed_over_to_somebody_near(self):
        self.write("friend.soar", "sp {friend*thank (state <s> ^superstate nil ^io.input-link.self.carries <x>) --> (write |thanks for the | <x> (crlf))}")
        goals = '[[goal]]\nname = "given"\nagent = "friend"\ncarries = "parcel"\n'
        run = self.go(script(("move-to", "^object parcel"), ("pick-up", "^object parcel"), ("move-to", "^agent friend"),
                             ("give", "^object parcel ^to friend"), ("drop", "^object parcel")), WORLD + FRIEND + goals)
        self.assertEqual(sorted(self.texts[3:]), ["4 give complete", "5 because not-carried", "5 drop error"])
        self.assertEqual([event["text"] for event in run.of("log", agent="friend")], ["thanks for the parcel"])
        self.assertEqual([event["text"] for event in run.of("reached")], ["given"])
        self.assertEqual(run.of("news", news="gives")[0]["text"], "parcel to friend")

    def test_what_cannot_be_given_says_why(self):
        self.write("friend.soar", "")
        for commands, reason in (((("give", "^object parcel ^to friend"),), "not-carried"),
                                 ((("move-to", "^object parcel"), ("pick-up", "^object parcel"), ("give", "^object parcel ^to hero")), "itself"),
                                 ((("move-to", "^object parcel"), ("pick-up", "^object parcel"), ("give", "^object parcel ^to nobody")), "no-such-agent"),
                                 ((("move-to", "^object parcel"), ("pick-up", "^object parcel"), ("move-to", "^x -4 ^z 0"),
                                   ("give", "^object parcel ^to friend")), "out-of-reach")):
            self.go(script(*commands), WORLD + FRIEND)
            self.assertTrue(any(text.endswith(f"because {reason}") for text in self.texts), (reason, self.texts))

    def test_move_to_a_thing_ends_within_a_gap_between_skins(self):
        run = self.go(script(("move-to", "^object parcel ^within 1")), WORLD, 10, "--report", 0.1)
        place = run.of("state")[-1]["agents"][0]["position"]
        radius = run.of("state")[-1]["agents"][0]["radius"]
        gap = math.hypot(place[0] - 4, place[2]) - radius - math.sqrt(3 * 0.2 ** 2)
        self.assertTrue(0.5 < gap <= 1.01, gap)


class Goals(OwnAgent):
    def test_of_several_conditions_hold_at_the_same_time(self):
        goal = ('[[goal]]\nname = "both"\nall = [{ agent = "hero", region = "depot" }, { agent = "hero", carries = "parcel" }]\n'
                '[[goal]]\nname = "one entry"\nagent = "hero"\nregion = "depot"\ncarries = "parcel"\n')
        run = self.go(script(("move-to", "^waypoint door"), ("move-to", "^object parcel"), ("pick-up", "^object parcel"),
                             ("move-to", "^waypoint door")), WORLD + goal, 30)
        reached = run.of("reached")
        self.assertEqual(sorted(event["text"] for event in reached), ["both", "one entry"])
        taken = run.of("news", news="takes")[0]["time"]
        self.assertTrue(all(event["time"] > taken + 1 for event in reached), "not when it was there without the parcel")

    def test_names_that_the_scenario_does_not_have_are_errors_with_a_suggestion(self):
        teams = WORLD.replace('position = [0, 0]\n', 'position = [0, 0]\nteam = "blue"\n', 1)
        for keys, message, hint in (('team_down = "bleu"', "there is no team 'bleu'", "did you mean 'blue'?"),
                                    ('dead = "heroe"', "there is no agent 'heroe'", "did you mean 'hero'?"),
                                    ('agent = "hero"\nregion = "deopt"', "there is no region 'deopt'", "did you mean 'depot'?"),
                                    ('agent = "hero"\ncarries = "parsel"', "there is no item 'parsel'", "did you mean 'parcel'?"),
                                    ('item = "parcel"', "'item' needs 'region': where it lies", ""),
                                    ('carries = "parcel"', "'carries' needs 'agent': who carries it", "")):
            self.write("hero.soar", "")
            self.write("scenario.toml", teams + f'[[end]]\nname = "x"\n{keys}\n')
            check = Run("check", self.folder / "scenario.toml", "--json")
            problem = json.loads(check.out.splitlines()[0])
            self.assertEqual((check.code, problem["message"], problem.get("hint", "")), (1, message, hint), check.out)
            run = Run("run", self.folder, "--headless", "--seconds", 1, code=3)
            self.assertIn(message, run.err)


class Things(OwnAgent):
    TELL = """
sp {hero*see (state <s> ^superstate nil ^io.input-link.object <b>)
   (<b> ^name <name> ^visible <yes> ^nearest <near>)
-->
   (write <name> | visible | <yes> | nearest | <near> (crlf))
}"""
    BOXES = """
[[item]]
name = "far"
position = [0, 9]
"""

    def test_the_nearest_in_view_of_its_kind_is_marked_and_others_are_remembered_for_a_while(self):
        world = WORLD.replace("position = [0, 0]", "position = [0, 0]\nheading = 90\nsenses = { view = 120, memory = 4 }", 1)
        run = self.go(script(("face", "^heading 90"), ("wait", "^seconds 1"), ("face", "^heading 0"), ("wait", "^seconds 9")) + self.TELL,
                      world + self.BOXES, 14)
        seen = [(event["time"], event["text"]) for event in run.of("log", agent="hero") if "visible" in event["text"]]
        texts = [text for _, text in seen]
        self.assertEqual(texts[0], "parcel visible yes nearest yes")
        self.assertIn("parcel visible no nearest no", texts)
        self.assertIn("far visible yes nearest yes", texts)
        look = self.write("look.txt", "120 command hero print --depth 4 i2\n390 command hero print --depth 4 i2\n")
        run = self.go(script(("face", "^heading 90"), ("wait", "^seconds 1"), ("face", "^heading 0"), ("wait", "^seconds 9")),
                      world + self.BOXES, 14, "--input", look)
        early, late = (event["text"] for event in run.of("answer"))
        self.assertIn("^name parcel", early)
        self.assertIn("^visible no", early)
        self.assertNotIn("^name parcel", late)
        self.assertIn("^name far", late)


class KeepingAway(OwnAgent):
    def test_the_way_leads_round_somebody_at_a_distance(self):
        world = """
[[agent]]
name = "hero"
rules = "hero.soar"
position = [-14, 0.5]
senses = { view = 360, sight = 40 }

[[agent]]
name = "bear"
position = [0, 0]
"""
        nearest = {}
        for name, more in (("straight", ""), ("away", " ^away-from bear ^gap 6")):
            run = self.go(script(("move-to", "^x 14 ^z 0" + more)), world, 40, "--report", 0.2)
            self.assertEqual(self.texts, ["1 move-to complete"])
            nearest[name] = min(math.hypot(state["agents"][0]["position"][0], state["agents"][0]["position"][2])
                                for state in run.of("state"))
        self.assertLess(nearest["straight"], 2)
        self.assertGreater(nearest["away"], 5)

    def test_from_nobody_is_an_error(self):
        self.go(script(("move-to", "^x 4 ^z 0 ^away-from ghost")))
        self.assertIn("1 because no-such-agent", self.texts)
