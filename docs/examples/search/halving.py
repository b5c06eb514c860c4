# SPDX-License-Identifier: BSD-2-Clause
"""Successive halving: many speeds with few seeds, the better half of them with twice as many, until one is left.

    python3 halving.py FOLDER
"""
import json
import pathlib
import statistics
import subprocess
import sys

HEAD = """
scenario = "soar_evade"
seeds = "1..{seeds}"
seconds = 20
[[metric]]
name = "walked"
at_end = "distance"
agent = "hare"
"""
VARIANT = """
[[variant]]
name = "speed-{speed}"
parameters = {{ "agent.hare.speed" = {speed}, "agent.hare.senses.noise" = 0.5 }}
"""


def walked(folder, speeds, seeds):
    """How far the hare walks at each of these speeds, on average. Runs that are there are not made again."""
    spec = folder / "search.toml"
    spec.write_text(HEAD.format(seeds=seeds) + "".join(VARIANT.format(speed=speed) for speed in speeds), encoding="utf-8")
    done = subprocess.run(["soarbox", "sweep", spec, "--json"], stdout=subprocess.PIPE, text=True, check=True)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return {speed: statistics.mean(line["walked"] for line in lines if line.get("variant") == f"speed-{speed}") for speed in speeds}


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    speeds, seeds = [2, 3, 4, 5, 6, 7, 8, 9], 4
    while len(speeds) > 1:
        means = walked(folder, speeds, seeds)
        speeds = sorted(sorted(speeds, key=means.get)[:len(speeds) // 2])
        print(f"{seeds} seeds: the best are {speeds}", flush=True)
        seeds *= 2
    print(f"speed {speeds[0]}")


if __name__ == "__main__":
    main()
