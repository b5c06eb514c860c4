# SPDX-License-Identifier: BSD-2-Clause
"""The behaviour of the shipped scenarios, one for each theme, checked by headless runs of the command."""
import math
import pathlib
import re
import tempfile
import unittest

from soarbox_command import run_json


def run_clean(case, scenario, *arguments):
    """A run without script errors and warnings."""
    run = run_json(scenario, *arguments, code=0)
    case.assertEqual(run.err, "")
    case.assertEqual(run.diagnostics(), [])
    return run


def prints(run):
    """(time, text) of what scripts printed, without the script's name."""
    return [(event["time"], event["text"].split(": ", 1)[1]) for event in run.of("log")]


def numbers(run, pattern):
    """The groups of each print that the pattern matches, as numbers."""
    found = (re.search(pattern, text) for _, text in prints(run))
    return [tuple(map(int, match.groups())) for match in found if match]


def asked(case, scenario, lines, *arguments):
    """A run with inputs: (tick, input) each."""
    with tempfile.TemporaryDirectory() as folder:
        inputs = pathlib.Path(folder) / "inputs.txt"
        inputs.write_text("".join(f"{tick} {text}\n" for tick, text in lines))
        return run_clean(case, scenario, "--input", inputs, *arguments)


class Movement(unittest.TestCase):
    COURIER, DOG, GEESE, JOGGERS = 0, 1, range(2, 8), range(8, 20)

    def test_everybody_moves_as_the_scene_says_with_any_seed(self):
        for seed in (1, 2, 3):
            with self.subTest(seed=seed):
                self.check(run_clean(self, "movement", "--seconds", 60, "--report", 0.5, "--seed", seed).of("state"))

    def check(self, states):
        self.assertEqual(len(states[-1]["agents"]), 20)

        def way(index):
            return [state["agents"][index]["position"] for state in states]

        def length(places):
            return sum(math.dist(a, b) for a, b in zip(places, places[1:]))

        self.assertTrue(all(abs(agent["position"][1] - 0.8) < 0.05 for state in states for agent in state["agents"]))
        courier = way(self.COURIER)
        gaps = [math.dist(a, b) for a, b in zip(courier, way(self.DOG))]
        # It is caught and escapes again: the gap closes and opens.
        self.assertLess(min(gaps), 2.5)
        caught = gaps.index(min(gaps))
        self.assertGreater(max(gaps[caught:], default=0), 6, "the dog lets it go")
        # It is never stuck: its position changes within any eight seconds.
        for begin in range(0, len(courier) - 16, 8):
            self.assertGreater(length(courier[begin:begin + 16]), 6, f"at {begin / 2} s")
        followed = [math.dist(a, b) for goose in self.GEESE for a, b in list(zip(courier, way(goose)))[40:]]
        self.assertLess(sum(followed) / len(followed), 10)
        for jogger in self.JOGGERS:
            self.assertGreater(length(way(jogger)), 150)

    def test_nobody_spins_on_the_spot(self):
        states = run_clean(self, "movement", "--seconds", 40, "--report", 0.1, "--seed", 3).of("state")
        turns = 0
        for before, after in zip(states, states[1:]):
            for a, b in zip(before["agents"], after["agents"]):
                (ax, _, az), (bx, _, bz) = a["velocity"], b["velocity"]
                if math.hypot(ax, az) > 0.5 and math.hypot(bx, bz) > 0.5:
                    cosine = (ax * bx + az * bz) / (math.hypot(ax, az) * math.hypot(bx, bz))
                    turns += cosine < 0
        self.assertLess(turns, 40, "turns by more than 90 degrees within 0.1 s, of 20 agents in 40 s")


class Navigation(unittest.TestCase):
    def test_all_walkers_reach_places_and_some_climb_a_terrace(self):
        run = run_clean(self, "navigation", "--seconds", 120, "--report", 1)
        visits = numbers(run, r"agent (\d+) has been at (\d+) places")
        best = {agent: count for agent, count in visits}
        self.assertEqual(len(best), 5)
        self.assertGreaterEqual(sum(best.values()), 15)
        heights = [agent["position"][1] for state in run.of("state") for agent in state["agents"]]
        self.assertGreater(max(heights), 4.5, "somebody was on a terrace")
        self.assertGreater(min(heights), -1.5, "nobody fell off the level")

    def test_a_key_shows_the_mesh_and_changes_nothing_else(self):
        plain = run_clean(self, "navigation", "--seconds", 5)
        shown = asked(self, "navigation", [(30, "key f3_key press")], "--seconds", 5)
        self.assertEqual(plain.of("end")[0]["state"], shown.of("end")[0]["state"])


