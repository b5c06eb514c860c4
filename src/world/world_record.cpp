// SPDX-License-Identifier: BSD-2-Clause
#include "world/overlay_snapshot.h"
#include "world/refill.h"
#include "world/state_hash.h"
#include "world/world.h"
#include "world/world_impl.h"

// What others keep of the world: its hash and its picture.
namespace soarbox::world {

std::uint64_t World::Hash() const {
  StateHash hash;
  hash.Add(impl_->tick);
  hash.Add(impl_->random.state());
  hash.Add(static_cast<std::uint64_t>(impl_->next_entity));
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) {
    Agent& agent = impl_->agents.agent(i);
    const AgentMotion& motion = impl_->agents.motion(i);
    hash.Add(motion.position);
    hash.Add(motion.velocity);
    hash.Add(motion.orientation);
    hash.Add(motion.speed);
    hash.Add(motion.radius);
    hash.Add(agent.Height());
    hash.Add(agent.Mass());
    hash.Add(agent.MaxForce());
    hash.Add(agent.MaxSpeed());
    hash.Add(agent.Health());
    hash.Add(agent.Target());
    hash.Add(agent.TargetRadius());
    hash.Add(std::string_view(agent.Team()));
    hash.Add(static_cast<std::uint64_t>(Number(agent.Leader())));
    hash.Add(static_cast<std::uint64_t>(agent.HasBody()));
    hash.Add(agent.random().state());
    hash.Add(agent.wander_.side);
    hash.Add(agent.wander_.up);
    // Path steering goes on along the old points after RemovePath, so they count either way.
    hash.Add(static_cast<std::uint64_t>(agent.HasPath()));
    for (const Vec3 point : agent.path_.points()) hash.Add(point);
  }
  for (const auto& [id, object] : impl_->objects) {
    hash.Add(static_cast<std::uint64_t>(Number(id)));
    hash.Add(object->Position());
    hash.Add(object->Orientation());
    hash.Add(object->Velocity());
    hash.Add(object->AngularVelocity());
    hash.Add(object->Mass());
  }
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
    if (owner == kNoEntity) continue;  // Its body has gone since.
    overlays.pushes.push_back({Number(owner), impl_->physics.Position(push.body), push.force_n,
                               impl_->physics.Mass(push.body), push.spin_rad_s});
  }
}

SceneSnapshot World::Snapshot() const {
  SceneSnapshot snapshot;
  Snapshot(snapshot);
  return snapshot;
}

void World::Snapshot(SceneSnapshot& snapshot) const {
  snapshot.tick = impl_->tick;
  snapshot.time_s = time_s();
  impl_->scene.FillSnapshot(snapshot, [this](EntityId owner, bool is_agent) -> std::optional<BonePose> {
    if (const Agent* agent = is_agent ? FindAgent(owner) : nullptr)
      return BonePose{agent->Position(), agent->Orientation()};
    if (const Object* object = is_agent ? nullptr : FindObject(owner))
      return BonePose{object->Position(), object->Orientation()};
    return std::nullopt;
  });
  impl_->ui.FillSnapshot(snapshot);

  impl_->debug.AppendLines(snapshot.lines);
  snapshot.lines.insert(snapshot.lines.end(), impl_->physics_lines.begin(), impl_->physics_lines.end());
  snapshot.triangles = impl_->debug.triangles();
  impl_->navigation.FillSnapshot(snapshot);
  if (impl_->influence) impl_->influence->FillSnapshot(snapshot);
  snapshot.camera = impl_->camera.state();
  snapshot.camera_moves = impl_->camera.moves();

  Refill<AgentSnapshot> agents(snapshot.agents, impl_->agents.size());
  for (std::size_t i = 0; i < impl_->agents.size(); ++i) {
    const Agent& agent = impl_->agents.agent(i);
    AgentSnapshot& seen = agents.Next();
    seen.id = Number(agent.id());
    seen.name = agent.name();
    seen.kind = agent.kind();
    seen.script = agent.script();
    seen.position = agent.Position();
    seen.velocity = agent.Velocity();
    seen.forward = agent.Forward();
    seen.radius_m = agent.Radius();
    seen.height_m = agent.Height();
    seen.health = agent.Health();
    seen.alive = agent.Health() > 0;
    seen.team = agent.Team();
    seen.last_command = agent.LastCommand();
    seen.failed = agent.Failed();
  }
}

}  // namespace soarbox::world
