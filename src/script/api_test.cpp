// SPDX-License-Identifier: BSD-2-Clause
#include "script/host_test_support.h"

// The sandbox's API as seen from scripts: snippets with their output.

namespace soarbox::script {
namespace {

struct Snippet {
  const char* script;
  const char* printed;
};

class ApiTest : public HostTest {
 protected:
  ApiTest() {
    Write("Quiet.lua", "");
    StartWith("function Sandbox_Initialize(s) sandbox = s agent = Sandbox.CreateAgent(s, 'Quiet.lua') end");
  }
  void Check(std::initializer_list<Snippet> snippets) {
    for (const Snippet& snippet : snippets) EXPECT_EQ(Run(snippet.script), snippet.printed) << snippet.script;
  }
};

TEST_F(ApiTest, VectorsAreMadeFromNothingAVectorANumberOrThreeNumbers) {
  Check({
      {"print(Vector.new())", "{ x=0.000000, y=0.000000, z=0.000000 }"},
      {"print(Vector.new(2))", "{ x=2.000000, y=2.000000, z=2.000000 }"},
      {"print(Vector.new(1, '2', 3))", "{ x=1.000000, y=2.000000, z=3.000000 }"},
      {"local v = Vector.new(1, 2, 3) local w = Vector.new(v) w.x = 9 print(v.x, w.x)", "1\t9"},
      {"print(Vector.new(1, 2), Vector.new(1, 2, 3, 4), Vector.new('a'), Vector.new({}), Vector.new(nil))",
       "nil\tnil\tnil\tnil\tnil"},
      {"print(type(Vector.new()), Vector.new(0.3).x)", "userdata\t0.30000001192093"},
  });
}

TEST_F(ApiTest, VectorOperatorsWorkByComponentsAndRefuseNumbersOnTheLeft) {
  Check({
      {"print(Vector.new(1, 2, 3) + Vector.new(1) == Vector.new(2, 3, 4))", "true"},
      {"print(Vector.new(1, 2, 3) + 1 == Vector.new(2, 3, 4), Vector.new(1, 2, 3) - 1 == Vector.new(0, 1, 2))",
       "true\ttrue"},
      {"print(Vector.new(1, 2, 3) * Vector.new(2, 3, 4) == Vector.new(2, 6, 12))", "true"},
      {"print(Vector.new(2, 4, 6) / Vector.new(2, 4, 3) == Vector.new(1, 1, 2), Vector.new(2) / 2 == Vector.new(1))",
       "true\ttrue"},
      {"local v = Vector.new(1) print(2 + v, 2 - v, 2 * v, 2 / v, v + {}, v * nil)", "nil\tnil\tnil\tnil\tnil\tnil"},
      {"print(-Vector.new(1, -2, 0.5) == Vector.new(-1, 2, -0.5), Vector.new(1) ~= Vector.new(2), Vector.new() == 0)",
       "true\ttrue\tfalse"},
      {"local v = Vector.new(1) v.y = 5 v.w = 7 v[1] = 3 print(v.y, v.w, v[1], v.Length)", "5\tnil\tnil\tnil"},
      {"local v = Vector.new() print(pcall(function() v.x = 'a' end))",
       "false\tconsole:1: the field 'x' of a vector is a number, not string"},
      {"print(Vector.new(1) / 0 == Vector.new(1 / 0))", "true"},
      {"print(pcall(function() return Vector.new(1) < Vector.new(2) end) == false)", "true"},
  });
}

TEST_F(ApiTest, VectorFunctionsReturnNewVectorsAndCheckTypes) {
  Check({
      {"print(Vector.CrossProduct(Vector.new(1, 0, 0), Vector.new(0, 1, 0)))",
       "{ x=0.000000, y=0.000000, z=1.000000 }"},
      {"print(Vector.Distance(Vector.new(), Vector.new(3, 4, 0)), Vector.DistanceSquared(Vector.new(), Vector.new(3, "
       "4, 0)))",
       "5\t25"},
      {"print(Vector.DotProduct(Vector.new(1, 2, 3), Vector.new(1)), Vector.Length(Vector.new(0, 3, 4)), "
       "Vector.LengthSquared(Vector.new(0, 3, 4)))",
       "6\t5\t25"},
      {"print(Vector.Length('x'), Vector.LengthSquared(), Vector.Normalize(Vector.new()) == Vector.new())",
       "nil\tnil\ttrue"},
      {"local v = Vector.new(0, 3, 4) local n = Vector.Normalize(v) print(n.y < 0.61, v.y)", "true\t3"},
      {"local r = Vector.RotationTo(Vector.new(0, 0, 1), Vector.new(5, 0, 0)) print(string.format('%.1f', r.y))",
       "90.0"},
      {"local r = Vector.Rotate(Vector.new(0, 0, 1), Vector.new(0, 90, 0)) print(string.format('%.3f', r.x))", "1.000"},
      {"print(pcall(Vector.Distance, Vector.new(), 3))",
       "false\tbad argument #2 to 'Vector.Distance' (Vector3Type expected, got number)"},
  });
}

TEST_F(ApiTest, WrongCountsAreIgnoredWithAWarningOrRaiseByFunction) {
  EXPECT_EQ(Run("print(Vector.Distance(Vector.new()))"), "");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].message,
            "\"Vector.Distance\" expected 2 arguments, encountered 1: the call is ignored");
  EXPECT_EQ(recorder_.warnings[0].line, 1);
  Check({
      {"print(pcall(agent.SetPosition, agent))", "false\t\"Agent.SetPosition\" expected 2 arguments, encountered 1"},
      {"print(pcall(Agent.SetPath, agent))", "false\t\"Agent.SetPath\" expected 2 to 3 arguments, encountered 1"},
  });
}

