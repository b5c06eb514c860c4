// SPDX-License-Identifier: BSD-2-Clause
#include "world/world.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "world/limits.h"
#include "world/rotation.h"
#include "world/scene_node.h"
#include "world/world_impl.h"

namespace soarbox::world {
namespace {

WorldSettings Checked(WorldSettings settings) {
  const WorldSettings defaults;
  settings.step_s = IsFinite(settings.step_s) ? std::clamp(settings.step_s, 0.001f, 0.1f) : defaults.step_s;
  if (!IsFinite(settings.gravity)) settings.gravity = defaults.gravity;
  settings.gravity = Limit(settings.gravity, 1000);
  settings.screen_width_px = std::max(1, settings.screen_width_px);
  settings.screen_height_px = std::max(1, settings.screen_height_px);
  return settings;
}

std::uint64_t NextNumber() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

World::Impl::Impl(const WorldSettings& wanted)
    : settings(Checked(wanted)),
      random(settings.seed),
      physics(settings),
      agents(settings, physics, scene),
      number(NextNumber()) {}

void World::Impl::DeleteObject(EntityId id) {
  const auto found = objects.find(id);
  if (found == objects.end()) return;
  by_body[static_cast<std::size_t>(found->second->body_)] = nullptr;
  physics.Remove(found->second->body_);
  scene.RemoveOwned(found->second->node_);
  objects.erase(found);
  object_ids.erase(std::lower_bound(object_ids.begin(), object_ids.end(), id));
}

Object* World::Impl::ObjectOf(BodyId body) const {
  const auto index = static_cast<std::size_t>(body);
  return index < by_body.size() ? by_body[index] : nullptr;
}

void World::Impl::WalkBodies(const Workers& workers) {
  const auto& animated = scene.animated();
  const auto walk = [&](NodeId id) {
    Animator* animator = scene.AnimatorOf(id);
    const Scene::Node* node = animator->has_locomotion() ? scene.Find(id) : nullptr;
    const Agent* agent = node && node->owner_is_agent ? agents.Find(node->owner) : nullptr;
    if (!agent) return animator->Advance(nullptr, settings.step_s);
    const Vec3 velocity = agent->Velocity(), forward = agent->Forward();
    const BodyMotion motion{.forward_mps = Dot(velocity, forward),
                            .left_mps = Dot(velocity, agent->Left()),
                            .heading_rad = std::atan2(forward.x, forward.z),
                            .alive = agent->Health() > 0};
    animator->Advance(&motion, settings.step_s);
  };
  constexpr std::size_t kWorthThread = 32;
  WorkInPieces(workers, animated.size(), kWorthThread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) walk(animated[i]);
  });
}

World::World(const WorldSettings& settings) : impl_(std::make_unique<Impl>(settings)) {}
World::~World() = default;

const WorldSettings& World::settings() const {
  return impl_->settings;
}
std::uint64_t World::tick() const {
  return impl_->tick;
}
int World::step_millis() const {
  // Milliseconds, rounded down. The small offset prevents 0.02 s from giving 19.
  return std::max(1, static_cast<int>(std::floor(impl_->settings.step_s * 1000.0f + 0.001f)));
}
double World::time_s() const {
  return static_cast<double>(impl_->tick) * static_cast<double>(impl_->settings.step_s);
}

std::uint64_t World::time_millis() const {
  return impl_->tick * static_cast<std::uint64_t>(step_millis());
}

std::vector<EntityId> World::BeginTick(const std::function<void(EntityId)>& before) {
  ++impl_->tick;
  impl_->debug.Clear();
  impl_->physics_lines.clear();
  std::vector<EntityId> removed = std::move(impl_->to_remove);
  impl_->to_remove.clear();
  std::sort(removed.begin(), removed.end());
  if (before) {
    for (const EntityId id : removed)
      if (impl_->agents.Find(id) != nullptr) before(id);
  }
  for (const EntityId id : removed) {
    if (Agent* agent = impl_->agents.Find(id)) {
      impl_->agents.Remove(*agent);
    } else {
      impl_->DeleteObject(id);
    }
  }
  return removed;
}

void World::SyncAgent(EntityId id) {
  if (Agent* agent = impl_->agents.Find(id); agent && !agent->is_node_placed_) agent->MoveNode();
}

void World::Step(const Workers& workers) {
  // Nodes are moved to the positions of bodies after the previous step. Resting bodies are not moved.
  for (const BodyId body : impl_->physics.MovedBodies())
    if (Object* object = impl_->ObjectOf(body)) object->MoveNode();
  impl_->physics.Step(impl_->settings.step_s, workers);
  for (const BodyId body : impl_->physics.MovedBodies()) {
    if (const Object* object = impl_->ObjectOf(body))
      impl_->scene.BodyMoved(object->node(), object->Position(), object->Orientation());
  }
  impl_->agents.ReadBodies();
  impl_->WalkBodies(workers);
  impl_->physics_lines.clear();
  if (impl_->draw_physics) impl_->physics.AddDebugLines(impl_->physics_lines);
}

