#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Runs one of the thesis' agents and compares the transcript, letter by letter, with what Soar 9.6.3 printed.

usage: check_case.py TRACE_CASE NAME

TRACE_CASE is the transcript driver; agents/NAME.soar, NAME.cmd and NAME.out are next to this script. Exit status 1: they differ (the difference is printed).
"""
import difflib
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def main(arguments):
    if len(arguments) != 2:
        print(__doc__)
        return 2
    driver, name = pathlib.Path(arguments[0]).resolve(), arguments[1]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(HERE / "agents" / f"{name}.soar", pathlib.Path(folder) / "agent.soar")
        shutil.copy(HERE / f"{name}.cmd", pathlib.Path(folder) / "case.cmd")
        done = subprocess.run([driver, "case.cmd"], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if done.returncode != 0:
        print(f"the driver ended with {done.returncode}: {done.stderr}")
        return 1
    expected = (HERE / f"{name}.out").read_text(encoding="utf-8").splitlines()
    difference = list(difflib.unified_diff(expected, done.stdout.splitlines(), "Soar 9.6.3", "ours", lineterm="", n=2))
    print("\n".join(difference) or f"{name}: as Soar 9.6.3 prints it")
    return 1 if difference else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
