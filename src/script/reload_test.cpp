// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"
#include "script/keep_state.h"

namespace soarbox::script {
namespace {

using world::EntityId;

/// Edits of running files, and the communication of scripts with users.
class ReloadTest : public HostTest {
 protected:
  /// Like a watched file that was saved: in the machine of the sandbox, or of an agent.
  std::optional<ScriptError> Reload(const std::string& file, const std::string& before, const std::string& after,
                                    EntityId who = EntityId::kSandbox) {
    recorder_.prints.clear();
    return host_->RunText(who, WithReload(after, {file, UnchangedVariables(before, after)}));
  }
};

TEST_F(ReloadTest, AFileThatWasRequiredIsKnownAndItsNewFunctionsAreCalled) {
  const std::string before =
      "Lib = {}\nlocal count = 0\nfunction Lib.Say() count = count + 1 return 'one' .. count end\n";
  const std::string after =
      "Lib = {}\nlocal count = 0\nfunction Lib.Say() count = count + 1 return 'two' .. count end\n";
  Write("Lib.lua", before);
  StartWith("require 'Lib' local lib = Lib function Sandbox_Update() print(lib.Say(), Lib.Say()) end");
  const auto files = host_->FilesOf(EntityId::kSandbox);
  EXPECT_EQ(std::vector<std::string>(files.begin(), files.end()), (std::vector<std::string>{"Sandbox.lua", "Lib.lua"}));
  Tick();
  EXPECT_EQ(Printed(), "one1\tone2");
  EXPECT_FALSE(Reload("Lib.lua", before, after));
  Tick();
  EXPECT_EQ(Printed(), "two3\ttwo4");  // New functions, the old count, and the same table, to which others refer.
}

TEST_F(ReloadTest, AgentsThatAreMadeLaterRunTheNewVersion) {
  const std::string before = "function Agent_Update() print('old') end",
                    after = "function Agent_Update() print('new') end";
  Write("A.lua", before);
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end");
  EXPECT_FALSE(Reload("A.lua", before, after, EntityId{1}));
  EXPECT_EQ(Run("Sandbox.CreateAgent(sandbox, 'A.lua')"), "");
  Tick();
  EXPECT_EQ(Printed(), "new|new");
}

TEST_F(ReloadTest, ErrorsNameFileAndLineOfTheNewVersion) {
  const std::string before = "function Sandbox_Update() end";
  const std::string after = "-- one\nlocal foo\nfunction Sandbox_Update()\n  print(foo.x)\nend";
  StartWith(before);
  EXPECT_FALSE(Reload("Sandbox.lua", before, after));
  Tick();
  ASSERT_EQ(recorder_.errors.size(), 1u);
  const Diagnostic& error = recorder_.errors[0].second.diagnostic;
  EXPECT_EQ(error.file, (folder_ / "Sandbox.lua").string());
  EXPECT_EQ(error.line, 4);
  EXPECT_EQ(error.excerpt, "  print(foo.x)");
}

TEST_F(ReloadTest, WhatIsTypedKnowsTheSandboxAndTheAgentAndHasAnAnswer) {
  Write("A.lua", "");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end");
  std::string answer;
  EXPECT_FALSE(host_->RunText(EntityId::kSandbox, "#Sandbox.GetAgents(sandbox), 'x'", &answer));
  EXPECT_EQ(answer, "1\tx");
  answer.clear();
  EXPECT_FALSE(host_->RunText(EntityId{1}, "agent:GetId() -- who", &answer));
  EXPECT_EQ(answer, "1");
  answer.clear();
  EXPECT_FALSE(host_->RunText(EntityId{1}, "x = 3 print(x)", &answer));
  EXPECT_EQ(answer, "");
  const auto error = host_->RunText(EntityId{1}, "agent:Fly()", &answer);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnostic.line, 1);
}

TEST_F(ReloadTest, RecordingsOfEarlierVersionsAreReadToo) {
  const std::string text = "function f() end\n--@keep a b";
  const std::optional<script::Reload> old = ReadReload(text);
  ASSERT_TRUE(old);
  EXPECT_EQ(old->file, "");
  EXPECT_EQ(old->names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(WithoutReload(text), "function f() end");
  const std::optional<script::Reload> now = ReadReload(WithReload("x = 1", {"My Lib.lua", {}}));
  ASSERT_TRUE(now);
  EXPECT_EQ(now->file, "My Lib.lua");
  EXPECT_FALSE(ReadReload("print('\\n--@keep')"));
}

TEST_F(ReloadTest, AScriptThatRanOutOfMemoryGoesOn) {
  settings_.world_limits.memory_bytes = std::size_t{64} << 20;
  settings_.sandbox_limits.instructions = 200'000'000;
  settings_.world_limits.tick_instructions = 4'000'000'000;
  StartWith(
      "local tick = 0\n"
      "function Sandbox_Update()\n"
      "  tick = tick + 1\n"
      "  if tick == 2 then local t = {} for i = 1, 1e9 do t[i] = string.rep('x', 1000) .. i end end\n"
      "  local s = {} for i = 1, 10 do s[i] = tostring(i * tick) .. 'abc' end\n"
      "  print(tick)\n"
      "end");
  Ticks(60);
  EXPECT_EQ(recorder_.prints.size(), 59u);
  ASSERT_EQ(recorder_.errors.size(), 1u) << Errors();
  EXPECT_NE(Errors().find("the script needs more than its share of this world's memory"), std::string::npos)
      << Errors();
}

TEST_F(ReloadTest, ErrorsSayWhichCallsLedToThem) {
  StartWith(
      "local function Inner(x) return x.y end\n"
      "function Outer(x)\n  local y = Inner(x)\n  return y\nend\n"
      "function Sandbox_Update()\n  Outer(nil)\n  print('x')\nend\n");
  Tick();
  ASSERT_EQ(recorder_.errors.size(), 1u);
  EXPECT_EQ(CallersIn(recorder_.errors[0].second.traceback),
            "called from Sandbox.lua:3 (Outer), Sandbox.lua:7 (the function at line 6)");
  EXPECT_EQ(CallersIn("  Bad.lua:3: in the function at line 1\n"), "");
  EXPECT_NE(Run("local function f() return debug.traceback('here') end print((f()))").find("here"), std::string::npos);
}

TEST_F(ReloadTest, CommandsMayTakeTime) {
  Write("Body.lua",
        "function Agent_Update(a, ms, command, parameters)\n"
        "  parameters.calls = (parameters.calls or 0) + 1\n"
        "  if command == 'bad' then return 'error', 'too-far', 'it is far' end\n"
        "  if command == 'odd' then return 'runing' end\n"
        "  if parameters.calls < 3 then return 'running', parameters.calls / 4 end\n"
        "end\n"
        "function Agent_Withdraw(a, command, parameters) print('withdrawn', command, parameters.calls) end\n"
        "function Agent_Tick(a, ms) print('tick', ms) end\n");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateSoarAgent(s, 'Body.lua', 'x.soar') end");
  using State = CommandAnswer::State;
  const EntityId body{1};
  CommandAnswer answer = host_->CommandAgent(body, 7, "go", {});
  EXPECT_EQ(answer.state, State::kRunning);
  EXPECT_FLOAT_EQ(answer.progress.value_or(-1), 0.25f);
  EXPECT_FLOAT_EQ(host_->ContinueCommand(body, 7, "go").progress.value_or(-1), 0.5f);
  EXPECT_EQ(host_->ContinueCommand(body, 7, "go").state, State::kComplete);
  EXPECT_EQ(host_->CommandAgent(body, 8, "go", {}).state, State::kRunning);
  host_->WithdrawCommand(body, 8, "go");
  host_->WithdrawCommand(body, 8, "go");
  answer = host_->CommandAgent(body, 9, "bad", {});
  EXPECT_EQ(answer.state, State::kError);
  EXPECT_EQ(answer.reason, "too-far");
  EXPECT_EQ(answer.text, "it is far");
  EXPECT_EQ(host_->CommandAgent(body, 10, "odd", {}).state, State::kComplete);
  host_->TickAgent(body);
  EXPECT_EQ(Printed(), "withdrawn\tgo\t1|tick\t33");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_NE(recorder_.warnings[0].message.find("runing"), std::string::npos);
  EXPECT_EQ(Errors(), "");
}

TEST_F(ReloadTest, WhatABodyOfAScriptDoesNotHeedGivesAWarningWithItsPlace) {
  Write("Body.lua", "function Agent_Update() end");
  StartWith(
      "function Sandbox_Initialize(s)\n Sandbox.CreateSoarAgent(s, 'Body.lua', 'x.soar', { body = 'runner', team = "
      "'red' })\nend");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].line, 2);
  EXPECT_EQ(recorder_.warnings[0].message, "body has no effect here: Body.lua moves and shows the agent");
}

