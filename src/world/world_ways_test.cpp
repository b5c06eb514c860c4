// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "world/limits.h"
#include "world/rotation.h"
#include "world/sight.h"
#include "world/weapon.h"
#include "world/world.h"
#include "world/world_random.h"

// The fast queries for crowds must give exactly the same results as rays through the trees of the broadphase.
namespace soarbox::world {
namespace {

/// Agents, boxes, spheres and inclined capsules on a plane, some on top of each other.
class Crowd {
 public:
  /// Around `middle`, up to `reach_m` in each direction.
  Crowd(std::uint64_t seed, Vec3 middle, float reach_m) : random_(seed, 1), middle_(middle), reach_m_(reach_m) {
    world_.CreatePlane(40, 40);
    for (int i = 0; i < 90; ++i) ids_.push_back(Make(i % 6));
    // Includes boxes that are not up to date and bodies that have moved since, as after any step.
    for (int tick = 0; tick < 3; ++tick) {
      world_.BeginTick();
      for (const EntityId id : ids_)
        if (Agent* agent = world_.FindAgent(id)) agent->SetVelocity({About(6), 0, About(6)});
      world_.Step();
    }
  }

  float About(float reach) { return (random_.Unit() * 2 - 1) * reach; }
  Vec3 Somewhere() { return middle_ + Vec3{About(reach_m_), 0.3f + random_.Unit(), About(reach_m_)}; }
  EntityId Anybody() { return ids_[random_.Below(static_cast<std::uint32_t>(ids_.size()))]; }
  World& world() { return world_; }
  RandomStream& random() { return random_; }

 private:
  EntityId Make(int kind) {
    if (kind < 3) {
      AgentDef def;
      const EntityId id = world_.CreateAgent(def);
      Agent& agent = *world_.FindAgent(id);
      agent.SetRadius(0.2f + 0.2f * random_.Unit());
      agent.SetPosition(Somewhere());
      agent.SetForward({About(1), 0, 1});
      return id;
    }
    const EntityId id = kind == 3   ? world_.CreateBox(0.2f + random_.Unit(), 1.5f, 0.2f + 4 * random_.Unit())
                        : kind == 4 ? world_.CreatePhysicsSphere(0.2f + 0.5f * random_.Unit())
                                    : world_.CreatePhysicsCapsule(1.5f, 0.3f);
    Object& object = *world_.FindObject(id);
    object.SetPosition(Somewhere());
    if (random_.Unit() < 0.5f) object.SetOrientation(Normalized(Quat{1, About(0.5f), About(1), About(0.5f)}));
    if (random_.Unit() < 0.5f) object.SetMass(0);
    return id;
  }

