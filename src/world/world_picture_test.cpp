// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "world/animation/animator.h"
#include "world/physics_world.h"
#include "world/rotation.h"
#include "world/world.h"

// Cached snapshots and hashes must equal those that are computed from scratch.
namespace soarbox::world {
namespace {

/// Agents with figures, a soldier with a rifle in the hand, falling and resting boxes, and scripts that change things.
class Stage {
 public:
  Stage() : world_(WorldSettings{.seed = 3}) {
    world_.CreatePlane(50, 50);
    for (int i = 0; i < 40; ++i) {
      const EntityId id = i % 2 == 0 ? world_.CreateBox(1, 1, 1) : world_.CreateObject("models/nobiax_modular/x.mesh");
      world_.FindObject(id)->SetPosition({static_cast<float>(i % 8) * 1.5f, 1.0f + static_cast<float>(i) / 8, 5});
      world_.scene().CreateBox(world_.NodeOf(id), 0.2f, 0.2f, 0.2f);
    }
    for (int i = 0; i < 3; ++i) {
      const EntityId id = world_.CreateAgent({});
      world_.FindAgent(id)->SetPosition({static_cast<float>(i) * 2, 0.8f, 0});
      Scene& scene = world_.scene();
      const NodeId body = scene.CreateMesh(world_.NodeOf(id), "models/futuristic_soldier/futuristic_soldier_anim.mesh");
      scene.AnimatorOf(body)->SetLocomotion(true, {});
      const NodeId rifle = scene.CreateMesh(NodeId::kRoot, "models/futuristic_soldier/soldier_weapon.mesh");
      scene.AttachToBone(body, 3, rifle, {0, 0.1f, 0}, {});
      scene.CreateCircle(world_.NodeOf(id), 0.5f);
      lamp_ = scene.CreatePointLight(rifle, {0, 1, 0});
      nodes_.push_back(rifle);
      panels_.push_back(world_.ui().Create(1));
    }
  }

  void Tick() {
    world_.BeginTick();
    for (const EntityId id : world_.AgentIds()) {
      Agent& agent = *world_.FindAgent(id);
      agent.SetForward({std::sin(static_cast<float>(world_.tick()) / 9), 0, 1});
      agent.SetVelocity(agent.Forward() * (world_.tick() % 40 < 20 ? 2.0f : 0.0f));
      world_.SyncAgent(id);
    }
    const std::uint64_t tick = world_.tick();
    Scene& scene = world_.scene();
    if (tick % 7 == 3) scene.SetMaterial(nodes_[0], tick % 2 == 0 ? "Red" : "Blue");
    if (tick % 11 == 5) scene.SetVisible(nodes_[1], tick % 2 == 0);
    if (tick % 5 == 1) scene.SetPosition(nodes_[2], {0, 0.01f * static_cast<float>(tick), 0});
    if (tick % 13 == 6) nodes_.push_back(scene.CreateParticle(nodes_[0], "Bullet"));
    if (tick % 17 == 8) scene.ResetParticle(nodes_.back());
    if (tick == 30) scene.Remove(lamp_);
    if (tick == 33) scene.SetAmbient({1, 0, 0});
    if (tick % 9 == 4) world_.ui().Edit(panels_[tick % panels_.size()])->caption = std::to_string(tick);
    if (tick % 6 == 2) world_.RemoveObject(world_.ObjectIds()[tick % world_.ObjectIds().size()]);
    if (tick % 8 == 7) world_.FindObject(world_.CreatePhysicsSphere(0.2f))->SetPosition({3, 4, 5});
    if (tick % 10 == 9) world_.FindObject(world_.ObjectIds().back())->ApplyImpulse({300, 900, 0});
    if (tick == 20) world_.FindAgent(world_.AgentIds()[1])->SetLastCommand("move");
    if (tick == 25) world_.FindAgent(world_.AgentIds()[1])->SetTeam("blue");
    world_.Step();
  }
  World& world() { return world_; }