std::span<const Collision> World::Collisions() const {
  return impl_->physics.Collisions();
}
std::span<const SensorChange> World::SensorChanges() const {
  return impl_->physics.SensorChanges();
}
std::size_t World::hinge_count() const {
  return impl_->physics.hinge_count();
}
RandomStream& World::random() {
  return impl_->random;
}

EntityId World::CreateAgent(const AgentDef& def) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, true);
  impl_->agents.Create(id, node, def);
  return id;
}

Agent* World::FindAgent(EntityId id) {
  return impl_->agents.Find(id);
}
const Agent* World::FindAgent(EntityId id) const {
  return impl_->agents.Find(id);
}
std::span<const EntityId> World::AgentIds() const {
  return impl_->agents.ids();
}

Object* World::FindObject(EntityId id) {
  const auto found = impl_->objects.find(id);
  return found == impl_->objects.end() ? nullptr : found->second.get();
}

const Object* World::FindObject(EntityId id) const {
  const auto found = impl_->objects.find(id);
  return found == impl_->objects.end() ? nullptr : found->second.get();
}

std::span<const EntityId> World::ObjectIds() const {
  return impl_->object_ids;
}

bool World::RemoveAgent(EntityId id) {
  Agent* agent = FindAgent(id);
  if (!agent) return false;
  if (!agent->removal_requested_) impl_->to_remove.push_back(id);
  agent->removal_requested_ = true;
  return true;
}

bool World::RemoveObject(EntityId id) {
  Object* object = FindObject(id);
  if (!object) return false;
  if (!object->removal_requested_) impl_->to_remove.push_back(id);
  object->removal_requested_ = true;
  return true;
}

NodeId World::NodeOf(EntityId id) const {
  if (id == EntityId::kSandbox) return NodeId::kRoot;
  if (const Agent* agent = FindAgent(id)) return agent->node();
  const Object* object = FindObject(id);
  return object ? object->node() : NodeId::kNone;
}

void World::PrepareForReaders(bool for_many_rays) {
  impl_->agents.PrepareCopyNear();
  if (for_many_rays) impl_->physics.PrepareRays();
}

std::optional<RayHit> World::RayCast(Vec3 from, Vec3 to) const {
  if (!IsFinite(from) || !IsFinite(to)) return std::nullopt;
  return impl_->physics.RayCast(LimitPosition(from), LimitPosition(to));
}

WaysAround World::Ways(const Walker& walker, float reach_m) const {
  return WaysAround(impl_->physics, walker, reach_m);
}

Scene& World::scene() {
  return impl_->scene;
}
const Scene& World::scene() const {
  return impl_->scene;
}
Ui& World::ui() {
  return impl_->ui;
}
void World::PlaySound(std::string_view file, float volume, std::optional<Vec3> position) {
  impl_->sounds.Play(file, time_s(), volume, position);
}
Camera& World::camera() {
  return impl_->camera;
}
const Camera& World::camera() const {
  return impl_->camera;
}
DebugDraw& World::debug() {
  return impl_->debug;
}
MediaCatalog& World::catalog() {
  return impl_->catalog;
}

int World::screen_width() const {
  return impl_->settings.screen_width_px;
}
int World::screen_height() const {
  return impl_->settings.screen_height_px;
}
void World::SetScreenSize(int width_px, int height_px) {
  impl_->settings.screen_width_px = std::max(1, width_px);
  impl_->settings.screen_height_px = std::max(1, height_px);
}

void World::SetDrawPhysics(bool draw) {
  impl_->draw_physics = draw;
  if (!draw) impl_->physics_lines.clear();
}
bool World::draw_physics() const {
  return impl_->draw_physics;
}

bool World::IsCrowded() const {
  return impl_->physics.IsCrowded();
}

bool World::HasMediaWarnings() const {
  return impl_->catalog.HasWarnings();
}

std::vector<Diagnostic> World::TakeMediaWarnings() {
  return impl_->catalog.TakeWarnings();
}

std::vector<Diagnostic> World::TakeWarnings() {
  std::vector<Diagnostic> warnings = impl_->catalog.TakeWarnings();
  if (impl_->physics.IsCrowded() && !std::exchange(impl_->told_crowded, true)) {
    Diagnostic warning;
    warning.severity = Severity::kWarning;
    warning.message = "too many bodies overlap at one place: from here on, some pass through others";
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace soarbox::world
