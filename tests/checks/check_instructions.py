#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Checks that the kernel uses no more instructions than docs/dev/performance.md states.

usage: check_instructions.py PERFORMANCE.MD DRIVER_FOLDER [--compiler NAME]

Reads the table under the heading "The instruction gate", repeats its runs with the drivers run_bench, io_loop and
recording_cost of DRIVER_FOLDER (a release build), and fails if a run uses over 2 % more instructions than its row
states. If a change is worth more instructions, write the new figure in the same commit. The figures are for the compiler
that is named in the paragraph above the table. With another one (--compiler), the runs are only shown.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import compare_bench  # noqa: E402  (bench/ is not a package)

HEADING = "The instruction gate"
MOST_GROWTH = 0.02
RECORDING = "recording "  # Prefix of the name of a run of recording_cost, before its level.
RECORDINGS = 3  # Instructions of the writing thread only add to a count, so the smallest count is used.
SCENARIO, TICKS_PER_SECOND = "crowd/crowd_100.lua", 30
ROW = re.compile(r"^\| *([a-z_-]+(?: \w+)*) *\| *([\d,]+) *\| *([\d,]+) *\|$", re.MULTILINE)
COMPILER = re.compile(r"Counted with `([^`]+)`")


class Figures:
    """The data of the page: the compiler, and for each run its length and the instructions per decision or tick."""

    def __init__(self, page):
        section = re.search(rf"^#+ {HEADING}\n(.*?)(?=^#|\Z)", page, re.MULTILINE | re.DOTALL)
        if section is None:
            raise ValueError(f'no section "{HEADING}"')
        compiler = COMPILER.search(section.group(1))
        if compiler is None:
            raise ValueError('the section does not say "Counted with `COMPILER`"')
        self.compiler = compiler.group(1)
        self.runs = {name: (int(length.replace(",", "")), int(count.replace(",", "")))
                     for name, length, count in ROW.findall(section.group(1))}
        if not self.runs:
            raise ValueError("the section has no table of figures")


def measure(folder, work, name, length):
    """Instructions per decision, or per agent and tick, of one run of the corpus at that length; an error otherwise."""
    if name.startswith(RECORDING):
        return measure_recording(folder, name.removeprefix(RECORDING), length)
    known = dict(compare_bench.rows(compare_bench.read_corpus(), None))
    if name not in known:
        return None, f"bench/corpus.json has no run of this name; there are {', '.join(known)}"
    row = {**known[name], "count_ticks" if "mode" in known[name] else "count_decisions": length}
    values, error = compare_bench.measure_instructions(folder, work, name, row)
    if error:
        return None, error
    if "mode" in row:
        return values["instructions_per_agent_tick"], None
    if values["decisions"] != length:
        return None, f"made {values['decisions']} decisions instead of {length}"
    return values["instructions_per_decision"], None


def measure_recording(folder, level, ticks):
    """Instructions per tick of a crowd that is recorded at this level, on the thread that runs the world; an error otherwise."""
    counts = []
    for _ in range(RECORDINGS):
        count, error = count_recording(folder, level, ticks)
        if error:
            return None, error
        counts.append(count)
    return min(counts), None


def count_recording(folder, level, ticks):
    """One count of measure_recording; an error otherwise."""
    done = subprocess.run(["valgrind", "--tool=callgrind", "--toggle-collect=MeasuredTicks*", "--callgrind-out-file=/dev/null",
                           folder / "recording_cost", "count", level, SCENARIO, str(ticks / TICKS_PER_SECOND)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    counted = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or counted is None or counted.group(1) == "0":
        return None, f"recording_cost failed: {(done.stderr.strip().splitlines() or ['no output'])[-1]}"
    return round(int(counted.group(1)) / ticks), None


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--compiler")
    options = parser.parse_args(arguments)
    try:
        figures = Figures(options.page.read_text(encoding="utf-8"))
    except ValueError as error:
        print(f"{options.page}: {error}")
        return 1
    binding = options.compiler is None or options.compiler == figures.compiler
    failed = False
    print(f"{'run':<20} {'length':>8} {'stated':>10} {'counted':>10} {'growth':>8}")
    with tempfile.TemporaryDirectory() as work:
        for name, (length, stated) in figures.runs.items():
            counted, error = measure(options.folder.resolve(), pathlib.Path(work), name, length)
            if error:
                print(f"{name:<20} {length:>8,} {stated:>10,}: {error}")
                failed = True
                continue
            growth = counted / stated - 1
            print(f"{name:<20} {length:>8,} {stated:>10,} {counted:>10,} {100 * growth:>+7.2f} %", flush=True)
            if growth > MOST_GROWTH and binding:
                print(f"  too many: make it leaner, or state {counted:,} in {options.page} in the same commit and say why")
                failed = True
            elif growth < -MOST_GROWTH:
                print(f"  fewer than stated: state {counted:,} in {options.page}, so that it stays so")
    if not binding:
        print(f"the figures hold for {figures.compiler}, this is {options.compiler}: nothing is required")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
