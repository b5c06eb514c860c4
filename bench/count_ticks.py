#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Count the instructions of a tick of the crowds, by part, with valgrind (callgrind).

usage: count_ticks.py WORLD_TICKS [AGENTS...]      default: 1 10 100 1000

Prints one line of JSON per crowd: instructions per tick in total, of the minds (percepts, decisions,
results of commands), of the scripts (updates of agents, including steering), of the physics and of
the rest. The first tick is left out, because it creates data that is used later. Uses one thread,
so that the counts do not depend on the load of the machine.
"""
import json
import re
import subprocess
import sys
import tempfile

TICKS = "MeasuredTicks"
PARTS = {
    "minds": ["soarbox::sim::Minds::Decide()", "soarbox::sim::Minds::Await(", "soarbox::sim::Minds::Answer()"],
    "scripts": ["soarbox::script::ScriptHost::UpdateAgent("],
    "physics": ["soarbox::world::World::Step()"],
}


def seconds_for(agents):
    """Simulated seconds: thousands of updates of agents, but only a few ticks of a large crowd."""
    return min(10.0, max(0.35, 100 / agents))


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed: {(done.stderr.strip().splitlines() or ['no output'])[-1]}")
    return done.stdout


def inclusive(profile):
    """Instructions of each function including its callees, by name."""
    counts = {}
    for line in run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", profile]).splitlines():
        match = re.match(r"\s*([\d,]+) \(.*?\)\s+\S*?:(.+?)( \[[^\]]*\])?$", line)
        if match:
            count = int(match.group(1).replace(",", ""))
            counts[match.group(2)] = max(count, counts.get(match.group(2), 0))
    return counts


def count_of(counts, function):
    found = [count for name, count in counts.items() if function in name]
    if not found:
        sys.exit(f"the profile does not know {function}: has it been inlined or renamed?")
    return max(found)


def measure(world_ticks, agents):
    with tempfile.TemporaryDirectory() as folder:
        profile = f"{folder}/profile"
        text = run(["valgrind", "--tool=callgrind", f"--toggle-collect=*{TICKS}*", f"--callgrind-out-file={profile}",
                    world_ticks, str(agents), str(seconds_for(agents)), "1"])
        ticks = json.loads(text.strip().splitlines()[-1])["ticks"]
        counts = inclusive(profile)
    per_tick = {"all": count_of(counts, TICKS) / ticks}
    for part, functions in PARTS.items():
        per_tick[part] = sum(count_of(counts, function) for function in functions) / ticks
    per_tick["rest"] = per_tick["all"] - sum(per_tick[part] for part in PARTS)
    return {"benchmark": "count_ticks", "agents": agents, "ticks": ticks,
            "instructions_per_tick": {part: round(count) for part, count in per_tick.items()}}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__.strip())
    for agents in [int(text) for text in sys.argv[2:]] or [1, 10, 100, 1000]:
        print(json.dumps(measure(sys.argv[1], agents)), flush=True)


main()
