# SPDX-License-Identifier: BSD-2-Clause
"""Test case that writes missions, and sweeps of them, into a temporary folder."""
import os
import pathlib

from soarbox_command import Run, ScenarioCase

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

WORLD = """
seconds = 20
[[agent]]
name = "scout"
rules = "scout.soar"
position = [0, 0]
[[waypoint]]
name = "gate"
position = [0, -12]
[[waypoint]]
name = "mill"
position = [9, 0]
"""
RULES = """
sp {scout*propose*go
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name gate ^here no)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {scout*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint gate)
   (write |off I go| (crlf))
}
"""


class MissionCase(ScenarioCase):
    def setUp(self):
        super().setUp()
        os.environ["XDG_STATE_HOME"] = str(self.folder / "state")
        self.addCleanup(os.environ.pop, "XDG_STATE_HOME")

    def mission(self, checks, world=WORLD, rules=RULES):
        self.write("scout.soar", rules)
        return self.write("scenario.toml", world + checks)

    def judge(self, checks, *arguments, **more):
        return Run("test", self.mission(checks, **more), *arguments)


SWEEP = """
scenario = "scenario.toml"
seeds = "1..6"
seconds = 8
[[check]]
name = "there"
agent = "scout"
at = "gate"
[[variant]]
name = "slow"
parameters = { "agent.scout.speed" = 2 }
[[variant]]
name = "fast"
parameters = { "agent.scout.speed" = 5, "agent.scout.senses.noise" = 0.5 }
[[metric]]
name = "arrival"
time_of = "there"
"""
