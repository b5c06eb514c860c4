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
  local twice_as_many = steps * 2
  agent:SetPosition(Vector.new(twice_as_many, 0, 0))
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
            expect-not " = 2"
            click "Step over"
            expect "Amble.lua:6"
            expect " = 2"
            picture {self.folder}/stopped.png
            audit "panel Script"
            click "Continue"
            expect "Amble.lua:5"
            expect " = 1"
            click "\u00d7"
            expect "No lines yet."
            click "Run" 2
            expect-not "Step over"
            expect "0:01"
            key Ctrl+Q
            """)


if __name__ == "__main__":
    unittest.main()