TEST_F(ApiTest, AgentsHaveTheSandboxsDefaultsAndMethods) {
  Check({
      {"print(agent:GetId(), agent:GetHeight(), agent:GetRadius(), agent:GetMass(), agent:GetMaxForce(), "
       "agent:GetMaxSpeed(), agent:GetHealth(), agent:GetTeam(), agent:GetTargetRadius(), agent:HasPath())",
       "1\t1.6000000238419\t0.30000001192093\t90.699996948242\t1000\t7\t100\tteam1\t0.5\tfalse"},
      {"print(agent == Sandbox.GetAgents(sandbox)[1], agent == nil, agent == sandbox, agent ~= Vector.new())",
       "true\tfalse\tfalse\ttrue"},
      {"print(agent:GetSandbox() == sandbox, type(agent), Agent.IsAgent(agent), Agent.IsAgent(nil), "
       "Agent.IsAgent(sandbox))",
       "true\tuserdata\ttrue\tfalse\tfalse"},
      {"function Agent.Mine() end print(agent.Mine, agent.GetId ~= nil, agent[1])", "nil\ttrue\tnil"},
      {"print(pcall(function() agent.foo = 1 end))",
       "false\tconsole:1: attempt to index global 'agent' (a userdata value)"},
      {"agent:SetTarget(Vector.new(1, 2, 3)) local t = agent:GetTarget() t.x = 9 print(agent:GetTarget().x)", "1"},
      {"agent:SetMaxSpeed(-3) agent:SetTeam('blue') agent:SetHealth(-5) print(agent:GetMaxSpeed(), agent:GetTeam(), "
       "agent:GetHealth())",
       "0\tblue\t-5"},
      {"print(pcall(Agent.GetPosition, nil))",
       "false\tbad argument #1 to 'Agent.GetPosition' (AgentType expected, got nil)"},
      {"agent:SetForward(Vector.new(0, 0, 0)) local f = agent:GetForward() print(f.z)", "1"},
      {"print(UI ~= nil, package.loaded.Agent == Agent, decoda_name)", "true\ttrue\tAI Sandbox VM - \"Sandbox.lua\""},
  });
  EXPECT_EQ(Run("print(UI, decoda_name)", world::EntityId{1}), "nil\tAI Agent VM - \"Quiet.lua\"");
}

