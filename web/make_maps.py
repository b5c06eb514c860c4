#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Writes src/lesson/maps.json: a map of each world and lesson in its first tick, for the cards of the start page.

    SOARBOX=../build/release/bin/soarbox python3 make_maps.py [NAME...]

A map has `things` ([x, z, width, depth, turn in degrees]; a circle has a depth of 0) and `agents` ([x, z]), in 1/200 of its
width, from its corner.
"""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
MAPS = HERE / "src" / "lesson" / "maps.json"
SOARBOX = os.path.abspath(os.environ.get("SOARBOX", ROOT / "build" / "release" / "bin" / "soarbox"))
MOST_THINGS, MOST_ALIKE, MOST_AGENTS, WIDTH = 90, 40, 60, 200


def worlds():
    """Names as the page has them, and their folders."""
    found = {path.parent.name: path.parent for path in sorted((ROOT / "scenarios").glob("*/scenario.toml"))}
    found |= {path.parent.name: path.parent for path in sorted((ROOT / "scenarios").glob("*/Sandbox.lua"))}
    # Courses name their lessons after the folder, as the first one does.
    found |= {path.parent.name: path.parent for path in sorted((ROOT / "lessons").glob("**/lesson.toml"))}
    return found


def first_tick(folder, scratch):
    recording, page = scratch / "world.soarrec", scratch / "world.html"
    done = subprocess.run([SOARBOX, "run", folder, "--headless", "--seconds", "0.1", "--record", recording], capture_output=True, text=True, check=False)
    if done.returncode > 1:
        sys.exit(f"{folder}: {done.stderr}")
    subprocess.run([SOARBOX, "report", recording, "-o", page], capture_output=True, check=True)
    text = re.search(r'<script type="application/json" id="data"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.S).group(1)
    return json.loads(text)[0]


def map_of(run):
    agents = [(agent["x"][0] / 100, agent["z"][0] / 100) for agent in run["agents"] if agent.get("x")]
    things = [thing for thing in run["things"] if max(thing["w"], thing["d"]) < 60]
    xs = [x for x, _ in agents] + [thing["x"] for thing in things if abs(thing["x"]) < 500]
    zs = [z for _, z in agents] + [thing["z"] for thing in things if abs(thing["z"]) < 500]
    if agents and things:
        # Distant scenery is left out: only objects near an agent are shown.
        near = 3 * max(max(x for x, _ in agents) - min(x for x, _ in agents), max(z for _, z in agents) - min(z for _, z in agents), 12)
        middle = (sum(x for x, _ in agents) / len(agents), sum(z for _, z in agents) / len(agents))
        things = [one for one in things if abs(one["x"] - middle[0]) < near and abs(one["z"] - middle[1]) < near]
        xs, zs = [x for x, _ in agents] + [one["x"] for one in things], [z for _, z in agents] + [one["z"] for one in things]
    if not xs:
        return {"things": [], "agents": []}
    side = max(max(xs) - min(xs), max(zs) - min(zs)) * 1.12 + 4
    left, top = (max(xs) + min(xs) - side) / 2, (max(zs) + min(zs) - side) / 2
    # Many objects with the same size are tiles of the ground.
    sizes = collections.Counter((one["w"], one["d"]) for one in things)
    things = [one for one in things if sizes[one["w"], one["d"]] <= MOST_ALIKE]
    things.sort(key=lambda one: -one["w"] * one["d"])
    short = lambda metres: round(metres / side * WIDTH)
    return {"things": [[short(one["x"] - left), short(one["z"] - top), max(2, short(one["w"])), 0 if one["round"] else max(2, short(one["d"])), round(one["turn"]) % 180] for one in things[:MOST_THINGS]],
            "agents": [[short(x - left), short(z - top)] for x, z in agents[:MOST_AGENTS]]}


def main():
    wanted = sys.argv[1:]
    maps = json.loads(MAPS.read_text(encoding="utf-8")) if wanted and MAPS.exists() else {}
    with tempfile.TemporaryDirectory() as scratch:
        for name, folder in worlds().items():
            if not wanted or name in wanted:
                maps[name] = map_of(first_tick(folder, pathlib.Path(scratch)))
    lines = [f'{json.dumps(name)}:{json.dumps(maps[name], separators=(",", ":"))}' for name in sorted(maps)]
    MAPS.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


main()
