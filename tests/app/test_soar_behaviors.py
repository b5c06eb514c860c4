# SPDX-License-Identifier: BSD-2-Clause
"""The visible behaviour of the Soar agents in scenarios/soar_*, for ten seeds."""
import collections
import json
import math
import pathlib
import re
import tempfile
import unittest

from soarbox_command import Run, run_json

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
SEEDS = tuple(range(1, 11))
RADIUS = 0.35


def flat(a, b):
    return math.hypot(a[0] - b[0], a[2] - b[2])


class Behavior(unittest.TestCase):
    def runs(self, scenario, *arguments):
        """The run and the tracks of its agents, {name: [(time, position, speed)]}, for each seed."""
        for seed in SEEDS:
            run = run_json(scenario, "--seed", seed, "--report", 0.1, *arguments, code=0)
            tracks = collections.defaultdict(list)
            for state in run.of("state"):
                for agent in state["agents"]:
                    speed = math.hypot(agent["velocity"][0], agent["velocity"][2])
                    tracks[agent["name"]].append((state["time"], agent["position"], speed))
            yield run, tracks

    def assert_apart(self, one, other, least):
        for (time, a, _), (_, b, _) in zip(one, other):
            self.assertGreater(flat(a, b), least, time)

    def visits(self, track, x, z, within):
        return any(math.hypot(p[0] - x, p[2] - z) <= within for _, p, _ in track)


class Movement(Behavior):
    def test_seek_reaches_its_goals_at_full_speed(self):
        for run, tracks in self.runs("soar_seek"):
            track = tracks["seeker"]
            self.assertGreaterEqual(len(run.of("command", command="seek")), 5)
            visited = sum(self.visits(track, x, z, 1.6) for x, z in ((18, 0), (0, -18), (-18, 0)))
            self.assertGreaterEqual(visited, 2)
            self.assertGreater(max(speed for _, _, speed in track), 7)

    def test_follow_keeps_close_to_the_leader_without_bumping_into_anybody(self):
        for _, tracks in self.runs("soar_follow"):
            names = ["leader", "follower-1", "follower-2", "follower-3"]
            for name in names[1:]:
                late = [flat(a[1], b[1]) for a, b in zip(tracks["leader"], tracks[name]) if a[0] > 10]
                self.assertLess(max(late), 7, name)
            for i, one in enumerate(names):
                for other in names[i + 1:]:
                    self.assert_apart(tracks[one], tracks[other], 2 * RADIUS - 0.1)
            self.assertGreater(max(flat(p, (0, 0, 0)) for _, p, _ in tracks["leader"]), 12)

    def test_flee_and_evade_keep_the_bear_away_and_rest_when_it_is_far(self):
        for scenario, name in (("soar_flee", "rabbit"), ("soar_evade", "hare")):
            for run, tracks in self.runs(scenario):
                self.assert_apart(tracks["bear"], tracks[name], 5)
                self.assertGreaterEqual(len(run.of("outcome", agent=name, text="complete")), 2)
                self.assertTrue(any(speed < 0.1 for time, _, speed in tracks[name] if time > 3), "it rests")
                self.assertLess(len(run.of("command", agent=name)), 40)

    def test_pursue_catches_the_walker_again_and_again(self):
        for run, tracks in self.runs("soar_pursue"):
            self.assertGreaterEqual(len([event for event in run.of("log", agent="hunter")]), 3)
            self.assertLess(min(flat(a[1], b[1]) for a, b in zip(tracks["walker"], tracks["hunter"])), 3.2)

    def test_wander_covers_ground_and_keeps_out_of_the_crates(self):
        crates = ((6, 6, 1, 1), (-7, -4, 1.5, 0.5), (2, -8, 0.5, 0.5))
        ways = []
        for _, tracks in self.runs("soar_wander"):
            for name, track in tracks.items():
                length = sum(flat(a[1], b[1]) for a, b in zip(track, track[1:]))
                self.assertGreater(length, 60, name)
                for time, (x, _, z), _ in track:
                    for cx, cz, hx, hz in crates:
                        self.assertFalse(abs(x - cx) < hx and abs(z - cz) < hz, (name, time))
            ways.append(tracks["stroller-1"][-1][1])
        self.assertGreater(flat(ways[0], ways[1]), 0.1, "another seed, another way")

    def test_path_is_followed_in_its_order(self):
        for run, _ in self.runs("soar_path"):
            delivered = [event["text"].removeprefix("delivered at ") for event in run.of("log", agent="postman")]
            self.assertGreaterEqual(len(delivered), 5)
            order = ["one", "two", "three", "four"]
            self.assertEqual(delivered, [order[i % 4] for i in range(len(delivered))])

    def test_obstacles_are_walked_round(self):
        crates = [(0, 10), (-3, 7), (3, 6), (0, 2), (-5, 1), (5, 0), (-2, -4), (3, -5), (0, -9)]
        for run, tracks in self.runs("soar_obstacles", "--seconds", 30):
            self.assertEqual([event["text"] for event in run.of("reached")], ["the porter is through"])
            for time, (x, _, z), _ in tracks["porter"]:
                for cx, cz in crates:
                    self.assertFalse(abs(x - cx) < 1.2 and abs(z - cz) < 0.8, (time, x, z))

    def test_hallway_is_passed_by_both_again_and_again(self):
        for run, tracks in self.runs("soar_hallway"):
            for name in ("anna", "bert"):
                ways = [event["text"] for event in run.of("log", agent=name)]
                self.assertGreaterEqual(sum(text.endswith("complete") for text in ways), 4, ways)
                for time, (x, _, z), _ in tracks[name]:
                    if abs(z) < 8:
                        self.assertLess(abs(x), 1.6, (name, time))
            self.assert_apart(tracks["anna"], tracks["bert"], 2 * RADIUS - 0.15)


