# SPDX-License-Identifier: BSD-2-Clause
"""Grades room.py: python3 check.py room.py"""
import importlib.util
import pathlib
import re
import sys

import soar_sml as sml


def load(file):
    spec = importlib.util.spec_from_file_location("room", file)
    room = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(room)
    return room


def values_of(agent, attribute):
    """The values of all elements with this attribute."""
    return re.findall(rf"\^{attribute} ([^\s)]+)", agent.ExecuteCommandLine(f"print --exact (* ^{attribute} *)"))


def points(kernel, temperatures):
    """A requirement: a sentence, whether it is met, and a hint."""
    agent = kernel.GetAgent("heater")
    felt, seen, orders = values_of(agent, "temperature"), values_of(agent, "heating"), values_of(agent, "heat")
    yield ("the mind perceives one temperature", len(felt) == 1,
           f"There are {len(felt)} elements ^temperature. Make it once (CreateFloatWME), and change it later (Update).")
    yield ("it is the temperature of now", len(felt) == 1 and abs(float(felt[0]) - temperatures[-1]) < 0.001,
           "The last temperature is not what the mind perceives. Update the element in each minute, before the mind runs.")
    yield ("the mind perceives whether the heater is on", len(seen) == 1 and seen[0] in ("yes", "no"),
           f"There are {len(seen)} elements ^heating, which is to be yes or no.")
    later = temperatures[20:]
    yield ("it never gets colder than 18.5 degrees", min(later) > 18.5,
           "The heater is never switched on. Is the command looked at after each run, and is ^to its parameter?")
    yield ("it never gets warmer than 21.5 degrees", max(later) < 21.5, "The heater is never switched off. Which value of ^to is it then?")
    yield ("commands are answered", not orders,
           "Commands stay on the output link, because the rules remove them only when they have ^status. AddStatusComplete answers.")


def main():
    if len(sys.argv) != 2:
        print("usage: python3 check.py room.py", file=sys.stderr)
        return 2
    kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
    try:
        temperatures = load(pathlib.Path(sys.argv[1])).run(kernel, 120)
        if kernel.GetAgent("heater") is None or len(temperatures) != 120:
            print("no   run returns the temperature of each minute, and its agent is called heater")
            return 1
        passed = True
        for name, holds, hint in points(kernel, temperatures):
            print(("yes  " if holds else "no   ") + name)
            if not holds and passed:
                print("     " + hint)
            passed = passed and holds
    finally:
        kernel.Shutdown()
    print("passed" if passed else "not passed")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
