# SPDX-License-Identifier: BSD-2-Clause
"""Metrics of sweeps: each metric alone equals the number computed from a recording of the same run."""
import csv
import json
import math
import shutil
import sqlite3

from mission_case import REPOSITORY, SWEEP, MissionCase
from soarbox_command import Run

SEED = 5
# World, agent and seconds: the numeric metrics of docs/missions.md that are not zero there.
WORLDS = {
    ("soar_skirmish", "blue-1", 7): ("health", "ammunition", "speed", "distance", "rounds", "damage", "idle", "answered", "repeats",
                                     "decisions", "firings", "elements"),
    ("soar_town", "learner", 90): ("depth", "learned", "reused"),
    ("soar_reward", "learner", 12): ("reward", "updates", "values"),
    # It finds nothing to eat around this second, so its perceived score equals its score.
    ("eaters", "eater", 24.5): ("score",),
}


class Recording:
    """One recorded run, and values that can be computed from it without a mission."""

    def __init__(self, file, agent, seconds):
        self.file, self.agent, self.seconds = file, agent, seconds
        lines = [json.loads(line) for line in Run("export", file, "--json", code=0).out.splitlines()]
        self.step_s, self.ticks = lines[0]["step_s"], lines[1:]
        self.body = [next(each for each in tick["agents"] if each["name"] == agent) for tick in self.ticks]
        self.minds = [mind for tick in self.ticks for mind in tick.get("minds", []) if mind["agent"] == agent]

    def inspect(self, view):
        return Run("inspect", self.file, "--at", self.seconds, "--agent", self.agent, "--view", view, "--json", code=0).out

    def console(self, command):
        return Run("inspect", self.file, "--at", self.seconds, "--agent", self.agent, "--view", f"console {command}", code=0).out

    def stack(self, key):
        return json.loads(self.inspect("stack"))[key]

    def percept(self, name):
        told = [line.split()[1] for mind in self.minds for line in mind.get("percepts", []) if line.split()[0] == name]
        return float(told[-1])

    def rules(self, command):
        """The fields of each row in the output of a command about rules."""
        return [line.split() for line in self.console(command).splitlines()[1:] if line.strip()]

    def health(self):
        return self.body[-1]["health"]

    def damage(self):
        return sum(max(0, a["health"] - b["health"]) for a, b in zip(self.body, self.body[1:]))

    def speed(self):
        x, _, z = self.body[-1]["velocity"]
        return math.hypot(x, z)

    def distance(self):
        return sum(math.hypot(b["position"][0] - a["position"][0], b["position"][2] - a["position"][2])
                   for a, b in zip(self.body, self.body[1:]))

    def idle(self):
        by_tick = [next((mind for mind in tick.get("minds", []) if mind["agent"] == self.agent), {}) for tick in self.ticks]
        running, idle = set(), 0
        for mind, body in list(zip(by_tick, self.body))[1:]:
            for line in mind.get("commands", []):
                name = line.split()[0].rstrip(":")
                (running.discard if line.startswith(f"{name}: ") else running.add)(name)
            idle += 0 if running or not body["alive"] else self.step_s
        return idle

    def ammunition(self):
        return self.percept("self.ammunition") + self.percept("self.reserve")

    def rounds(self):
        first = next(mind for mind in self.minds if mind.get("percepts"))
        told = {line.split()[0]: float(line.split()[1]) for line in first["percepts"] if line.startswith(("self.ammunition ", "self.reserve "))}
        return sum(told.values()) - self.ammunition()

    def decisions(self):
        return self.stack("decisions")

    def firings(self):
        return self.stack("firings")

    def elements(self):
        return self.stack("elements")

    def depth(self):
        return len(self.stack("states"))

    def answered(self):
        output = json.loads(self.inspect("io"))["output"]
        return sum(any(each["attribute"] == "status" for each in command.get("elements", [])) for command in output["elements"])

    def learned(self):
        return sum(row[-1].startswith("chunk") for row in self.rules("production firing-counts") if row[0].endswith(":"))

    def reused(self):
        return sum(float(row[0].rstrip(":")) for row in self.rules("production firing-counts") if row[-1].startswith("chunk"))

    def reward(self):
        return float(self.console("rl -S").split("Global reward since init:")[1])

    def score(self):
        return self.percept("eater.score")

    def repeats(self):
        under_way, repeated = {}, 0
        for line in (line for mind in self.minds for line in mind.get("commands", [])):
            name = line.split()[0].rstrip(":")
            if line.startswith(f"{name}: "):
                under_way.pop(name, None)
                continue
            repeated += under_way.get(name) == line
            under_way[name] = line
        return repeated

    def updates(self):
        return sum(float(row[1]) for row in self.rules("print --rl"))

    def values(self):
        return len(self.rules("print --rl"))


