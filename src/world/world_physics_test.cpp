// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "world/modular_meshes.h"
#include "world/overlay_snapshot.h"
#include "world/rotation.h"
#include "world/world.h"
#include "world/world_random.h"

// The numbers were measured in the sandbox (lua_api.md 6 and 18).
namespace soarbox::world {
namespace {

void Tick(World& world, int times = 1) {
  for (int i = 0; i < times; ++i) {
    world.BeginTick();
    for (const EntityId id : world.AgentIds()) world.SyncAgent(id);
    world.Step();
  }
}

TEST(WorldPhysics, ABoxFallsAsSemiImplicitEulerSays) {
  World world;
  Object& box = *world.FindObject(world.CreateBox(1, 1, 1));
  box.SetPosition({0, 10, 0});
  const float expected[] = {9.98911f, 9.96733f, 9.93467f, 9.89111f};
  for (const float y : expected) {
    Tick(world);
    EXPECT_NEAR(box.Position().y, y, 2e-5f);
  }
  Tick(world, 26);
  EXPECT_NEAR(box.Position().y, 4.93667f, 1e-4f);
}

TEST(WorldPhysics, AnAgentMadeInsideTheFloorIsLiftedOntoIt) {
  World world;
  world.CreatePlane(200, 200);
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  EXPECT_EQ(agent.Position(), (Vec3{0, 0, 0}));
  Tick(world);
  EXPECT_NEAR(agent.Position().y, 0.640f, 0.002f);
  Tick(world);
  EXPECT_NEAR(agent.Position().y, 0.768f, 0.002f);
  Tick(world, 28);
  EXPECT_NEAR(agent.Position().y, 0.800f, 0.001f);
}

TEST(WorldPhysics, AnAgentPutIntoAFloorBetweenTwoBlocksIsLiftedOntoThem) {
  World world;
  world.CreatePlane(200, 200);
  for (const float x : {-1.5f, 1.5f}) {
    Object& block = *world.FindObject(world.CreateBox(3, 4, 3));
    block.SetMass(0);
    block.SetPosition({x, 2, 0});
  }
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetPosition({0.2f, 4, 0});
  Tick(world, 60);
  EXPECT_NEAR(agent.Position().y, 4.8f, 0.1f);
  const Vec3 stands = agent.Position();
  Tick(world, 30);
  EXPECT_NEAR(Length(agent.Position() - stands), 0, 0.01f);
}

TEST(WorldPhysics, AnAgentWithoutRoomAboveItStaysWhereItIs) {
  World world;
  Object& block = *world.FindObject(world.CreateBox(8, 20, 8));
  block.SetMass(0);
  block.SetPosition({0, 10, 0});
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetPosition({0, 10, 0});
  Tick(world, 60);
  EXPECT_TRUE(IsFinite(agent.Position().y));
}

TEST(WorldPhysics, AConstantForceOvercomesFrictionAsMeasured) {
  World world;
  world.CreatePlane(200, 200);
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  const auto push = [&](int times) {
    for (int i = 0; i < times; ++i) {
      agent.ApplyForce({1000, 0, 0});
      Tick(world);
    }
  };
  push(1);
  EXPECT_NEAR(agent.Velocity().x, 0.286f, 0.002f);
  push(1);
  EXPECT_NEAR(agent.Velocity().x, 0.572f, 0.004f);
  push(28);
  EXPECT_NEAR(agent.Velocity().x, 8.575f, 0.02f);
  EXPECT_NEAR(agent.Speed(), 8.575f, 0.02f);
}

TEST(WorldPhysics, AnImpulseIsAForceForOneStep) {
  World world;
  Object& block = *world.FindObject(world.CreateObject("models/nobiax_modular/modular_block.mesh"));
  block.SetMass(15);
  block.SetPosition({0, 100, 0});
  block.ApplyImpulse({15000, 0, 0});
  Tick(world);
  EXPECT_NEAR(block.Velocity().x, 33.33f, 0.01f);
  Tick(world);
  EXPECT_NEAR(block.Velocity().x, 33.33f, 0.01f);
  EXPECT_TRUE(world.TakeWarnings().empty());
}

TEST(WorldPhysics, OverlaysTellWhatPushedBodiesInTheLastStep) {
  World world;
  const EntityId block_id = world.CreateObject("models/nobiax_modular/modular_block.mesh");
  Object& block = *world.FindObject(block_id);
  block.SetMass(15);
  block.SetPosition({0, 100, 0});
  block.ApplyImpulse({15000, 0, 0});
  block.ApplyForce({0, 0, 30});
  block.SetVelocity({0, 2, 0});
  block.ApplyAngularImpulse({0, 3, 0});
  const float spin_rad_s = block.AngularVelocity().y;
  Tick(world);
  OverlaySnapshot told;
  world.AddOverlays({}, told);
  EXPECT_FALSE(told.has_pushes);
  world.AddOverlays({.forces = true}, told);
  EXPECT_TRUE(told.has_pushes);
  ASSERT_EQ(told.pushes.size(), 4u);
  EXPECT_EQ(told.pushes[0].owner_id, Number(block_id));
  EXPECT_EQ(told.pushes[0].force_n, (Vec3{15000, 0, 0}));
  EXPECT_EQ(told.pushes[1].force_n, (Vec3{0, 0, 30}));
  EXPECT_NEAR(told.pushes[2].force_n.y, 2 * 15 * 30, 0.1f) << "a change of velocity by a force for one step";
  EXPECT_FLOAT_EQ(told.pushes[2].mass_kg, 15);
  EXPECT_EQ(told.pushes[3].force_n, Vec3{});
  EXPECT_GT(spin_rad_s, 0.1f);
  EXPECT_NEAR(told.pushes[3].spin_rad_s.y, spin_rad_s, 1e-4f);
  Tick(world);
  OverlaySnapshot later;
  world.AddOverlays({.forces = true}, later);
  EXPECT_TRUE(later.pushes.empty()) << "they were for one step";
}

TEST(WorldPhysics, AnAngularImpulseSpinsAtOnce) {
  World world;
  Object& box = *world.FindObject(world.CreateBox(1, 1, 1));
  box.ApplyAngularImpulse({0, 1, 0});
  // A cube of 1 kg and 1 m has a moment of inertia of 1/6.
  EXPECT_NEAR(box.AngularVelocity().y, 6.0f, 0.01f);
}

TEST(WorldPhysics, MassZeroFixesABodyAndAPositiveMassFreesItAgain) {
  World world;
  Object& box = *world.FindObject(world.CreateBox(1, 1, 1));
  box.SetPosition({0, 5, 0});
  box.SetMass(0);
  Tick(world, 10);
  EXPECT_FLOAT_EQ(box.Position().y, 5);
  EXPECT_EQ(box.Mass(), 0);
  box.SetPosition({3, 6, 0});
  EXPECT_EQ(world.RayCast({3, 10, 0}, {3, 0, 0})->entity, box.id());
  box.SetMass(2);
  EXPECT_FLOAT_EQ(box.Mass(), 2);
  Tick(world, 10);
  EXPECT_LT(box.Position().y, 5.9f);
}

TEST(WorldPhysics, AnObjectMayHaveItsOwnGravity) {
  World world;
  Object& ball = *world.FindObject(world.CreatePhysicsSphere(0.5f));
  ball.SetGravity({0, 0, 3});
  Tick(world, 30);
  EXPECT_NEAR(ball.Velocity().z, 3, 0.001f);
  EXPECT_NEAR(ball.Velocity().y, 0, 0.001f);
}

TEST(WorldPhysics, AllPiecesButTheHangarDoorRiseOutOfTheFloorAndStand) {
  World world;
  world.CreatePlane(200, 200);
  std::vector<Object*> pieces;
  for (const ModularMesh& mesh : kModularMeshes) {
    const std::string name = "models/nobiax_modular/" + std::string(mesh.name) + ".mesh";
    pieces.push_back(world.FindObject(world.CreateObject(name)));
    pieces.back()->SetPosition({4.0f * static_cast<float>(pieces.size()), 0, 0});
  }
  Tick(world, 600);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ModularMesh& mesh = kModularMeshes[i];
    const Object& piece = *pieces[i];
    SCOPED_TRACE(mesh.name);
    EXPECT_NEAR(Length(piece.Velocity()), 0, 1e-3f);
    if (mesh.name == "modular_hangar_door") {
      EXPECT_LT(piece.Position().y, 0.1f) << "its origin lies outside its edge, so it topples";
      continue;
    }
    EXPECT_NEAR(piece.Position().y, -mesh.min.y, 0.01f);
    EXPECT_NEAR(piece.Position().x, 4.0f * static_cast<float>(i + 1), 0.05f);
    EXPECT_NEAR(piece.Position().z, 0, 0.05f);
    EXPECT_NEAR(Rotate(piece.Orientation(), {0, 1, 0}).y, 1, 0.001f);
  }
}

TEST(WorldPhysics, AThrownBlockComesToRest) {
  World world;
  world.CreatePlane(200, 200);
  Object& block = *world.FindObject(world.CreateObject("models/nobiax_modular/modular_block.mesh"));
  block.SetMass(15);
  block.SetPosition({0, 4, 0});
  block.SetOrientation(FromRotationVector({-131, -68, -133}));
  block.ApplyImpulse({14000, -3000, 2000});
  block.ApplyAngularImpulse({10, 0, 3});
  Tick(world, 900);
  EXPECT_TRUE(block.IsSleeping());
  EXPECT_GT(block.Position().x, 5);
  EXPECT_GT(block.Position().y, 0.3f);
  EXPECT_LT(block.Position().y, 0.42f);
}

// A walker that seeks five points in turn, steered like the sandbox's steering helper (lua_api.md 16.5).
TEST(WorldPhysics, AWaypointWalkerNeedsTwentyThreeSecondsPerRound) {
  World world;
  world.CreatePlane(200, 200);
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  const std::vector<Vec3> waypoints{{0, 0, 0}, {20, 0, 0}, {20, 0, 30}, {-20, 0, 0}, {-20, 0, 10}};
  agent.SetTarget({0, 0, 10});
  std::vector<float> first_point_times;
  std::size_t next = 0;
  for (int tick = 0; tick < 1800; ++tick) {
    if (LengthSquared(agent.Position() - agent.Target()) < 3) {
      if (next % 5 == 1) first_point_times.push_back(static_cast<float>(tick) * 0.033f);
      agent.SetTarget(waypoints[next++ % 5]);
    }
    Vec3 force = agent.ForceToPosition(agent.Target());
    force.y = 0;
    agent.ApplyForce(Normalized(force) * agent.MaxForce());
    agent.SetForward({agent.Velocity().x, 0, agent.Velocity().z});
    if (agent.Speed() > agent.MaxSpeed()) {
      const Vec3 v = agent.Velocity() * (agent.MaxSpeed() / agent.Speed());
      agent.SetVelocity({v.x, agent.Velocity().y, v.z});
    }
    Tick(world);
  }
  ASSERT_GE(first_point_times.size(), 3u);
  EXPECT_NEAR(first_point_times[2] - first_point_times[1], 23.0f, 0.6f);
}

TEST(WorldPhysics, RaysHitTheNearestBodyFromOutsideOnly) {
  World world;
  const EntityId plane = world.CreatePlane(200, 200);
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetPosition({10, 0.8f, 0});

  const auto hit = world.RayCast({10, 5, 0}, {10, -5, 0});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->entity, agent.id());
  EXPECT_NEAR(hit->point.y, 1.6f, 0.01f);

