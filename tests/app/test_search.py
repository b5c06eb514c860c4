# SPDX-License-Identifier: BSD-2-Clause
"""The examples that search for parameters with sweeps (docs/search.md)."""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

from mission_case import REPOSITORY, RULES, SWEEP, WORLD, MissionCase
from soarbox_command import COMMAND

EXAMPLES = REPOSITORY / "docs" / "examples" / "search"


class Search(MissionCase):
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

    def test_optuna(self):
        if importlib.util.find_spec("optuna") is None:
            self.skipTest("Optuna is not installed")
        out, _ = self.type(sys.executable, EXAMPLES / "optuna_search.py", "hares", 3)
        self.assertRegex(out, r"best: \{'speed': [\d.]+, 'sight': \d+\}, [\d.]+ m")
        # The study continues.
        self.type(sys.executable, EXAMPLES / "optuna_search.py", "hares", 1)
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
