# SPDX-License-Identifier: BSD-2-Clause
"""Worlds as learning environments, and runs shown in notebooks."""
import builtins
import html
import importlib.util
import inspect
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
from unittest import mock

import soarbox

if os.environ.get("SOARBOX_WITHOUT_NUMPY"):
    sys.modules["numpy"] = None  # Then importing it raises ImportError.

ACTIONS = [None, "stop", ("move-to", {"waypoint": "north"}), ("move-to", {"x": 4, "z": 0.5})]
OBSERVE = ["self.health", "self.position.x", "self.position.z", "agent.range", "agent.visible"]


def hallway(**more):
    return soarbox.Environment("soar_hallway", "anna", **{"actions": ACTIONS, "observe": OBSERVE, "seed": 3, **more})


def episode(environment, actions, **reset):
    observation, info = environment.reset(**reset)
    seen = [(tuple(observation), info)]
    for action in actions:
        observation, *others = environment.step(action)
        seen.append((tuple(observation), *others))
    return seen


class Environments(unittest.TestCase):
    def test_python_decides_for_one_agent_and_soar_for_the_others(self):
        with hallway(reward=lambda agent: -agent.percepts["self"]["position"]["z"]) as environment:
            bert = environment.world["bert"]
            first, info = environment.reset()
            self.assertEqual((first[0], info), (100, {"tick": 1, "time": environment.world.time, "command": ""}))
            begin = bert.percepts["self"]["position"]["z"]
            for _ in range(6):
                last, reward, terminated, truncated, info = environment.step(2)
            self.assertEqual((terminated, truncated, info["tick"], info["command"]), (False, False, 61, "under way"))
            # With numpy, observations are rounded to float32.
            self.assertAlmostEqual(reward, -last[2], delta=1e-5)
            self.assertLess(last[2], first[2] - 2, "anna has walked to the north")
            self.assertNotEqual(bert.percepts["self"]["position"]["z"], begin, "bert walks, too")
            self.assertEqual([command.name for command in environment.agent.commands], ["move-to"])
            self.assertIn("soarbox*python*decides", str(environment.agent.why()))
            *_, info = environment.step(0)
            self.assertEqual((environment.agent.commands, info["command"]), ([], ""))

    def test_equal_seeds_and_actions_give_equal_episodes(self):
        actions = [2, 2, 3, 1, 1, 0, 3]
        with hallway() as environment:
            once = episode(environment, actions, seed=5)
            self.assertEqual(episode(environment, actions, seed=5), once)
            self.assertNotEqual(episode(environment, [0] * 7, seed=5), once)
        with hallway() as another:
            self.assertEqual(episode(another, actions, seed=5), once)

    def test_episodes_share_a_process_and_do_not_depend_on_those_before(self):
        actions = [2, 2, 3]
        with hallway() as environment:
            episode(environment, [3, 1, 0], seed=4)
            process = environment.world._engine._process.pid
            second = episode(environment, actions, seed=5)
            self.assertEqual(environment.world._engine._process.pid, process)
        with hallway(seed=5) as fresh:
            self.assertEqual(episode(fresh, actions), second)

    def test_many_take_their_steps_at_once_as_each_alone(self):
        actions = [2, 2, 3]
        with soarbox.VectorEnvironment(lambda: hallway(most_steps=2), 3) as many:
            observations, infos = many.reset(seed=5)
            self.assertEqual((len(many), many.num_envs, infos["tick"]), (3, 3, [1, 1, 1]))
            seen = [observations]
            for action in actions:
                observations, rewards, terminated, truncated, infos = many.step([action] * 3)
                seen.append(observations)
                self.assertEqual(list(rewards), [0, 0, 0])
                self.assertEqual(list(terminated), [False] * 3)
            # The third step began the next episodes.
            self.assertEqual((list(truncated), infos["tick"]), ([False] * 3, [1, 1, 1]))
            self.assertEqual(many.single_action_space, soarbox.Discrete(4))
            with self.assertRaisesRegex(ValueError, "2 actions for 3 environments"):
                many.step([0, 0])
            with self.assertRaisesRegex(ValueError, "1 seeds for 3"):
                many.reset(seed=[1])
        for i in range(3):
            with hallway() as alone:
                expected = episode(alone, actions[:2], seed=5 + i)
            self.assertEqual([tuple(observations[i]) for observations in seen[:3]], [step[0] for step in expected])

    def test_many_refuse_what_one_refuses(self):
        with self.assertRaisesRegex(ValueError, "self.helth"):
            soarbox.VectorEnvironment(lambda: hallway(observe=["self.helth"]), 2)
        with self.assertRaisesRegex(TypeError, "whole number"):
            soarbox.VectorEnvironment(hallway, 0)

    def test_a_world_begins_again(self):
        with soarbox.World("soar_hallway", seed=3) as world:
            world.step(40)
            before = str(world.why("anna"))
            world.restart()
            self.assertEqual((world.tick, world.seed), (0, 3))
            world.step(40)
            self.assertEqual(str(world.why("anna")), before)
            world.restart(seed=8)
            self.assertEqual((world.tick, world.seed), (0, 8))
            with self.assertRaisesRegex(TypeError, "whole number"):
                world.restart(seed=-1)

    def test_a_path_that_no_percept_has_is_an_error_with_a_suggestion(self):
        for path, near in (("self.helth", "self.health"), ("self.position.zz", "self.position.z"), ("agents.range", "agent.range")):
            with self.assertRaisesRegex(ValueError, f"no percept '{path}'; did you mean '{near}'"):
                hallway(observe=[path])
        with self.assertRaisesRegex(ValueError, "docs/percepts.md"):
            hallway(observe=["qqqqq"])

    def test_episodes_take_one_seed_after_the_other(self):
        with hallway() as environment:
            seeds = []
            for reset in ({}, {}, {"seed": 9}, {}):
                environment.reset(**reset)
                seeds.append(environment.world.seed)
            self.assertEqual(seeds, [3, 4, 9, 10])

    def test_the_recording_of_an_episode_gives_the_same_run(self):
        with hallway() as environment:
            episode(environment, [2, 2, 3, 1, 3, 0, 2, 2])
            file = environment.world._engine.recording()
            for _ in range(600):
                done = subprocess.run([os.environ["SOARBOX"], "verify", str(file)], capture_output=True, text=True, check=False)
                if "holds no ticks" not in done.stderr:
                    break
                time.sleep(0.1)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertRegex(done.stdout, r"^equal: ticks 0 to \d\d")

    def test_an_order_goes_on_until_its_command_has_ended_and_is_then_given_again(self):
        with hallway() as environment:
            environment.reset()
            environment.step(2)
            name = environment.agent.output["move-to"].name
            environment.step(2)
            self.assertEqual(environment.agent.output["move-to"].name, name)
            environment.step(1)
            stop = environment.agent.output["stop"].name
            *_, info = environment.step(1)
            self.assertEqual(info["command"], "complete")
            environment.step(1)
            self.assertNotEqual(environment.agent.output["stop"].name, stop)

    def test_episodes_are_cut_off_or_end(self):
        with hallway(most_steps=2, ended=lambda agent: agent.percepts["time"] > 1.5) as environment:
            environment.reset()
            self.assertEqual(environment.step(0)[2:4], (False, False))
            self.assertEqual(environment.step(0)[2:4], (False, True))
            with self.assertRaisesRegex(soarbox.WorldEnded, "call reset"):
                environment.step(0)
        with hallway(ticks=50, ended=lambda agent: agent.percepts["time"] > 1.5) as environment:
            environment.reset()
            self.assertEqual(environment.step(0)[2:4], (True, False))

    def test_spaces_and_functions_of_ones_own(self):
        space = soarbox.Box([-10, -10], [10, 10])
        with hallway(actions=(space, lambda place: ("move-to", {"x": float(place[0]), "z": float(place[1])})),
                     observe=(soarbox.Discrete(2), lambda agent: int(agent.percepts["time"] > 0.2)),
                     render_mode="ansi") as environment:
            self.assertIs(environment.action_space, space)
            self.assertEqual(environment.reset()[0], 0)
            self.assertEqual(environment.step((3, 8.5))[0], 1)
            self.assertEqual(environment.agent.commands[0].parameters["z"], 8.5)
            self.assertIn("anna at 0.3", environment.render())
            with self.assertRaisesRegex(ValueError, "is not an action: Box"):
                environment.step((30, 0))

    def test_it_has_the_shape_of_a_gymnasium_environment(self):
        parameters = inspect.signature(soarbox.Environment.reset).parameters
        self.assertEqual([(name, parameters[name].kind) for name in ("seed", "options")],
                         [(name, inspect.Parameter.KEYWORD_ONLY) for name in ("seed", "options")])
        with hallway() as environment:
            self.assertIs(environment.unwrapped, environment)
            self.assertEqual((environment.action_space.n, environment.observation_space.shape), (4, (5,)))
            observation, _ = environment.reset(seed=1, options={})
            self.assertIn(observation, environment.observation_space)
            self.assertIsNone(environment.render())
            self.assertEqual(environment.metadata, {"render_modes": ["ansi"]})


