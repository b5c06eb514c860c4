# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox inspect`: what debuggers show of a mind, as text and as JSON.

The files in inspect_golden are what it prints of one agent; SOARBOX_UPDATE=1 writes them anew.
"""
import json
import os
import pathlib
import socket
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase
from test_soar_authors import WORLD

GOLDEN = pathlib.Path(__file__).resolve().parent / "inspect_golden"

RULES = """
sp {hero*elaborate*vigour
   (state <s> ^superstate nil ^io.input-link.self.health <h>)
-->
   (<s> ^vigour <h>)
}
sp {hero*propose*walk
   (state <s> ^superstate nil ^vigour > 50)
-->
   (<s> ^operator <o> +)
   (<o> ^name walk)
}
sp {hero*propose*rest
   (state <s> ^superstate nil ^vigour <v>)
-->
   (<s> ^operator <o> +)
   (<o> ^name rest)
}
sp {hero*prefer*walk
   (state <s> ^operator <w> + ^operator <r> +)
   (<w> ^name walk)
   (<r> ^name rest)
-->
   (<s> ^operator <w> > <r>)
}
sp {hero*apply*walk
   (state <s> ^operator.name walk ^io.output-link <out>)
-->
   (<out> ^move <m>)
   (<m> ^speed 1.5)
}
sp {hero*propose*flee
   (state <s> ^superstate nil ^vigour < 10)
-->
   (<s> ^operator <o> + !)
   (<o> ^name flee)
}
"""

VIEWS = ["agents", "stack", "memory", "memory /vigour", "operators", "rules", "rule hero*propose*flee", "coverage",
         "why", "why rest", "why flee", "why move", "why runn", "io", "timeline", "messages", "trace", "plots self.health",
         "console print s1"]


class Inspect(ScenarioCase):
    def setUp(self):
        super().setUp()
        self.write("hero.soar", RULES)
        self.write("scenario.toml", WORLD)

    def inspect(self, view, *arguments, source=None):
        return Run("inspect", source or self.folder, "--at", "0.1", "--view", view, *arguments)

    def text(self, view, *arguments, **options):
        run = self.inspect(view, *arguments, **options)
        self.assertEqual(run.code, 0, run.err)
        return run.out

    def test_each_view_prints_what_its_golden_file_says(self):
        for view in VIEWS:
            with self.subTest(view):
                name = "".join(c if c.isalnum() else "_" for c in view) + ".txt"
                printed = self.text(view).replace(str(self.folder), "FOLDER")
                if os.environ.get("SOARBOX_UPDATE"):
                    GOLDEN.mkdir(exist_ok=True)
                    (GOLDEN / name).write_text(printed, encoding="utf-8")
                self.assertEqual(printed, (GOLDEN / name).read_text(encoding="utf-8"))

    def test_each_view_is_json_too(self):
        for view in VIEWS:
            with self.subTest(view):
                self.assertTrue(json.loads(self.text(view, "--json")) is not None)
        operators = json.loads(self.text("operators", "--json"))
        self.assertEqual([row["name"] for row in operators["operators"] if row["selected"]], ["walk"])
        self.assertIn("better than rest", operators["why"])

    def test_a_run_stops_at_a_breakpoint(self):
        for until in ["fire hero*apply*walk", "match hero*prefer*walk", "element ^vigour *", "command move"]:
            with self.subTest(until):
                run = self.inspect("stack", "--until", until)
                self.assertEqual(run.code, 0, run.err)
                self.assertIn("breakpoint 1: hero: ", run.err)
        self.assertIn("did not come to 'fire hero*propose*flee' by tick 3",
                      self.inspect("stack", "--until", "fire hero*propose*flee").err)

    def test_a_recording_tells_the_same_as_the_run(self):
        recording = self.folder / "hero.soarbox"
        run = Run("run", self.folder, "--headless", "--seconds", "0.5", "--record", recording, "--record-level", "all")
        self.assertEqual(run.code, 0, run.err)
        for view in VIEWS:
            with self.subTest(view):
                self.assertEqual(self.text(view, "--agent", "hero", source=recording),
                                 self.text(view, "--agent", "hero"))

    def test_a_kernel_elsewhere_is_asked_in_its_command_language(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        kernel = subprocess.Popen([COMMAND, "kernel", "--port", str(port)], stdout=subprocess.PIPE, text=True)
        self.addCleanup(kernel.stdout.close)
        self.addCleanup(kernel.wait)
        self.addCleanup(kernel.kill)
        self.assertIn("listens", kernel.stdout.readline())
        far = ("--kernel", f"127.0.0.1:{port}")
        for view in ["agents", "memory S1", "memory /vigour", "io", "messages", "plots S1.vigour", "console print s1",
                     "rule hero*propose*flee"]:
            with self.subTest(view):
                there = self.text(view, *far)
                here = self.text(view).replace(f", from {self.folder}/hero.soar:32", "")
                self.assertEqual(there, here)
        self.assertIn("walk (O2) won: it is better than rest (O1) by rule hero*prefer*walk.", self.text("operators", *far))
        for view in ["stack", "operators", "memory 31", "why move"]:
            with self.subTest(view):
                self.assertIn("not available there", self.text(view, *far))
        self.assertIn("needs ^vigour < 10, and it is 100", self.text("why flee", *far))

    def test_what_is_not_there_is_told(self):
        for view, message in [("stak", "did you mean 'stack'?"), ("rule", "needs a name"),
                              ("rule hero*apply*wlk", "did you mean 'hero*apply*walk'?"),
                              ("memory Z9", "there is no identifier 'Z9' now"),
                              ("memory 99999", "no element with the time tag 99999"),
                              ("operators S9", "there is no state S9 now")]:
            with self.subTest(view):
                run = self.inspect(view)
                self.assertNotEqual(run.code, 0)
                self.assertIn(message, run.err)
        self.assertIn("did you mean 'hero'?", self.inspect("stack", "--agent", "herp").err)
        self.assertIn("say fire RULE", self.inspect("stack", "--until", "never").err)
        self.assertNotEqual(self.inspect("stack", source="no-such-scenario").code, 0)


if __name__ == "__main__":
    unittest.main()