 private:
  World world_;
  NodeId lamp_{};
  std::vector<NodeId> nodes_;
  std::vector<UiId> panels_;
};

void ExpectSame(const SceneSnapshot& a, const SceneSnapshot& b) {
  ASSERT_EQ(a.drawables.size(), b.drawables.size());
  auto other = b.drawables.begin();
  for (const DrawableSnapshot& drawable : a.drawables) {
    SCOPED_TRACE(drawable.id);
    EXPECT_EQ(drawable.id, other->id);
    EXPECT_EQ(drawable.owner_id, other->owner_id);
    EXPECT_EQ(drawable.material, other->material);
    EXPECT_EQ(drawable.mesh, other->mesh);
    EXPECT_EQ(drawable.visible, other->visible);
    EXPECT_EQ(drawable.position, other->position);
    EXPECT_EQ(drawable.orientation, other->orientation);
    ASSERT_EQ(drawable.bones.size(), other->bones.size());
    for (std::size_t i = 0; i < drawable.bones.size(); ++i)
      EXPECT_EQ(drawable.bones[i].position, other->bones[i].position);
    ++other;
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) EXPECT_EQ(a.lights[i].position, b.lights[i].position);
  ASSERT_EQ(a.particles.size(), b.particles.size());
  for (std::size_t i = 0; i < a.particles.size(); ++i) {
    EXPECT_EQ(a.particles[i].position, b.particles[i].position);
    EXPECT_EQ(a.particles[i].restarts, b.particles[i].restarts);
  }
  ASSERT_EQ(a.lines.size(), b.lines.size());
  for (std::size_t i = 0; i < a.lines.size(); ++i) EXPECT_EQ(a.lines[i].to, b.lines[i].to);
  ASSERT_EQ(a.circles.size(), b.circles.size());
  for (std::size_t i = 0; i < a.circles.size(); ++i) EXPECT_EQ(a.circles[i].center, b.circles[i].center);
  ASSERT_EQ(a.ui.size(), b.ui.size());
  for (std::size_t i = 0; i < a.ui.size(); ++i) EXPECT_EQ(a.ui[i].text, b.ui[i].text);
  ASSERT_EQ(a.agents.size(), b.agents.size());
  for (std::size_t i = 0; i < a.agents.size(); ++i) {
    EXPECT_EQ(a.agents[i].team, b.agents[i].team);
    EXPECT_EQ(a.agents[i].last_command, b.agents[i].last_command);
    EXPECT_EQ(a.agents[i].position, b.agents[i].position);
  }
  EXPECT_EQ(a.ambient, b.ambient);
}

TEST(WorldPicture, ThingsThatHangOnBonesArePlacedAfterwardsAsInTheWorld) {
  Stage stage;
  SceneSnapshot later;
  for (int tick = 1; tick <= 60; ++tick) {
    stage.Tick();
    stage.world().Snapshot(later, HungThings::kNotPlaced);
    if (tick % 4 != 0) continue;
    SceneSnapshot placed = later;
    PlaceHung(placed.drawables);
    const SceneSnapshot now = stage.world().Snapshot();
    ASSERT_EQ(placed.drawables.size(), now.drawables.size());
    std::size_t hung = 0;
    for (std::size_t i = 0; i < now.drawables.size(); ++i) {
      const DrawableSnapshot &a = placed.drawables[i], &b = now.drawables[i];
      SCOPED_TRACE(b.id);
      hung += b.hung.on != 0 ? 1 : 0;
      EXPECT_LT(Length(a.position - b.position), 1e-4f);
      EXPECT_LT(Length(Rotate(a.orientation, {1, 2, 3}) - Rotate(b.orientation, {1, 2, 3})), 1e-4f);
      EXPECT_EQ(a.scale, b.scale);
    }
    EXPECT_EQ(hung, 3u);
    if (HasFailure()) FAIL() << tick;
  }
}

TEST(WorldPicture, AThingOnABoneThatDoesNotExistKeepsItsPlace) {
  SharedList<DrawableSnapshot> drawables;
  DrawableSnapshot thing;
  thing.position = {1, 2, 3};
  thing.id = 4;
  for (const std::uint32_t on : {4u, 5u, 7u, ~0u}) {
    ++thing.id;
    thing.hung = {on, 1'000'000, {}, {}};
    drawables.push_back(thing);
  }
  PlaceHung(drawables);
  for (const DrawableSnapshot& drawable : drawables) EXPECT_EQ(drawable.position, thing.position);
}

TEST(WorldPicture, SnapshotsTickByTickAreThoseOfAWorldThatNobodyLookedAtBefore) {
  Stage watched;
  // Reuses snapshots in turn, as a recording does.
  std::vector<SceneSnapshot> places(3);
  for (int tick = 1; tick <= 80; ++tick) {
    watched.Tick();
    SceneSnapshot& place = places[static_cast<std::size_t>(tick) % places.size()];
    watched.world().Snapshot(place);
    if (tick % 9 != 1) continue;
    SCOPED_TRACE(tick);
    Stage unwatched;
    while (unwatched.world().tick() < watched.world().tick()) unwatched.Tick();
    ExpectSame(place, unwatched.world().Snapshot());
    ASSERT_EQ(watched.world().Hash(), unwatched.world().Hash());
    if (HasFailure()) return;
  }
}

TEST(WorldPicture, ASnapshotThatAnotherWorldFilledIsFilledAnew) {
  Stage a, b;
  for (int i = 0; i < 30; ++i) a.Tick();
  b.Tick();
  SceneSnapshot snapshot = a.world().Snapshot();
  b.world().Snapshot(snapshot);
  ExpectSame(snapshot, b.world().Snapshot());
}

TEST(WorldPicture, WhatRestsIsSharedByLaterSnapshots) {
  World world;
  world.CreatePlane(100, 100);
  for (int i = 0; i < 300; ++i)
    world.FindObject(world.CreateBox(1, 1, 1))->SetPosition({2.0f * static_cast<float>(i % 20), 0.51f, i / 20 * 2.0f});
  const auto tick = [&world] {
    world.BeginTick();
    world.Step();
  };
  for (int i = 0; i < 200; ++i) tick();
  const SceneSnapshot before = world.Snapshot();
  Object& box = *world.FindObject(world.ObjectIds()[150]);
  ASSERT_TRUE(box.IsSleeping());
  box.SetVelocity({0, 3, 0});
  for (int i = 0; i < 5; ++i) tick();
  const SceneSnapshot after = world.Snapshot();
  std::size_t other = 0;
  for (std::size_t i = 0; i * 32 < after.drawables.size(); ++i)
    other += !after.drawables.SharesBlock(i, before.drawables, i);
  EXPECT_EQ(other, 1u);
  EXPECT_NEAR(world.scene().WorldPosition(box.node()).y, box.Position().y, 0.15f) << "its node follows";
}

TEST(WorldPicture, TheHashOfBodiesThatIsKeptIsTheOneMadeAnew) {
  PhysicsWorld physics(WorldSettings{});
  const auto add = [&physics](BodyShape shape, Vec3 position, std::uint32_t owner) {
    BodyDef def;
    def.shape = shape;
    def.position = position;
    def.owner = EntityId{owner};
    return physics.Add(def);
  };
  add(BodyShape::kPlane, {}, 1);
  std::vector<BodyId> boxes;
  for (std::uint32_t i = 0; i < 30; ++i)
    boxes.push_back(add(BodyShape::kBox, {static_cast<float>(i % 5) * 0.9f, 1.0f + static_cast<float>(i), 0}, i + 2));
  std::vector<std::uint64_t> seen;
  for (int step = 0; step < 400; ++step) {
    physics.Step(1.0f / 30);
    if (step == 100) physics.Remove(boxes[4]);
    if (step == 150) physics.SetMass(boxes[5], 0);
    if (step == 200) physics.SetGravity(boxes[6], {0, 1, 0});
    if (step == 250) physics.SetPosition(boxes[7], {20, 5, 0});
    if (step == 300) boxes[4] = add(BodyShape::kBox, {0, 30, 0}, 2);
    if (step % 3 != 0) continue;
    const std::uint64_t kept = physics.HashOfThings();
    ASSERT_EQ(kept, physics.HashOfThings(true)) << "after step " << step;
    seen.push_back(kept);
  }
  EXPECT_TRUE(physics.IsSleeping(boxes[0]));
  EXPECT_NE(seen[0], seen[1]);
}

TEST(WorldPicture, EveryPropertyOfABodyIsInTheHash) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  Object& box = *world.FindObject(world.CreateBox(1, 1, 1));
  const Vec3 path[] = {{1, 0, 0}, {2, 0, 0}};
  const std::vector<std::function<void()>> changes = {
      [&] {
        agent.SetPosition({1, 2, 3});
      },
      [&] {
        agent.SetForward({1, 0, 0});
      },
      [&] {
        agent.SetVelocity({1, 0, 0});
      },
      [&] { agent.SetHeight(1.2f); },
      [&] { agent.SetRadius(0.2f); },
      [&] { agent.SetMass(50); },
      [&] { agent.SetMaxForce(10); },
      [&] { agent.SetMaxSpeed(2); },
      [&] { agent.SetHealth(40); },
      [&] {
        agent.SetTarget({4, 0, 0});
      },
      [&] { agent.SetTargetRadius(3); },
      [&] { agent.SetTeam("blue"); },
      [&] { agent.SetLeader(box.id()); },
      [&] { agent.SetPath(path, false); },
      [&] { agent.RemovePath(); },
      [&] { agent.random().Next(); },
      [&] { agent.RemovePhysics(); },
      [&] {
        box.SetPosition({5, 5, 5});
      },
      [&] {
        box.SetOrientation({0, 1, 0, 0});
      },
      [&] {
        box.SetVelocity({1, 0, 0});
      },
      [&] {
        box.SetAngularVelocity({1, 0, 0});
      },
      [&] { box.SetMass(3); },
      [&] {
        box.SetGravity({0, -1, 0});
      },
      [&] { world.random().Next(); },
      [&] { world.CreatePhysicsSphere(1); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::uint64_t before = world.Hash();
    ASSERT_EQ(world.Hash(), before);
    changes[i]();
    EXPECT_NE(world.Hash(), before) << "change " << i;
  }
}

}  // namespace
}  // namespace soarbox::world
