// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "world/agent.h"
#include "world/camera.h"
#include "world/collision.h"
#include "world/debug_draw.h"
#include "world/entity_ids.h"
#include "world/influence_map.h"
#include "world/media_catalog.h"
#include "world/navigation.h"
#include "world/object.h"
#include "world/scene.h"
#include "world/scene_snapshot.h"
#include "world/ui.h"
#include "world/ways_around.h"
#include "world/workers.h"
#include "world/world_random.h"
#include "world/world_settings.h"

namespace soarbox::world {

struct OverlaySnapshot;
struct OverlayWants;

/// The physical world of one sandbox: bodies, agents, scene, user interface, camera. It does not depend on scripts or
/// minds.
///
/// One tick, in the order of section 1.3 of docs/spec/lua_api.md:
///   1. BeginTick(): time advances, debug lines of the last tick are removed, removed objects are destroyed.
///   2. The caller delivers events, then updates each agent in creation order, each followed by SyncAgent().
///   3. Step(): the nodes of objects follow their bodies, physics advances, collisions are gathered.
///   4. The caller handles Collisions() and lets the sandbox update.
///   5. Snapshot(), Hash(): the visible scene, and a hash of the state.
///
/// Deterministic: the same settings and the same calls give the same state, bit for bit. A world is used by one thread
/// at a time; different worlds may run on different threads.
class World {
 public:
  explicit World(const WorldSettings& settings = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const WorldSettings& settings() const;

  // Time.
  /// Ticks begun so far.
  std::uint64_t tick() const;
  /// Milliseconds per tick as scripts see them, rounded down: 33 for 1/30 s.
  int step_millis() const;
  /// tick() times step_millis(): the scripts' clock.
  std::uint64_t time_millis() const;
  /// Physical time: tick() times the step. At 1/30 s, the scripts' clock is 1 % slower.
  double time_s() const;
  /// Starts a tick. Removes the agents and objects for which a removal was requested, and returns their ids in
  /// ascending order, so that callers can drop their data about them. First calls `before` for each of these agents,
  /// while all of them still exist.
  std::vector<EntityId> BeginTick(const std::function<void(EntityId agent)>& before = {});
  /// The agent's node follows its body.
  void SyncAgent(EntityId agent);
  /// Advances the physics. The result does not depend on the number of threads.
  void Step(const Workers& workers = {});
  /// The collisions of the last step.
  std::span<const Collision> Collisions() const;
  /// The movable agents and objects that entered or left sensors in the last step (PhysicsWorld::SensorChanges).
  std::span<const SensorChange> SensorChanges() const;
  std::size_t hinge_count() const;
  /// Hash of all state that determines the future of bodies, agents and random streams. The same in every run of one
  /// build.
  std::uint64_t Hash() const;
  RandomStream& random();

  // Agents. A removed agent is still found by its id (Agent::IsGone), but it has no body, and others do not perceive
  // it.
  /// Created at the origin with a capsule body, half inside a floor at y = 0; physics lifts it.
  EntityId CreateAgent(const AgentDef& def);
  /// Null for unknown ids and ids of objects. Valid during the life of the world.
  Agent* FindAgent(EntityId id);
  const Agent* FindAgent(EntityId id) const;
  /// Removes the agent and everything attached to it in the next BeginTick. Repeated calls are allowed. Returns false
  /// for unknown ids.
  bool RemoveAgent(EntityId id);
  /// The agents that were not removed, in creation order. The span is invalid after the next CreateAgent or BeginTick.
  std::span<const EntityId> AgentIds() const;

  // Objects.
  EntityId CreateBox(float width_m, float height_m, float length_m, float u_tile = 1, float v_tile = 1);
  EntityId CreateCapsule(float height_m, float radius_m);
  /// A mesh of the catalog with a body of its size. For unknown meshes, a box of 1 m and a warning.
  EntityId CreateObject(std::string_view mesh);
  /// A visible plane of this size on an infinite, fixed half-space.
  EntityId CreatePlane(float length_m, float width_m);
  /// Bodies without a drawable.
  EntityId CreatePhysicsCapsule(float height_m, float radius_m);
  EntityId CreatePhysicsSphere(float radius_m);
  /// A box without a drawable that collides with nothing. It detects which movable bodies are inside (SensorChanges).
  EntityId CreateSensor(float width_m, float height_m, float length_m);
  /// Null for unknown ids, for ids of agents, and for removed objects.
  Object* FindObject(EntityId id);
  const Object* FindObject(EntityId id) const;
  /// By ascending id, including objects that will be removed. The span is invalid after the next creation or BeginTick.
  std::span<const EntityId> ObjectIds() const;
  /// The object is destroyed in the next BeginTick; until then it still collides. Repeated calls are allowed. Returns
  /// false for unknown ids.
  bool RemoveObject(EntityId id);

  /// The node of the sandbox, an agent or an object, as a parent for Scene::Create*; kNone for unknown ids.
  NodeId NodeOf(EntityId id) const;
  /// From now on, until a body moves, is added or is removed, several threads may call const functions and those of
  /// sight.h. `for_many_rays`: makes rays, paths and lines of sight cheaper until then. Worthwhile if there are several
  /// per body.
  void PrepareForReaders(bool for_many_rays = false);
  /// The first body on the segment, including agents and fixed bodies. A body that contains its start is not hit.
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;
  /// The free horizontal paths of a walker. The length of a path plus its width is at most `reach_m`.
  WaysAround Ways(const Walker& walker, float reach_m) const;

  // Navigation.
  /// Starts to build a mesh over all present fixed objects that have a drawable, except planes. See Navigation::Create.
  Result<bool> CreateNavigationMesh(std::string_view name, const NavigationConfig& config);
  /// Approximate number of cells of such a mesh, which determines its cost.
  double NavigationCells(const NavigationConfig& config) const;
  Navigation& navigation();
  /// Replaces the previous map.
  Result<void> CreateInfluenceMap(std::string_view navigation_mesh, const InfluenceConfig& config);
  /// Null until CreateInfluenceMap.
  InfluenceMap* influence();

  // Parts.
  Scene& scene();
  const Scene& scene() const;
  Ui& ui();
  /// Starts a sound now (sound_board.h).
  void PlaySound(std::string_view file, float volume, std::optional<Vec3> position);
  Camera& camera();
  const Camera& camera() const;
  DebugDraw& debug();
  MediaCatalog& catalog();

  // Screen, in pixels: at least 1 each.
  int screen_width() const;
  int screen_height() const;
  void SetScreenSize(int width_px, int height_px);

  /// Adds wireframes and bounding boxes of all bodies to the lines of snapshots.
  void SetDrawPhysics(bool draw);
  bool draw_physics() const;

  /// Whether so many bodies overlap at one place that further ones pass through each other.
  bool IsCrowded() const;
  /// The warnings since the last call (unknown meshes, materials, ...). Each name is reported once.
  std::vector<Diagnostic> TakeWarnings();
  /// Warnings about names that the catalog does not contain. The caller that used such a name can take them and add its
  /// position.
  bool HasMediaWarnings() const;
  std::vector<Diagnostic> TakeMediaWarnings();

  SceneSnapshot Snapshot() const;
  /// The same. Reuses the memory of `snapshot`, so that little is allocated.
  void Snapshot(SceneSnapshot& snapshot, HungThings hung = HungThings::kPlaced) const;
  /// Adds navigation meshes, the influence map and the shapes of bodies, whether scripts show them or not.
  void AddOverlays(const OverlayWants& wants, OverlaySnapshot& overlays) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::world