TEST_F(ReloadTest, LooksBesideAScriptGiveOneWarningThatSaysWhatToWriteAndTheMindIsMade) {
  Write("Body.lua", "function Agent_Update() end");
  StartWith(
      "function Sandbox_Initialize(s)\n Sandbox.CreateSoarAgent(s, 'Body.lua', 'x.soar', { looks = 'duck.glb', team = "
      "'red' })\n Sandbox.CreateSoarAgent(s, 'Body.lua', 'x.soar', { looks = 'wolf' })\nend");
  ASSERT_EQ(recorder_.warnings.size(), 2u);
  EXPECT_EQ(recorder_.warnings[0].line, 2);
  EXPECT_EQ(recorder_.warnings[0].message, "looks has no effect here: Body.lua moves and shows the agent");
  EXPECT_EQ(recorder_.warnings[0].hint,
            "leave it out, and write in Agent_Initialize of Body.lua: Core.CreateMesh(agent, \"duck.glb\")");
  EXPECT_NE(recorder_.warnings[1].hint.find("Core.CreateCapsule(agent, "), std::string::npos);
  EXPECT_EQ(Errors(), "");
  ASSERT_EQ(minds_.made.size(), 2u);
  EXPECT_FALSE(minds_.made[0].second.options.contains("looks"));
  EXPECT_TRUE(minds_.made[0].second.options.contains("team"));
}

