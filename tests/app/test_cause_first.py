# SPDX-License-Identifier: BSD-2-Clause
"""The findings at the end of `soarbox run` and the panel Problems list the cause first, in the same order.

Each file in cause_first contains the texts of both for one world. SOARBOX_UPDATE=1 writes the files again.
"""
import json
import os
import pathlib
import re
import sys

from soarbox_command import Run, ScenarioCase

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings" / "python"))
from soarbox.engine import Engine  # noqa: E402

TICKS = 120  # 4 s.
GOLDEN = pathlib.Path(__file__).resolve().parent / "cause_first"

WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
position = [0, 0]

[[agent]]
name = "second"
rules = "second.soar"
position = [5, 0]

[[waypoint]]
name = "gate"
position = [3, 0]
"""

IDLE = """sp {second*propose*go
   (state <s> ^superstate nil ^io.input-link.self.health < 50)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {second*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^move-to.waypoint gate)
}
"""

# The rules of hero, by file name. The rules of second wait for a health that is never that low.
CASES = {
    # A rule with a syntax error, a slip, a command that the world refuses, and an agent that waits.
    "everything": """sp {hero*broken
   (state <s> ^superstate nil
-->
   (<s> ^x 1)
}
sp {hero*propose*go
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {hero*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^move-to <c>)
   (<c> ^waypoint gatte)
}
sp {hero*slip
   (state <s> ^superstate nil ^io.input-link.self.helth <h>)
-->
   (<s> ^h <h>)
}
""",
    # A tie: no slip, only agents that do nothing.
    "tie": """sp {hero*propose*left
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> +)
   (<o> ^name left)
}
sp {hero*propose*right
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> +)
   (<o> ^name right)
}
sp {hero*apply
   (state <s> ^operator.name << left right >> ^io.output-link <out>)
-->
   (<out> ^move-to.waypoint gate)
}
""",
}


class CauseFirst(ScenarioCase):
    maxDiff = None

    def world(self, name):
        folder = self.folder / name
        folder.mkdir()
        (folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        (folder / "hero.soar").write_text(CASES[name], encoding="utf-8")
        (folder / "second.soar").write_text(IDLE, encoding="utf-8")
        return folder

    def end_of_run(self, folder):
        """The findings at the end of a run, as text; the JSON must contain the same."""
        lines = Run("run", folder, "--headless", "--seconds", 4, code=None).out.splitlines()
        begin = next(i for i, line in enumerate(lines) if line.startswith(("soarbox: what went wrong", "soarbox: when agents had nothing to do")))
        events = [json.loads(line) for line in Run("run", folder, "--headless", "--seconds", 4, "--json", code=None).out.splitlines()]
        findings = [event for event in events if event["event"] == "finding"]
        self.assertEqual([line.split(". ", 1)[1] for line in lines[begin + 1:-1]], [finding["text"] for finding in findings])
        return "".join(f"{finding['cause']}: {finding['text']}\n" for finding in findings)

    def panel(self, folder):
        """The contents of the panel Problems, as text."""
        engine = Engine(str(folder), 1)
        try:
            engine.ask({"request": "look", "panels": ["problems"]})
            engine.synchronize()
            while engine.contents["moment"]["time"]["last_tick"] < TICKS:
                engine.ask({"request": "flow", "what": "step-tick"})
                engine.synchronize()
            rows = engine.contents["problems"]["problems"]
        finally:
            engine.close()
        return "".join(f"{row['cause']}: {row['severity']}: {row['message']}\n" for row in rows)

    def test_a_run_and_the_panel_rank_alike(self):
        for name in CASES:
            with self.subTest(name):
                folder = self.world(name)
                run, panel = self.end_of_run(folder), self.panel(folder)
                causes = [re.findall(r"^(\w+):", text, re.M) for text in (run, panel)]
                self.assertEqual(causes[0], causes[1])
                told = (f"== run\n{run}== problems\n{panel}").replace(str(folder) + "/", "")
                golden = GOLDEN / f"{name}.txt"
                if os.environ.get("SOARBOX_UPDATE"):
                    golden.write_text(told, encoding="utf-8")
                self.assertEqual(told, golden.read_text(encoding="utf-8"))

    def test_agents_that_only_wait_are_not_called_wrong(self):
        folder = self.world("tie")
        (folder / "hero.soar").write_text(IDLE.replace("second", "hero"), encoding="utf-8")
        out = Run("run", folder, "--headless", "--seconds", 4, code=0).out
        self.assertNotIn("went wrong", out)
        self.assertIn("soarbox: when agents had nothing to do, and why:\n  1. ", out)
        self.assertIn(", 0 problems, ", out)
        # A command that the world refuses is wrong, although it is no problem of a file.
        (folder / "hero.soar").write_text(CASES["everything"].split("}\n", 1)[1], encoding="utf-8")
        out = Run("run", folder, "--headless", "--seconds", 4, code=None).out
        self.assertIn("soarbox: what went wrong, the cause first:\n", out)
        self.assertNotIn(", 0 problems, ", out)

    def test_a_run_in_which_nothing_is_wrong_says_nothing_of_it(self):
        folder = self.world("tie")
        (folder / "hero.soar").write_text(IDLE.replace("second", "hero").replace("< 50", "> 50"), encoding="utf-8")
        (folder / "second.soar").write_text(IDLE.replace("< 50", "> 50"), encoding="utf-8")
        self.assertNotIn("went wrong", Run("run", folder, "--headless", "--seconds", 0.5, code=0).out)
