// SPDX-License-Identifier: BSD-2-Clause
#include "world/overlay_snapshot.h"
#include "world/refill.h"
#include "world/state_hash.h"
#include "world/world.h"
#include "world/world_impl.h"

// The hash and the snapshots of a world.
namespace soarbox::world {

std::uint64_t World::Hash() const {
  StateHash hash;
  hash.Add(impl_->tick);
  hash.Add(impl_->random.state());
  hash.Add(static_cast<std::uint64_t>(impl_->next_entity));
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) {
    Agent& agent = impl_->agents.agent(i);
    const AgentMotion& motion = impl_->agents.motion(i);
    if (motion.gone) continue;
    hash.Add(motion.position);
    hash.Add(motion.velocity);
    hash.Add(motion.orientation);
    hash.Add(motion.speed);
    hash.Add(agent.random().state());
    hash.Add(agent.wander_.side, agent.wander_.up);
    hash.Add(agent.HashOfProperties());
  }
  hash.Add(impl_->physics.HashOfThings());
  hash.Add(impl_->navigation.Hash());
  if (impl_->influence) hash.Add(impl_->influence->Hash());
  impl_->scene.AddAnimationTo(hash);
  return hash.value();
}

void World::AddOverlays(const OverlayWants& wants, OverlaySnapshot& overlays) const {
  if (wants.navigation) impl_->navigation.FillOverlay(overlays);
  if (wants.influence && impl_->influence) impl_->influence->FillOverlay(overlays);
  if (wants.physics) impl_->physics.AddDebugLines(overlays.lines);
  if (!wants.forces) return;
  overlays.has_pushes = true;
  for (const PhysicsWorld::Push& push : impl_->physics.LastPushes()) {
    const EntityId owner = impl_->physics.OwnerOf(push.body);
    if (owner == kNoEntity) continue;  // Its body was removed since then.
    overlays.pushes.push_back({Number(owner), impl_->physics.Position(push.body), push.force_n,
                               impl_->physics.Mass(push.body), push.spin_rad_s});
  }
}

SceneSnapshot World::Snapshot() const {
  SceneSnapshot snapshot;
  Snapshot(snapshot);
  return snapshot;
}

void World::Snapshot(SceneSnapshot& snapshot, HungThings hung) const {
  const bool is_known = snapshot.kept.world == impl_->number;
  snapshot.kept.world = impl_->number;
  snapshot.tick = impl_->tick;
  snapshot.time_s = time_s();
  impl_->scene.FillSnapshot(snapshot, is_known, hung);
  impl_->ui.FillSnapshot(snapshot, is_known);
  impl_->sounds.FillSnapshot(snapshot);

  snapshot.lines.insert(snapshot.lines.end(), impl_->debug.lines().begin(), impl_->debug.lines().end());
  snapshot.lines.insert(snapshot.lines.end(), impl_->physics_lines.begin(), impl_->physics_lines.end());
  snapshot.circles = impl_->debug.circles();
  snapshot.triangles = impl_->debug.triangles();
  impl_->navigation.FillSnapshot(snapshot);
  if (impl_->influence) impl_->influence->FillSnapshot(snapshot);
  snapshot.camera = impl_->camera.state();
  snapshot.camera_moves = impl_->camera.moves();
  snapshot.camera_is_fixed = impl_->camera.is_fixed();

  Refill<AgentSnapshot> agents(snapshot.agents, impl_->agents.ids().size());
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) {
    if (impl_->agents.motion(i).gone) continue;
    const Agent& agent = impl_->agents.agent(i);
    AgentSnapshot& seen = agents.Next();
    if (!is_known || seen.id != Number(agent.id()) || seen.texts != agent.texts_) {
      seen.id = Number(agent.id());
      seen.texts = agent.texts_;
      seen.name = agent.name();
      seen.kind = agent.kind();
      seen.script = agent.script();
      seen.team = agent.Team();
      seen.last_command = agent.LastCommand();
      seen.shown = agent.Shown().text();
    }
    const AgentMotion& motion = impl_->agents.motion(i);
    seen.position = motion.position;
    seen.velocity = motion.velocity;
    seen.forward = motion.forward;
    seen.radius_m = motion.radius;
    seen.height_m = agent.Height();
    seen.health = agent.Health();
    seen.alive = agent.Health() > 0;
    seen.failed = agent.Failed();
    seen.has_score = agent.Score().has_value();
    seen.score = agent.Score().value_or(0);
  }
}

}  // namespace soarbox::world
