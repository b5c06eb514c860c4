// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

namespace soarbox::script {
namespace {

using world::EntityId;

constexpr EntityId kFirst{1};

TEST_F(HostTest, RunsAgentsInTheOrderOfTheirLife) {
  Write("A.lua",
        "print('chunk')\n"
        "function Agent_Initialize(a) print('initialize', a:GetId()) end\n"
        "function Agent_Update(a, ms, ...) print('update', ms, select('#', ...), ...) end\n"
        "function Agent_Cleanup(a) print('cleanup') end");
  StartWith(
      "function Sandbox_Initialize(s) local a = Sandbox.CreateAgent(s, 'A.lua') print('created', a:GetId()) end\n"
      "function Sandbox_Update(s, ms) print('sandbox', ms) end\n"
      "function Sandbox_Cleanup(s) print('end') end");
  Tick();
  host_->UpdateAgent(kFirst, "stop");
  host_->Cleanup();
  EXPECT_EQ(Printed(), "chunk|initialize\t1|created\t1|update\t33\t0|sandbox\t33|update\t33\t1\tstop|cleanup|end");
  EXPECT_EQ(Errors(), "");
}

TEST_F(HostTest, EachAgentHasGlobalsOfItsOwn) {
  Write("A.lua", "count = 0 function Agent_Update(a) count = count + 1 end");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') Sandbox.CreateAgent(s, 'A.lua') end");
  host_->UpdateAgent(kFirst);
  EXPECT_EQ(Run("print(count)", kFirst), "1");
  EXPECT_EQ(Run("print(count)", EntityId{2}), "0");
  EXPECT_EQ(Run("print(count)"), "nil");
}

TEST_F(HostTest, AnErrorCostsItsCallAndIsToldOnce) {
  Write("Bad.lua", "function Agent_Update(a)\n  local n = nil\n  print(n.x)\nend");
  Write("Good.lua", "updates = 0 function Agent_Update(a) updates = updates + 1 end");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'Bad.lua') Sandbox.CreateAgent(s, 'Good.lua') end");
  Ticks(5);
  ASSERT_EQ(recorder_.errors.size(), 1u);
  const auto& [agent, error] = recorder_.errors[0];
  EXPECT_EQ(agent, kFirst);
  EXPECT_EQ(error.diagnostic.file, (folder_ / "Bad.lua").string());
  EXPECT_EQ(error.diagnostic.line, 3);
  EXPECT_EQ(error.diagnostic.excerpt, "  print(n.x)");
  EXPECT_EQ(error.traceback, "  Bad.lua:3: in the function at line 1\n");
  EXPECT_FALSE(world_->FindAgent(kFirst)->Failed());
  EXPECT_EQ(Run("print(updates)", EntityId{2}), "5");
  host_->TellCounts();
  ASSERT_EQ(recorder_.counts.size(), 1u);
  EXPECT_EQ(recorder_.counts[0].count, 5u);
}

TEST_F(HostTest, AnErrorAfterAnIgnoredCallNamesThatCall) {
  StartWith("function Sandbox_Initialize(s)\n  local p = Core.GetPosition()\n  print(p.x)\nend");
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.hint,
            "a call in Sandbox.lua:2 was ignored, so it returned nil; see the warning about it");
}

TEST_F(HostTest, OneErrorOfSeveralAgentsIsToldOnceWithAllOfThemAndAgainWhenTheyKeepFailingAndRecover) {
  using Kind = ScriptTrouble::Kind;
  Write("Bad.lua", "tries = 0 function Agent_Update(a) tries = tries + 1 if tries < 10 then error('again') end end");
  StartWith("function Sandbox_Initialize(s) for i = 1, 3 do Sandbox.CreateAgent(s, 'Bad.lua') end end");
  Ticks(20);
  EXPECT_EQ(Run("print(tries)", kFirst), "20");
  ASSERT_EQ(recorder_.troubles.size(), 3u);
  const Kind kinds[] = {Kind::kError, Kind::kKeepsFailing, Kind::kWorksAgain};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(recorder_.troubles[i].kind, kinds[i]);
    EXPECT_EQ(recorder_.troubles[i].agents.size(), 3u);
    EXPECT_EQ(recorder_.troubles[i].callback, "Agent_Update");
  }
}

TEST_F(HostTest, AFailedSetUpOfAnAgentDoesNotStopItsUpdates) {
  Write("Bad.lua",
        "updates = 0 function Agent_Initialize(a) error('no') end function Agent_Update(a) updates = updates + 1 end");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'Bad.lua') end");
  Ticks(3);
  EXPECT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(Run("print(updates)", kFirst), "3");
}

