# SPDX-License-Identifier: BSD-2-Clause
"""Every world ends in the same state if its minds run in its own process, in our kernel in another process, or in the
kernel at SOARBOX_SOAR_KERNEL=HOST:PORT, which may be one of Soar 9.6.3 (docs/official_soar.md)."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests" / "app"))

from soarbox_command import COMMAND, new_folder, run_json  # noqa: E402

SCENARIOS, LESSONS, PAGES = REPOSITORY / "scenarios", REPOSITORY / "lessons", REPOSITORY / "docs" / "lessons"
OFFICIAL = os.environ.get("SOARBOX_SOAR_KERNEL", "")

# These worlds are left out.
LEFT_OUT = {
    "scenarios/crowd": "crowd_10.lua is the same with fewer agents",
    "scenarios/crowd/crowd_100.lua": "crowd_10.lua is the same with fewer agents",
    "scenarios/crowd/crowd_1000.lua": "crowd_10.lua is the same with fewer agents",
    "scenarios/crowd/crowd_10000.lua": "crowd_10.lua is the same with fewer agents",
    "scenarios/soar_skirmish/skirmish_100.toml": "scenario.toml is the same with fewer agents",
    "scenarios/soar_skirmish/skirmish_200.toml": "scenario.toml is the same with fewer agents",
    "scenarios/soar_wander/strollers_1000.toml": "scenario.toml is the same with fewer agents",
    "scenarios/soar_skirmish/joint_blue.toml": "it waits for another process (DIS)",
    "scenarios/soar_skirmish/joint_red.toml": "it waits for another process (DIS)",
    "scenarios/soar_skirmish/joint_watch.toml": "it waits for another process (DIS)",
}

# In each of these worlds, several agents draw random numbers. All agents of an official kernel share one generator; in our kernel each agent has its
# own. For an official kernel, only the listed agents run, one of each, and only the last of them draws random numbers.
ONE_DRAWS = {
    "scenarios/eaters/four.toml": [["greedy.soar"], ["wanderer.soar"], ["learner.soar"]],
    "scenarios/soar_ambush": [["hare", "red", "blue"]],
    "scenarios/soar_remember": [["watchman", "scout"], ["watchman", "drifter"]],
    "scenarios/soar_reward": [["learner"], ["fixed"]],
    "scenarios/soar_skirmish": [["red-leader", "blue"], ["blue-leader", "red-leader"]],
    "scenarios/soar_town": [["learner"], ["forgetful"]],
    "scenarios/tanksoar": [["hunter.soar"], ["wanderer.soar"]],
    "scenarios/tanksoar/four.toml": [["learner.soar"]],
    "lessons/tanks/t8-mission": [["tank"], ["bot"]],
}

# If the eye or its target moves, Soar 9.6.3 keeps the lines of sight of an occlusion's first computation
# (docs/spec/imagery.md). In these worlds it runs with a copy of the rules that extracts again at each moment, for this number of seconds.
ASKED_ANEW = {
    "lessons/13-imagine": ("mouse.soar", 40),
    "scenarios/soar_hide": ("hider.soar", 40),
}

# A lesson may take long until its agent has learned.
SECONDS = {"scenarios": 5, "docs": 10, "lessons": 20}


def name_of(path):
    return path.relative_to(REPOSITORY).as_posix()


def worlds():
    """All worlds that `soarbox run` accepts: scenarios, their variants, and the lessons."""
    for folder in sorted(SCENARIOS.iterdir()):
        if (folder / "scenario.toml").exists() or (folder / "Sandbox.lua").exists():
            yield folder
        for file in sorted(folder.iterdir()):
            if file.name in ("scenario.toml", "mission.toml", "Sandbox.lua") or file.suffix == ".toml" and "[[variant]]" in file.read_text():
                continue
            if file.suffix == ".toml" or (file.suffix == ".lua" and "function Sandbox_Initialize" in file.read_text()):
                yield file
    yield from sorted(file.parent for file in PAGES.glob("*/scenario.toml"))
    yield from sorted(file.parent for file in LESSONS.rglob("lesson.toml"))


def with_agents(scenario, wanted):
    """The text of a scenario with one agent for each given name or file of rules, in this order."""
    blocks = re.split(r"(?m)^(?=\[\[)", scenario)
    agents = [block for block in blocks if block.startswith("[[agent]]")]
    kept = []
    for one in wanted:
        block = next(block for block in agents if re.search(rf'(?m)^(name|rules) = "{re.escape(one)}"$', block))
        kept.append(re.sub(r"(?m)^(count|leader) = .*\n", "", block))
    others = [block for block in blocks if not block.startswith("[[agent]]")]
    return "".join([others[0], *kept, *others[1:]])


def asking_anew(rules):
    """The same rules with extract_once instead of extract."""
    blocks = []
    for block in re.split(r"(?m)^(?=sp \{)", rules):
        if "^extract <x>" in block:
            block = block.replace("(state <s> ^superstate nil", "(state <s> ^superstate nil ^io.input-link.time <asked>")
            block = block.replace("^extract <x>)", "^extract_once <x>)\n   (<x> ^asked <asked>)")
        blocks.append(block.replace("^svs.command.extract ", "^svs.command.extract_once "))
    return "".join(blocks)


def end_of(world, seconds, *arguments):
    """The result of a run: its last event, and all commands of its agents."""
    run = run_json(world, "--seconds", seconds, "--seed", 1, "--every-command", *arguments)
    ends = run.of("end")
    if run.code not in (0, 1) or len(ends) != 1:
        raise AssertionError(f"{world}: no end was reached ({run.code}): {run.err[-500:]}")
    return ends[0], run.of("command")


class Worlds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kernel = subprocess.Popen([COMMAND, "kernel", "--port", "0"], stdout=subprocess.PIPE, text=True)
        cls.addClassCleanup(cls.kernel.wait)
        cls.addClassCleanup(cls.kernel.stdout.close)
        cls.addClassCleanup(cls.kernel.terminate)
        cls.elsewhere = re.search(r"listens on (\S+:\d+)", cls.kernel.stdout.readline()).group(1)
        cls.folder = new_folder(cls)

    def solved(self, lesson):
        """A copy of a lesson that contains the solution."""
        copy = self.folder / name_of(lesson)
        shutil.copytree(lesson, copy, dirs_exist_ok=True)
        shutil.copytree(lesson / "solution", copy, dirs_exist_ok=True)
        return copy / "scenario.toml"

    def reduced(self, world, wanted):
        """A copy of a world with these agents only."""
        file = world / "scenario.toml" if world.is_dir() else world
        copy = self.folder / "-".join(wanted) / file.parent.name
        shutil.copytree(file.parent, copy)
        (copy / file.name).write_text(with_agents(file.read_text(), wanted))
        return copy / file.name

    def anew(self, world, rules):
        """A copy of a world in which the agent extracts from its scene again at each moment."""
        folder = world if world.is_dir() else world.parent
        copy = self.folder / "anew" / folder.name
        shutil.copytree(folder, copy)
        text = (copy / rules).read_text()
        self.assertNotEqual(asking_anew(text), text)
        (copy / rules).write_text(asking_anew(text))
        return copy / "scenario.toml"

    def same(self, world, seconds, kernel):
        """Compares a world's own run with that in another kernel; returns the number of commands."""
        near, commands = end_of(world, seconds, "--threads", 1)
        far, far_commands = end_of(world, seconds, "--kernel", kernel)
        self.assertEqual(commands, far_commands)
        self.assertEqual(near, far)
        return len(commands) if near["soar_agents"] else 0

    def compare(self, kernel, official):
        commands = 0
        for world in worlds():
            name = name_of(world)
            if name in LEFT_OUT:
                continue
            seconds = SECONDS[name.split("/")[0]]
            if name.startswith("lessons"):
                world = self.solved(world)
            if official and name in ASKED_ANEW:
                rules, seconds = ASKED_ANEW[name]
                with self.subTest(name, anew=rules):
                    commands += self.same(self.anew(world, rules), seconds, kernel)
            elif not (official and name in ONE_DRAWS):
                with self.subTest(name):
                    commands += self.same(world, seconds, kernel)
            for wanted in ONE_DRAWS.get(name, []):
                with self.subTest(name, only=wanted):
                    commands += self.same(self.reduced(world, wanted), seconds, kernel)
        self.assertGreater(commands, 1000, "minds that do nothing show nothing")

    def test_in_a_kernel_of_ours_in_another_process(self):
        self.compare(self.elsewhere, official=False)

    @unittest.skipUnless(OFFICIAL, "SOARBOX_SOAR_KERNEL=HOST:PORT names no kernel of Soar 9.6.3")
    def test_in_an_official_kernel(self):
        self.compare(OFFICIAL, official=True)

    def test_the_list_of_exceptions_names_worlds_that_there_are(self):
        there = {name_of(world) for world in worlds()}
        self.assertGreater(len(there), 60)
        self.assertEqual((set(LEFT_OUT) | set(ONE_DRAWS) | set(ASKED_ANEW)) - there, set())
