# SPDX-License-Identifier: BSD-2-Clause
"""Scripts remove agents, panels and objects: in a live run, in its recording, and at moments before and after."""
import json

from soarbox_command import Run, ScenarioCase

SANDBOX = """
local step = 0;
local lua, hero, puppet, panel;
function Sandbox_Initialize(sandbox)
    Core.SetMaterial(Sandbox.CreatePlane(sandbox, 100, 100), "Ground2");
    lua = Sandbox.CreateAgent(sandbox, "Walker.lua");
    hero = Sandbox.CreateSoarAgent(sandbox, { name = "hero", rules = "hero.soar", position = Vector.new(4, 0, 0) });
    Sandbox.CreateSoarAgent(sandbox, { name = "watcher", rules = "hero.soar", position = Vector.new(4, 0, 4) });
    puppet = Sandbox.CreateSoarAgent(sandbox, "Puppet.lua", "hero.soar", { name = "puppet" });
    panel = Sandbox.CreateUIComponent(sandbox, 1);
    UI.SetText(UI.CreateChild(panel), "until two seconds");
end
function Sandbox_Update(sandbox)
    step = step + 1;
    if (step == 60) then
        for _, agent in ipairs({ lua, hero, puppet }) do
            Sandbox.RemoveAgent(sandbox, agent);
        end
        UI.Remove(panel);
    end
end
"""
LATER = """
local update = Sandbox_Update;
function Sandbox_Update(sandbox)
    update(sandbox);
    if (step == 75) then
        lua:SetSpeed(1);
    end
end
"""
WALKER = """
function Agent_Initialize(agent) agent:SetPosition(Vector.new(-4, 1, 0)); end
function Agent_Update(agent) agent:ApplyForce(Vector.new(0, 0, 20)); end
function Agent_Cleanup(agent) print("cleaned up"); end
"""
RULES = """
sp {hero*propose*walk (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name walk)}
sp {hero*apply*walk (state <s> ^operator.name walk ^io.output-link <out>) --> (<out> ^wander <w>)}
"""


class Removal(ScenarioCase):
    def setUp(self):
        super().setUp()
        self.write("Sandbox.lua", SANDBOX)
        self.write("Walker.lua", WALKER)
        self.write("Puppet.lua", "function Agent_Update(agent, ms, command) end\n")
        self.write("hero.soar", RULES)

    def agents(self, source, at):
        listed = Run("inspect", source, "--at", at, "--view", "agents", "--json", code=0)
        return sorted(agent["name"] for agent in json.loads(listed.out))

    def test_removed_agents_leave_and_their_handles_give_an_error_with_its_place(self):
        self.write("Sandbox.lua", SANDBOX + LATER)
        run = Run("run", self.folder, "--headless", "--seconds", 4, code=1)
        for name in ("Walker-1", "hero", "puppet"):
            self.assertRegex(run.out, rf"2\.03 s +{name} +leaves: a script removed it")
        self.assertEqual(run.out.count("cleaned up"), 1)
        self.assertRegex(run.err, r"Sandbox\.lua:\d+: error: bad self of 'Agent.SetSpeed' \(this agent was removed\)")
        self.assertIn("lua:SetSpeed(1);", run.err)

    def test_the_run_is_the_same_on_any_number_of_threads_and_in_its_recording(self):
        recording = self.folder / "run.soarrec"
        first = Run("run", self.folder, "--headless", "--seconds", 4, "--record", recording, code=0)
        second = Run("run", self.folder, "--headless", "--seconds", 4, "--threads", 2, code=0)
        state = [run.out.splitlines()[-1].split()[-1] for run in (first, second)]
        self.assertEqual(state[0], state[1])
        Run("verify", recording, code=0)
        everybody, rest = ["Walker-1", "hero", "puppet", "watcher"], ["watcher"]
        for source in (self.folder, recording):
            self.assertEqual(self.agents(source, 1.5), everybody)
            self.assertEqual(self.agents(source, 3), rest)
        ticks = [json.loads(line) for line in Run("export", recording, "--json", code=0).out.splitlines()[1:]]
        counts = {tick["tick"]: len(tick["agents"]) for tick in ticks}
        self.assertEqual([counts[60], counts[61]], [4, 1])

    def test_why_says_that_the_agent_is_no_longer_there(self):
        before = Run("why", self.folder, "--at", 1, "--agent", "hero", code=0)
        self.assertIn("command wander", before.out)
        after = Run("why", self.folder, "--at", 3, "--agent", "hero", code=0)
        self.assertIn("no longer there: a script removed it", after.out)

    def test_a_recorded_run_goes_on_from_before_and_from_after(self):
        recording = self.folder / "run.soarrec"
        Run("run", self.folder, "--headless", "--seconds", 4, "--record", recording, code=0)
        for at in (1, 3):
            resumed = Run("resume", recording, "--at", at, "--seconds", 4, code=0)
            self.assertIn("1 of them Soar", resumed.out.splitlines()[-1])


class Saloon(ScenarioCase):
    def test_guests_come_in_by_the_swing_doors_and_are_removed_behind_the_back_door(self):
        run = Run("run", "saloon", "--headless", "--seconds", 60, "--seed", 3)
        self.assertEqual(run.err, "")
        self.assertGreaterEqual(run.out.count("leaves: a script removed it"), 9)
        self.assertIn("ten guests served", run.out)

    def test_the_mission_of_the_saloon_passes_with_any_seed(self):
        run = Run("test", "saloon", "--seeds", "1..3")
        self.assertEqual(run.code, 0, run.out + run.err)
