# SPDX-License-Identifier: BSD-2-Clause
"""Shared by tests of untrusted files: a folder from a stranger, a folder outside of it, a folder of the user, and the
checks that each request must pass."""
import os
import shutil
import subprocess
import unittest

from soarbox_command import COMMAND, new_folder

SECRET = "the-secret-of-somebody-else"
LIMIT_S = 60
MEMORY_BYTES = 3 << 30

WORLD = '[[agent]]\nname = "hero"\nrules = "hero.soar"\nbody = "runner"\n'
GOOD = "sp {go (state <s> ^superstate nil ^io.output-link <out>) --> (<out> ^wander <w>)}\n"


def rules(text):
    return {"scenario.toml": WORLD, "hero.soar": text + "\n" + GOOD}


def write(folder, files):
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


def record(folder, file, *arguments, seconds="0.3"):
    return [COMMAND, "run", folder, "--headless", "--seconds", seconds, "--record", file, *arguments]


class Outcome:
    def __init__(self, process):
        self.code, self.out = process.returncode, process.stdout + process.stderr


def run(command, cwd, stdin=""):
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    limits = f"ulimit -v {MEMORY_BYTES >> 10}; exec \"$@\""
    return Outcome(subprocess.run(["bash", "-c", limits, "-", *map(str, command)], input=stdin, capture_output=True, text=True,
                                  timeout=LIMIT_S, cwd=cwd, env=environment, check=False, errors="replace"))


class StrangersFolder(unittest.TestCase):
    def setUp(self):
        self.top = new_folder(self)
        self.outside, self.folder, self.mine = self.top / "outside", self.top / "folder", self.top / "mine"
        for folder in (self.outside, self.mine):
            folder.mkdir()
        write(self.outside, {"secret.soar": f"{SECRET} in a line that is not a rule\nsp {{{SECRET} (state <s>\n",
                             "secret.lua": f'print("{SECRET}") error("{SECRET}")', "secret.toml": f'"{SECRET}'})

    def lay(self, request):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        if callable(request):
            request(self.folder)
        else:
            write(self.folder, request)

    def state(self):
        """All files outside of the user's folder, by name, size and time."""
        return sorted((str(path), path.lstat().st_size, path.lstat().st_mtime_ns) for root in (self.outside, self.folder)
                      for path in root.rglob("*"))

    def check(self, name, command, stdin="", may_show=False, codes=(0, 1, 2, 3)):
        before = self.state()
        try:
            done = run(command, self.folder, stdin)
        except subprocess.TimeoutExpired:
            self.fail(f"{name}: hangs")
        self.assertIn(done.code, codes, f"{name}: {done.out[-2000:]}")
        self.assertNotIn("bad_alloc", done.out)
        self.assertEqual(self.state(), before, f"{name}: something was written: {done.out[-2000:]}")
        if not may_show:
            self.assertNotIn(SECRET, done.out.replace(str(self.outside), ""), name)
        self.assertLess(len(done.out), 300_000, name)
        return done
