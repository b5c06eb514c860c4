# SPDX-License-Identifier: BSD-2-Clause
"""Long runs in a window like those of users: every scenario, every lesson and the sample themes, at full speed, with all
panels opened, recorded and replayed. Memory and the cost of frames must not grow after the first half minute.

    soak.py [--seconds 120] [NAME...]"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from virtual_display import can_draw, environment

REPOSITORY = pathlib.Path(__file__).resolve().parent.parent.parent
COMMAND = os.environ.get("SOARBOX", str(REPOSITORY / "build" / "release" / "bin" / "soarbox"))
PANELS = ("Problems", "Why", "Messages", "Memory", "Plots", "Rules", "Trace", "Edit", "Senses", "Breakpoints", "Console")
BACK = ("Mind", "Timeline")
WIDTH, HEIGHT = 1280, 720
MOST_GROWTH = 1.2
# Tolerance for such small figures on a busy machine.
SLACK_MS, SLACK_MB, SLACK_CORNERS = 2.0, 24, 4000
LIMIT_S = 1500


def all_names():
    """Everything that can be run: scenarios, lessons that are graded, and the lessons of docs/lessons."""
    names = []
    for folder in sorted((REPOSITORY / "scenarios").iterdir()):
        if (folder / "Sandbox.lua").exists() or (folder / "scenario.toml").exists():
            names.append(folder.name)
    names.append("soar_skirmish/skirmish_100")
    for lessons in (REPOSITORY / "lessons", REPOSITORY / "docs" / "lessons"):
        for folder in sorted(lessons.iterdir()):
            if (folder / "scenario.toml").exists() or (folder / "Sandbox.lua").exists():
                names.append(str(folder))
    return names


def at_rest(name):
    """Measures while the run is paused, so that the cost of a frame does not depend on the number of frames per tick."""
    return f'key P\nexpect "Paused"\nwait 20\nmeasure "settle"\nwait 60\nmeasure "{name}"\nkey P\n'


def script(seconds, early):
    panels = "".join(f'click "{panel}"\nwait 5\n' for panel in PANELS + BACK)
    return f"until {early}\n{panels}{at_rest('early')}until {seconds}\n{panels}{at_rest('late')}"


class Failure(Exception):
    pass


def play(arguments, file, text):
    """Plays a user in a window, and returns the measures by name."""
    file.write_text(text, encoding="utf-8")
    command = [COMMAND, *arguments, "--detail", "low", "--width", str(WIDTH), "--height", str(HEIGHT), "--ui-script", str(file)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S, check=False,
                              env=environment(WIDTH, HEIGHT), errors="replace")
    except subprocess.TimeoutExpired as error:
        raise Failure(f"does not come to its end within {LIMIT_S} s: {' '.join(command)}") from error
    # 1 is the code for a problem in the run, which is allowed.
    if done.returncode not in (0, 1):
        raise Failure(f"ended with {done.returncode}: {' '.join(command)}\n{done.stderr[-3000:]}")
    if "too much to be drawn" in done.stderr:
        raise Failure(done.stderr[-1000:])
    measures = [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"event":"measure"')]
    return {measure["name"]: measure for measure in measures}


def compare(what, early, late, timed):
    """Complaints about measures that have grown. Times are compared only if `timed`, because they need an idle machine."""
    complaints = []
    times = (("frame_ms", SLACK_MS), ("panels_ms", SLACK_MS)) if timed else ()
    for key, slack in times + (("memory_mb", SLACK_MB), ("corners", SLACK_CORNERS)):
        if late[key] > MOST_GROWTH * early[key] + slack:
            complaints.append(f"{what}: {key} is {late[key]} at {late['time']:.0f} s, {early[key]} at {early['time']:.0f} s")
        if key == "corners" and late[key] >= 1 << 16:
            complaints.append(f"{what}: a window holds {late[key]} corners")
    return complaints


def ending(name, seconds):
    """The time at which the scenario ends by itself; at most `seconds`."""
    done = subprocess.run([COMMAND, "run", name, "--headless", "--json", "--seconds", str(seconds)], capture_output=True,
                          text=True, timeout=LIMIT_S, check=False, errors="replace")
    for line in done.stdout.splitlines():
        if line.startswith("{") and '"ended"' in line:
            return min(seconds, json.loads(line).get("time", seconds))
    return seconds


def soak(name, seconds, folder, timed=True):
    """Runs one scenario. Returns the complaints and a line of figures."""
    begun = time.monotonic()
    until = ending(name, seconds) - 0.5
    if until < 2:
        return [], "ends at once"
    early = min(30, until / 4)
    recording, user = folder / "run.soarrec", folder / "user.txt"
    recording.unlink(missing_ok=True)
    run = play(["run", name, "--port", "0", "--speed", "1000", "--record", str(recording)], user, script(until, early))
    complaints = compare("run", run["early"], run["late"], timed)
    # As fast as possible, because a replay begins at the speed of the run.
    again = f"key O\nuntil {early}\n" + at_rest("early") + f"until {until}\n" + at_rest("late")
    replay = play(["replay", str(recording)], user, again)
    complaints += [text for text in compare("replay", replay["early"], replay["late"], timed) if "memory" not in text]
    figures = " ".join(f"{key} {run['early'][key]} -> {run['late'][key]}" for key in ("frame_ms", "panels_ms", "memory_mb", "corners"))
    return complaints, f"{figures} recording {recording.stat().st_size >> 10} KB ({time.monotonic() - begun:.0f} s)"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("names", nargs="*")
    given = parser.parse_args()
    if not can_draw():
        sys.exit("no virtual display at hand: install xvfb")
    failed = 0
    folder = pathlib.Path(tempfile.mkdtemp(prefix="soarbox-soak-"))
    try:
        for name in given.names or all_names():
            try:
                complaints, figures = soak(name, given.seconds, folder)
            except (Failure, KeyError) as failure:
                complaints, figures = [str(failure)], ""
            failed += bool(complaints)
            print(f"{'FAILED' if complaints else 'ok    '} {name}: {figures}", flush=True)
            for complaint in complaints:
                print("       " + complaint, flush=True)
    finally:
        shutil.rmtree(folder)
    print(f"{failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