  EXPECT_EQ(world.RayCast({0, 5, 0}, {0, -5, 0})->entity, plane);
  EXPECT_EQ(world.RayCast({0, -5, 0}, {0, 5, 0})->entity, plane);
  EXPECT_FALSE(world.RayCast({10, 0.8f, 0}, {20, 0.8f, 0}).has_value()) << "starts inside the agent";
  EXPECT_FALSE(world.RayCast({0, 1, 0}, {0, 1, 0}).has_value()) << "no length";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(world.RayCast({nan, 1, 0}, {0, 1, 0}).has_value());
}

/// The first point of the segment inside a shape, searched in small steps; 2 if there is none.
float FirstInside(Vec3 from, Vec3 to, const std::function<bool(Vec3)>& is_inside) {
  constexpr int kSteps = 4000;
  for (int i = 0; i <= kSteps; ++i) {
    const float share = static_cast<float>(i) / kSteps;
    if (is_inside(from + (to - from) * share)) return share;
  }
  return 2;
}

TEST(WorldPhysics, RaysEnterShapesWhereTheirSurfacesAre) {
  const Quat turn = FromRotationVector({30, 50, -20});
  const Quat back = FromRotationVector({0, 0, 0});
  const auto into = [&](Vec3 point) { return Rotate(Quat{turn.w, -turn.x, -turn.y, -turn.z}, point); };
  const auto from_axis = [](Vec3 p) { return Length(p - Vec3{0, std::clamp(p.y, -0.5f, 0.5f), 0}); };
  struct Case {
    const char* name;
    std::function<EntityId(World&)> make;
    std::function<bool(Vec3)> is_inside;
    Quat turned;
  };
  const Case cases[] = {
      {"sphere", [](World& world) { return world.CreatePhysicsSphere(0.7f); }, [](Vec3 p) { return Length(p) < 0.7f; },
       back},
      {"capsule", [](World& world) { return world.CreatePhysicsCapsule(1.6f, 0.3f); },
       [&](Vec3 p) { return from_axis(p) < 0.3f; }, back},
      {"turned capsule", [](World& world) { return world.CreatePhysicsCapsule(1.6f, 0.3f); },
       [&](Vec3 p) { return from_axis(into(p)) < 0.3f; }, turn},
      {"turned box", [](World& world) { return world.CreateBox(1, 2, 0.5f); },
       [&](Vec3 p) {
         const Vec3 q = into(p);
         return std::abs(q.x) < 0.5f && std::abs(q.y) < 1 && std::abs(q.z) < 0.25f;
       },
       turn},
  };
  RandomStream random(5, 1);
  const auto about = [&](float reach) { return (random.Unit() * 2 - 1) * reach; };
  for (const Case& tried : cases) {
    SCOPED_TRACE(tried.name);
    World world;
    Object& object = *world.FindObject(tried.make(world));
    object.SetMass(0);
    object.SetPosition({0, 0, 0});
    object.SetOrientation(tried.turned);
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 from{about(2), about(2), about(2)};
      const Vec3 to = i % 10 == 0 ? Vec3{from.x, -from.y, from.z} : Vec3{about(1), about(1), about(1)};
      const float share = FirstInside(from, to, tried.is_inside);
      const auto hit = world.RayCast(from, to);
      if (share == 0) {
        EXPECT_FALSE(hit.has_value()) << "begins inside";
        continue;
      }
      // If the segment touches the shape for less than a step, either result is accepted.
      const float length = Length(to - from);
      if (!hit || share == 2) {
        const bool grazes = hit.has_value() && !tried.is_inside(hit->point - hit->normal * 0.002f);
        EXPECT_TRUE(grazes || (!hit && share == 2)) << i;
        continue;
      }
      ++hits;
      EXPECT_LE(Length(hit->point - from), share * length + 1e-3f) << i;
      EXPECT_GT(Length(hit->point - from), share * length - length / 500) << i;
      EXPECT_NEAR(Length(hit->normal), 1, 1e-4f) << i;
      EXPECT_LT(Dot(hit->normal, to - from), 0) << i;
    }
    EXPECT_GT(hits, 20);
  }
}

