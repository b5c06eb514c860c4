# SPDX-License-Identifier: BSD-2-Clause
"""A kernel that records its clients: its agents can be run again without them, explained, and continued differently."""
import pathlib
import signal
import subprocess
import tempfile
import unittest

from protocol_client import Client
from soarbox_command import COMMAND, free_port
from test_wire import Case

COUNT = """sp {propose*count
   (state <s> ^superstate nil ^io.input-link.limit <limit> ^count { <n> < <limit> })
-->
   (<s> ^operator <o> + =)
   (<o> ^name count)}"""
BEGIN = "sp {begin (state <s> ^superstate nil) --> (<s> ^count 0)}"
APPLY = """sp {apply*count
   (state <s> ^operator.name count ^count <n> ^io.output-link <out>)
-->
   (<s> ^count <n> - (+ <n> 1))
   (<out> ^counted <c>)
   (<c> ^number <n>)}"""
# It counts by twos.
OTHER = APPLY.replace("(+ <n> 1)", "(+ <n> 2)")


def soarbox(*arguments):
    return subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=240, check=False)


class Recorded(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "run.soarrec"
        self.port = free_port()

    def start_recorded(self):
        kernel = self.start("kernel", "--port", self.port, "--record", self.file)
        kernel.wait_for(lambda line: f"listens on 127.0.0.1:{self.port}" in line)
        return kernel

    def count_to_five(self):
        kernel = self.start_recorded()
        with Client(self.port) as client:
            client.call("create_agent", name="counter")
            client.line("counter", BEGIN)
            client.line("counter", COUNT)
            client.line("counter", APPLY)
            client.line("counter", "wm add I2 limit 5")
            for _ in range(4):
                client.line("counter", "run 2")
        kernel.interrupt()

    def test_a_world_that_thinks_elsewhere_is_recorded(self):
        kernel = self.start_recorded()
        run = soarbox("run", "soar_hallway", "--headless", "--seconds", 3, "--kernel", f"127.0.0.1:{self.port}")
        self.assertEqual(run.returncode, 0, run.stderr)
        kernel.interrupt()
        again = soarbox("replay", self.file, "--headless")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("move-to", again.stdout)
        self.assertNotIn("another way", again.stdout)
        verified = soarbox("verify", self.file)
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)

    def test_command_lines_are_recorded_and_runs_are_not_made_twice(self):
        self.count_to_five()
        why = soarbox("why", self.file, "--agent", "counter", "--at", 0.1)
        self.assertEqual(why.returncode, 0, why.stderr)
        self.assertIn("counted", why.stdout)
        self.assertIn("apply*count", why.stdout)
        memory = soarbox("inspect", self.file, "--agent", "counter", "--at", 0.1, "--view", "memory")
        self.assertIn("count", memory.stdout)

    def test_another_rule_takes_another_course_and_the_file_says_where(self):
        self.count_to_five()
        rules = self.folder / "other.soar"
        rules.write_text(OTHER, encoding="utf-8")
        other = self.folder / "other.soarrec"
        resumed = soarbox("resume", self.file, "--at", 0.05, "--rules", rules, "--agent", "counter", "--seconds", 0.2, "--record", other)
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        compared = soarbox("compare", self.file, other)
        self.assertIn("counter", compared.stdout)
        self.assertIn("differ", compared.stdout)

    def test_an_agent_that_its_client_destroyed_is_there_until_then(self):
        kernel = self.start_recorded()
        with Client(self.port) as client:
            client.call("create_agent", name="counter")
            for line in (BEGIN, COUNT, APPLY, "wm add I2 limit 5", "run 3"):
                client.line("counter", line)
            client.call("create_agent", name="other")
            client.call("destroy_agent", agent="counter")
            client.line("other", "run 3")
        kernel.interrupt()
        # Its third and last decision.
        memory = soarbox("inspect", self.file, "--agent", "counter", "--at", 0.1, "--view", "memory")
        self.assertRegex(memory.stdout, r"count 2\b", memory.stderr)
        later = soarbox("inspect", self.file, "--agent", "counter", "--at", 0.17, "--view", "memory")
        self.assertIn("counter does not exist at this moment", later.stderr)
        self.assertNotIn("did you mean", later.stderr)

    def test_a_killed_kernel_leaves_what_was_run(self):
        kernel = self.start_recorded()
        with Client(self.port) as client:
            client.call("create_agent", name="counter")
            for rule in (BEGIN, COUNT, APPLY):
                client.line("counter", rule)
            client.line("counter", "wm add I2 limit 5")
            client.line("counter", "run 3")
            kernel.process.send_signal(signal.SIGKILL)
        kernel.finish()
        again = soarbox("replay", self.file, "--headless")
        self.assertIn("counted", again.stdout)

    def test_what_is_no_log_is_refused_with_a_reason(self):
        self.file.write_text("soarbox-client\t1\t9.6.3\n", encoding="utf-8")
        refused = soarbox("replay", self.file, "--headless")
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("the program created no agent", refused.stderr)
        self.file.write_text("soarbox-client\t1\t9.6.3\nagent\ta\nnonsense\ta\t1\nadd\ta\nline\tb\tprint\ngo\ta\tx\ty\n", encoding="utf-8")
        odd = soarbox("replay", self.file, "--headless")
        self.assertEqual(odd.returncode, 0, odd.stderr)
        self.assertIn("has an unknown line: nonsense", odd.stdout)
        self.assertIn("no agent 'b'", odd.stdout)

    def test_a_file_that_cannot_be_written_is_named(self):
        refused = soarbox("kernel", "--port", self.port, "--record", self.folder / "absent" / "run.soarrec")
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("absent/run.soarrec", refused.stderr)


if __name__ == "__main__":
    unittest.main()