  World world_;
  RandomStream random_;
  Vec3 middle_;
  float reach_m_;
  std::vector<EntityId> ids_;
};

constexpr Vec3 kMiddles[] = {{0, 0, 0}, {30, 0, -70}, {-4000, 0, 90'000}};

TEST(WorldWays, RaysHitTheSameOncePrepared) {
  int hits = 0;
  for (const Vec3 middle : kMiddles) {
    Crowd crowd(3, middle, 7);
    struct Ray {
      Vec3 from, to;
      std::optional<RayHit> hit;
    };
    std::vector<Ray> rays;
    for (int i = 0; i < 1500; ++i) {
      Ray ray{crowd.Somewhere(), crowd.Somewhere(), {}};
      if (i % 5 == 0) ray.to = ray.from + Vec3{crowd.About(80), crowd.About(3), crowd.About(80)};
      if (i % 7 == 0) ray.to.x = ray.from.x;
      if (i % 11 == 0) ray.to.z = ray.from.z;
      if (i % 13 == 0) ray.from = ray.to + Vec3{0, 9, 0};
      ray.hit = crowd.world().RayCast(ray.from, ray.to);
      rays.push_back(ray);
    }
    crowd.world().PrepareForReaders(true);
    for (const Ray& ray : rays) {
      const auto hit = crowd.world().RayCast(ray.from, ray.to);
      ASSERT_EQ(hit.has_value(), ray.hit.has_value());
      if (!hit) continue;
      ++hits;
      EXPECT_EQ(hit->entity, ray.hit->entity);
      EXPECT_EQ(hit->point, ray.hit->point);
      EXPECT_EQ(hit->normal, ray.hit->normal);
    }
  }
  EXPECT_GT(hits, 1500);
}

TEST(WorldWays, AWayIsOpenIfItsThreeRaysHitNothingOrTheWalkersOwnFirst) {
  int open = 0, closed = 0;
  for (const bool is_prepared : {false, true}) {
    for (const Vec3 middle : kMiddles) {
      Crowd crowd(5, middle, 7);
      World& world = crowd.world();
      if (is_prepared) world.PrepareForReaders(true);
      for (int i = 0; i < 300; ++i) {
        Walker walker;
        walker.self = crowd.Anybody();
        walker.through = i % 3 == 0 ? crowd.Anybody() : kNoEntity;
        const Agent* self = world.FindAgent(walker.self);
        walker.place = self != nullptr && i % 4 != 0 ? self->Position() - Vec3{0, 0.3f, 0} : crowd.Somewhere();
        walker.half_width_m = self != nullptr && i % 5 != 0 ? self->Radius() * 1.1f : crowd.random().Unit() * 0.4f;
        const float reach_m = i % 2 == 0 ? 1.2f : 3.5f;
        const WaysAround ways = world.Ways(walker, reach_m + walker.half_width_m);
        for (int n = 0; n < 24; ++n) {
          const float angle = static_cast<float>(n) / 12 * std::numbers::pi_v<float>;
          Vec3 direction{std::sin(angle), 0, std::cos(angle)};
          if (n == 20) direction = {};
          if (n == 21) direction = direction * 0.7f;
          const float length_m = n % 3 == 0 ? reach_m / 2 : reach_m;
          bool wanted = true;
          for (const float offset : {0.0f, 1.0f, -1.0f}) {
            const Vec3 from = walker.place + Vec3{direction.z, 0, -direction.x} * (offset * walker.half_width_m);
            const auto hit = world.RayCast(from, from + direction * length_m);
            wanted &= !hit || hit->entity == walker.self || hit->entity == walker.through;
          }
          ASSERT_EQ(ways.IsOpen(direction, length_m), wanted) << is_prepared << " " << i << " " << n;
          ++(wanted ? open : closed);
        }
      }
    }
  }
  EXPECT_GT(open, 8000);
  EXPECT_GT(closed, 8000);
  World world;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(world.Ways({{nan, 0, 0}, 1, kNoEntity, kNoEntity}, 3).IsOpen({1, 0, 0}, 2));
  EXPECT_TRUE(world.Ways({{0, 0, 0}, 1, kNoEntity, kNoEntity}, 3).IsOpen({nan, 0, 0}, 2));
}

TEST(WorldWays, AgentsSeeTheSameAmongTheBodiesAroundThem) {
  int seen = 0, hidden = 0, hits = 0;
  for (const bool is_prepared : {false, true}) {
    for (const Vec3 middle : kMiddles) {
      for (const float angle_deg : {60.0f, 200.0f, 360.0f}) {
        Crowd crowd(7, middle, 7);
        World& world = crowd.world();
        std::vector<bool> wanted;
        const auto for_all = [&](const auto& visit) {
          for (const EntityId one : world.AgentIds()) {
            const Agent& viewer = *world.FindAgent(one);
            const BodiesAround around = AroundEyes(viewer, 8, angle_deg);
            for (const EntityId other : world.AgentIds()) {
              const Agent& target = *world.FindAgent(other);
              Vec3 to = target.Position() - viewer.Position();
              to.y = 0;
              const float cosine = std::cos(angle_deg / 2 * std::numbers::pi_v<float> / 180);
              if (one == other || Length(to) > 8 || Dot(viewer.Forward(), to) < cosine * Length(to)) continue;
              visit(viewer, target, around);
            }
          }
        };
        for_all([&](const Agent& viewer, const Agent& target, const BodiesAround&) {
          wanted.push_back(SeesAgent(viewer, target));
          ++(wanted.back() ? seen : hidden);
        });
        if (is_prepared) world.PrepareForReaders(true);
        std::size_t at = 0;
        for_all([&](const Agent& viewer, const Agent& target, const BodiesAround& around) {
          EXPECT_EQ(SeesAgent(viewer, target, &around), wanted[at]) << at;
          EXPECT_EQ(SeesAgent(viewer, target), wanted[at]) << at;
          EXPECT_EQ(HasLineOfSight(world, viewer, target.Position(), target.id(), &around),
                    HasLineOfSight(world, viewer, target.Position(), target.id()));
          const auto hit = world.RayCast(EyesOf(viewer), target.Position());
          const auto same = around.RayCast(EyesOf(viewer), target.Position());
          ASSERT_EQ(same.has_value(), hit.has_value()) << at;
          ++at;
          if (!hit) return;
          ++hits;
          EXPECT_EQ(same->entity, hit->entity);
          EXPECT_EQ(same->point, hit->point);
          EXPECT_EQ(same->normal, hit->normal);
        });
      }
    }
  }
  EXPECT_GT(seen, 2000);
  EXPECT_GT(hidden, 2000);
  EXPECT_GT(hits, 4000);
}

TEST(WorldWays, ItIsFreeAheadWhereARayHitsNothing) {
  int free = 0, closed = 0;
  for (const bool is_prepared : {false, true}) {
    for (const Vec3 middle : kMiddles) {
      Crowd crowd(11, middle, 7);
      World& world = crowd.world();
      if (is_prepared) world.PrepareForReaders(true);
      for (const EntityId id : world.AgentIds()) {
        Agent& agent = *world.FindAgent(id);
        for (int i = 0; i < 40; ++i) {
          agent.SetForward({crowd.About(1), i % 4 == 0 ? crowd.About(1) : 0, i % 5 == 0 ? 0 : crowd.About(1)});
          const float ahead_m = crowd.random().Unit() * 4, height_m = crowd.random().Unit() * 2;
          Vec3 from = agent.Position();
          from.y += height_m - agent.Height() / 2;
          const bool wanted = !world.RayCast(from, from + agent.Forward() * ahead_m);
          ASSERT_EQ(IsFreeAhead(agent, ahead_m, height_m), wanted) << is_prepared << " " << i;
          ++(wanted ? free : closed);
        }
      }
    }
  }
  EXPECT_GT(free, 2000);
  EXPECT_GT(closed, 2000);
}

TEST(WorldWays, WhatMovesAfterRaysWerePreparedIsFoundWhereItIs) {
  Crowd crowd(9, {}, 7);
  World& world = crowd.world();
  world.PrepareForReaders(true);
  const EntityId box = world.CreateBox(1, 1, 1);
  Object& object = *world.FindObject(box);
  object.SetPosition({20, 0.5f, 0});
  EXPECT_TRUE(world.RayCast({20, 9, 0}, {20, 0, 0}));
  EXPECT_FALSE(world.Ways({{20, 0.5f, -2}, 0.3f, kNoEntity, kNoEntity}, 4).IsOpen({0, 0, 1}, 3));
  world.PrepareForReaders(true);
  object.SetPosition({20, 0.5f, 9});
  EXPECT_FALSE(world.RayCast({20, 9, 0}, {20, 0.1f, 0}));
  EXPECT_TRUE(world.Ways({{20, 0.5f, -2}, 0.3f, kNoEntity, kNoEntity}, 4).IsOpen({0, 0, 1}, 3));
  world.PrepareForReaders(true);
  world.RemoveObject(box);
  world.BeginTick();
  EXPECT_FALSE(world.RayCast({20, 9, 9}, {20, 0.1f, 9}));
}

}  // namespace
}  // namespace soarbox::world