class Mistakes(unittest.TestCase):
    def test_what_is_wrong_with_arguments_is_said(self):
        for more, message in (
                ({"actions": []}, "there must be an action"),
                ({"actions": [3]}, "an order is None, a command's name, or a pair"),
                ({"actions": ["move to"]}, "'move to' is not a name"),
                ({"actions": [("move-to", {"x": math.nan})]}, "a finite number"),
                ({"actions": [("move-to", {"x": [1]})]}, "a number or a text"),
                ({"actions": [("say", {"text": "a\nb"})]}, "characters that no value may have"),
                ({"observe": []}, "observe names percepts"),
                ({"observe": [1]}, "observe names percepts"),
                ({"ticks": 0}, "ticks are"),
                ({"render_mode": "human"}, "render_mode")):
            with self.subTest(more=more), self.assertRaisesRegex((TypeError, ValueError), message):
                hallway(**more)
        with self.assertRaisesRegex(soarbox.WorldError, "say for which agent Python decides: anna, bert"):
            soarbox.Environment("soar_hallway", actions=ACTIONS, observe=OBSERVE)
        with self.assertRaisesRegex(KeyError, "there are: anna, bert"):
            soarbox.Environment("soar_hallway", "carl", actions=ACTIONS, observe=OBSERVE)

    def test_steps_need_an_episode(self):
        environment = hallway()
        with self.assertRaisesRegex(soarbox.WorldError, "call reset"):
            environment.step(0)
        environment.reset()
        for action in (4, -1, "stop", None, 1.5, True):
            with self.subTest(action=action), self.assertRaisesRegex(ValueError, r"is not an action: Discrete\(4\)"):
                environment.step(action)
        environment.close()
        environment.close()
        with self.assertRaisesRegex(soarbox.WorldEnded, "closed"):
            environment.step(0)

    def test_a_word_is_no_number(self):
        with hallway(observe=["self.stance"]) as environment:
            with self.assertRaisesRegex(ValueError, r"\^self.stance is the word 'standing'"):
                environment.reset()

    def test_a_command_that_does_not_exist_is_a_warning(self):
        with hallway(actions=["mve-to"]) as environment:
            environment.reset()
            with self.assertWarnsRegex(UserWarning, "did you mean .move-to"):
                *_, info = environment.step(0)
            self.assertEqual(info["command"], "error")
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                environment.step(0)

    def test_a_world_that_dies_ends_the_episode(self):
        with hallway() as environment:
            environment.reset()
            before = environment.step(2)
            environment.world._engine._process.kill()
            environment.world._engine._process.wait()
            after = environment.step(2)
            self.assertEqual((tuple(after[0]), *after[2:]), (tuple(before[0]), True, False, before[4]))
            environment.reset()
            self.assertEqual(environment.step(2)[2:4], (False, False))

    def test_texts_of_parameters_are_quoted(self):
        for value, text in (("a|b\\", "|a\\|b\\\\|"), (True, "yes"), (3.0, "3"), (0.5, "0.500000000"), ("3", "|3|")):
            self.assertIn(f"^to {text})", soarbox.environment.rule_of(("say", {"to": value})))


