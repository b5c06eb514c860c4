// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "world/rotation.h"
#include "world/world.h"

namespace soarbox::world {
namespace {

// A crowd that seeks, avoids, separates and wanders on a floor with blocks that are thrown and removed.
class Crowd {
 public:
  Crowd(std::uint64_t seed, int agents) : world_(WorldSettings{.seed = seed}) {
    world_.CreatePlane(200, 200);
    for (int i = 0; i < agents; ++i) {
      Agent& agent = *world_.FindAgent(world_.CreateAgent({}));
      agent.SetPosition(Somewhere(agent.random()));
      agent.SetTarget(Somewhere(agent.random()));
    }
  }

  void Tick() {
    world_.BeginTick();
    for (const EntityId id : world_.AgentIds()) {
      Drive(*world_.FindAgent(id));
      world_.SyncAgent(id);
    }
    world_.Step();
    if (world_.tick() % 10 == 1) Throw();
    if (world_.tick() % 25 == 0) world_.RemoveObject(world_.ObjectIds().back());
  }

  World& world() { return world_; }

 private:
  static Vec3 Somewhere(RandomStream& random) { return {random.Unit() * 100 - 50, 0.8f, random.Unit() * 100 - 50}; }

  void Drive(Agent& agent) {
    if (Distance(agent.Position(), agent.Target()) < 2) agent.SetTarget(Somewhere(agent.random()));
    Vec3 force = Normalized(agent.ForceToPosition(agent.Target())) + agent.ForceToAvoidAgents(1.5f) * 3 +
                 agent.ForceToAvoidObjects(1.5f) * 3 + agent.ForceToSeparate(2, 180, world_.AgentIds()) +
                 agent.ForceToWander(33) * 0.25f;
    force.y = 0;
    agent.ApplyForce(Normalized(force) * agent.MaxForce());
    agent.SetForward({agent.Velocity().x, 0, agent.Velocity().z});
    if (agent.Speed() > agent.MaxSpeed()) {
      const Vec3 v = agent.Velocity() * (agent.MaxSpeed() / agent.Speed());
      agent.SetVelocity({v.x, agent.Velocity().y, v.z});
    }
  }

  void Throw() {
    Object& block = *world_.FindObject(world_.CreateObject("models/nobiax_modular/modular_block.mesh"));
    block.SetMass(15);
    block.SetPosition({-30, 5, 0});
    block.ApplyImpulse({10000, 0, world_.random().Unit() * 5000});
    block.ApplyAngularImpulse({3, 2, 1});
  }

  World world_;
};

std::vector<std::uint64_t> Hashes(std::uint64_t seed, int agents, int ticks) {
  Crowd crowd(seed, agents);
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < ticks; ++i) {
    crowd.Tick();
    hashes.push_back(crowd.world().Hash());
  }
  return hashes;
}

TEST(WorldDeterminism, TheSameSeedGivesTheSameHashesTickByTick) {
  const auto first = Hashes(42, 60, 300);
  // Memory that is laid out otherwise must not matter.
  std::vector<std::unique_ptr<Crowd>> clutter;
  for (int i = 1; i < 4; ++i) clutter.push_back(std::make_unique<Crowd>(static_cast<std::uint64_t>(i), 7 * i));
  EXPECT_EQ(first, Hashes(42, 60, 300));
}

TEST(WorldDeterminism, WorldsOnSeparateThreadsDoNotDisturbEachOther) {
  std::vector<std::uint64_t> first, second;
  std::thread one([&first] { first = Hashes(42, 40, 150); });
  std::thread two([&second] { second = Hashes(42, 40, 150); });
  one.join();
  two.join();
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, Hashes(42, 40, 150));
}

TEST(WorldDeterminism, TwoSeedsDiffer) {
  EXPECT_NE(Hashes(1, 10, 30), Hashes(2, 10, 30));
}

TEST(WorldDeterminism, ASmallDisturbanceShowsInTheHash) {
  Crowd a(5, 10), b(5, 10);
  a.Tick();
  b.Tick();
  ASSERT_EQ(a.world().Hash(), b.world().Hash());
  Agent& agent = *b.world().FindAgent(b.world().AgentIds()[3]);
  agent.SetVelocity(agent.Velocity() + Vec3{1e-4f, 0, 0});
  EXPECT_NE(a.world().Hash(), b.world().Hash());
}

TEST(WorldDeterminism, AThousandAgentsStepAndStayInOnePiece) {
  Crowd crowd(9, 1000);
  for (int i = 0; i < 60; ++i) crowd.Tick();
  for (const EntityId id : crowd.world().AgentIds()) {
    const Agent& agent = *crowd.world().FindAgent(id);
    ASSERT_TRUE(IsFinite(agent.Position()));
    EXPECT_GT(agent.Position().y, 0.7f);
    EXPECT_LT(agent.Speed(), 12.0f);
  }
}

TEST(RandomStream, IsReproducibleAndStreamsDiffer) {
  RandomStream a(3, 1), b(3, 1), c(3, 2);
  bool differs = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint32_t number = a.Next();
    EXPECT_EQ(number, b.Next());
    differs |= number != c.Next();
    EXPECT_LT(a.Below(7), 7u);
    EXPECT_LT(b.Below(7), 7u);
    const float unit = c.Unit();
    EXPECT_TRUE(unit >= 0 && unit < 1);
  }
  EXPECT_TRUE(differs);
  EXPECT_EQ(a.Below(0), 0u);
}

}  // namespace
}  // namespace soarbox::world
