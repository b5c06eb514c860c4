# SPDX-License-Identifier: BSD-2-Clause
"""Runs files of tests in a browser. A file that fails runs once more, alone, and is named: a page that draws without a graphics card,
possibly next to another one, may be too slow for a click."""
import concurrent.futures


def run_files(tests, passes, at_a_time=1):
    """passes: runs a file and returns whether its tests passed. Returns the exit code."""
    with concurrent.futures.ThreadPoolExecutor(at_a_time) as pool:
        failed = [test for test, passed in zip(tests, pool.map(passes, tests)) if not passed]
    for test in failed:
        print(f"{test} failed; it runs once more, alone", flush=True)
    return 0 if all([passes(test) for test in failed]) else 1