TEST_F(ApiTest, PathsCloseWithACopyOfTheFirstPoint) {
  Check({
      {"agent:SetPath({Vector.new(), Vector.new(4, 0, 0), 'no vector', Vector.new(4, 0, 3)}, true) "
       "print(#agent:GetPath(), agent:HasPath())",
       "4\ttrue"},
      {"print(agent:GetDistanceAlongPath(Vector.new(4, 0, 1)), agent:GetPointOnPath(5).z, "
       "agent:GetNearestPointOnPath(Vector.new(2, 5, -1)).x)",
       "5\t1\t2"},
      {"agent:RemovePath() print(agent:HasPath(), #agent:GetPath(), agent:GetPointOnPath(1))", "false\t0"},
  });
}

TEST_F(ApiTest, GroupForcesTakeTablesOfAgentsOnly) {
  Check({
      {"print(agent:ForceToSeparate(2, 180, Sandbox.GetAgents(sandbox)))", "{ x=0.000000, y=0.000000, z=0.000000 }"},
      {"print(agent:ForceToCombine(2, 180, {}))", "{ x=0.000000, y=0.000000, z=0.000000 }"},
      {"print(pcall(Agent.ForceToSeparate, agent, 2, 180, {1}))",
       "false\tbad argument #4 to 'Agent.ForceToSeparate' (a table of agents expected; it holds a number)"},
      {"other = Sandbox.CreateAgent(sandbox, 'Quiet.lua') other:SetPosition(Vector.new(0, 0, 1)) "
       "print(agent:ForceToSeparate(5, 180, {x = other}).z, agent:ForceToCombine(5, 180, {other}).z)",
       "-1\t1"},
  });
}

TEST_F(ApiTest, ObjectsNodesAndTheSandboxTakeWhatTheirKindAllows) {
  Check({
      {"box = Sandbox.CreateBox(sandbox, 1, 1, 1) print(Core.GetMass(box), Core.GetPosition(box) == Vector.new())",
       "1\ttrue"},
      {"Core.SetPosition(box, Vector.new(0, 5, 0)) Core.SetRotation(box, Vector.new(0, 30, 0)) "
       "print(Core.GetPosition(box).y, string.format('%.1f', Core.GetRotation(box).y))",
       "5\t30.0"},
      {"node = Core.CreateBox(box, 1, 2, 3) Core.SetPosition(node, Vector.new(1)) print(Core.GetPosition(node).x, "
       "Core.IsVisisble(node))",
       "1\ttrue"},
      {"Core.SetVisisble(node, false) print(Core.IsVisible(node)) Core.Remove(node) print(pcall(Core.GetPosition, "
       "node))",
       "false|false\tbad argument #1 to 'Core.GetPosition' (this scene node was removed)"},
      {"print(Core.GetMass(sandbox), Core.CreateBox('x', 1, 1, 1))", "nil"},
      {"print(#Sandbox.GetObjects(sandbox), Sandbox.GetObjects(sandbox)[1] == box)", "1\ttrue"},
      {"local hit = Sandbox.RayCastToObject(sandbox, Vector.new(0, 9, 0), Vector.new(0, 3, 0)) print(hit.result, "
       "hit.object == box)",
       "true\ttrue"},
      {"print(Sandbox.RayCastToObject(sandbox, Vector.new(50), Vector.new(60)).object)", "nil"},
      {"Sandbox.RemoveObject(sandbox, box) Sandbox.RemoveObject(sandbox, box) print(Core.GetMass(box))", "1"},
      {"print(pcall(Core.Remove, box))", "false\tCore.Remove is for scene nodes; use Sandbox.RemoveObject"},
  });
  Tick();
  Check({
      {"print(pcall(Core.GetMass, box))", "false\tbad argument #1 to 'Core.GetMass' (this sandbox object was removed)"},
      {"Sandbox.RemoveObject(sandbox, box) print(#Sandbox.GetObjects(sandbox))", "0"},
  });
}

