# SPDX-License-Identifier: BSD-2-Clause
"""The examples that search for parameters with sweeps (docs/search.md)."""
import csv
import math
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from mission_case import REPOSITORY, RULES, SWEEP, WORLD, MissionCase
from soarbox_command import COMMAND, Run

EXAMPLES = REPOSITORY / "docs" / "examples" / "search"


class Search(MissionCase):
    def rows(self, folder):
        with open(self.folder / folder / "results.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def type(self, *words):
        environment = {**os.environ, "PATH": f"{pathlib.Path(COMMAND).parent}:{os.environ['PATH']}", "HOME": str(self.folder)}
        done = subprocess.run([*map(str, words)], cwd=self.folder, env=environment, capture_output=True, text=True, timeout=600, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout, done.stderr

    def test_successive_halving_makes_no_run_twice(self):
        out, err = self.type(sys.executable, EXAMPLES / "halving.py", "hares")
        self.assertRegex(out, r"\A4 seeds: the best are \[.*\]\n8 seeds: .*\n16 seeds: .*\nspeed \d\n\Z")
        made = [line for line in err.splitlines() if "runs made" in line]
        self.assertEqual([line.split(" runs made, ")[0] for line in made], ["32", "16", "16"], err)
        again, err = self.type(sys.executable, EXAMPLES / "halving.py", "hares")
        self.assertEqual(again, out)
        self.assertEqual(err.count("0 runs made"), 3, err)

    def python_with(self, module):
        """An interpreter that has this module: the current one, or the system's."""
        for python in (sys.executable, "/usr/bin/python3"):
            if pathlib.Path(python).exists() and subprocess.run([python, "-c", f"import {module}"], capture_output=True, check=False).returncode == 0:
                return python
        self.skipTest(f"{module} is not installed")

    def test_optuna(self):
        python = self.python_with("optuna")
        out, _ = self.type(python, EXAMPLES / "optuna_search.py", "hares", 3)
        self.assertRegex(out, r"best: \{'sight': \d+, 'speed': [\d.]+\}, [\d.]+ m")
        # The study continues.
        self.type(python, EXAMPLES / "optuna_search.py", "hares", 1)
        self.assertTrue((self.folder / "hares" / "trial-3.sweep" / "results.csv").is_file())

    def test_snakemake(self):
        if shutil.which("snakemake") is None:
            self.skipTest("Snakemake is not installed")
        self.type("snakemake", "--cores", 1, "--snakefile", EXAMPLES / "Snakefile")
        rows = (self.folder / "walked.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(rows), 8)

    def test_dvc(self):
        if shutil.which("dvc") is None:
            self.skipTest("DVC is not installed")
        self.write("scenario.toml", WORLD)
        self.write("scout.soar", RULES)
        self.write("study.toml", SWEEP)
        shutil.copy(EXAMPLES / "dvc.yaml", self.folder)
        self.type("dvc", "init", "--no-scm")
        self.type("dvc", "repro")
        self.assertTrue((self.folder / "study.sweep" / "results.csv").is_file())
        self.assertIn("up to date", self.type("dvc", "repro")[0])

    def test_a_sweep_of_drawn_values_covers_its_ranges(self):
        self.mission("")
        variant = """
scenario = "scenario.toml"
seeds = "1..2"
seconds = 4
[[variant]]
name = "scout"
draw = { variants = 8, design = "%s" }
parameters = { "agent.scout.speed" = { from = 1.0, to = 5.0 }, "agent.scout.senses.sight" = { from = 10, to = 17 }, "agent.scout.senses.noise" = { from = 0.01, to = 1.0, log = true } }
"""
        Run("sweep", self.write("latin.toml", variant % "latin"), code=0)
        rows = self.rows("latin.sweep")
        self.assertEqual(len(rows), 16)
        self.assertEqual({row["variant"] for row in rows}, {f"scout-{i}" for i in range(1, 9)})
        first = [row for row in rows if row["seed"] == "1"]
        parts = lambda name, part: sorted(part(float(row[name])) for row in first)
        self.assertEqual(parts("agent.scout.speed", lambda value: int((value - 1) / 4 * 8)), list(range(8)))
        self.assertEqual(parts("agent.scout.senses.sight", int), list(range(10, 18)))
        self.assertEqual(parts("agent.scout.senses.noise", lambda value: int((math.log10(value) + 2) / 2 * 8)), list(range(8)))
        # The same file gives the same variants in another folder.
        Run("sweep", self.folder / "latin.toml", "--folder", self.folder / "again", code=0)
        self.assertEqual([row["state_hash"] for row in self.rows("again")], [row["state_hash"] for row in rows])
        # More random variants do not change the first ones.
        spec = self.write("random.toml", variant % "random")
        Run("sweep", spec, code=0)
        spec.write_text(spec.read_text(encoding="utf-8").replace("variants = 8", "variants = 10"), encoding="utf-8")
        self.assertIn("4 runs made, 16 were there", Run("sweep", spec, code=0).err)

    def test_ranges_that_make_no_sense_are_refused_before_the_first_run(self):
        self.mission("")
        head = 'scenario = "scenario.toml"\nseeds = "1..2"\n[[variant]]\nname = "a"\n'
        for text, message in (('parameters = { "agent.scout.speed" = { from = 5, to = 2 } }\ndraw = { variants = 2, design = "latin" }\n',
                               "goes from one number to a greater one"),
                              ('parameters = { "agent.scout.speed" = { from = 1, to = 2 } }\n', "ranges of parameters need 'draw'"),
                              ('draw = { variants = 2, design = "latin" }\n', "'draw' needs parameters with ranges"),
                              ('parameters = { "agent.scout.speed" = { from = 1, to = 2 } }\ndraw = { variants = 2, design = "grid" }\n',
                               'the design of \'draw\' is "latin" or "random"'),
                              ('parameters = { "agent.scout.speed" = { from = 1.0, to = 2.0 } }\ndraw = { variants = 5000, design = "latin" }\n',
                               "1 to 1000 variants"),
                              ('parameters = { "agent.scout.speed" = { from = 0.0, to = 2.0, log = true } }\ndraw = { variants = 2, design = "latin" }\n',
                               "only positive numbers")):
            run = Run("sweep", self.write("wrong.toml", head + text), code=3)
            self.assertIn(message, run.err)
            self.assertRegex(run.err, r"wrong\.toml:\d+")
            self.assertFalse((self.folder / "wrong.sweep" / "parts").exists())


class Recipe(unittest.TestCase):
    def test_the_recipe_for_clusters_does_what_the_tested_one_for_containers_does(self):
        container = (REPOSITORY / "packaging" / "Containerfile").read_text(encoding="utf-8")
        cluster = (REPOSITORY / "packaging" / "soarbox.def").read_text(encoding="utf-8")
        install = next(line for line in container.splitlines() if line.startswith("RUN apt-get")).removeprefix("RUN ")
        self.assertIn("    " + install + "\n", cluster)
        base = container.rsplit("\nFROM docker.io/library/", 1)[1].splitlines()[0]
        self.assertIn(f"\nBootstrap: docker\nFrom: {base}\n", cluster)
        self.assertIn("    build/release/soarbox_*.deb /packages/\n", cluster)
        self.assertIn("/soarbox/build/release/soarbox_*.deb /packages/", container)
