# SPDX-License-Identifier: BSD-2-Clause
"""A script stops at a line in the window: its user adds the line, looks at variables, takes a step and goes on."""
import unittest

from virtual_display import can_draw
from window_user import WindowUser

SANDBOX = """function Sandbox_Initialize(sandbox)
  Sandbox.CreateAgent(sandbox, "Amble.lua")
end
"""
AMBLE = """local steps = 0

function Agent_Update(agent, ms)
  steps = steps + 1
  local answer = 6 * 7
  agent:SetPosition(Vector.new(answer, 0, steps))
end
"""


@unittest.skipUnless(can_draw(), "no virtual display at hand")
class ScriptsInTheWindow(WindowUser):
    def setUp(self):
        super().setUp()
        (self.folder / "scenario.toml").unlink()
        (self.folder / "Sandbox.lua").write_text(SANDBOX, encoding="utf-8")
        (self.folder / "Amble.lua").write_text(AMBLE, encoding="utf-8")

    def test_a_script_stops_shows_its_variables_and_goes_on(self):
        self.play(f"""
            key Alt+F
            expect "Stop scripts at"
            click "line"
            type "5"
            click "Add"
            expect "Local variables"
            expect "Amble.lua:5"
            expect-not "answer = 42"
            click "Step over"
            expect "Amble.lua:6"
            expect "answer = 42"
            expect "agent = Amble-1"
            picture {self.folder}/stopped.png
            audit "panel Script"
            click "Continue"
            expect "Amble.lua:5"
            expect-not "answer = 42"
            click "5"
            click "Continue"
            expect-not "Step over"
            expect "0:01"
            click "View"
            click "Sounds off"
            key U
            key Ctrl+Q
            """)

    def test_a_run_begins_again_and_ends_although_a_script_is_stopped(self):
        done = self.play("""
            key Alt+F
            expect "Stop scripts at"
            click "line"
            type "5"
            click "Add"
            expect "Step over"
            key Ctrl+R
            expect "From the beginning"
            expect "Step over"
            click "Step over"
            expect "Amble.lua:6"
            key Ctrl+Q
            """)
        self.assertNotIn("Traceback", done.stderr)

    def test_the_tick_of_a_decision_stops_too(self):
        both = SANDBOX.replace("\nend", '\n  Sandbox.CreateSoarAgent(sandbox, { rules = "walker.soar", body = "runner" })\nend')
        (self.folder / "Sandbox.lua").write_text(both, encoding="utf-8")
        self.play("""
            click "Pause"
            expect "Paused"
            key Alt+F
            expect "Stop scripts at"
            click "line"
            type "5"
            click "Add"
            expect-not "Step over"
            key Shift+N
            expect "Step over"
            click "Step over"
            expect "answer = 42"
            click "Continue"
            expect-not "Step over"
            expect "one decision"
            key Ctrl+Q
            """)


if __name__ == "__main__":
    unittest.main()
