// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "world/team_numbers.h"
#include "world/world.h"

// The steering forces in known situations, for agents without gravity and floor (lua_api.md 7).
namespace soarbox::world {
namespace {

class Steering : public ::testing::Test {
 protected:
  Agent& Add(Vec3 position, Vec3 forward = {0, 0, 1}, Vec3 velocity = {}) {
    Agent& agent = *world_.FindAgent(world_.CreateAgent({}));
    agent.SetPosition(position);
    agent.SetForward(forward);
    agent.SetVelocity(velocity);
    return agent;
  }
  static void ExpectNear(Vec3 actual, Vec3 expected, float tolerance = 1e-4f) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
  }
  World world_;
};

TEST_F(Steering, SeekAndFleeSubtractTheVelocity) {
  const Agent& agent = Add({1, 0, 0}, {0, 0, 1}, {0, 0, 2});
  ExpectNear(agent.ForceToPosition({11, 0, 0}), {10, 0, -2});
  ExpectNear(agent.ForceToFleePosition({11, 0, 0}), {-10, 0, -2});
}

TEST_F(Steering, PursuitAimsWhereTheQuarryWillBe) {
  const Agent& hunter = Add({0, 0, 0}, {0, 0, 1}, {0, 0, 5});
  const Agent& quarry = Add({0, 0, 10}, {1, 0, 0}, {3, 0, 0});
  // 10 m at 5 m/s take 2 s.
  ExpectNear(hunter.ForceToPursue(quarry.id(), 10), {6, 0, 5});
  ExpectNear(hunter.ForceToPursue(quarry.id(), 1), {3, 0, 5});
  ExpectNear(hunter.ForceToEvade(quarry.id(), 1), {-3, 0, -15});
  ExpectNear(hunter.ForceToPursue(EntityId{99}, 1), {0, 0, 0});
}

TEST_F(Steering, TargetSpeedPushesForwardWithinTheMaximumForce) {
  Agent& agent = Add({}, {1, 0, 0}, {2, 5, 0});
  ExpectNear(agent.ForceToTargetSpeed(3), {1, 0, 0});
  agent.SetMaxForce(0.5f);
  ExpectNear(agent.ForceToTargetSpeed(3), {0.5f, 0, 0});
  ExpectNear(agent.ForceToTargetSpeed(0), {-0.5f, 0, 0});
}

TEST_F(Steering, WanderStaysWithinASquareAndSaturatesOnMilliseconds) {
  Agent& agent = Add({});
  for (int i = 0; i < 100; ++i) {
    const Vec3 small = agent.ForceToWander(0.033f);
    EXPECT_LE(std::abs(small.x), 1);
    EXPECT_LE(std::abs(small.y), 1);
    EXPECT_EQ(small.z, 0);
  }
  int saturated = 0;
  for (int i = 0; i < 100; ++i) saturated += std::abs(agent.ForceToWander(33).x) == 1 ? 1 : 0;
  EXPECT_GT(saturated, 95);
}

TEST_F(Steering, StayOnPathPullsBackIntoTheTubeOnly) {
  Agent& agent = Add({0.1f, 0, 5}, {0, 0, 1}, {0, 0, 1});
  const std::vector<Vec3> points{{0, 0, 0}, {0, 0, 100}};
  ExpectNear(agent.ForceToStayOnPath(1), {0, 0, 0});
  agent.SetPath(points, false);
  ExpectNear(agent.ForceToStayOnPath(1), {0, 0, 0});
  agent.SetPosition({2, 0, 5});
  ExpectNear(agent.ForceToStayOnPath(1), {-2, 0, 0});
}

TEST_F(Steering, FollowPathSeeksAheadOnceItIsOffOrGoingBack) {
  Agent& agent = Add({0.1f, 0, 5}, {0, 0, 1}, {0, 0, 2});
  const std::vector<Vec3> points{{0, 0, 0}, {0, 0, 100}};
  agent.SetPath(points, false);
  ExpectNear(agent.ForceToFollowPath(1), {0, 0, 0});
  agent.SetVelocity({0, 0, -2});
  ExpectNear(agent.ForceToFollowPath(1), {-0.1f, 0, 4});
  agent.RemovePath();
  EXPECT_FALSE(agent.HasPath());
  ExpectNear(agent.ForceToFollowPath(1), {-0.1f, 0, 4});
}

TEST_F(Steering, AvoidAgentsPushesSidewaysFromTheFirstThatTouches) {
  const Agent& self = Add({0, 0, 0});
  Add({0.3f, 0, 0.2f});
  ExpectNear(self.ForceToAvoidAgents(1), {-0.3f, 0, 0});
}

TEST_F(Steering, AvoidAgentsDodgesAnOncomingAgentAndIgnoresTheDead) {
  const Agent& self = Add({0, 0, 0}, {0, 0, 1}, {0, 0, 2});
  Agent& other = Add({0.1f, 0, 4}, {0, 0, -1}, {0, 0, -2});
  ExpectNear(self.ForceToAvoidAgents(1.5f), {-1, 0, 0});
  ExpectNear(self.ForceToAvoidAgents(0.5f), {0, 0, 0});
  other.SetPosition({-0.1f, 0, 4});
  ExpectNear(self.ForceToAvoidAgents(1.5f), {1, 0, 0});
  other.SetHealth(0);
  ExpectNear(self.ForceToAvoidAgents(1.5f), {0, 0, 0});
}

TEST_F(Steering, AvoidAgentsLetsTheSlowerOfTwoCrossingAgentsPass) {
  const Agent& fast = Add({0, 0, -3}, {0, 0, 1}, {0, 0, 3});
  const Agent& slow = Add({-2, 0, 0}, {1, 0, 0}, {2, 0, 0});
  ExpectNear(fast.ForceToAvoidAgents(1.5f), {-1, 0, 0});
  ExpectNear(slow.ForceToAvoidAgents(1.5f), {0, 0, 0});
}

TEST_F(Steering, AvoidObjectsSidestepsWhatCanMoveAndLiesAhead) {
  const Agent& self = Add({0, 0, 0}, {0, 0, 1}, {0, 0, 2});
  Object& ball = *world_.FindObject(world_.CreatePhysicsSphere(0.5f));
  ball.SetPosition({0.4f, 0, 3});
  ExpectNear(self.ForceToAvoidObjects(1.5f), {-0.4f, 0, 0});
  ExpectNear(self.ForceToAvoidObjects(0.1f), {0, 0, 0});
  ball.SetPosition({0.4f, 0, -3});
  ExpectNear(self.ForceToAvoidObjects(1.5f), {0, 0, 0});
  ball.SetPosition({0.4f, 0, 3});
  ball.SetMass(0);
  ExpectNear(self.ForceToAvoidObjects(1.5f), {0, 0, 0});
}

TEST_F(Steering, GroupForcesSeeNeighboursInTheConeOrVeryNear) {
  const Agent& self = Add({0, 0, 0});
  const Agent& ahead = Add({1, 0, 3}, {1, 0, 0});
  const Agent& behind = Add({0, 0, -5}, {-1, 0, 0});
  const std::vector<EntityId> one{ahead.id(), self.id(), EntityId{77}};
  const float n = std::sqrt(10.0f);
  ExpectNear(self.ForceToCombine(10, 90, one), {1 / n, 0, 3 / n});
  ExpectNear(self.ForceToSeparate(10, 90, one), {-1 / n, 0, -3 / n});
  const float d = std::sqrt(2.0f);
  ExpectNear(self.ForceToAlign(10, 90, one), {1 / d, 0, -1 / d});
  const std::vector<EntityId> other{behind.id()};
  ExpectNear(self.ForceToCombine(10, 90, other), {0, 0, 0});
  ExpectNear(self.ForceToCombine(2, 180, one), {0, 0, 0});
  const Agent& near = Add({0, 0, -0.8f});
  const std::vector<EntityId> close{near.id()};
  ExpectNear(self.ForceToCombine(0, 0, close), {0, 0, -1});
}

TEST_F(Steering, TheSpatialIndexAnswersAsALinearSearchWould) {
  RandomStream random(7);
  const auto somewhere = [&random] { return Vec3{random.Unit() * 60 - 30, 0.8f, random.Unit() * 60 - 30}; };
  for (int i = 0; i < 400; ++i) {
    const float angle = random.Unit() * 6.28f;
    Add(somewhere(), {std::cos(angle), 0, std::sin(angle)}, Vec3{std::cos(angle), 0, std::sin(angle)} * 5);
  }
  const std::vector<EntityId> copy(world_.AgentIds().begin(), world_.AgentIds().end());
  for (const EntityId id : copy) {
    Agent& agent = *world_.FindAgent(id);
    EXPECT_EQ(agent.ForceToSeparate(3, 120, world_.AgentIds()), agent.ForceToSeparate(3, 120, copy));
    EXPECT_EQ(agent.ForceToCombine(3, 120, world_.AgentIds()), agent.ForceToCombine(3, 120, copy));
    EXPECT_EQ(agent.ForceToAlign(3, 120, world_.AgentIds()), agent.ForceToAlign(3, 120, copy));
    // Agents that move between queries must not cause errors in the index.
    agent.SetPosition(somewhere());
  }
}

TEST_F(Steering, ANeighbourAtExactlyTheDistanceIsFoundWhateverItsCell) {
  // Borders of cells are multiples of 4 m. -0.0000002 is in another cell than 0, but 8 m from 8 when rounded.
  for (int i = 0; i < 400; ++i)
    Add({static_cast<float>(i % 20) * 2 + static_cast<float>(i % 3 - 1) * 2e-7f, 0.8f,
         static_cast<float>(i / 20) * 2 + static_cast<float>(i % 5 - 2) * 1e-7f});
  const auto expect_same = [&] {
    const std::vector<EntityId> copy(world_.AgentIds().begin(), world_.AgentIds().end());
    for (const EntityId id : copy) {
      const Agent& agent = *world_.FindAgent(id);
      ASSERT_EQ(agent.ForceToCombine(8, 180, world_.AgentIds()), agent.ForceToCombine(8, 180, copy)) << Number(id);
    }
  };
  expect_same();
  // So far apart that the grid hashes its cells.
  Add({9e5f, 0.8f, 9e5f});
  expect_same();
}

TEST_F(Steering, ARepeatedQueryNoticesWhoComesMovesAndGoes) {
  const Agent& self = Add({0, 0, 0});
  const auto combine = [&] { return self.ForceToCombine(5, 180, world_.AgentIds()); };
  ExpectNear(combine(), {0, 0, 0});
  Agent& other = Add({1, 0, 0});
  ExpectNear(combine(), {1, 0, 0});
  other.SetPosition({-1, 0, 0});
  ExpectNear(combine(), {-1, 0, 0});
  // Another agent in between has another place, and perhaps the same range.
  ExpectNear(other.ForceToCombine(5, 180, world_.AgentIds()), {1, 0, 0});
  ExpectNear(combine(), {-1, 0, 0});
  world_.RemoveAgent(other.id());
  world_.BeginTick();
  ExpectNear(combine(), {0, 0, 0});
}

TEST(TeamNumbers, ANameHasANumberAsLongAsItHasMembers) {
  TeamNumbers teams;
  EXPECT_EQ(teams.Find("red"), TeamNumbers::kNone);
  const std::uint32_t red = teams.Join("red"), blue = teams.Join("blue");
  EXPECT_NE(red, TeamNumbers::kNone);
  EXPECT_NE(red, blue);
  EXPECT_EQ(teams.Join("red"), red);
  teams.Leave("red");
  EXPECT_EQ(teams.Find("red"), red);
  teams.Leave("red");
  EXPECT_EQ(teams.Find("red"), TeamNumbers::kNone);
  // A script that invents names again and again needs no further numbers.
  EXPECT_EQ(teams.Join("green"), red);
  EXPECT_EQ(teams.Find("blue"), blue);
  EXPECT_EQ(teams.Find("green"), red);
}

TEST_F(Steering, AgentsAtTheSamePlaceGiveNoNonsense) {
  const Agent& a = Add({0, 0, 0});
  Add({0, 0, 0});
  ExpectNear(a.ForceToSeparate(5, 180, world_.AgentIds()), {0, 0, 0});
  ExpectNear(a.ForceToCombine(5, 180, world_.AgentIds()), {0, 0, 0});
  const Vec3 avoid = a.ForceToAvoidAgents(1);
  EXPECT_TRUE(std::isfinite(avoid.x) && std::isfinite(avoid.y) && std::isfinite(avoid.z));
}

}  // namespace
}  // namespace soarbox::world
