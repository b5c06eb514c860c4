# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox watch` follows the agents of a kernel in another process, which another program drives."""
import json
import pathlib
import tempfile
import unittest

from protocol_client import Client
from soarbox_command import Run, free_port
from test_recorded_clients import APPLY, BEGIN, COUNT
from test_wire import Case


def is_command_of(agent, number):
    """The event that this agent counted to this number."""
    def holds(line):
        event = json.loads(line) if line.startswith("{") else {}
        return event.get("event") == "command" and event["agent"] == agent and f"number {number}" in event.get("parameters", "")
    return holds


class Watch(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_port()

    def start_watched(self, *options):
        kernel = self.start("kernel", "--port", self.port, *options)
        kernel.wait_for(lambda line: f"listens on 127.0.0.1:{self.port}" in line)
        return kernel

    def watch(self, *options):
        return self.start("watch", f"127.0.0.1:{self.port}", "--headless", "--json", *options)

    @staticmethod
    def begin(client, name="counter"):
        client.call("create_agent", name=name)
        for line in (BEGIN, COUNT, APPLY, "wm add I2 limit 100"):
            client.line(name, line)

    def test_what_was_and_what_comes_is_shown(self):
        kernel = self.start_watched()
        with Client(self.port) as client:
            self.begin(client)
            client.line("counter", "run 3")
            watch = self.watch()
            watch.wait_for(is_command_of("counter", 1))
            client.line("counter", "run 4")
            watch.wait_for(is_command_of("counter", 5))
            # An agent that is created later.
            self.begin(client, "late")
            client.line("late", "run --self 3")
            watch.wait_for(is_command_of("late", 1))
        kernel.interrupt()
        # `soarbox watch` ends together with the kernel.
        self.assertEqual(watch.process.wait(60), 0)

    def test_files_are_followed_as_the_client_loaded_them(self):
        rules = self.folder / "count.soar"
        rules.write_text("\n".join((BEGIN, COUNT, APPLY)), encoding="utf-8")
        self.start_watched(rules)
        with Client(self.port) as client:
            client.line("count", "wm add I2 limit 9")
            rules.unlink()
            client.line("count", "run 4")
            self.watch().wait_for(is_command_of("count", 2))

    def test_a_recorded_kernel_is_watched_too(self):
        file = self.folder / "run.soarrec"
        kernel = self.start_watched("--record", file)
        with Client(self.port) as client:
            self.begin(client)
            client.line("counter", "run 3")
            self.watch().wait_for(is_command_of("counter", 1))
        kernel.interrupt()
        self.assertIn("counted", Run("replay", file, "--headless", code=0).out)

    def test_equal_runs_of_a_client_compare_as_equal(self):
        files = []
        for name in ("a", "b"):
            files.append(self.folder / f"{name}.soarrec")
            kernel = self.start_watched("--record", files[-1])
            with Client(self.port) as client:
                self.begin(client)
                for _ in range(4):
                    client.line("counter", "run 2")
            kernel.interrupt()
        compared = Run("compare", *files)
        self.assertEqual(compared.code, 0, compared.out + compared.err)

    def test_a_kernel_without_a_log_is_asked_what_its_agents_do_now(self):
        kernel = self.start_watched("--no-log")
        with Client(self.port) as client:
            self.begin(client)
            client.line("counter", "run 3")
            watch = self.watch()
            watch.wait_for(lambda line: '"agent":"counter"' in line)
            client.line("counter", "run 4")
            watch.wait_for(is_command_of("counter", 5))
            self.begin(client, "late")
            client.line("late", "run --self 3")
            watch.wait_for(is_command_of("late", 1))
            # The end of `soarbox watch` does not change the agent.
            watch.interrupt()
            self.assertIn("^count 6", client.line("counter", "print S1"))
        kernel.interrupt()

    def test_a_kernel_without_a_log_says_how_it_would_keep_one(self):
        kernel = self.start_watched("--no-log")
        with Client(self.port) as client:
            self.begin(client)
        watch = self.watch()
        watch.wait_for(lambda line: '"agent":"counter"' in line)
        kernel.interrupt()
        self.assertEqual(watch.process.wait(60), 0)
        said = watch.process.stderr.read()
        self.assertIn("keeps no log", said)
        self.assertIn("SOARBOX_RECORD", said)

    def test_nobody_at_the_address(self):
        refused = Run("watch", f"127.0.0.1:{self.port}", "--headless")
        self.assertNotEqual(refused.code, 0)
        self.assertIn(f"no Soar kernel answers at 127.0.0.1:{self.port}", refused.err)
        self.assertIn("is not an address", Run("watch", "127.0.0.1:99999999", "--headless").err)


if __name__ == "__main__":
    unittest.main()