TEST_F(HostTest, ASyntaxErrorStopsItsAgentOnly) {
  Write("Broken.lua", "function Agent_Update(a)\n  if then\nend");
  StartWith("function Sandbox_Initialize(s) local a = Sandbox.CreateAgent(s, 'Broken.lua') print(a:GetId()) end");
  EXPECT_EQ(Printed(), "1");
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.line, 2);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.message, "unexpected symbol near 'then'");
  Ticks(2);
  EXPECT_TRUE(world_->FindAgent(kFirst)->Failed());
}

TEST_F(HostTest, AMissingAgentScriptIsAnErrorOfTheScriptThatNamesIt) {
  Write("Seeker.lua", "");
  StartWith("function Sandbox_Initialize(s)\n  Sandbox.CreateAgent(s, 'Seeeker.lua')\nend");
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.line, 2);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.message,
            "no such script file: \"Seeeker.lua\" (did you mean \"Seeker.lua\"?)");
  EXPECT_TRUE(world_->AgentIds().empty());
}

TEST_F(HostTest, AMissingOrBrokenSandboxDoesNotLoad) {
  Start("Nowhere.lua");
  EXPECT_FALSE(loaded_);
  EXPECT_EQ(recorder_.errors.size(), 1u);
  StartWith("require 'NoSuchModule'");
  EXPECT_FALSE(loaded_);
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.line, 1);
  Tick();
}

TEST_F(HostTest, EndlessLoopsAndEndlessCreationAreStopped) {
  Write("Loop.lua", "function Agent_Update(a) while true do end end");
  Write("Self.lua", "function Agent_Initialize(a) Sandbox.CreateAgent(a:GetSandbox(), 'Self.lua') end");
  StartWith(
      "function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'Loop.lua') Sandbox.CreateAgent(s, 'Self.lua') end\n"
      "function Sandbox_Update(s) while true do Sandbox.CreateBox(s, 1, 1, 1) end end");
  EXPECT_NE(Errors().find("agents make agents without end"), std::string::npos) << Errors();
  Tick();
  EXPECT_NE(Errors().find("Loop.lua:1: error: the script ran for more than 1000 thousand instructions"),
            std::string::npos)
      << Errors();
  EXPECT_LT(world_->ObjectIds().size(), 2000u);
}

TEST_F(HostTest, EventsArriveNextStepInAllMachinesWithTheirFields) {
  Write("A.lua",
        "function Agent_Initialize(a)\n"
        "  Sandbox.AddEventCallback(a:GetSandbox(), a, function(s, target, type, e)\n"
        "    print(target:GetId(), type, e.n, e.yes, e.no, e.text, e.v, e.who == target, e['1'], e.inner) end)\n"
        "end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  local a = Sandbox.CreateAgent(s, 'A.lua')\n"
      "  Sandbox.AddEventCallback(s, s, function(_, target, type) print('sandbox', type)\n"
      "    if type == 'first' then Sandbox.AddEvent(s, 'second', {}) end end)\n"
      "  Sandbox.AddEvent(s, 'first', {n = '2', yes = true, no = false, text = 'hi', v = Vector.new(1), who = a, 10, "
      "inner = {}})\n"
      "end");
  EXPECT_EQ(Printed(), "");
  Tick();
  EXPECT_EQ(Printed(),
            "sandbox\tfirst|1\tfirst\t2\ttrue\tfalse\thi\t{ x=1.000000, y=1.000000, z=1.000000 }\ttrue\t10\tnil");
  recorder_.prints.clear();
  Tick();
  EXPECT_EQ(Printed(), "sandbox\tsecond|1\tsecond\tnil\tnil\tnil\tnil\tnil\tfalse\tnil\tnil");
  EXPECT_EQ(Errors(), "");
}

TEST_F(HostTest, CollisionsReachTheCallbacksOfBothObjects) {
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  plane = Sandbox.CreatePlane(s, 10, 10)\n"
      "  ball = Sandbox.CreatePhysicsSphere(s, 0.5) Core.SetPosition(ball, Vector.new(0, 0.6, 0))\n"
      "  hits = 0\n"
      "  Sandbox.AddCollisionCallback(s, ball, function(_, c) hits = hits + 1\n"
      "    first = first or c Sandbox.RemoveObject(s, c.objectA) end)\n"
      "  Sandbox.AddCollisionCallback(s, plane, function(_, c) other = other or c end)\n"
      "end");
  Ticks(20);
  EXPECT_EQ(Run("print(hits >= 1, first.objectA == ball, first.objectB == plane, other.objectA == plane, "
                "first.normalOnB.y > 0.9, other.normalOnB.y < -0.9, first.pointA == other.pointB)"),
            "true\ttrue\ttrue\ttrue\ttrue\ttrue\ttrue");
  EXPECT_EQ(world_->ObjectIds().size(), 1u);
}

