# SPDX-License-Identifier: BSD-2-Clause
"""The behaviour of the thesis' agents, checked by the events of headless runs."""
import math
import unittest

from soarbox_command import THESIS, Run, run_json

TICK = 1 / 30
# The rules' thresholds, in squared metres.
NEAR_TARGET = 3
NEAR_LEADER = 5


def flat_distance(a, b):
    return math.hypot(a[0] - b[0], a[2] - b[2])


def news(events):
    """The first of each series of equal commands."""
    return [event for before, event in zip([None] + events, events) if before is None or before["command"] != event["command"]]


def overlaps(states, tolerance_m):
    """(time, one, other, depth) of each pair of agents with capsules that overlap by more than `tolerance_m`."""
    found = []
    for state in states:
        agents = state["agents"]
        for i, one in enumerate(agents):
            for other in agents[i + 1:]:
                depth = one["radius"] + other["radius"] - flat_distance(one["position"], other["position"])
                if depth > tolerance_m:
                    found.append((state["time"], one["name"], other["name"], depth))
    return found


class Seeker(unittest.TestCase):
    def check(self, run):
        self.assertEqual(run.code, 0, run.err)
        seeker = run.of("agent")[0]["agent"]
        commands = run.of("command", agent=seeker)
        asked = [event for event in commands if event["command"] == "newtarget"]
        kept = [event for event in commands if event["command"] == "sametarget"]
        self.assertGreaterEqual(len(asked), 10, "targets reached in 120 s")
        self.assertTrue(all(event["distance"] <= NEAR_TARGET for event in asked))
        self.assertTrue(all(event["distance"] > NEAR_TARGET for event in kept))
        # One command per tick, except for the first ticks.
        self.assertGreaterEqual(len(commands), run.of("end")[0]["ticks"] - 2)

    def test_reaches_ten_targets_and_asks_for_a_new_one_only_when_near(self):
        self.check(run_json("thesis/soar_leader.lua", "--seconds", 120, "--every-command", "--seed", 7))


class Followers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_ = run_json("thesis/gather.lua", "--seconds", 60, "--report", TICK, "--every-command")

    def test_end_within_their_stopping_band_of_the_leader(self):
        self.assertEqual(self.run_.code, 0, self.run_.err)
        leader, *followers = self.run_.of("state")[-1]["agents"]
        self.assertEqual(len(followers), 4)
        for follower in followers:
            # The rule's threshold, and a margin because separation may push them out again.
            self.assertLess(flat_distance(leader["position"], follower["position"]), math.sqrt(NEAR_LEADER) + 1.5, follower["name"])

    def test_say_stop_exactly_when_the_leader_is_near(self):
        for event in self.run_.of("command"):
            self.assertEqual(event["command"], "stop" if event["distance"] <= NEAR_LEADER else "follow", event)

    def test_never_overlap_another_body(self):
        states = [state for state in self.run_.of("state") if state["time"] > 1]
        self.assertGreater(len(states), 1700)
        self.assertEqual(overlaps(states, tolerance_m=0.06), [])


class WaypointAgent(unittest.TestCase):
    POINTS = [(0, 0), (20, 0), (20, 30), (-20, 0), (-20, 10)]

    def test_visits_the_five_points_in_order_twice(self):
        run = run_json("thesis", "--seconds", 70, "--every-command", code=0)
        agent = next(event["agent"] for event in run.of("agent") if "waypoint" in event["text"])
        switches = [event for event in run.of("command", agent=agent) if event["command"] == "nextwaypoint"]
        # The first switch is from its initial target; after that, its targets are the points in turn.
        visited = switches[1:11]
        self.assertEqual(len(visited), 10)
        for index, event in enumerate(visited):
            x, z = self.POINTS[index % 5]
            self.assertLess(math.hypot(event["position"][0] - x, event["position"][2] - z), 2, (index, event))


class Groups(unittest.TestCase):
    def test_of_lua_and_soar_agents_keep_together(self):
        run = run_json("thesis/mixed.lua", "--seconds", 90, "--report", 1, "--every-command", code=0)
        end = run.of("end")[0]
        self.assertEqual((end["agents"], end["soar_agents"]), (5, 3))
        late = [state for state in run.of("state") if state["time"] > 40]
        for index in range(1, 5):
            mean = sum(flat_distance(state["agents"][0]["position"], state["agents"][index]["position"]) for state in late) / len(late)
            self.assertLess(mean, 12, late[0]["agents"][index]["name"])

    def test_with_a_soar_leader_move_as_with_a_lua_leader(self):
        run = run_json("thesis/soar_leader.lua", "--seconds", 60, "--report", 1, code=0)
        self.assertEqual(run.of("end")[0]["soar_agents"], 6)


class TheThesisOwnAgents(unittest.TestCase):
    def test_run_unmodified_with_scripts_in_its_dialect(self):
        run = run_json(THESIS / "scripts", "--path", THESIS / "agents", "--seconds", 60, "--every-command", code=0)
        # The rules of the thesis do not cover the distances 3 and 5.
        told = [(diagnostic["severity"], diagnostic["message"].split(",")[0]) for diagnostic in run.diagnostics()]
        self.assertEqual(set(told), {("warning", f"if ^distance is exactly {distance}") for distance in (3, 5)}, told)
        self.assertEqual((run.of("end")[0]["agents"], run.of("end")[0]["soar_agents"]), (6, 5))
        said = {event["command"] for event in run.of("command")}
        self.assertLessEqual({"follow", "stop", "nextwaypoint", "samewaypoint"}, said)


class TextOutput(unittest.TestCase):
    def test_is_legible(self):
        run = Run("run", "thesis", "--headless", "--seconds", 5, code=0)
        first, *_, last = run.out.splitlines()
        self.assertEqual(first, "soarbox: scenario thesis, seed 1, headless")
        self.assertRegex(last, r"^soarbox: 15\d ticks, 5\.\d s simulated, 6 agents \(5 of them Soar\), 0 problems, state [0-9a-f]{16}$")
