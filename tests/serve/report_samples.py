# SPDX-License-Identifier: BSD-2-Clause
"""Creates reports for web/e2e/report.mjs: a fight, a run with markup in names and texts, several runs, a sweep, a
tournament.

usage: report_samples.py FOLDER     SOARBOX names the command; the page is built (npm run build in web/)
"""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "app"))

from mission_case import RULES, SWEEP, WORLD

EVIL = "x</script><script>window.hurt=1</script>\" onload='window.hurt=1' ]]> \u202e"
IMAGE = '<img src=x onerror="window.hurt=1">'
SAY = 'sp {scout*say (state <s> ^superstate nil ^io.input-link.self) --> (write |%s {{data}}| (crlf))}\n' % IMAGE
CHECKS = ('[[check]]\nname = "to the gate"\nagent = "scout"\nat = "gate"\nby = 10\n'
          '[[check]]\nname = "%s"\nagent = "scout"\nat = "mill"\nby = 5\n' % EVIL.replace('"', '\\"'))
CUP = ('scenario = "cup"\nseeds = "1..2"\nseconds = 3\n[tournament]\nseats = ["eater", "eater-2"]\n'
       'agents = { still = "still.soar", east = "east.soar", "%s" = "still.soar" }\n' % IMAGE.replace('"', '\\"'))
BOARD = 'require "Eaters";\nEaters.Settings = { map = { "...#...", "...#...", "1..#2.." } };\n'
EAST = ('sp {east*propose (state <s> ^superstate nil ^io.input-link.my-location <m>) --> (<s> ^operator <o> +)'
        ' (<o> ^name east)}\n'
        'sp {east*apply (state <s> ^operator.name east ^io.output-link <out>) --> (<out> ^move.direction east)}\n')


def soarbox(*words, folder=None):
    done = subprocess.run([os.path.abspath(os.environ["SOARBOX"]), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False, cwd=folder)
    if done.returncode != 0:
        sys.exit(f"soarbox {' '.join(map(str, words))}:\n{done.stdout}")


def write(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    return file


def make(folder):
    """Writes fight.html, markup.html, several.html, sweep.html and cup.html into this folder."""
    folder = pathlib.Path(folder).resolve()
    os.environ["XDG_STATE_HOME"] = str(folder / "state")
    folder.mkdir(parents=True, exist_ok=True)
    soarbox("run", "soar_skirmish", "--headless", "--seconds", 12, "--record", "fight.soarrec", "--record-level", "all",
            folder=folder)
    soarbox("report", "fight.soarrec", "-o", "fight.html", folder=folder)
    write(folder / "scenario.toml", WORLD + CHECKS)
    write(folder / "scout.soar", RULES + SAY)
    runs = folder / "runs"
    runs.mkdir()
    for seed in (1, 2):
        soarbox("run", folder, "--headless", "--seconds", 8, "--seed", seed, "--record", runs / f"{seed}.soarrec")
    soarbox("report", runs / "1.soarrec", "-o", folder / "markup.html")
    soarbox("report", runs, "-o", folder / "several.html")
    spec = write(folder / "sweep.toml", SWEEP.replace('"fast"', '"%s"' % IMAGE.replace('"', '\\"')))
    soarbox("sweep", spec)
    soarbox("report", spec, "-o", folder / "sweep.html")
    seat = '[[agent]]\nname = "eater"\nby = "sandbox"\nrules = "still.soar"\n'
    write(folder / "cup" / "scenario.toml", 'script = "Board.lua"\n' + seat + seat)
    write(folder / "cup" / "Board.lua", BOARD)
    write(folder / "cup" / "still.soar", "")
    write(folder / "still.soar", "# Does nothing.\n")
    write(folder / "east.soar", EAST)
    spec = write(folder / "cup.toml", CUP)
    soarbox("sweep", spec)
    soarbox("report", spec, "-o", folder / "cup.html")


if __name__ == "__main__":
    make(sys.argv[1])