TEST(WorldPhysics, AFastBulletDoesNotPassThroughAnAgent) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetMass(0);
  agent.SetPosition({0, 0.8f, 20});
  Object& bullet = *world.FindObject(world.CreatePhysicsCapsule(0.3f, 0.01f));
  bullet.SetMass(0.1f);
  bullet.SetGravity({0, -0.01f, 0});
  bullet.SetPosition({0, 0.9f, 0});
  bullet.ApplyImpulse({0, 0, 750});
  bool touched = false;
  for (int i = 0; i < 30; ++i) {
    Tick(world);
    for (const Collision& collision : world.Collisions()) {
      touched |= (collision.a == bullet.id() && collision.b == agent.id()) ||
                 (collision.b == bullet.id() && collision.a == agent.id());
    }
  }
  EXPECT_TRUE(touched);
  EXPECT_LT(bullet.Position().z, 20);
}

TEST(WorldPhysics, ResizingAnAgentRebuildsItsBodyAboutTheSameCentre) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetPosition({1, 5, 2});
  agent.SetVelocity({3, 0, 4});
  EXPECT_FLOAT_EQ(agent.Speed(), 5);
  agent.SetHeight(1.3f);
  EXPECT_EQ(agent.Position(), (Vec3{1, 5, 2}));
  EXPECT_EQ(agent.Velocity(), (Vec3{0, 0, 0}));
  EXPECT_NEAR(world.RayCast({1, 9, 2}, {1, 0, 2})->point.y, 5.65f, 0.01f);
}

