// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

// Scripts remove agents, objects and panels. Using a handle of a removed one is an error that names the cause.
namespace soarbox::script {
namespace {

using world::EntityId;

constexpr EntityId kFirst{1}, kSecond{2};

TEST_F(HostTest, ARemovedAgentActsOnceMoreIsCleanedUpAndGoesWithTheNextStep) {
  Write("A.lua",
        "function Agent_Update(a) print('update', a:GetId()) end\n"
        "function Agent_Cleanup(a) print('cleanup', a:GetId(), a:GetHeight() > 0) end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  first = Sandbox.CreateAgent(s, 'A.lua') second = Sandbox.CreateAgent(s, 'A.lua')\n"
      "end\n"
      "function Sandbox_Update(s) print('agents', #Sandbox.GetAgents(s)) end");
  EXPECT_EQ(Run("Sandbox.RemoveAgent(sandbox, first) Sandbox.RemoveAgent(sandbox, first)"), "");
  EXPECT_EQ(world_->AgentIds().size(), 2u);
  Ticks(2);
  EXPECT_EQ(Printed(), "cleanup\t1\ttrue|update\t2|agents\t1|update\t2|agents\t1");
  EXPECT_EQ(Errors(), "");
  host_->Cleanup();
  EXPECT_EQ(recorder_.prints.back(), "cleanup\t2\ttrue");
  EXPECT_EQ(host_->RequestOf(kFirst), nullptr);
}

TEST_F(HostTest, AHandleOfARemovedThingGivesAnErrorWithFileAndLine) {
  Write("A.lua", "function Agent_Update(a) end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  agent = Sandbox.CreateAgent(s, 'A.lua')\n"
      "  box = Sandbox.CreateBox(s, 1, 1, 1)\n"
      "  panel = Sandbox.CreateUIComponent(s, 1) child = UI.CreateChild(panel)\n"
      "end\n"
      "function Sandbox_Update(s)\n"
      "  if step then step() end\n"
      "end");
  Run("Sandbox.RemoveAgent(sandbox, agent) Sandbox.RemoveObject(sandbox, box) UI.Remove(panel)");
  Tick();
  EXPECT_EQ(Run("print(agent:GetPosition())"), "error: bad self of 'Agent.GetPosition' (this agent was removed)");
  EXPECT_EQ(Run("agent:SetHealth(5)"), "error: bad self of 'Agent.SetHealth' (this agent was removed)");
  EXPECT_EQ(Run("agent:ForceToPosition(Vector.new())"),
            "error: bad self of 'Agent.ForceToPosition' (this agent was removed)");
  EXPECT_EQ(Run("print(Core.GetPosition(agent))"),
            "error: bad argument #1 to 'Core.GetPosition' (this agent was removed)");
  EXPECT_EQ(Run("Core.GetMass(box)"), "error: bad argument #1 to 'Core.GetMass' (this sandbox object was removed)");
  EXPECT_EQ(Run("UI.SetText(panel, 'x')"), "error: bad argument #1 to 'UI.SetText' (this UI component was removed)");
  EXPECT_EQ(Run("UI.SetText(child, 'x')"), "error: bad argument #1 to 'UI.SetText' (this UI component was removed)");
  EXPECT_EQ(Run("Sandbox.RemoveAgent(sandbox, agent) print(agent == agent)"), "true");
  recorder_.errors.clear();
  Write("Late.lua", "local kept\nfunction Agent_Initialize(a) kept = a end");
  StartWith(
      "function Sandbox_Initialize(s) agent = Sandbox.CreateAgent(s, 'Late.lua') end\n"
      "function Sandbox_Update(s)\n"
      "  Sandbox.RemoveAgent(s, agent)\n"
      "  if gone then agent:GetSpeed() end\n"
      "  gone = true\n"
      "end");
  Ticks(2);
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.file, (folder_ / "Sandbox.lua").string());
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.line, 4);
}

TEST_F(HostTest, AnAgentRemovesItselfAndItsCallbacksGoWithIt) {
  Write("A.lua",
        "function Agent_Initialize(a)\n"
        "  Sandbox.AddEventCallback(a:GetSandbox(), a:GetSandbox(), function() print('heard') end)\n"
        "end\n"
        "function Agent_Update(a) Sandbox.RemoveAgent(a:GetSandbox(), a) print('update') end");
  StartWith(
      "function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end\n"
      "function Sandbox_Update(s) Sandbox.AddEvent(s, 'Noise', {}) end");
  Ticks(4);
  EXPECT_EQ(Printed(), "update");
  EXPECT_EQ(Errors(), "");
}

TEST_F(HostTest, ManyAgentsMayComeAndGoOneAfterTheOther) {
  settings_.max_agents = 4;
  Write("A.lua", "kept = {} for i = 1, 2000 do kept[i] = {i} end");
  StartWith(
      "function Sandbox_Update(s)\n"
      "  if last then Sandbox.RemoveAgent(s, last) end\n"
      "  last = Sandbox.CreateAgent(s, 'A.lua')\n"
      "end");
  Ticks(50);
  const std::size_t early = host_->memory_bytes();
  Ticks(450);
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(world_->AgentIds().size(), 2u);
  EXPECT_LT(host_->memory_bytes(), early + early / 2);
}

