// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_table.h"

#include <set>

#include "picture/png.h"
#include "script/host_test_support.h"

// Compares the table of the API with the registered functions, and runs its examples in a world.

namespace soarbox::script {
namespace {

constexpr const char* kWorld = R"(
function Sandbox_Initialize(s)
  sandbox = s
  Sandbox.CreatePlane(s, 100, 100)
  local floor = Sandbox.CreateBox(s, 30, 1, 30)
  Core.SetMass(floor, 0)
  Core.SetPosition(floor, Vector.new(0, -0.5, 0))
  agent = Sandbox.CreateAgent(s, "Quiet.lua")
  agent:SetPosition(Vector.new(0, 0.8, 0))
  other = Sandbox.CreateAgent(s, "Quiet.lua")
  other:SetPosition(Vector.new(3, 0.8, 2))
  object = Sandbox.CreateBox(s, 1, 1, 1)
  Core.SetPosition(object, Vector.new(5, 0.5, 5))
  node = Core.CreateBox(s, 1, 1, 1)
  light = Core.CreatePointLight(s, Vector.new(0, 5, 0))
  effect = Core.CreateParticle(s, "Bullet")
  ui = Sandbox.CreateUIComponent(s, 1)
  panel = Sandbox.CreateUIComponent3d(s, Vector.new(0, 2, 0))
  mesh = Core.CreateMesh(s, "models/soarbox/soldier.mesh")
  animation = Animation.GetAnimation(mesh, "stand_run_forward_aim")
end
)";

constexpr const char* kPlaces = R"(
Sandbox.CreateNavigationMesh(sandbox, "default", {MinimumRegionArea = 10})
Sandbox.CreateInfluenceMap(sandbox, "default", {CellWidth = 2, CellHeight = 1})
)";

class ApiTableTest : public HostTest {
 protected:
  ApiTableTest() {
    Write("Quiet.lua", "");
    Write("badge.png", picture::PngOf(picture::Image(4, 4, {1, 0, 0, 1})));
    Write("bell.wav", ShortWav());
    StartWith(kWorld);
  }
};

TEST_F(ApiTableTest, HoldsEachRegisteredFunctionAndNoOther) {
  const std::string names =
      Run("local names = {}\n"
          "for _, table_name in ipairs({'Agent', 'Animation', 'Core', 'Sandbox', 'UI', 'Vector'}) do\n"
          "  for name in pairs(_G[table_name]) do print(table_name .. '.' .. name) end\n"
          "end");
  std::set<std::string> registered, listed;
  for (const std::string& name : recorder_.prints) registered.insert(name);
  int of_the_first_sandbox = 0;
  for (const ApiGroup& group : ApiGroups()) {
    for (const ApiFunction& function : group.functions) {
      EXPECT_TRUE(listed.insert(std::string(function.name)).second) << function.name << " stands there twice";
      EXPECT_TRUE(function.name.starts_with(std::string(group.name) + ".")) << function.name;
      EXPECT_TRUE(function.text.ends_with(".")) << function.name;
      EXPECT_FALSE(function.example.empty()) << function.name;
      of_the_first_sandbox += !function.own;
    }
  }
  EXPECT_EQ(registered, listed);
  EXPECT_EQ(of_the_first_sandbox, 192);
}

TEST_F(ApiTableTest, CountsRequiredArgumentsAsTheFunctionsDo) {
  for (const ApiGroup& group : ApiGroups()) {
    for (const ApiFunction& function : group.functions) {
      int required = 0;
      for (const ApiArgument& argument : ParseArguments(function.arguments)) required += !argument.optional;
      if (required == 0) continue;
      StartWith(kWorld);
      std::string complaint = Run(std::string(function.name) + "()");
      if (complaint.empty() && !recorder_.warnings.empty()) complaint = recorder_.warnings[0].message;
      EXPECT_NE(complaint.find("expected " + std::to_string(required) + " "), std::string::npos)
          << function.name << " wants " << required << ": " << complaint;
    }
  }
}

/// The texts after each "-->" of an example, joined like printed lines.
std::string ExpectedPrints(std::string_view example) {
  std::string expected;
  while (!example.empty()) {
    const std::string_view line = example.substr(0, example.find('\n'));
    if (const std::size_t arrow = line.find("--> "); arrow != std::string_view::npos)
      expected += (expected.empty() ? "" : "|") + std::string(line.substr(arrow + 4));
    example.remove_prefix(std::min(example.size(), line.size() + 1));
  }
  return expected;
}

bool FindsPlaces(std::string_view example) {
  return example.find("default") != std::string_view::npos || example.find("sandbox, 0") != std::string_view::npos ||
         example.find("Influence") != std::string_view::npos;
}

