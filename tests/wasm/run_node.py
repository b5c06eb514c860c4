#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Tests the programs for Node.js against the native command, as `./dev wasm test` calls it.

usage: run_node.py --node FOLDER --native SOARBOX [--only golden|worlds|recordings] [NAME...]

golden       the kernel's cases (tests/golden): as many agree with Soar 9.6.3 as natively
worlds       every world that comes with the program, sway, and every lesson with its solution end in the same state as natively, bit for bit
recordings   if the command was compiled: the recordings of each program are simulated again by the other, with the same state in each tick

NAME: only worlds and lessons of these names. The exit status is 1 if anything differs.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
GOLDEN = REPOSITORY / "tests" / "golden"
AREAS = ("core", "differential", "random", "learning", "memory", "svs", "cases_own")
SECONDS = 60
# Scripts in Lua only; minds with steering and paths; minds that die; minds that learn.
RECORDED = ("thesis", "soar_hallway", "soar_skirmish", "soar_reward")


class Differences:
    """Prints and counts differences."""

    def __init__(self):
        self.count = 0

    def report(self, what):
        self.count += 1
        print(f"DIFFERS  {what}", flush=True)


def run(command, *arguments, limit_s=900):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([str(command), *map(str, arguments)], capture_output=True, text=True, check=False, env=environment,
                          timeout=limit_s, cwd=REPOSITORY)


def end_of(*words):
    """The last event of a run as a dictionary, or the error if there is none; and the duration in seconds."""
    start = time.monotonic()
    done = run(*words)
    ends = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"event":"end"')]
    seconds = time.monotonic() - start
    if not ends:
        return {"state": f"none, exit status {done.returncode}: {(done.stderr or done.stdout)[-500:]}"}, seconds
    return ends[-1], seconds


def shipped_worlds():
    return sorted(folder for folder in (REPOSITORY / "scenarios").iterdir()
                  if (folder / "scenario.toml").exists() or (folder / "Sandbox.lua").exists())


def solved_lessons(folder):
    """Copies each lesson with its solution in place of the learner's files into a folder."""
    lessons = []
    for solution in sorted((REPOSITORY / "lessons").rglob("solution")):
        lesson = folder / solution.parent.relative_to(REPOSITORY)
        shutil.copytree(solution.parent, lesson, ignore=shutil.ignore_patterns("wrong", "solution"))
        shutil.copytree(solution, lesson, dirs_exist_ok=True)
        lessons.append(lesson)
    return lessons


def check_golden(node, differences):
    minimum = json.loads((GOLDEN / "minimum.json").read_text(encoding="utf-8"))
    for area in AREAS:
        start = time.monotonic()
        done = run(sys.executable, GOLDEN / "run_golden.py", "--driver", node / "trace_case", "--cases", GOLDEN / area,
                   "--minimum", GOLDEN / "minimum.json", limit_s=3600)
        print(f"golden   {area}: {minimum.get(area)} required, {time.monotonic() - start:.0f} s", flush=True)
        print("  " + done.stdout.strip().replace("\n", "\n  "), flush=True)
        if done.returncode != 0:
            differences.report(f"golden cases of {area}: {done.stderr[-1000:]}")


def check_worlds(node, native, names, differences):
    """The number of worlds and lessons that were compared."""
    with tempfile.TemporaryDirectory() as folder:
        worlds = [*shipped_worlds(), REPOSITORY / "tests" / "wasm" / "sway", *solved_lessons(pathlib.Path(folder))]
        chosen = [world for world in worlds if not names or world.name in names]
        compare_worlds(node, native, chosen, differences)
    return len(chosen)


def compare_worlds(node, native, worlds, differences):
    for world in worlds:
        (ours, node_s) = end_of(node / "run_world", world, SECONDS)
        (theirs, native_s) = end_of(native, "run", world, "--headless", "--json", "--seconds", SECONDS, "--threads", 1)
        if ours["state"] == theirs["state"] and "ticks" in theirs:
            print(f"same     {world.name}: {ours['state']} after {theirs['ticks']} ticks; node {node_s:.1f} s, native {native_s:.1f} s",
                  flush=True)
        else:
            differences.report(f"{world.name}: node {ours['state']}, native {theirs['state']}")


def check_recordings(node, native, names, differences):
    """Each records, the other simulates the recording again."""
    with tempfile.TemporaryDirectory() as folder:
        for world in (name for name in RECORDED if not names or name in names):
            for title, recorder, verifier in (("node's", node / "soarbox", native), ("native", native, node / "soarbox")):
                file = pathlib.Path(folder) / "run.soarrec"
                made = run(recorder, "run", REPOSITORY / "scenarios" / world, "--headless", "--seconds", SECONDS, "--record", file)
                verified = run(verifier, "verify", file)
                verdict = re.search(r"^equal: .*$", verified.stdout, re.MULTILINE)
                if made.returncode == 0 and verified.returncode == 0 and verdict:
                    print(f"same     {title} recording of {world}: {verdict.group()}", flush=True)
                else:
                    differences.report(f"{title} recording of {world}: {made.stderr[-500:]}{verified.stdout[-500:]}{verified.stderr[-500:]}")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--node", required=True, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--native", required=True, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--only", choices=("golden", "worlds", "recordings"))
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    differences = Differences()
    start = time.monotonic()
    worlds = 0
    if arguments.only in (None, "golden") and not arguments.names:
        check_golden(arguments.node, differences)
    if arguments.only in (None, "worlds"):
        worlds = check_worlds(arguments.node, arguments.native, arguments.names, differences)
    if arguments.only == "recordings" or (arguments.only is None and (arguments.node / "soarbox.js").exists()):
        check_recordings(arguments.node, arguments.native, arguments.names, differences)
    print(f"{worlds} worlds and lessons; {differences.count} differences; {time.monotonic() - start:.0f} s", flush=True)
    return 1 if differences.count else 0


if __name__ == "__main__":
    sys.exit(main())