TEST_F(HostTest, KeysReachTheSandboxThenTheAgents) {
  Write("A.lua", "function Agent_HandleEvent(a, e) print('agent', e.source, e.key, e.pressed) end");
  StartWith(
      "function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end\n"
      "function Sandbox_HandleEvent(s, e) print('sandbox', e.source, e.key, e.button, e.pressed, e.width) end");
  host_->HandleInput(KeyEvent("space_key", true));
  EXPECT_EQ(Printed(), "sandbox\tkeyboard\tspace_key\tnil\ttrue\tnil|agent\tkeyboard\tspace_key\ttrue");
  recorder_.prints.clear();
  InputEvent motion;
  motion.source = InputEvent::Source::kMouse;
  host_->HandleInput(motion);
  EXPECT_EQ(recorder_.prints[0], "sandbox\tmouse\tnil\tnil\tnil\t1280");
}

TEST_F(HostTest, AgentsWithMindsAreAskedForWithTheirKindRulesAndOptions) {
  Write("A.lua", "function Agent_Initialize(a) print(a:GetTarget()) end");
  StartWith(
      "function Sandbox_Initialize(s)\n"
      "  Sandbox.CreateSoarSeekingAgent(s, 'A.lua')\n"
      "  local f = Sandbox.CreateSoarFollowerAgent(s, 'A.lua', 'mine.soar')\n"
      "  Sandbox.CreateSoarAgent(s, 'A.lua', 'scout.soar', {name = 'scout', range = 5, brave = true})\n"
      "  Sandbox.CreateSoarAgent(s, 'A.lua', 'missing.soar')\n"
      "  f:SetLeader(Sandbox.GetAgents(s)[1]) print(f:GetLeader():GetId())\n"
      "  print(pcall(Sandbox.CreateSoarAgent, s, 'A.lua', 'x.soar', {bad = print}))\n"
      "end");
  EXPECT_EQ(recorder_.prints[0], "{ x=0.000000, y=0.000000, z=10.000000 }");
  ASSERT_EQ(minds_.made.size(), 3u);
  EXPECT_EQ(minds_.made[0].second.kind, "seeking");
  EXPECT_EQ(minds_.made[1].second.rules, "mine.soar");
  EXPECT_EQ(std::get<double>(minds_.made[2].second.options.at("range")), 5);
  EXPECT_TRUE(std::get<bool>(minds_.made[2].second.options.at("brave")));
  EXPECT_EQ(world_->FindAgent(EntityId{1})->name(), "seeker-1");
  EXPECT_EQ(world_->FindAgent(EntityId{2})->name(), "follower-1");
  EXPECT_EQ(world_->FindAgent(EntityId{2})->kind(), "soar follower");
  EXPECT_EQ(world_->FindAgent(EntityId{3})->name(), "scout");
  EXPECT_TRUE(world_->FindAgent(EntityId{4})->Failed());
  EXPECT_EQ(recorder_.prints[4], "1");
  EXPECT_NE(recorder_.prints[5].find("the values of options are strings, numbers, booleans, vectors"),
            std::string::npos);
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(recorder_.errors[0].second.diagnostic.message, "no such file: \"missing.soar\"");
}

TEST_F(HostTest, AgentsDrawFromStreamsOfTheirOwn) {
  Write("A.lua", "function Agent_Initialize(a) print(math.random(1, 1000000000)) end");
  const std::string script =
      "function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') Sandbox.CreateAgent(s, 'A.lua') end";
  StartWith(script);
  const std::vector<std::string> first = recorder_.prints;
  ASSERT_EQ(first.size(), 2u);
  EXPECT_NE(first[0], first[1]);
  // Random numbers of others do not change it.
  StartWith("math.random() math.random() " + script);
  EXPECT_EQ(recorder_.prints, first);
  StartWith(script, 2);
  EXPECT_NE(recorder_.prints[0], first[0]);
}

}  // namespace
}  // namespace soarbox::script
