# SPDX-License-Identifier: BSD-2-Clause
"""One seed, one run."""
import pathlib
import tempfile
import unittest

from soarbox_command import Run

# The heading of this agent depends on the last bit of a sine: an error triples in each step.
SWAY = """require "AgentUtilities";
local x = 0.3;
function Agent_Initialize(agent) end
function Agent_Update(agent)
    for _ = 1, 20 do x = 3.05 * math.sin(x) end
    agent:SetForward(Vector.new(math.sin(x), 0, math.cos(x)));
end
"""
YARD = """require "YardWorld";
function Sandbox_Initialize(sandbox)
    YardWorld_Initialize(sandbox, Vector.new(0, 40, -35));
    Sandbox.CreateAgent(sandbox, "Sway.lua"):SetPosition(Vector.new(0, 0.8, 0));
end
"""


def run(seed, *more):
    return Run("run", "thesis/mixed.lua", "--headless", "--json", "--every-command", "--report", 1, "--seconds", 30, "--seed", seed, *more)


class Determinism(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.first = run(3)

    def test_one_seed_prints_the_same_twice(self):
        self.assertEqual(self.first.code, 0, self.first.err)
        self.assertGreater(len(self.first.events), 1000)
        self.assertEqual(self.first.out, run(3).out)

    def test_two_seeds_differ(self):
        other = run(4)
        self.assertNotEqual(self.first.of("end")[0]["state"], other.of("end")[0]["state"])

    def test_the_number_of_threads_changes_nothing(self):
        for threads in (1, 2, 4):
            self.assertEqual(self.first.out, run(3, "--threads", threads).out)

    def test_the_speed_asked_for_changes_nothing(self):
        self.assertEqual(self.first.out, run(3, "--speed", 1000).out)

    def test_the_processor_changes_nothing(self):
        # The C library has other functions for processors with a fused multiply-add; this variable disables them.
        plain = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"}
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "Sandbox.lua").write_text(YARD, encoding="utf-8")
            pathlib.Path(folder, "Sway.lua").write_text(SWAY, encoding="utf-8")
            states = [Run("run", folder, "--headless", "--json", "--seconds", 10, variables=variables).of("end")[0]["state"]
                      for variables in ({}, plain)]
        self.assertEqual(states[0], states[1])
        # The same on every machine and with every compiler.
        self.assertEqual(states[0], "f30ac37e9ea6cf6f")