TEST_F(ApiTableTest, EachExampleRunsAndPrintsWhatItSays) {
  for (const ApiGroup& group : ApiGroups()) {
    for (const ApiFunction& function : group.functions) {
      StartWith(kWorld);
      ASSERT_EQ(Errors(), "");
      const std::string trouble = FindsPlaces(function.example) ? Run(kPlaces) : "";
      ASSERT_EQ(trouble, "");
      EXPECT_EQ(Run(function.example), ExpectedPrints(function.example)) << function.name << "\n" << function.example;
      Ticks(3);
      EXPECT_EQ(Errors(), "") << function.name;
      for (const Diagnostic& warning : recorder_.warnings) ADD_FAILURE() << function.name << ": " << warning.message;
    }
  }
}

TEST_F(ApiTableTest, TheFirstWrongArgumentIsTheOneThatIsReported) {
  EXPECT_EQ(Run("Agent.SetPath(1, 2)"), "error: bad argument #1 to 'Agent.SetPath' (AgentType expected, got number)");
  EXPECT_EQ(Run("Agent.SetPosition(nil, nil)"),
            "error: bad argument #1 to 'Agent.SetPosition' (AgentType expected, got nil)");
  EXPECT_EQ(Run("Vector.Distance('a', 'b')"),
            "error: bad argument #1 to 'Vector.Distance' (Vector3Type expected, got string)");
  EXPECT_EQ(Run("Sandbox.FindPath(sandbox, {}, 1, 2)"),
            "error: bad argument #2 to 'Sandbox.FindPath' (string expected, got table)");
  EXPECT_EQ(Run("Core.DrawLine(Vector.new(), 1, 2)"),
            "error: bad argument #2 to 'Core.DrawLine' (Vector3Type expected, got number)");
  EXPECT_EQ(Run("agent:ForceToCombine('x', {}, 3)"),
            "error: bad argument #1 to 'Agent.ForceToCombine' (number expected, got string)");
  EXPECT_EQ(Run("Animation.SetTime(agent, {})"),
            "error: bad argument #1 to 'Animation.SetTime' (animation expected, got AgentType)");
  EXPECT_TRUE(recorder_.warnings.empty());
  EXPECT_EQ(Run("Sandbox.SetCameraPosition(agent, 7)"), "");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].message, "argument 1 is not the sandbox but AgentType: the call is ignored");
}

TEST_F(ApiTableTest, AThingThatIsGoneIsReportedBeforeAWrongArgumentBehindIt) {
  Run("Core.Remove(node)");
  EXPECT_EQ(Run("Core.SetPosition(node, 7)"),
            "error: bad argument #1 to 'Core.SetPosition' (this scene node was removed)");
}

TEST_F(ApiTableTest, FunctionsKeepTheirNamesInProtectedCalls) {
  EXPECT_EQ(Run("print(select(2, pcall(agent.SetPosition, agent, 3)))"),
            "bad argument #2 to 'Agent.SetPosition' (Vector3Type expected, got number)");
  EXPECT_EQ(Run("print(select(2, pcall(Sandbox.CreateUIComponent, sandbox, 16)))"),
            "bad argument #2 to 'Sandbox.CreateUIComponent' (a layer is a number from 0 to 15)");
  EXPECT_EQ(Run("print(select(2, pcall(function() agent:SetPosition(3) end)))"),
            "console:1: bad argument #1 to 'Agent.SetPosition' (Vector3Type expected, got number)");
}

TEST_F(ApiTableTest, NamesThatAreNearlyRightAreErrorsThatNameTheRightOne) {
  EXPECT_EQ(Run("Agent.SetPosiiton(agent, Vector.new())"),
            "error: Agent has no function 'SetPosiiton': did you mean 'SetPosition'?");
  EXPECT_EQ(Run("agent:GetPositon()"), "error: Agent has no function 'GetPositon': did you mean 'GetPosition'?");
  EXPECT_EQ(Run("local f = Sandbox.findPath"), "error: Sandbox has no function 'findPath': did you mean 'FindPath'?");
  EXPECT_EQ(Run("UI.SetTxt(ui, 'a')"), "error: UI has no function 'SetTxt': did you mean 'SetText'?");
  EXPECT_EQ(Run("print(Core.SomethingElse, agent.somethingElse, agent[1], Vector[{}])"), "nil\tnil\tnil\tnil");
  EXPECT_EQ(Run("function Core.Mine() return 5 end print(Core.Mine())"), "5");
  EXPECT_EQ(Run("Core.Unheard()"), "error: attempt to call field 'Unheard' (a nil value)");
}

}  // namespace
}  // namespace soarbox::script
