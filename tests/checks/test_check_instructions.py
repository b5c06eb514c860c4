# SPDX-License-Identifier: BSD-2-Clause
"""The instruction gate accepts what it should, and can fail. Uses real counts of the drivers in SOARBOX_DRIVERS.

Each run is counted once for all tests, because two counts of a program with several threads differ.
"""
import contextlib
import io
import os
import pathlib
import tempfile
import unittest

import check_instructions

DRIVERS = pathlib.Path(os.environ["SOARBOX_DRIVERS"])
PAGE = """# Performance

## The instruction gate

Counted with `GNU 12.2.0`.

| run | length | instructions |
| --- | ---: | ---: |
{rows}

## Another section

| text | 10 | 1 |
"""


def counted_once(measure):
    """`measure` with a cache: it counts each combination of name and length only once."""
    counts = {}

    def look_up(folder, work, name, length):
        if (name, length) not in counts:
            counts[name, length] = measure(folder, work, name, length)
        return counts[name, length]

    return look_up


class TheInstructionGate(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        check_instructions.measure = counted_once(check_instructions.measure)
        # A small crowd is sufficient here.
        check_instructions.SCENARIO = "crowd/crowd_10.lua"
        with tempfile.TemporaryDirectory() as work:
            cls.counted = {}
            for name, length in (("decide-loop", 200), ("io_loop 1 self", 20), ("recording decisions", 12)):
                cls.counted[name], error = check_instructions.measure(DRIVERS, pathlib.Path(work), name, length)
                assert error is None, error

    def check(self, rows, *options, page=PAGE):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "performance.md"
            path.write_text(page.format(rows=rows), encoding="utf-8")
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                status = check_instructions.main([str(path), str(DRIVERS), *options])
            return status, printed.getvalue()

    def rows(self, factor):
        return (f"| decide-loop | 200 | {round(self.counted['decide-loop'] * factor):,} |\n"
                f"| io_loop 1 self | 20 | {round(self.counted['io_loop 1 self'] * factor):,} |\n"
                f"| recording decisions | 12 | {round(self.counted['recording decisions'] * factor):,} |")

    def test_passes_at_the_stated_figure_and_a_little_above(self):
        self.assertEqual(self.check(self.rows(1))[0], 0)
        self.assertEqual(self.check(self.rows(1 / 1.015))[0], 0)

    def test_fails_when_three_percent_were_added(self):
        status, printed = self.check(self.rows(1 / 1.03))
        self.assertEqual(status, 1, printed)
        self.assertEqual(printed.count("too many"), 3, printed)

    def test_asks_to_state_fewer(self):
        status, printed = self.check(self.rows(1.05))
        self.assertEqual(status, 0, printed)
        self.assertEqual(printed.count("fewer than stated"), 3, printed)

    def test_requires_nothing_of_another_compiler(self):
        self.assertEqual(self.check(self.rows(1 / 1.03), "--compiler", "GNU 12.2.0")[0], 1)
        self.assertEqual(self.check(self.rows(1 / 1.03), "--compiler", "Clang 14.0.6")[0], 0)

    def test_fails_without_figures(self):
        self.assertEqual(self.check("")[0], 1)
        self.assertEqual(self.check("", page="# Performance\n")[0], 1)

    def test_fails_for_a_run_that_does_not_exist_or_ends_early(self):
        status, printed = self.check("| decide-lop | 200 | 20,000 |")
        self.assertEqual(status, 1)
        self.assertIn("no run of this name", printed)
        status, printed = self.check("| planner | 40 | 1 |")
        self.assertEqual(status, 1, printed)
        status, printed = self.check("| recording everything | 12 | 9,000,000 |")
        self.assertEqual(status, 1, printed)
        self.assertIn("recording_cost failed", printed)
