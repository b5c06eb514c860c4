# SPDX-License-Identifier: BSD-2-Clause
"""The runner of golden cases fails when it should. TRACE_CASE names the driver."""
import contextlib
import io
import json
import os
import pathlib
import shutil
import tempfile
import unittest

import run_golden

HERE = pathlib.Path(__file__).resolve().parent
DRIVER = os.environ["TRACE_CASE"]


class TheRunner(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.area = pathlib.Path(folder.name) / "area"
        for name in ("alias-command", "gp-command"):
            shutil.copytree(HERE / "core" / name, self.area / name)
        self.minimum = pathlib.Path(folder.name) / "minimum.json"

    def run_area(self, semantic, *options):
        self.minimum.write_text(json.dumps({"area": {"semantic": semantic}, "other": {"semantic": 9}}), encoding="utf-8")
        printed = io.StringIO()
        arguments = ["--driver", DRIVER, "--cases", str(self.area), "--minimum", str(self.minimum), *options]
        with contextlib.redirect_stdout(printed):
            status = run_golden.main(arguments)
        return status, printed.getvalue()

    def change_a_transcript(self):
        expected = self.area / "gp-command" / "expected.out"
        expected.write_text(expected.read_text(encoding="utf-8") + "One line more\n", encoding="utf-8")

    def test_passes_when_as_many_agree(self):
        self.assertEqual(self.run_area(2)[0], 0)
        self.assertEqual(self.run_area("all")[0], 0)

    def test_fails_when_a_transcript_differs(self):
        self.change_a_transcript()
        for semantic in (2, "all"):
            status, printed = self.run_area(semantic)
            self.assertEqual(status, 1)
            self.assertIn("gp-command", printed)
        self.assertEqual(self.run_area(1)[0], 0)

    def test_a_case_that_does_not_end_fails_alone(self):
        run_golden.TIMEOUT_S, before = 5, run_golden.TIMEOUT_S
        self.addCleanup(setattr, run_golden, "TIMEOUT_S", before)
        case = self.area / "gp-command" / "case.cmd"
        case.write_text("sp {p (state <s>) --> (<s> ^a 1)}\nsoar wait-snc on\nrun 1000000000\n", encoding="utf-8")
        status, printed = self.run_area(2)
        self.assertEqual(status, 1)
        self.assertIn("still running", printed)
        self.assertIn("1 of 2 cases agree", printed)

    def test_tells_and_writes_a_higher_count(self):
        status, printed = self.run_area(1)
        self.assertEqual(status, 0)
        self.assertIn("more agree than required", printed)
        self.run_area(1, "--raise")
        self.assertEqual(json.loads(self.minimum.read_text(encoding="utf-8")), {"area": {"semantic": 2}, "other": {"semantic": 9}})