class Skirmish(Behavior):
    def test_is_fought_with_orders_radio_cover_and_an_end(self):
        covered = 0
        for run, tracks in self.runs("soar_skirmish"):
            said = run.of("news", news="says")
            for leader in ("blue-leader", "red-leader"):
                orders = [event for event in said if event["agent"] == leader and "^about order" in event["text"]]
                self.assertEqual(len(orders), 1)
                # No agent moves before the order.
                team = leader.split("-")[0]
                for number in (1, 2, 3):
                    moves = run.of("command", agent=f"{team}-{number}", command="move-to")
                    self.assertGreaterEqual(moves[0]["time"], orders[0]["time"])
            self.assertTrue(any("^about enemy" in event["text"] for event in said))
            self.assertEqual([event for event in run.of("gap") if event["time"] < 3], [], "nobody is idle when it begins")
            self.assertGreater(len(run.of("news", news="shoots")), 20)
            covered += len(run.of("outcome", command="take-cover", text="complete"))
            # A dead agent sends no messages and does not act.
            for death in run.of("news", news="dies"):
                later = [event for event in run.of("command", agent=death["agent"]) if event["time"] > death["time"]]
                self.assertEqual(later, [])
            self.assertRegex(run.of("reached")[-1]["text"], "(red|blue) wins")
            loser = "blue" if run.of("reached")[-1]["text"] == "red wins" else "red"
            dead = {event["agent"] for event in run.of("news", news="dies")}
            self.assertLessEqual({f"{loser}-leader", f"{loser}-1", f"{loser}-2", f"{loser}-3"}, dead)
        self.assertGreaterEqual(covered, 3)


class Imagery(Behavior):
    """soar_hide: the scene that the hider imagines, and its display."""

    def view(self, *arguments):
        run = Run("inspect", "soar_hide", "--agent", "hider", "--view", *arguments, code=0)
        return run.out

    def test_it_is_never_in_view_for_long(self):
        for run, tracks in self.runs("soar_hide", "--seconds", 60):
            self.assertGreaterEqual(len(run.of("command", agent="hider", command="move-to")), 2)
            self.assertEqual(run.diagnostics(), [])

    def test_what_it_imagines_can_be_looked_at(self):
        text = self.view("imagery", "--at", 10)
        for part in ("  world\n", "    searcher  hull at ", "^kind box", "(rule hider*imagine*hidden)", "1: occlusion ^place "):
            self.assertIn(part, text)
        scene = json.loads(self.view("imagery", "--at", 10, "--json"))["scenes"][0]
        self.assertEqual(scene["state"], "S1")
        self.assertIn("barn", [node["name"] for node in scene["nodes"]])
        extracts = [extract for extract in scene["extracts"] if extract["filter"] == "occlusion"]
        self.assertEqual(len(extracts), 8, "one for each waypoint")
        lines = [line for extract in extracts for value in extract["values"] for line in value["lines"]]
        crossed = sum(line["is_crossed"] for line in lines)
        self.assertTrue(0 < crossed < len(lines), "some places are hidden, some are not")

    def test_why_leads_from_an_operator_to_what_was_imagined(self):
        why = self.view("why", "--at", 10)
        self.assertIn("imagined by extract ", why)
        self.assertIn("asked by rule hider*imagine*hidden", why)

    def test_a_recording_tells_what_was_imagined(self):
        with tempfile.TemporaryDirectory() as folder:
            recording = pathlib.Path(folder) / "hide.soarrec"
            Run("run", "soar_hide", "--headless", "--seconds", 11, "--record", recording, code=0)

            def recorded(*arguments):
                told = Run("inspect", recording, "--agent", "hider", *arguments, code=0)
                return told.out

            places = set()
            for at in (1, 3, 10):
                scene = recorded("--view", "imagery", "--at", at, "--json")
                self.assertEqual(scene, self.view("imagery", "--at", at, "--json"))
                places.add(str(next(n["at"] for n in json.loads(scene)["scenes"][0]["nodes"] if n["name"] == "self")))
            self.assertEqual(len(places), 3, "it walks, in its scene, too")
            self.assertEqual(recorded("--view", "why", "--at", 10), self.view("why", "--at", 10))
            why = Run("why", recording, "hide", "--agent", "hider", "--at", 10, code=0)
            self.assertIn("imagined by extract ", why.out)
            self.assertEqual(why.out, Run("why", "soar_hide", "hide", "--agent", "hider", "--at", 10).out)
            refused = Run("inspect", recording, "--agent", "hider", "--view", "imagery", "--at", 10, "--recorded")
            self.assertNotEqual(refused.code, 0)
            self.assertIn("the view imagery shows nothing that is recorded", refused.err)
            self.assertIn("simulate the run again for it", refused.err)