TEST(WorldPhysics, AnAgentWithoutPhysicsStaysWhereItIsPut) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  agent.SetPosition({0, 5, 0});
  agent.RemovePhysics();
  agent.RemovePhysics();
  agent.SetVelocity({0, 0, 3});
  agent.SetForward({1, 0, 0});
  Tick(world, 10);
  EXPECT_EQ(agent.Position(), (Vec3{0, 5, 0}));
  EXPECT_NEAR(Distance(agent.Velocity(), {3, 0, 0}), 0, 1e-5f) << "forward times stored speed";
  EXPECT_FALSE(world.RayCast({0, 9, 0}, {0, 0, 0}).has_value());
  EXPECT_TRUE(agent.SetPosition({7, 8, 9}));
  EXPECT_EQ(world.scene().WorldPosition(agent.node()), (Vec3{7, 8, 9}));
}

TEST(WorldPhysics, RemovingABodyDuringItsCollisionTakesEffectAtTheNextTick) {
  World world;
  world.CreatePlane(200, 200);
  const EntityId box = world.CreateBox(1, 1, 1);
  Tick(world);
  ASSERT_EQ(world.Collisions().size(), 1u);
  const Collision collision = world.Collisions()[0];
  EXPECT_NEAR(std::abs(collision.normal_on_b.y), 1, 1e-4f);

  EXPECT_TRUE(world.RemoveObject(box));
  EXPECT_TRUE(world.RemoveObject(box)) << "asking again is harmless";
  EXPECT_NE(world.FindObject(box), nullptr);
  EXPECT_EQ(world.ObjectIds().size(), 2u);
  EXPECT_EQ(world.BeginTick(), std::vector<EntityId>{box});
  EXPECT_EQ(world.FindObject(box), nullptr);
  EXPECT_FALSE(world.RemoveObject(box));
  EXPECT_EQ(world.NodeOf(box), NodeId::kNone);
  world.Step();
  EXPECT_TRUE(world.Collisions().empty());
  EXPECT_TRUE(world.BeginTick().empty());
}

