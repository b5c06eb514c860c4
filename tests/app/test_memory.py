# SPDX-License-Identifier: BSD-2-Clause
"""If the rules of an agent use all memory, the agent stops and the reason is reported; the other agents and the world continue."""
import os
import unittest

import test_wire
from soarbox_command import WALKER, ScenarioCase, limit_memory, run_json

MEMORY_BYTES = 600 << 20

SANDBOX = """
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 200, 200);
    Sandbox.CreateAgent(sandbox, "Walker.lua");
    Sandbox.CreateSoarAgent(sandbox, "Walker.lua", "greedy.soar");
    Sandbox.CreateSoarAgent(sandbox, "Walker.lua", "modest.soar");
end
"""
MODEST = """
sp {say
   (state <s> ^superstate nil ^io <io>)
   (<io> ^input-link.distance <d> ^output-link <out>)
-->
   (<out> ^walk <w>)
}
"""
# All combinations of four of 400 values match the last rule.
GREEDY = MODEST + """
sp {values
   (state <s> ^superstate nil ^io.input-link.distance)
-->
   (<s> ^value %s)
}
sp {explode
   (state <s> ^value <a> ^value <b> ^value <c> ^value <d>)
-->
   (<s> ^all yes)
}
""" % " ".join(map(str, range(400)))


@unittest.skipIf(os.environ.get("SOARBOX_SANITIZE"), "sanitizers need all addresses")
class RuleThatMatchesTooOften(ScenarioCase, test_wire.Case):
    def setUp(self):
        super().setUp()
        for name, text in (("Sandbox.lua", SANDBOX), ("Walker.lua", WALKER), ("greedy.soar", GREEDY), ("modest.soar", MODEST)):
            self.write(name, text)

    def check(self, run):
        self.assertEqual(run.code, 1, run.err)
        _, greedy, modest = [event["agent"] for event in run.of("agent")]
        failed = run.of("failed")
        self.assertEqual([event["agent"] for event in failed], [greedy], run.out)
        self.assertRegex(failed[0]["diagnostic"]["message"],
                         f"^{greedy} ran out of memory .*: rule explode had [0-9]+ partial matches$")
        self.assertTrue(failed[0]["diagnostic"]["file"].endswith("greedy.soar"))
        self.assertEqual(run.of("gap"), [])
        self.assertGreater(len(run.of("command", agent=modest)), 50)
        last = run.of("state")[-1]
        self.assertGreater(last["time"], 1.9)
        self.assertGreater(last["agents"][0]["position"][0], 0.5)

    def test_stops_its_agent_only(self):
        self.check(run_json(self.folder, "--seconds", 2, "--every-command", "--report", 0.1, memory_bytes=MEMORY_BYTES))

    def test_stops_its_agent_only_in_a_kernel_elsewhere(self):
        port = test_wire.free_port()
        limit_memory(self.start_kernel(port).process.pid, MEMORY_BYTES)
        self.check(run_json(self.folder, "--seconds", 2, "--every-command", "--report", 0.1,
                            "--kernel", f"127.0.0.1:{port}", "--kernel-limit", 60))

    def check_growth(self, rules):
        self.write("greedy.soar", MODEST + rules)
        run = run_json(self.folder, "--seconds", 2, "--every-command", "--report", 0.1, "--memory", 400,
                       memory_bytes=3 << 29, code=1)
        _, greedy, modest = [event["agent"] for event in run.of("agent")]
        failed = run.of("failed")
        self.assertEqual([event["agent"] for event in failed], [greedy], run.out)
        self.assertRegex(failed[0]["diagnostic"]["message"], f"^{greedy} (ran out of memory and )?stops for good: ")
        self.assertGreater(len(run.of("command", agent=modest)), 50)

    def test_stops_an_agent_that_doubles_a_text(self):
        self.check_growth("""
sp {seed (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name grow)}
sp {first (state <s> ^operator.name grow -^text) --> (<s> ^text abcdefgh)}
sp {double (state <s> ^operator.name grow ^text <t>) --> (<s> ^text (concat <t> <t>) <t> -)}
""")

    def test_stops_an_agent_that_adds_elements_within_one_decision(self):
        self.check_growth("""
soar max-elaborations 10000
sp {digits (state <s> ^superstate nil) --> (<s> ^digit 0 1 2 3 4 5 6 7 8 9 ^operator <o> +) (<o> ^name count)}
sp {first (state <s> ^operator.name count -^n) --> (<s> ^n 0)}
sp {count (state <s> ^operator.name count ^n <n>) --> (<s> ^n (+ <n> 1) <n> -)}
sp {keep (state <s> ^operator.name count ^n <n> ^digit <a> ^digit <b>) --> (<s> ^<a> (concat <n> |-| <b>))}
""")
