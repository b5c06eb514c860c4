#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Runs golden cases and compares their transcripts with what Soar 9.6.3 printed.

usage: run_golden.py --driver TRACE_CASE --cases FOLDER --compare COMPARE.PY [--minimum FILE] [--show] [CASE...]

Each case runs in a copy of its folder. Prints how many agree in meaning (compare.py's default) and letter by letter,
and names those that do not. Fails if fewer agree than the file of minimums asks for: {"AREA": {"semantic": N,
"verbatim": N}}, counts of cases. CASE: only cases whose names contain one of these words; then nothing is required.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

TIMEOUT_S = 60


def transcript(driver, case):
    """What the driver prints for a case; how it ended, if badly."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "case"
        shutil.copytree(case, copy)
        try:
            run = subprocess.run([driver, "case.cmd"], cwd=copy, capture_output=True, timeout=TIMEOUT_S, check=False)
        except subprocess.TimeoutExpired as expired:
            return (expired.stdout or b""), f"still running after {TIMEOUT_S} s"
        ending = "" if run.returncode == 0 else f"exit status {run.returncode}"
        return run.stdout, ending


def same(compare, expected, actual, verbatim):
    """Whether compare.py finds two transcripts equal, and the difference that it prints."""
    command = [sys.executable, compare] + (["--verbatim"] if verbatim else []) + [expected, actual]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return run.returncode == 0, run.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--driver", required=True)
    parser.add_argument("--cases", required=True, type=pathlib.Path)
    parser.add_argument("--compare", required=True)
    parser.add_argument("--minimum", type=pathlib.Path)
    parser.add_argument("--show", action="store_true", help="print the differences")
    parser.add_argument("words", nargs="*", metavar="CASE")
    arguments = parser.parse_args()

    cases = sorted(folder for folder in arguments.cases.iterdir() if (folder / "case.cmd").exists())
    if arguments.words:
        cases = [case for case in cases if any(word in case.name for word in arguments.words)]
    semantic = verbatim = 0
    failed, nearly = [], []
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            output, ending = transcript(pathlib.Path(arguments.driver).resolve(), case)
            actual = pathlib.Path(folder) / "actual.out"
            actual.write_bytes(output)
            expected = case / "expected.out"
            equal, difference = same(arguments.compare, expected, actual, verbatim=False)
            letters, letter_difference = same(arguments.compare, expected, actual, verbatim=True)
            if ending:
                equal = letters = False
            semantic += equal
            verbatim += letters
            if not equal:
                failed.append(case.name + (f" ({ending})" if ending else ""))
            elif not letters:
                nearly.append(case.name)
            if arguments.show and not letters:
                print(f"--- {case.name}\n{difference or letter_difference}")

    count = max(len(cases), 1)
    area = arguments.cases.name
    print(f"{area}: {semantic} of {len(cases)} cases agree in meaning ({100 * semantic / count:.1f} %), "
          f"{verbatim} letter by letter ({100 * verbatim / count:.1f} %)")
    for title, names in (("differ", failed), ("differ in letters only", nearly)):
        if names:
            print(f"{title}:\n  " + "\n  ".join(names))
    if arguments.words or not arguments.minimum:
        return 0
    required = json.loads(arguments.minimum.read_text(encoding="utf-8"))[area]
    if semantic < required["semantic"] or verbatim < required["verbatim"]:
        print(f"required: {required['semantic']} in meaning, {required['verbatim']} letter by letter "
              f"({arguments.minimum})")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