TEST_F(HostTest, OthersForgetARemovedAgent) {
  Write("A.lua", "function Agent_Initialize(a) a:SetPosition(Vector.new(0, 1, 10 - a:GetId())) end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  first = Sandbox.CreateAgent(s, 'A.lua') second = Sandbox.CreateAgent(s, 'A.lua')\n"
      "  second:SetLeader(first) all = Sandbox.GetAgents(s)\n"
      "end");
  EXPECT_EQ(Run("print(#second:GetNeighbours(10), second:ForceToSeparate(10, 180).z)"), "1\t-1");
  Run("Sandbox.RemoveAgent(sandbox, first)");
  Tick();
  EXPECT_EQ(Run("print(#second:GetNeighbours(10), second:ForceToSeparate(10, 180, all).z, second:GetLeader() == nil)"),
            "0\t0\ttrue");
  EXPECT_EQ(Run("print(Sandbox.RayCastToObject(sandbox, Vector.new(0, 9, 9), Vector.new(0, -9, 9)).result)"), "false");
  world::SceneSnapshot scene = world_->Snapshot();
  ASSERT_EQ(scene.agents.size(), 1u);
  EXPECT_EQ(scene.agents[0].id, Number(kSecond));
}

TEST_F(HostTest, ASensorReportsWhoComesAndLeaves) {
  Write("A.lua", "function Agent_Initialize(a) a:SetPosition(Vector.new(-20, 1, 0)) end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  Sandbox.CreatePlane(s, 100, 100)\n"
      "  sensor = Sandbox.CreateSensor(s, 4, 4, 4)\n"
      "  agent = Sandbox.CreateAgent(s, 'A.lua')\n"
      "  box = Sandbox.CreateBox(s, 1, 1, 1)\n"
      "  Core.SetPosition(box, Vector.new(20, 1, 0))\n"
      "  Sandbox.AddEventCallback(s, sensor, function(s, listener, type, event)\n"
      "    print(type, event.sensor == listener, event.agent == agent, event.object == box)\n"
      "  end)\n"
      "end");
  Ticks(3);
  EXPECT_EQ(Printed(), "");
  Run("agent:SetPosition(Vector.new(0, 1, 0))");
  Ticks(3);
  EXPECT_EQ(Printed(), "SensorEntered\ttrue\ttrue\tfalse");
  EXPECT_EQ(Run("local hit = Sandbox.RayCastToObject(sandbox, Vector.new(0, 10, 0), Vector.new(0, 1.2, 0))\n"
                "print(hit.object == agent, agent:GetPosition().y < 1.5)"),
            "true\ttrue");
  Run("agent:SetPosition(Vector.new(-20, 1, 0)) Core.SetPosition(box, Vector.new(1, 1, 0))");
  Ticks(3);
  EXPECT_EQ(Printed(), "SensorLeft\ttrue\ttrue\tfalse|SensorEntered\ttrue\tfalse\ttrue");
  Run("Sandbox.RemoveObject(sandbox, box)");
  Ticks(3);
  EXPECT_EQ(Printed(), "SensorLeft\ttrue\tfalse\ttrue");
  Run("Core.SetPosition(sensor, Vector.new(-20, 1, 0))");
  Ticks(3);
  EXPECT_EQ(Printed(), "SensorEntered\ttrue\ttrue\tfalse");
  EXPECT_EQ(Errors(), "");
}

TEST_F(HostTest, ADoorOnAHingeTurnsWithinItsLimitsAndFallsFreeWithoutIt) {
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  door = Sandbox.CreateBox(s, 1, 2, 0.1)\n"
      "  Core.SetPosition(door, Vector.new(0.5, 3, 0)) Core.SetMass(door, 5)\n"
      "  Core.AddHinge(door, Vector.new(0, 3, 0), Vector.new(0, 1, 0), nil, {low = -60, high = 60})\n"
      "end\n"
      "function Sandbox_Update(s) if push then Core.ApplyForce(door, Vector.new(0, 0, push)) end end");
  EXPECT_EQ(Run("push = 40"), "");
  Ticks(120);
  EXPECT_EQ(Run("local p = Core.GetPosition(door)\n"
                "print(math.abs(p.y - 3) < 0.05, math.abs(math.sqrt(p.x * p.x + p.z * p.z) - 0.5) < 0.05, p.z > 0.3)\n"
                "print(p.x > 0.1)"),
            "true\ttrue\ttrue|true");
  Run("push = nil Core.RemoveHinges(door)");
  Ticks(30);
  EXPECT_EQ(Run("print(Core.GetPosition(door).y < 2)"), "true");
  EXPECT_EQ(Run("Core.AddHinge(door, Vector.new(), Vector.new(0, 1, 0)) Sandbox.RemoveObject(sandbox, door)"), "");
  Ticks(2);
  EXPECT_EQ(world_->hinge_count(), 0u);
  EXPECT_EQ(Errors(), "");
}

}  // namespace
}  // namespace soarbox::script