class Spaces(unittest.TestCase):
    def test_samples_are_inside_and_repeat_with_the_seed(self):
        for make in (lambda: soarbox.Discrete(3, start=-1), lambda: soarbox.Box(-1, [1, math.inf, 0]),
                     lambda: soarbox.Box(-math.inf, [math.inf, 2], shape=(2,)), lambda: soarbox.Box(0.1, 0.1, (1,))):
            space, again = make(), make()
            self.assertEqual(space, again)
            space.seed(4)
            again.seed(4)
            for _ in range(50):
                sample, same = space.sample(), again.sample()
                self.assertIn(sample, space)
                self.assertEqual(tuple(sample) if space.shape else sample, tuple(same) if space.shape else same)

    def test_what_is_outside_is_not_inside(self):
        for outside in (3, -1, True, 0.5, "0", None):
            self.assertNotIn(outside, soarbox.Discrete(3))
        for outside in ((0, 2), (0,), 0, ("a", 0), None, (math.nan, 0)):
            self.assertNotIn(outside, soarbox.Box(-1, 1, (2,)))
        self.assertNotEqual(soarbox.Discrete(3), soarbox.Discrete(4))

    def test_spaces_that_cannot_be_are_refused(self):
        for make in (lambda: soarbox.Discrete(0), lambda: soarbox.Discrete(2.5), lambda: soarbox.Box(0, 1),
                     lambda: soarbox.Box([0, 1], [1]), lambda: soarbox.Box(2, 1, (1,)), lambda: soarbox.Box(0, 1, (1, 2))):
            with self.assertRaises(ValueError):
                make()

    @unittest.skipIf(sys.modules.get("numpy", ...) is None or not importlib.util.find_spec("numpy"), "there is no numpy")
    def test_with_numpy_observations_are_arrays_of_float32(self):
        low = soarbox.Box(0, 0.1, (2,)).low
        self.assertEqual((type(low).__name__, str(low.dtype)), ("ndarray", "float32"))

    def test_without_numpy_observations_are_tuples(self):
        real = builtins.__import__

        def without(name, *others):
            if name == "numpy":
                raise ImportError(name)
            return real(name, *others)

        with mock.patch("builtins.__import__", without):
            self.assertEqual(soarbox.Box(0, 1, (2,)).low, (0.0, 0.0))


