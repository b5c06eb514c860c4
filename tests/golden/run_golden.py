#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Runs golden cases and compares their transcripts with what Soar 9.6.3 printed.

usage: run_golden.py --driver TRACE_CASE --cases FOLDER [--minimum FILE [--raise]] [--show] [CASE...]
       run_golden.py --driver TRACE_CASE --cases FOLDER --remote-driver DRIVER --soarbox COMMAND [CASE...]

Each case runs in a copy of its folder, for a limited time and with limited output. Prints how many agree in meaning
(compare.py's default) and letter by letter, and names those that do not. Fails if fewer agree than the file of minimums
requires: {"AREA": {"semantic": N, "verbatim": N}}, counts of cases or "all". If more agree, it reports this; with --raise
it writes the new counts to the file. CASE: only cases whose names contain one of these words; then nothing is required.

With --remote-driver each case runs a second time with its kernel in another process (`soarbox kernel`, started in the
case's folder), and fails unless both transcripts are equal to the letter.
"""
import argparse
import contextlib
import difflib
import io
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

import compare

TIMEOUT_S = 60
MOST_OUTPUT_BYTES = 64 << 20
# A file of this name marks a case in which Soar 9.6.5 differs from Soar 9.6.3, which printed the transcript. The file describes the difference.
LIKE_963 = "like-9.6.3"


@contextlib.contextmanager
def kernel_port(command, folder):
    """Starts a kernel in this folder, and gives its port; ends it afterwards."""
    with subprocess.Popen([command, "kernel", "--port", "0"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          text=True) as kernel:
        try:
            found = re.search(r"127\.0\.0\.1:(\d+)", kernel.stdout.readline())
            if found is None:
                raise RuntimeError("the kernel does not tell its port")
            yield found.group(1)
        finally:
            kernel.terminate()


def transcript(driver, case, soarbox=None):
    """The output of the driver for a case, and how it ended if it failed. With `soarbox`: uses a kernel of that command."""
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        copy = pathlib.Path(folder) / "case"
        shutil.copytree(case, copy)
        environment = dict(os.environ)
        if soarbox:
            environment["SOARBOX_KERNEL_PORT"] = stack.enter_context(kernel_port(soarbox, copy))
        output = pathlib.Path(folder) / "output"
        with open(output, "wb") as stream:
            try:
                like = ["9.6.3"] if (case / LIKE_963).exists() else []
                run = subprocess.run([driver, "case.cmd", *like], cwd=copy, stdout=stream, stderr=subprocess.DEVNULL,
                                     stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, check=False, env=environment,
                                     preexec_fn=limit_output)
                ending = "" if run.returncode == 0 else f"exit status {run.returncode}"
            except subprocess.TimeoutExpired:
                ending = f"still running after {TIMEOUT_S} s"
        return output.read_bytes(), ending


def limit_output():
    """Limits the output: a signal ends a case that prints too much."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_OUTPUT_BYTES, MOST_OUTPUT_BYTES))


def same(expected, actual, verbatim):
    """Whether compare.py finds two transcripts equal, and the difference that it prints."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        status = compare.main((["--verbatim"] if verbatim else []) + [str(expected), str(actual)])
    return status == 0, printed.getvalue()


def required_counts(required, case_count):
    """The required counts of an area; "all" means every case."""
    return {kind: case_count if count == "all" else count for kind, count in required.items()}


def check_minimum(path, area, reached, case_count, raise_it):
    """The exit status: 0 if at least the required number of cases agree."""
    minimums = json.loads(path.read_text(encoding="utf-8"))
    if area not in minimums:
        print(f"{path} does not say how many cases of {area} must agree")
        return 1
    required = required_counts(minimums[area], case_count)
    fewer = [kind for kind, count in required.items() if reached[kind] < count]
    if fewer:
        print("too few agree: " + ", ".join(f"{kind} {reached[kind]}, required {required[kind]}" for kind in fewer) + f" ({path})")
        return 1
    more = {kind: reached[kind] for kind, count in required.items() if reached[kind] > count}
    if more and raise_it:
        minimums[area].update(more)
        lines = [f"  {json.dumps(name)}: {json.dumps(counts)}" for name, counts in minimums.items()]
        path.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
        print(f"raised the minimum of {area}: {more} ({path})")
    elif more:
        print(f"more agree than required: raise {area} to {more} in {path} (run again with --raise)")
    return 0


def compare_remote(arguments, cases):
    """Each case in process and over a socket."""
    driver, remote, soarbox = (pathlib.Path(name).resolve() for name in
                               (arguments.driver, arguments.remote_driver, arguments.soarbox))
    failed = []
    for case in cases:
        (near, near_ending), (far, far_ending) = transcript(driver, case), transcript(remote, case, soarbox)
        # Paths contain the folder of the run.
        near, far = (re.sub(rb"/tmp/\w+/case", b"CASE", text) for text in (near, far))
        if near == far and near_ending == far_ending:
            continue
        failed.append(case.name)
        lines = [text.decode("utf-8", "replace").splitlines() for text in (near, far)]
        print(f"--- {case.name} {near_ending} {far_ending}")
        print("\n".join(list(difflib.unified_diff(*lines, "in process", "over a socket", lineterm="", n=1))[:30]))
    print(f"{arguments.cases.name}: {len(cases) - len(failed)} of {len(cases)} cases are the same in process and over a socket")
    return 1 if failed else 0


def main(argument_list=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--driver", required=True)
    parser.add_argument("--cases", required=True, type=pathlib.Path)
    parser.add_argument("--remote-driver")
    parser.add_argument("--soarbox")
    parser.add_argument("--minimum", type=pathlib.Path)
    parser.add_argument("--raise", dest="raise_it", action="store_true", help="write a higher count to the file of minimums")
    parser.add_argument("--show", action="store_true", help="print the differences")
    parser.add_argument("words", nargs="*", metavar="CASE")
    arguments = parser.parse_args(argument_list)

    cases = sorted(folder for folder in arguments.cases.iterdir() if (folder / "case.cmd").exists())
    if arguments.words:
        cases = [case for case in cases if any(word in case.name for word in arguments.words)]
    if arguments.remote_driver:
        return compare_remote(arguments, cases)
    semantic = verbatim = 0
    failed, nearly = [], []
    with tempfile.TemporaryDirectory() as folder:
        for case in cases:
            output, ending = transcript(pathlib.Path(arguments.driver).resolve(), case)
            actual = pathlib.Path(folder) / "actual.out"
            actual.write_bytes(output)
            expected = case / "expected.out"
            equal, difference = same(expected, actual, verbatim=False)
            letters, letter_difference = same(expected, actual, verbatim=True)
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
    return check_minimum(arguments.minimum, area, {"semantic": semantic, "verbatim": verbatim}, len(cases), arguments.raise_it)


if __name__ == "__main__":
    sys.exit(main())