TEST(WorldPhysics, WhatLeansOnARemovedBodyWakesAndFalls) {
  World world;
  world.CreatePlane(200, 200);
  const EntityId below = world.CreateBox(2, 2, 2);
  world.FindObject(below)->SetPosition({0, 1, 0});
  Object& above = *world.FindObject(world.CreateBox(1, 1, 1));
  above.SetPosition({0, 2.5f, 0});
  Tick(world, 200);
  ASSERT_TRUE(above.IsSleeping());
  world.RemoveObject(below);
  Tick(world, 60);
  EXPECT_NEAR(above.Position().y, 0.5f, 0.02f);
}

TEST(WorldPhysics, AThousandBodiesAtOnePlaceAreCarriedByTheGroundAndTheFirstStillTouch) {
  World world;
  world.CreatePlane(100, 100);
  constexpr int kBodies = 1000;
  std::vector<EntityId> agents;
  for (int i = 0; i < kBodies; ++i) agents.push_back(world.CreateAgent({}));
  EXPECT_TRUE(world.IsCrowded());
  for (int tick = 0; tick < 10; ++tick) {
    world.BeginTick();
    world.Step();
  }
  for (const EntityId id : agents) EXPECT_GT(world.FindAgent(id)->Position().y, -0.2f) << Number(id);
  // Bodies that were set aside are seen and shot at their true positions.
  for (int i = 0; i < kBodies - 100; ++i) {
    const auto apart = static_cast<float>(i);
    world.FindAgent(agents[static_cast<std::size_t>(i)])->SetPosition({100 + 2 * apart, 0.8f, 50});
  }
  for (std::size_t i = kBodies - 100; i < kBodies; ++i) {
    const Vec3 place = world.FindAgent(agents[i])->Position();
    EXPECT_TRUE(world.RayCast(place + Vec3{0, 5, 0}, place)) << i;
  }
  // A body that leaves the crowd collides again.
  Agent& away = *world.FindAgent(agents.back());
  away.SetPosition({30, 0.8f, 0});
  for (int tick = 0; tick < 10; ++tick) {
    world.BeginTick();
    away.SetPosition({30, 0.8f, 0});
    world.Step();
    if (world.RayCast({30, 0.8f, -5}, {30, 0.8f, 5})) break;
  }
  EXPECT_TRUE(world.RayCast({30, 0.8f, -5}, {30, 0.8f, 5}));
}