class Metrics(MissionCase):
    def alone(self, scenario, seconds, metrics):
        """The row of one run of a sweep with only these metrics."""
        text = f'scenario = "{scenario}"\nseeds = "{SEED}"\nseconds = {seconds}\n'
        for name, how, key, agent in metrics:
            text += f'[[metric]]\nname = "{name}"\n{how} = "{key}"\nagent = "{agent}"\n'
        folder = self.folder / "alone.sweep"
        shutil.rmtree(folder, ignore_errors=True)
        Run("sweep", self.write("alone.toml", text), code=0)
        with open(folder / "results.csv", newline="", encoding="utf-8") as file:
            return next(csv.DictReader(file))

    def test_each_metric_alone_is_what_a_recording_gives(self):
        for (scenario, agent, seconds), keys in WORLDS.items():
            kept = self.folder / f"{scenario}.soarrec"
            Run("run", scenario, "--headless", "--seed", SEED, "--seconds", seconds, "--record", kept, "--record-level", "all", code=0)
            recording = Recording(kept, agent, seconds)
            for key in keys:
                with self.subTest(key=key):
                    row = self.alone(scenario, seconds, [("it", "at_end", key, agent)])
                    self.assertNotEqual(row["it"], "", "it was not measured")
                    expected = getattr(recording, key)()
                    self.assertAlmostEqual(float(row["it"]), expected, delta=1e-3 * max(1, abs(expected)))
                    self.assertEqual(row["state_hash"], recording.ticks[-1]["state"], "the recording is of this run")

    def test_a_metric_that_nobody_has_is_empty_and_not_zero(self):
        row = self.alone("thesis", 2, [("points", "at_end", "score", "*"), ("learned rules", "max", "learned", "*")])
        self.assertEqual(row["points"], "")
        self.assertEqual(row["learned rules"], "0")

    def test_every_number_of_the_documents_is_measured_here(self):
        page = (REPOSITORY / "docs" / "missions.md").read_text(encoding="utf-8")
        numbers = {"health", "ammunition", "speed", "score", "distance", "rounds", "damage", "idle", "answered", "elements", "depth",
                   "decisions", "firings", "repeats", "learned", "reused", "reward", "updates", "values"}
        for number in numbers:
            self.assertIn(f"`{number}`", page)
        self.assertEqual(numbers, {key for keys in WORLDS.values() for key in keys})

    def test_names_that_a_table_has_already_are_refused_before_the_first_run(self):
        self.mission("")
        for name in ("distance", "Distance", "health", "decisions", "seconds", "idle", "seed", "passed", "outcome", "impasses_tie",
                     "state_hash", "check: there", "agent.scout.speed"):
            metric = f'[[metric]]\nname = "{name}"\nmax = "distance"\nagent = "scout"\n'
            run = Run("sweep", self.write("clash.toml", SWEEP + metric), code=3)
            self.assertRegex(run.err, r"clash\.toml:\d+.*(each table has a column|there is a parameter)")
            self.assertIn("give this metric another name", run.err)
            self.assertFalse((self.folder / "clash.sweep").exists(), name)
        two = '[[metric]]\nname = "m"\nmax = "speed"\n[[metric]]\nname = "M"\nmax = "distance"\n'
        self.assertIn("there are two metrics named 'M'", Run("sweep", self.write("clash.toml", SWEEP + two), code=3).err)

    def test_checks_whose_names_differ_in_case_get_columns_of_their_own(self):
        self.mission("")
        spec = SWEEP.split("[[variant]]")[0].replace("1..6", "1") + '[[check]]\nname = "There"\nagent = "scout"\nat = "gate"\nby = 7\n'
        Run("sweep", self.write("two.toml", spec), code=0)
        with sqlite3.connect(self.folder / "two.sweep" / "results.sqlite") as database:
            names = [row[1] for row in database.execute("PRAGMA table_info(runs)")]
        self.assertIn("check: there", names)
        self.assertIn("check: There (2)", names)