# Continuous integration builds the page first.
PAGE = pathlib.Path(__file__).resolve().parents[2] / "web" / "dist" / "page" / "report_scene.js"


@unittest.skipUnless(PAGE.exists() or os.environ.get("CI") == "true", "the page of reports is not built: ./dev test builds it")
class Pages(unittest.TestCase):
    def page_of(self, shown):
        frame = re.fullmatch(r'<iframe srcdoc="([^"]*)" sandbox="allow-scripts" [^>]*></iframe>', shown)
        self.assertTrue(frame, shown[:200])
        return html.unescape(frame[1])

    def test_a_recorded_run_shows_itself_as_its_page(self):
        with tempfile.TemporaryDirectory() as folder:
            run = soarbox.record("soar_hallway", os.path.join(folder, "run.soarrec"), seconds=2, seed=3)
            self.assertEqual(set(run.table().column("agent")), {"anna", "bert"})
            page = self.page_of(run._repr_html_())
            self.assertTrue(page.lower().startswith("<!doctype html>"))
            self.assertIn("soar_hallway", page)
            run.report(os.path.join(folder, "page.html"))
            self.assertIn("anna", pathlib.Path(folder, "page.html").read_text(encoding="utf-8"))
            os.remove(run.file)
            with self.assertRaisesRegex(soarbox.CommandError, "run.soarrec"):
                run._repr_html_()

    def test_a_world_shows_its_run_so_far(self):
        with soarbox.World("soar_hallway", seed=3) as world, tempfile.TemporaryDirectory() as folder:
            self.assertIsNone(world._repr_html_())
            with self.assertRaisesRegex(soarbox.WorldError, "nothing is recorded yet"):
                world.report(os.path.join(folder, "page.html"))
            world.run(2)
            self.assertIn("bert", self.page_of(world._repr_html_()))
            world.report(os.path.join(folder, "page.html"))
            self.assertTrue(os.path.getsize(os.path.join(folder, "page.html")))
        self.assertIsNone(world._repr_html_())
        with self.assertRaises(soarbox.WorldEnded):
            world.report("page.html")


if __name__ == "__main__":
    unittest.main()