TEST(WorldPhysics, ACapsuleMeetsABoxInTheSameWayIfTheyWereApartBefore) {
  // Pairs that stay apart are not given to Bullet. When they meet, the step must be the same as in a new world.
  constexpr float kRadius_m = 0.2f, kHalf_m = 0.3f, kSpeed_mps = 2, kStep_s = 1.0f / 30;
  RandomStream random(11, 1);
  const auto about = [&](float reach) { return (random.Unit() * 2 - 1) * reach; };
  int stopped = 0, free = 0;
  for (int i = 0; i < 300; ++i) {
    const Quat turn = Normalized(Quat{1, about(0.6f), about(0.6f), about(0.6f)});
    const Quat own_turn = Normalized(Quat{about(1), about(1), about(1), about(1)});
    const Vec3 axis = Rotate(own_turn, {0, 1, 0}), down = Rotate(turn, {0, -1, 0});
    const Vec3 beside{about(0.5f), 0, about(0.5f)}, middle{about(30), about(3), about(30)};
    const float gap_m = -0.02f + 0.12f * random.Unit();
    Vec3 place, velocity;
    for (const bool was_apart : {false, true}) {
      WorldSettings settings;
      settings.gravity = {};
      World world(settings);
      Object& box = *world.FindObject(world.CreateBox(2, 1, 3));
      box.SetMass(0);
      box.SetOrientation(turn);
      box.SetPosition(middle);
      Object& capsule = *world.FindObject(world.CreatePhysicsCapsule(2 * (kHalf_m + kRadius_m), kRadius_m));
      const auto put = [&](float above_m) {
        const float height_m = 0.5f + kRadius_m + kHalf_m * std::abs(axis.y) + above_m;
        capsule.SetPosition(middle + Rotate(turn, beside + Vec3{0, height_m, 0}));
        capsule.SetOrientation(turn * own_turn);
        capsule.SetAngularVelocity({});
      };
      if (was_apart) {
        for (const float above_m : {0.12f, 0.06f}) {
          put(above_m);
          capsule.SetVelocity({});
          Tick(world);
          ASSERT_TRUE(world.Collisions().empty()) << i;
        }
      }
      put(gap_m);
      capsule.SetVelocity(down * kSpeed_mps);
      Tick(world);
      if (was_apart) {
        EXPECT_EQ(capsule.Position(), place) << i << ", " << gap_m;
        EXPECT_EQ(capsule.Velocity(), velocity) << i << ", " << gap_m;
      }
      place = capsule.Position();
      velocity = capsule.Velocity();
    }
    const bool is_stopped = Dot(velocity, down) < kSpeed_mps * 0.99f;
    ++(is_stopped ? stopped : free);
    EXPECT_TRUE(is_stopped || gap_m >= 0) << i;
    EXPECT_TRUE(!is_stopped || gap_m <= kSpeed_mps * kStep_s) << i;
  }
  EXPECT_GT(stopped, 50);
  EXPECT_GT(free, 50);
}

TEST(WorldPhysics, ValuesThatPhysicsCannotBearAreRefusedOrLimited) {
  World world;
  world.CreatePlane(200, 200);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float huge = std::numeric_limits<float>::max();
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  Object& box = *world.FindObject(world.CreateBox(-1, nan, huge));
  EXPECT_FALSE(agent.SetPosition({nan, 0, 0}));
  EXPECT_FALSE(agent.SetVelocity({0, nan, 0}));
  EXPECT_FALSE(agent.ApplyForce({0, 0, nan}));
  EXPECT_FALSE(agent.SetForward({0, 1, 0}));
  EXPECT_FALSE(agent.SetForward({0, 0, 0}));
  EXPECT_FALSE(agent.SetRadius(nan));
  EXPECT_FALSE(box.SetOrientation({nan, 0, 0, 0}));
  EXPECT_TRUE(agent.SetHeight(0));
  EXPECT_TRUE(agent.SetRadius(-3));
  EXPECT_TRUE(agent.SetPosition({huge, -huge, 0}));
  EXPECT_TRUE(agent.SetVelocity({huge, huge, huge}));
  EXPECT_TRUE(box.SetMass(huge));
  for (int i = 0; i < 20; ++i) {
    agent.ApplyForce({huge, huge, -huge});
    box.ApplyForce({huge, huge, -huge});
    box.ApplyAngularImpulse({huge, huge, -huge});
    Tick(world);
    EXPECT_TRUE(IsFinite(agent.Position()));
    EXPECT_TRUE(IsFinite(box.Position()));
    EXPECT_TRUE(IsFinite(box.Orientation()));
  }
}

}  // namespace
}  // namespace soarbox::world