class Decisions(unittest.TestCase):
    def test_guards_of_all_minds_patrol_chase_catch_and_rest(self):
        for mind in ("tree", "state_machine", "behavior_tree"):
            with self.subTest(mind):
                texts = [text for _, text in prints(run_clean(self, f"decisions/{mind}.lua", "--seconds", 90, "--seed", 2))]
                for deed in ("patrols to post 1", "patrols to post 2", "chases", "catches", "rests"):
                    self.assertTrue(any(text.endswith(deed) for text in texts), f"{deed}: {texts}")

    def test_a_guard_rests_three_seconds_and_only_after_a_chase(self):
        deeds = [(time, text.split()[1]) for time, text in prints(run_clean(self, "decisions", "--seconds", 120, "--seed", 2))]
        rests = [index for index, (_, deed) in enumerate(deeds[:-1]) if deed == "rests"]
        self.assertTrue(rests)
        for index in rests:
            self.assertIn(deeds[index - 1][1], ("chases", "catches"))
            self.assertAlmostEqual(deeds[index + 1][0] - deeds[index][0], 3.1, delta=0.15)

    def test_the_decision_tree_and_the_behavior_tree_are_the_same_mind(self):
        ends = [run_clean(self, f"decisions/{mind}.lua", "--seconds", 60).of("end")[0]["state"]
                for mind in ("tree", "behavior_tree")]
        self.assertEqual(ends[0], ends[1])


class Knowledge(unittest.TestCase):
    def test_foragers_find_berries(self):
        run = run_clean(self, "knowledge", "--seconds", 120)
        picked = {agent: count for agent, count in numbers(run, r"(\d+) picked (\d+)")}
        self.assertEqual(len(picked), 3)
        self.assertGreaterEqual(sum(picked.values()), 9)


class Perception(unittest.TestCase):
    def test_watchers_see_their_own_side_and_know_of_both_by_messages(self):
        run = run_clean(self, "perception", "--seconds", 60)
        self.assertEqual(set(numbers(run, r"(\d+) sees (\d+)")), {(5, 7), (6, 8)}, "the wall hides the others")
        self.assertEqual(set(numbers(run, r"(\d+) knows of (\d+)")), {(5, 7), (5, 8), (6, 7), (6, 8)})


class Animation(unittest.TestCase):
    def test_the_parade_runs_and_its_patrols_go_round(self):
        states = run_clean(self, "animation", "--seconds", 30, "--report", 1).of("state")
        for index in range(2):
            way = [state["agents"][index]["position"] for state in states]
            self.assertGreater(sum(math.dist(a, b) for a, b in zip(way, way[1:])), 20)


class MindAndBody(unittest.TestCase):
    KEYS = [(5, "key f4_key press"), (6, "key f4_key press"), (60, "key 3_key press"), (1860, "key 5_key press"),
            (2000, "key 2_key press"), (2300, "key 1_key press"), (2390, 'script CommandedSoldier-1 print("shots " .. shots)'),
            (2400, "key numpad_4_key press"), (2500, "key 3_key press")]

    def test_soldiers_do_as_they_are_told(self):
        run = asked(self, "mind_body", self.KEYS, "--seconds", 90, "--report", 1)
        # The second soldier follows the first, who is in its line of fire.
        _, second = [text.split()[0] for _, text in prints(run) if text.endswith(" IDLE")][:2]
        deeds = [text.split()[1] for _, text in prints(run) if text.startswith(second + " ")]
        self.assertEqual(deeds, ["IDLE", "MOVE", "CHANGE_STANCE", "MOVE", "SHOOT", "IDLE", "DIE"])
        states = {round(state["time"]): [agent["position"] for agent in state["agents"]] for state in run.of("state")}
        walked = sum(math.dist(states[second][0], states[second + 1][0]) for second in range(3, 60))
        self.assertTrue(120 < walked < 175, f"{walked} m of the level's path in 57 s")
        self.assertGreater(max(position[0][1] for position in states.values() if position), 4.7, "over the terraces")
        self.assertAlmostEqual(states[65][0][1], 0.65, delta=0.02, msg="it crouches")
        self.assertLess(math.dist(states[81][0], states[90][0]), 0.01, "the dead stay where they are")
        # Two soldiers, each with a shot every 0.5 s, for ten seconds.
        shots = numbers(run, r"^shots (\d+)$")[0][0]
        self.assertTrue(34 <= shots <= 42, shots)


class Tactics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = run_json("tactics", "--seconds", 90, "--report", 1)

    def test_two_teams_find_and_fight_each_other(self):
        self.assertEqual((self.run_.code, self.run_.err, self.run_.diagnostics()), (0, "", []))
        deeds = {text.split(" ", 1)[1] for _, text in prints(self.run_)}
        for deed in ("randomMove", "move", "idle", "pursue", "shoot", "is hit"):
            self.assertIn(deed, deeds)
        self.assertEqual(len(self.run_.of("agent")), 6)

    def test_soldiers_walk_on_the_level(self):
        heights = [agent["position"][1] for state in self.run_.of("state") for agent in state["agents"]]
        self.assertGreater(min(heights), -2.5)

    def test_hiding_the_map_changes_nothing_else(self):
        plain = run_json("tactics", "--seconds", 10)
        hidden = asked(self, "tactics", [(30, "key f4_key press")], "--seconds", 10)
        self.assertEqual(plain.of("end")[0]["state"], hidden.of("end")[0]["state"])
