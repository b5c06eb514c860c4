# SPDX-License-Identifier: BSD-2-Clause
"""A window that is killed loses neither the recording nor typed text."""
import signal
import subprocess
import unittest

from soarbox_command import Run, end_with, wait_until
from test_window_tasks import TYPE_INTO_EDIT
from virtual_display import can_draw
from window_user import WALKER, WindowUser


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class Crash(WindowUser):
    def die(self, recording, how, typing=TYPE_INTO_EDIT, text="# mine"):
        """Types the text, by default into Edit, and ends the window's process with that signal."""
        script = "until 2.2" + typing + "until 60\n"
        window = subprocess.Popen(
            self.window(script, "run", str(self.folder), f"--record={recording}", "--port", "0"),
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder,
            env=self.surroundings((1280, 720)))
        self.addCleanup(window.stderr.close)
        end_with(self, window)
        drafts = self.home / "state" / "soarbox" / "drafts"
        wait_until(lambda: window.poll() is not None or any(
            text in draft.read_text(encoding="utf-8") for draft in drafts.glob("*.draft")), "the draft", 240)
        self.assertIsNone(window.poll(), window.stderr.read() if window.poll() is not None else "")
        self.assertEqual(len(list(drafts.glob("*.draft"))), 1, "it is on the disk while the window is open")
        window.send_signal(how)
        self.assertEqual(window.wait(timeout=60), -how)

    def finds_again(self):
        """The next window offers the typed text; the file is unchanged."""
        self.assertEqual((self.folder / "walker.soar").read_text(encoding="utf-8"), WALKER)
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Edit"
            expect "# mine"
            expect "This is your draft"
            click "Revert"
            expect-not "# mine"
            """)
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Edit"
            expect "sp {walker*propose*seek"
            expect-not "# mine"
            """)

    def test_killed_and_aborted_windows_leave_drafts_and_whole_recordings(self):
        for how in (signal.SIGKILL, signal.SIGABRT):
            with self.subTest(how.name):
                recording = self.folder / f"{how.name}.soarrec"
                self.die(recording, how)
                Run("verify", recording, code=0)
                exported = Run("export", recording, "--csv", code=0)
                seconds = {line.split(",")[0] for line in exported.out.splitlines()[1:]}
                self.assertGreaterEqual(len(seconds), 30, "all but the last second is there")
                self.finds_again()

    def test_a_line_of_the_console_that_was_not_sent_is_there_again(self):
        self.die(self.folder / "line.soarrec", signal.SIGKILL, """
            key P
            click-agent walker
            click "Console"
            click "a Soar command; Tab completes"
            type "matches walker*prefer*n"
            """, "matches walker*prefer*n")
        self.play("""
            until 0.3
            key P
            click-agent idler
            click "Console"
            expect "a Soar command; Tab completes"
            click-agent walker
            expect "matches walker*prefer*n"
            key Ctrl+Q
            expect "was typed and not sent"
            expect "is kept and comes back"
            click "Stay"
            expect-not "Close the window?"
            """)
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Console"
            click "matches walker*prefer*n"
            key End
            type "orth"
            key Return
            expect "1 complete matches."
            expect "a Soar command; Tab completes"
            key Ctrl+Q
            wait 60
            """)
        self.play("""
            until 0.3
            key P
            click-agent walker
            click "Console"
            expect "a Soar command; Tab completes"
            key Ctrl+Q
            """)