TEST_F(ApiTest, TheCameraFollowsTheSandboxsConventions) {
  Check({
      {"Sandbox.SetCameraPosition(sandbox, Vector.new(-30, 5, 7)) print(Sandbox.GetCameraPosition(sandbox))",
       "{ x=-30.000000, y=5.000000, z=7.000000 }"},
      {"Sandbox.SetCameraForward(sandbox, Vector.new(0, 0, -1)) print(string.format('%.2f', "
       "Sandbox.GetCameraForward(sandbox).z))",
       "1.00"},
      {"Sandbox.SetCameraOrientation(sandbox, Vector.new(-160, 0, -180)) local f = Sandbox.GetCameraForward(sandbox) "
       "print(f.z > 0.9, f.y < -0.3)",
       "true\ttrue"},
      {"print(Sandbox.GetScreenWidth(sandbox), Sandbox.GetScreenHeight(sandbox), Sandbox.GetTimeInMillis(sandbox))",
       "1280\t800\t0"},
      {"print(Sandbox.GetDrawPhysicsWorld(sandbox)) Sandbox.SetDrawPhysicsWorld(sandbox, true) "
       "print(Sandbox.GetDrawPhysicsWorld(sandbox))",
       "false|true"},
  });
  Ticks(30);
  Check({{"print(Sandbox.GetTimeInMillis(sandbox), Sandbox.GetTimeInSeconds(sandbox))", "990\t0.99"}});
}

TEST_F(ApiTest, UserInterfaceComponentsKeepWhatScriptsSet) {
  Check({
      {"ui = Sandbox.CreateUIComponent(sandbox, 1) local d = UI.GetDimensions(ui) print(d.x, d.y, UI.IsVisible(ui), "
       "UI.GetFont(ui))",
       "100\t100\ttrue\tsmall"},
      {"UI.SetPosition(ui, 10, 20) child = UI.CreateChild(ui) UI.SetPosition(child, 1, 2) local p = "
       "UI.GetScreenPosition(child) print(p.x, p.y)",
       "11\t22"},
      {"UI.SetTextMargin(ui, 3, 4) local m = UI.GetTextMargin(ui) print(m.x, m.y)", "4\t3"},
      {"UI.SetMarkupText(ui, '%1red') UI.SetText(ui, 'plain') print(UI.GetMarkupText(ui), UI.GetText(ui))",
       "%1red\tplain"},
      {"UI.SetFont(ui, 'large_mono') UI.SetVisible(ui, false) print(UI.GetFont(ui), UI.IsVisible(ui))",
       "large_mono\tfalse"},
      {"local i, c = Sandbox.GetMarkupColor(sandbox, 3) print(i, c.alpha)", "3\t1"},
      {"print(pcall(Sandbox.CreateUIComponent, sandbox, 16))",
       "false\tbad argument #2 to 'Sandbox.CreateUIComponent' (a layer is a number from 0 to 15)"},
      {"print(pcall(UI.SetText, sandbox, 'x'))",
       "false\tbad argument #1 to 'UI.SetText' (UI component expected, got sandbox)"},
  });
}

TEST_F(ApiTest, ValuesThatAreNotFiniteChangeNothing) {
  EXPECT_EQ(Run("agent:SetPosition(Vector.new(0 / 0)) agent:ApplyForce(Vector.new(1 / 0)) agent:SetRadius(0 / 0) "
                "print(agent:GetRadius() > 0, agent:GetPosition() == Vector.new())"),
            "true\ttrue");
  ASSERT_EQ(recorder_.warnings.size(), 3u);
  EXPECT_EQ(recorder_.warnings[0].message, "argument 2, the position, is not finite: the call is ignored");
}

}  // namespace
}  // namespace soarbox::script
