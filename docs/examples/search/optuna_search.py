# SPDX-License-Identifier: BSD-2-Clause
"""Optuna looks for the speed and the range of view with which a hare walks least. Needs Optuna (Debian: python3-optuna).

    python3 optuna_search.py FOLDER TRIALS
"""
import json
import pathlib
import statistics
import subprocess
import sys

import optuna

SPEC = """
scenario = "soar_evade"
seeds = "1..{seeds}"
seconds = 20
[[variant]]
name = "hare"
parameters = {{ "agent.hare.speed" = {speed}, "agent.hare.senses.sight" = {sight}, "agent.hare.senses.noise" = 0.5 }}
[[metric]]
name = "walked"
at_end = "distance"
agent = "hare"
"""


def objective(trial, folder):
    speed = trial.suggest_float("speed", 2, 9, step=0.5)
    sight = trial.suggest_int("sight", 10, 60, step=5)
    spec = folder / f"trial-{trial.number}.toml"
    for seeds in (4, 8, 16):
        spec.write_text(SPEC.format(seeds=seeds, speed=speed, sight=sight), encoding="utf-8")
        done = subprocess.run(["soarbox", "sweep", spec, "--json"], stdout=subprocess.PIPE, text=True, check=True)
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        mean = statistics.mean(line["walked"] for line in lines if line["event"] == "run")
        trial.report(mean, seeds)
        if trial.should_prune():
            raise optuna.TrialPruned
    return mean


def main():
    folder, trials = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    # What was tried is kept: the same command continues.
    study = optuna.create_study(study_name="hare", storage=f"sqlite:///{folder}/optuna.db", load_if_exists=True,
                                sampler=optuna.samplers.TPESampler(seed=1))
    study.optimize(lambda trial: objective(trial, folder), n_trials=trials)
    print(f"best: {dict(sorted(study.best_params.items()))}, {study.best_value:.1f} m")


if __name__ == "__main__":
    main()
