// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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
  Crowd(std::uint64_t seed, int agents, float reach_m = 50) : world_(WorldSettings{.seed = seed}), reach_m_(reach_m) {
    world_.CreatePlane(200, 200);
    for (int i = 0; i < agents; ++i) {
      Agent& agent = *world_.FindAgent(world_.CreateAgent({}));
      agent.SetPosition(Somewhere(agent.random()));
      agent.SetTarget(Somewhere(agent.random()));
    }
  }

  void Tick(const Workers& workers = {}) {
    world_.BeginTick();
    for (const EntityId id : world_.AgentIds()) {
      Drive(*world_.FindAgent(id));
      world_.SyncAgent(id);
    }
    world_.Step(workers);
    if (world_.tick() % 10 == 1) Throw();
    if (world_.tick() % 25 == 0) world_.RemoveObject(world_.ObjectIds().back());
  }

  World& world() { return world_; }

 private:
  Vec3 Somewhere(RandomStream& random) const {
    const auto about = [&] { return (random.Unit() * 2 - 1) * reach_m_; };
    const float x = about();
    return {x, 0.8f, about()};
  }

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
  float reach_m_;
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
  // A different layout of memory must not change the result.
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

TEST(WorldDeterminism, AStepIsTheSameOnAnyNumberOfThreadsInAnyOrder) {
  const auto backwards = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    while (count > 0) job(--count);
  };
  const auto threads = [](std::size_t count, const std::function<void(std::size_t)>& job) {
    std::vector<std::thread> three;
    for (std::size_t thread = 0; thread < 3; ++thread)
      three.emplace_back([&, thread] {
        for (std::size_t i = thread; i < count; i += 3) job(i);
      });
    for (std::thread& each : three) each.join();
  };
  // The agents are so close that they collide all the time.
  Crowd alone(6, 500, 12), other(6, 500, 12), third(6, 500, 12);
  std::size_t collisions = 0;
  for (int i = 0; i < 40; ++i) {
    alone.Tick();
    other.Tick(threads);
    third.Tick(backwards);
    ASSERT_EQ(other.world().Hash(), alone.world().Hash()) << i;
    ASSERT_EQ(third.world().Hash(), alone.world().Hash()) << i;
    collisions += alone.world().Collisions().size();
  }
  EXPECT_GT(collisions, 500u);
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
