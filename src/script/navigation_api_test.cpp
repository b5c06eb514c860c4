// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>

#include "script/host_test_support.h"

// Navigation meshes and influence maps as seen from scripts.

namespace soarbox::script {
namespace {

/// A floor of 30 by 30 m, divided by a wall with a gap at one end, and its mesh.
class NavigationApiTest : public HostTest {
 protected:
  NavigationApiTest() {
    Write("Quiet.lua", "");
    StartWith(
        "function Fixed(size, position)\n"
        "  local box = Sandbox.CreateBox(sandbox, size.x, size.y, size.z)\n"
        "  Core.SetMass(box, 0) Core.SetPosition(box, position) return box\n"
        "end\n"
        "function Sandbox_Initialize(s)\n"
        "  sandbox = s agent = Sandbox.CreateAgent(s, 'Quiet.lua')\n"
        "  Fixed(Vector.new(30, 1, 30), Vector.new(0, -0.5, 0))\n"
        "  Fixed(Vector.new(24, 2, 1), Vector.new(-3, 1, 0))\n"
        "  Sandbox.CreateNavigationMesh(s, 'default', {WalkableRadius = 0.4, MinimumRegionArea = 10})\n"
        "  Sandbox.CreateInfluenceMap(s, 'default', {CellWidth = 2, CellHeight = 1})\n"
        "end");
  }
};

TEST_F(NavigationApiTest, PathsAreArraysOfVectors) {
  EXPECT_EQ(Errors(), "");
  EXPECT_EQ(Run("local p = Sandbox.FindPath(sandbox, 'default', Vector.new(-10, 0, -5), Vector.new(-10, 0, 5))\n"
                "agent:SetPath(p) print(type(p), #p >= 3, p[1].x, p[#p].z, agent:HasPath())"),
            "table\ttrue\t-10\t5\ttrue");
  EXPECT_EQ(Run("print(#Sandbox.FindPath(sandbox, 'default', Vector.new(), Vector.new(0, 0, 200)))"), "0");
}

TEST_F(NavigationApiTest, PointsAreOnTheMesh) {
  EXPECT_EQ(Run("for i = 1, 50 do local p = Sandbox.RandomPoint(sandbox, 'default')\n"
                "  assert(math.abs(p.x) < 15 and math.abs(p.z) < 15 and p.y < 0.2)\n"
                "  assert(#Sandbox.FindPath(sandbox, 'default', p, Vector.new(-10, 0, -5)) > 0) end\n"
                "local q = Sandbox.FindClosestPoint(sandbox, 'default', Vector.new(5, 0.8, 5))\n"
                "print(q.x, q.y < 0.2, Sandbox.FindClosestPoint(sandbox, 'default', Vector.new(5, 90, 5)).y)"),
            "5\ttrue\t90");
}

TEST_F(NavigationApiTest, TheNavigationOfMovingAgentsFollowsTheSeed) {
  const auto run = [&](std::uint64_t seed) {
    Write("Walker.lua",
          "function Agent_Initialize(agent) agent:SetPosition(Sandbox.RandomPoint(agent:GetSandbox(), 'default')) end\n"
          "function Agent_Update(agent)\n"
          "  local s = agent:GetSandbox()\n"
          "  if not agent:HasPath() then\n"
          "    agent:SetPath(Sandbox.FindPath(s, 'default', agent:GetPosition(), Sandbox.RandomPoint(s, 'default')))\n"
          "  end\n"
          "  agent:ApplyForce(agent:ForceToFollowPath(0.5) * 100 + agent:ForceToTargetSpeed(3) * 100)\n"
          "end");
    Start("Sandbox.lua", seed);
    Run("for i = 1, 5 do Sandbox.CreateAgent(sandbox, 'Walker.lua') end");
    Ticks(60);
    EXPECT_EQ(Errors(), "");
    return world_->Hash();
  };
  const std::uint64_t first = run(4);
  EXPECT_EQ(run(4), first);
  EXPECT_NE(run(5), first);
}

TEST_F(NavigationApiTest, FaultsAreErrorsThatNameThem) {
  EXPECT_EQ(Run("Sandbox.FindPath(sandbox, 'defualt', Vector.new(), Vector.new())"),
            "error: there is no navigation mesh \"defualt\" (did you mean \"default\"?)");
  EXPECT_EQ(Run("Sandbox.RandomPoint(sandbox, 'other')"),
            "error: there is no navigation mesh \"other\" (make one with Sandbox.CreateNavigationMesh)");
  EXPECT_EQ(Run("Sandbox.CreateNavigationMesh(sandbox, 'a', {WalkableRadius = -2})"),
            "error: WalkableRadius is -2 (it is a number from 0 to 50)");
  EXPECT_EQ(Run("Sandbox.CreateNavigationMesh(sandbox, 'a', {WalkableHeight = {}})"),
            "error: bad argument #3 to 'Sandbox.CreateNavigationMesh' (WalkableHeight must be a number, not a table)");
  EXPECT_EQ(Run("Sandbox.SetDebugNavigationMesh(sandbox, 'b', true)"),
            "error: there is no navigation mesh \"b\" (make one with Sandbox.CreateNavigationMesh)");
  EXPECT_EQ(Run("Sandbox.CreateInfluenceMap(sandbox, 'default', {CellWidth = 2})"),
            "error: CellWidth and CellHeight must be from 0.01 to 1000 m (give both: {CellWidth = 2, CellHeight = 1})");
  EXPECT_EQ(Run("Sandbox.SetInfluence(sandbox, 10, Vector.new(), 1)"),
            "error: bad argument #2 to 'Sandbox.SetInfluence' (a layer is a number from 0 to 9)");
  EXPECT_TRUE(recorder_.warnings.empty());
  EXPECT_EQ(Run("Sandbox.CreateNavigationMesh(sandbox, 'a', {WalkableRadios = 2})"), "");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_EQ(recorder_.warnings[0].message, "there is no setting \"WalkableRadios\", did you mean \"WalkableRadius\"?");
}

TEST_F(NavigationApiTest, MeshesWithoutEndAreStoppedByTheScriptsBudget) {
  EXPECT_NE(Run("while true do Sandbox.CreateNavigationMesh(sandbox, 'a') end").find("error: "), std::string::npos);
}

TEST_F(NavigationApiTest, AWorldWithoutFloorHasNoMeshAndNoMap) {
  StartWith("function Sandbox_Initialize(s) sandbox = s Sandbox.CreatePlane(s, 100, 100) end");
  EXPECT_EQ(
      Run("Sandbox.CreateNavigationMesh(sandbox, 'default')"),
      "error: there is no fixed object to walk on (make boxes or meshes of mass 0 first (Core.SetMass(object, 0)); "
      "planes are not walked on)");
  EXPECT_EQ(Run("print(Sandbox.GetInfluence(sandbox, 0, Vector.new()))"), "0");
  EXPECT_EQ(Run("Sandbox.SpreadInfluenceMap(sandbox, 0)"),
            "error: there is no influence map yet (make one with Sandbox.CreateInfluenceMap)");
}

TEST_F(NavigationApiTest, InfluencesSpreadFadeAndAreDrawn) {
  EXPECT_EQ(Run("local here, beside = Vector.new(5, 0.05, 5), Vector.new(7, 0.05, 5)\n"
                "Sandbox.SetFalloff(sandbox, 0, 0.2) Sandbox.SetInertia(sandbox, 0, 0)\n"
                "Sandbox.SetInfluence(sandbox, 0, here, 3)\n"
                "Sandbox.SpreadInfluenceMap(sandbox, 0)\n"
                "print(Sandbox.GetInertia(sandbox, 0, here), string.format('%.3f', Sandbox.GetInfluence(sandbox, 0, "
                "beside)), Sandbox.GetInfluence(sandbox, 1, here))\n"
                "Sandbox.DrawInfluenceMap(sandbox, 0, {1, 0, 0, 1}, {0, 0, 0, 0.5}, {0, 0, 1})"),
            "1\t0.800\t0");
  EXPECT_FALSE(world_->Snapshot().triangles.empty());
  Run("Sandbox.SetDrawInfluenceMap(sandbox, false) Sandbox.ClearInfluenceMap(sandbox, 0)");
  EXPECT_TRUE(world_->Snapshot().triangles.empty());
  EXPECT_EQ(Run("print(Sandbox.GetInfluence(sandbox, 0, Vector.new(5, 0.05, 5)))"), "0");
  Run("Sandbox.SetDebugNavigationMesh(sandbox, 'default', true)");
  EXPECT_FALSE(world_->Snapshot().triangles.empty());
}

}  // namespace
}  // namespace soarbox::script