class Crates(Behavior):
    """soar_crates: a crate that is too wide for the door cannot pass it, even if a porter believes that it fits."""

    RULES = REPOSITORY / "scenarios" / "soar_crates" / "by_percepts.soar"

    def test_a_porter_that_believes_that_all_fit_is_stopped_by_the_door(self):
        with tempfile.TemporaryDirectory() as folder:
            bold = pathlib.Path(folder) / "bold.soar"
            bold.write_text(self.RULES.read_text().replace("^radius <= 1", "^radius <= 9").replace("^radius > 1", "^radius > 9")
                            .replace("source carry.soar", f"source {self.RULES.parent / 'carry.soar'}"))
            run = run_json("soar_crates", "--rules", f"porter={bold}", "--seconds", 60)
        self.assertEqual([(event["agent"], event["text"]) for event in run.of("outcome") if "error" in event["text"]],
                         [("porter", "error blocked: No progress for 4 s")])
        taken = [event["text"] for event in run.of("news", news="takes")]
        dropped = [event for event in run.of("news", news="drops") if event["position"][0] > 1]
        self.assertEqual(taken[-1], "crate-2")
        self.assertEqual({event["text"] for event in dropped}, {"crate-1", "crate-3"})

    def test_imagination_suits_any_door_and_a_number_in_a_rule_the_one_that_was_measured(self):
        for world, rules, brought in (("soar_crates", None, 2), ("soar_crates/wide.toml", None, 4),
                                      ("soar_crates", self.RULES, 2), ("soar_crates/wide.toml", self.RULES, 2)):
            run = run_json(world, "--seconds", 120, *(("--rules", f"porter={rules}") if rules else ()))
            inside = [event["text"] for event in run.of("news", news="drops") if event["position"][0] > 1]
            self.assertEqual(len(set(inside)), brought, (world, rules, inside))

    def test_the_rules_that_it_learns_are_about_a_size(self):
        learned = Run("inspect", "soar_crates", "--at", 1, "--view", "learning").out
        for part in ("chunk*judge*return*fits", "makes ^goes-to barn", "chunk*judge*return*too-wide", "makes ^goes-to rack"):
            self.assertIn(part, learned)
        story = Run("why", "soar_crates", re.search(r"chunk\*judge\*return\*fits\S*", learned)[0], "--at", 1).out
        self.assertIn("^radius 0.8", story)


class ImageryExample(unittest.TestCase):
    """The complete example of docs/imagery.md runs unchanged."""

    def test_the_porter_puts_the_lamp_where_it_imagined_it(self):
        text = (REPOSITORY / "docs" / "imagery.md").read_text(encoding="utf-8")
        section = text[text.index("## A complete example"):text.index("## What to know")]
        with tempfile.TemporaryDirectory() as folder:
            for language, name in (("toml", "scenario.toml"), ("soar", "porter.soar")):
                block = section[section.index(f"```{language}\n") + len(language) + 4:]
                (pathlib.Path(folder) / name).write_text(block[:block.index("```")], encoding="utf-8")
            check = Run("check", folder)
            self.assertEqual((check.code, check.out.splitlines()[-1]), (0, "0 errors, 0 warnings"), check.out)
            run = run_json(folder, "--seconds", 20, code=0)
            self.assertEqual([event["command"] for event in run.of("command", agent="porter")],
                             ["move-to", "pick-up", "move-to", "drop"])
            self.assertEqual(run.diagnostics(), [])
            seen = Run("inspect", folder, "--at", 15, "--view", "imagery", "--json", code=0)
            nodes = {node["name"]: node["at"] for node in json.loads(seen.out)["scenes"][0]["nodes"]}
            # Half the width of the barn, the gap, and half the lamp; the lamp falls in front of the agent.
            self.assertLess(flat(nodes["lamp"], (8 - 2 - 1 - 0.2, 0, 6)), 0.9)


class Checked(unittest.TestCase):
    def test_all_of_them_are_free_of_slips(self):
        for name in ("seek", "follow", "flee", "hide", "crates", "evade", "pursue", "wander", "path", "obstacles", "hallway", "skirmish"):
            run = Run("check", "scenarios/soar_" + name, cwd=REPOSITORY)
            self.assertEqual((run.code, run.out.splitlines()[-1]), (0, "0 errors, 0 warnings"), run.out)
