# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox inspect` prints the data that debuggers show about a mind, as text and as JSON.

The files in inspect_golden are its output for one agent. SOARBOX_UPDATE=1 writes them again.
"""
import json
import os
import pathlib

from soarbox_command import Run, ScenarioCase, end, start_kernel
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

# a is better than b, b is better than a, and there are no preferences about c.
CIRCLE = """
sp {hero*propose
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <a> + ^operator <b> + ^operator <c> +)
   (<a> ^name a)
   (<b> ^name b)
   (<c> ^name c)
}
sp {hero*prefer*ab
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name a)
   (<b> ^name b)
-->
   (<s> ^operator <a> > <b>)
}
sp {hero*prefer*ba
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name a)
   (<b> ^name b)
-->
   (<s> ^operator <b> > <a>)
}
"""

# The reject of the other one is created after go was selected, by its application.
LATER = """
sp {hero*propose
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <go> + > ^operator <stay> +)
   (<go> ^name go)
   (<stay> ^name stay)
}
sp {hero*apply
   (state <s> ^operator.name go)
-->
   (<s> ^went yes)
}
sp {hero*later
   (state <s> ^went yes ^operator <stay> +)
   (<stay> ^name stay)
-->
   (<s> ^operator <stay> -)
}
"""

VIEWS = ["agents", "stack", "memory", "memory /vigour", "imagery", "operators", "rules", "rule hero*propose*flee", "coverage",
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

    def kernel_elsewhere(self):
        """The port of a kernel in a separate process."""
        kernel, port = start_kernel()
        self.addCleanup(end, kernel)
        return port

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
        self.assertEqual([row["dropped"] for row in operators["operators"] if not row["selected"]],
                         [{"stage": "dominated", "rules": ["hero*prefer*walk"], "decisive": True}])

    def test_a_run_stops_at_a_breakpoint(self):
        for until in ["fire hero*apply*walk", "match hero*prefer*walk", "element ^vigour *", "number ^vigour > 50", "operator walk", "command move"]:
            with self.subTest(until):
                run = self.inspect("stack", "--until", until)
                self.assertEqual(run.code, 0, run.err)
                self.assertIn("breakpoint 1: hero: ", run.err)
        self.assertIn("breakpoint 1: it is 0.05 s", self.inspect("stack", "--until", "time 0.05").err)
        self.assertIn("for example: ^health < 20", self.inspect("stack", "--until", "number ^vigour").err)
        self.assertIn("did not come to 'fire hero*propose*flee' by tick 3",
                      self.inspect("stack", "--until", "fire hero*propose*flee").err)

    def test_a_recording_tells_the_same_as_the_run(self):
        recording = self.folder / "hero.soarbox"
        Run("run", self.folder, "--headless", "--seconds", "0.5", "--record", recording, "--record-level", "all", code=0)
        for view in VIEWS:
            with self.subTest(view):
                self.assertEqual(self.text(view, "--agent", "hero", source=recording),
                                 self.text(view, "--agent", "hero"))

    def test_a_panel_is_printed_as_window_and_pages_show_it(self):
        recording = self.folder / "hero.soarbox"
        Run("run", self.folder, "--headless", "--seconds", "0.1", "--record", recording, "--record-level", "all", code=0)
        for panel in ["mind", "memory", "rules", "links", "why", "trace", "learning", "plots"]:
            with self.subTest(panel):
                printed = self.text(f"panel {panel}")
                self.assertEqual(printed, self.text(f"panel {panel}", "--agent", "hero", source=recording))
                self.assertTrue(all("is" in node for node in json.loads(self.text(f"panel {panel}", "--json"))))
        for panel, words in [("mind", "walk (O2) was selected"), ("memory", "^vigour 100"), ("rules", "hero*propose*flee"),
                             ("why", "Why does hero do what it does?"), ("agents", "hero")]:
            self.assertIn(words, self.text(f"panel {panel}"))
        self.assertIn("name one of agents, mind", self.inspect("panel nothing").err)
        self.assertIn("there is no agent 'herp' at that moment", self.inspect("panel mind", "--agent", "herp").err)
        self.assertIn("not with --until", self.inspect("panel mind", "--until", "command move").err)

    def test_a_kernel_elsewhere_is_asked_in_its_command_language(self):
        port = self.kernel_elsewhere()
        far = ("--kernel", f"127.0.0.1:{port}")
        for view in ["agents", "memory S1", "memory /vigour", "io", "messages", "plots S1.vigour", "console print s1",
                     "rule hero*propose*flee"]:
            with self.subTest(view):
                there = self.text(view, *far)
                here = self.text(view).replace(f", from {self.folder}/hero.soar:32", "")
                # Where the first line is broken depends on the column in which the kernel printed last.
                self.assertEqual(there.split(), here.split())
        self.assertIn("walk (O2) was selected: rule hero*prefer*walk makes it better than rest (O1).", self.text("operators", *far))
        for view in ["stack", "operators", "memory 31"]:
            with self.subTest(view):
                self.assertIn("not available there", self.text(view, *far))
        self.assertIn("requires ^vigour < 10, but it is 100", self.text("why flee", *far))
        self.assertIn("which applied operator walk (O2)", self.text("why move", *far), "a kernel of ours tells origins there, too")

    def test_two_that_are_each_better_than_the_other_leave_the_third(self):
        self.write("hero.soar", CIRCLE)
        why = (r"c \([A-Z]\d\) was selected: (a|b) \([A-Z]\d\) and (a|b) \([A-Z]\d\) are each better than the other "
               r"\(rules hero\*prefer\*(ab|ba) and hero\*prefer\*(ab|ba)\), so both were dropped")
        recording = self.folder / "hero.soarbox"
        Run("run", self.folder, "--headless", "--seconds", "0.5", "--record", recording, code=0)
        port = self.kernel_elsewhere()
        for mode, told in [("live", self.text("operators")), ("live", self.text("why")),
                           ("simulated again", self.text("operators", "--agent", "hero", source=recording)),
                           ("elsewhere", self.text("operators", "--kernel", f"127.0.0.1:{port}"))]:
            with self.subTest(mode):
                self.assertRegex(told, why + r"\.")
        recorded = Run("replay", recording, "--headless", code=0)
        self.assertRegex(recorded.out, why.removeprefix(r"c \([A-Z]\d\) was selected: ") + "; proposed by rule hero\\*propose")

    def test_what_changed_after_a_decision_is_no_reason_for_it(self):
        self.write("hero.soar", LATER)
        self.assertRegex(self.text("operators"),
                         r"go \([A-Z]\d\) is selected, and preferences have changed since then\. With the present preferences: "
                         r"rule hero\*later rejects stay (\([A-Z]\d\)) \(without that stay \1 would still lose\)\.")

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
