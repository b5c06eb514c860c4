# SPDX-License-Identifier: BSD-2-Clause
"""os.exit ends a headless run with the code that a script asked for; no script runs after it."""

from soarbox_command import ScenarioCase, run_json

AGENT = """
function Agent_Initialize(agent) print("agent made") end
function Agent_Update(agent, milliseconds)
    if pcall(os.exit, %s) then print("caught") end
    print("after")
end
"""
SANDBOX = """
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 100, 100)
    Sandbox.CreateAgent(sandbox, "First.lua")
    Sandbox.CreateAgent(sandbox, "Second.lua")
end
function Sandbox_Update() print("sandbox updated") end
function Sandbox_Cleanup() print("cleaned up") end
"""


class Exit(ScenarioCase):
    def printed(self, run):
        return [event["text"] for event in run.of("log")]

    def test_the_main_chunk_of_a_script_may_end_the_run_before_it_begins(self):
        script = self.write("Tests.lua", "print('11 tests passed')\nos.exit(0)\nprint('never')\n")
        run = run_json(script, "--seconds", 5)
        self.assertEqual((run.code, run.err), (0, ""))
        self.assertEqual(self.printed(run), ["Tests.lua: 11 tests passed"])
        self.assertEqual(run.of("end")[0]["ticks"], 0)
        self.assertIn("os.exit(0)", run.of("reached")[0]["text"])

    def test_the_code_is_the_commands(self):
        for asked, code in (("-1", 255), ("7", 7), ("true", 0), ("false", 1), ("", 0)):
            with self.subTest(asked=asked):
                run = run_json(self.write("Tests.lua", f"os.exit({asked})\n"), "--seconds", 5)
                self.assertEqual((run.code, run.err), (code, ""))

    def test_no_script_runs_after_it_and_pcall_does_not_catch_it(self):
        self.write("Sandbox.lua", SANDBOX)
        self.write("First.lua", AGENT % "3")
        self.write("Second.lua", AGENT % "4")
        run = run_json(self.folder, "--seconds", 5)
        self.assertEqual((run.code, run.err), (3, ""))
        self.assertEqual(self.printed(run), ["First.lua: agent made", "Second.lua: agent made"])
        self.assertEqual(run.of("end")[0]["ticks"], 1)

    def test_a_wrong_code_is_an_error_and_the_run_goes_on(self):
        run = run_json(self.write("Tests.lua", "print(pcall(os.exit, 'soon'))\n"), "--seconds", 1, code=0)
        self.assertEqual(run.of("end")[0]["ticks"], 30)
        self.assertIn("number expected", self.printed(run)[0])