TEST_F(ReloadTest, UnknownNamesOfMediaAreToldWithTheirPlaceAndTheList) {
  StartWith("function Sandbox_Initialize(s)\n  Core.SetMaterial(Core.CreateBox(s, 1, 1, 1), 'Wood')\nend");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].line, 2);
  EXPECT_NE(recorder_.warnings[0].hint.find("Soarbox/Brick"), std::string::npos) << recorder_.warnings[0].hint;
}

TEST_F(ReloadTest, ShowsNestedStateWithTheActivePathAndSinceWhen) {
  Write("A.lua",
        "local n = 0\n"
        "function Agent_Update(a)\n"
        "  n = n + 1\n"
        "  a:Show('tree', { { name = 'fight', active = n > 2, { name = 'reload', active = n > 2, value = n > 2 } } })\n"
        "  a:Show('board', { enemy = a, place = Vector.new(1, 2, 3), ammo = 3, list = { 'x' } })\n"
        "  if n == 5 then a:Show('board') end\n"
        "end");
  StartWith("function Sandbox_Initialize(s) Sandbox.CreateAgent(s, 'A.lua') end");
  Ticks(3);
  const world::Agent& agent = *world_->FindAgent(EntityId{1});
  std::string text;
  const auto written = [&] {
    text.clear();
    for (const world::ShownRow& row : world::ReadShown(agent.Shown().text()))
      text += std::string(static_cast<std::size_t>(row.depth), ' ') + row.name + "=" + row.value +
              (row.active ? "*" : "") + "@" + std::to_string(row.since_tick) + "\n";
    return text;
  };
  EXPECT_EQ(written(),
            "tree=@1\n fight=*@3\n  reload=true*@3\n"
            "board=@1\n ammo=3@1\n enemy=A-1@1\n list=@1\n  1=x@1\n place=(1.00, 2.00, 3.00)@1\n");
  EXPECT_EQ(agent.LastCommand(), "fight > reload");
  EXPECT_EQ(agent.Shown().rows(), world::ReadShown(agent.Shown().text()));
  Ticks(2);
  EXPECT_EQ(written(), "tree=@1\n fight=*@3\n  reload=true*@3\n");
  EXPECT_EQ(Run("print(Agent.Self())"), "nil");
}

}  // namespace
}  // namespace soarbox::script
