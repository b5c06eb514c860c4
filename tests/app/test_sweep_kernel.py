# SPDX-License-Identifier: BSD-2-Clause
"""Sweeps with a variant that runs its minds in a kernel in another process."""
import csv
import json
import os
import re
import socket
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase, end_with, free_port, page_missing, wait_until
from mission_case import RULES, WORLD

SPEC = """
scenario = "."
seeds = "1..%d"
seconds = %d
[[check]]
name = "there"
agent = "scout"
at = "gate"
by = 10
[[variant]]
name = "own"
[[variant]]
name = "elsewhere"
kernel = "127.0.0.1:%d"
"""


class Elsewhere(ScenarioCase):
    def setUp(self):
        super().setUp()
        self.write("scenario.toml", WORLD)
        self.write("scout.soar", RULES)
        self.port = free_port()

    def kernel(self):
        process = subprocess.Popen([COMMAND, "kernel", "--port", str(self.port)], stdin=subprocess.PIPE,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

        self.addCleanup(process.stdin.close)
        end_with(self, process)

        def answers():
            try:
                socket.create_connection(("127.0.0.1", self.port), 1).close()
            except OSError:
                return False
            return True

        wait_until(answers, "the kernel")
        return process

    def is_in_use(self):
        """Whether a client is connected to the kernel's port: state 01 in the kernel's table of sockets."""
        with open("/proc/net/tcp", encoding="ascii") as table:
            return any(f":{self.port:04X} " in line.split(None, 1)[1][:14] and line.split()[3] == "01" for line in list(table)[1:])

    def sweep(self, seeds, seconds=10):
        spec = self.write("sweep.toml", SPEC % (seeds, seconds, self.port))
        return Run("sweep", spec, "--jobs", 4)

    def rows(self):
        with open(self.folder / "sweep.sweep" / "results.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {name: [row for row in rows if row["variant"] == name] for name in ("own", "elsewhere")}

    def test_runs_take_turns_at_one_kernel_and_come_to_the_same(self):
        self.kernel()
        run = self.sweep(4)
        self.assertEqual(run.code, 0, run.out + run.err)
        rows = self.rows()
        for column in ("seed", "outcome", "passed", "time: there", "distance", "commands"):
            self.assertEqual([row[column] for row in rows["own"]], [row[column] for row in rows["elsewhere"]], column)
        self.assertEqual([row["tries"] for row in rows["elsewhere"]], ["1"] * 4)

    def test_without_the_kernel_the_other_runs_are_made_and_its_own_later(self):
        run = self.sweep(3)
        self.assertEqual(run.code, 1, run.out + run.err)
        self.assertIn("variant 'elsewhere' cannot run", run.err)
        self.assertIn(f"no Soar kernel answers at 127.0.0.1:{self.port}", run.err)
        self.assertIn("3 runs were left out", run.err)
        rows = self.rows()
        self.assertEqual((len(rows["own"]), len(rows["elsewhere"])), (3, 0))
        self.kernel()
        run = self.sweep(3)
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertIn("3 runs made, 3 were there", run.err)
        self.assertEqual([row["passed"] for row in self.rows()["elsewhere"]], ["1"] * 3)

    @unittest.skipIf(page_missing(), page_missing())
    def test_a_page_counts_undecided_runs_for_themselves(self):
        self.kernel()
        asks = '[[check]]\nname = "walks"\nagent = "scout"\noperator = "go"\n'
        spec = self.write("sweep.toml", (SPEC % (2, 10, self.port)).replace("[[variant]]", asks + "[[variant]]", 1))
        run = Run("sweep", spec, "--jobs", 2)
        self.assertEqual([row["passed"] for row in self.rows()["elsewhere"]], ["", ""], run.out + run.err)
        page = self.folder / "page.html"
        self.assertEqual(Run("report", self.folder / "sweep.sweep", "-o", page).code, 0)
        data = re.search(r'<script type="application/json"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.DOTALL)
        data = json.loads(data.group(1))[0]
        own, elsewhere = data["variants"]
        self.assertEqual((own["runs"], own["judged"], elsewhere["runs"], elsewhere["judged"]), (2, 2, 2, 0))
        self.assertEqual([(check["true"], check["of"]) for check in elsewhere["checks"]], [(2, 2), (0, 0)])
        passed = data["columns"].index("passed")
        self.assertEqual([row[passed] for row in data["rows"] if row[0] == "elsewhere"], ["undecided"] * 2)

    def test_a_kernel_that_dies_in_a_run_leaves_no_row_that_looks_right(self):
        kernel = self.kernel()
        spec = self.write("sweep.toml", SPEC % (2, 600, self.port))
        process = subprocess.Popen([COMMAND, "sweep", str(spec), "--jobs", "1"], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.wait)
        parts = self.folder / "sweep.sweep" / "parts"
        # The runs in the command's own kernel come first; the next has begun when a client is connected to this kernel.
        wait_until(lambda: any(part.stat().st_size for part in parts.glob("*.rows")) and self.is_in_use())
        os.kill(kernel.pid, 9)
        out, err = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 1, out + err)
        self.assertIn("variant 'elsewhere' cannot run", err)
        rows = self.rows()
        self.assertEqual([row["outcome"] for row in rows["own"]], ["ok"] * 2)
        self.assertEqual(rows["elsewhere"], [])
        self.kernel()
        run = self.sweep(2, 600)
        self.assertEqual(run.code, 0, run.out + run.err)
        self.assertEqual([(row["outcome"], row["passed"]) for row in self.rows()["elsewhere"]], [("ok", "1")] * 2)
