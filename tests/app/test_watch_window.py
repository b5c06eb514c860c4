# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox watch` in a window: its panels follow the agents of a kernel that another program drives."""
import threading
import time
import unittest

from protocol_client import Client
from soarbox_command import free_port
from test_recorded_clients import APPLY, BEGIN, COUNT
from test_wire import Process
from virtual_display import can_draw
from window_user import WindowUser


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class WatchInWindow(WindowUser):
    def setUp(self):
        super().setUp()
        self.rules = self.folder / "counter.soar"
        self.rules.write_text("\n".join((BEGIN, COUNT, APPLY)), encoding="utf-8")
        self.port = free_port()
        self.kernel = Process("kernel", "--port", self.port, self.rules)
        self.addCleanup(self.kernel.kill)
        self.kernel.wait_for(lambda line: f"listens on 127.0.0.1:{self.port}" in line)
        self.client = Client(self.port)
        self.addCleanup(self.client.close)
        self.line("wm add I2 limit 100")
        self.line("run 3")

    def line(self, line):
        return self.client.line("counter", line)

    def when_memory_holds(self, words, then):
        """Calls `then`, on another thread, as soon as the input link of the kernel's agent contains these words."""
        def wait():
            until = time.monotonic() + 250
            while words not in self.line("print I2"):
                if time.monotonic() > until:
                    return
                time.sleep(0.1)
            then()
        thread = threading.Thread(target=wait)
        thread.start()
        self.addCleanup(thread.join)

    def test_panels_follow_the_kernel_and_what_is_typed_goes_to_it(self):
        self.when_memory_holds("^signal go", lambda: self.line("run 4"))
        self.played("""
            expect "counter"
            click-agent counter
            click "Trace"
            expect "counted ^number 1"
            click "Why"
            expect "propose*count"
            click "Console"
            click "a Soar command"
            type "wm add I2 signal go"
            key Return
            click "Trace"
            expect "counted ^number 5"
            click "Decision"
            expect "counter: one decision"
            expect "counted ^number 6"
            """, "watch", f"127.0.0.1:{self.port}")
        self.assertIn("^count 7", self.line("print S1"))

    def test_the_window_remains_when_the_kernel_has_ended(self):
        self.when_memory_holds("^signal go", self.kernel.kill)
        self.played("""
            expect "counter"
            click "Console"
            click "a Soar command"
            type "wm add I2 signal go"
            key Return
            click "Problems"
            expect "the kernel has ended"
            click "Trace"
            expect "counted ^number 1"
            """, "watch", f"127.0.0.1:{self.port}")


if __name__ == "__main__":
    unittest.main()
