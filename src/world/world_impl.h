// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "world/agent_store.h"
#include "world/physics_world.h"
#include "world/sound_board.h"
#include "world/world.h"

// For the world*.cpp files only.
namespace soarbox::world {

struct World::Impl {
  explicit Impl(const WorldSettings& wanted);

  /// The next id for an agent or object.
  EntityId NextEntity() { return EntityId{next_entity++}; }
  Object& AddObject(EntityId id, NodeId node, ObjectKind kind, BodyDef def);
  /// Null for the bodies of agents.
  Object* ObjectOf(BodyId body) const;
  void DeleteObject(EntityId id);
  NavigationGeometry FixedGeometry() const;
  /// Updates the automatic walking of bodies from the motion of their agents.
  void WalkBodies(const Workers& workers);

  WorldSettings settings;
  RandomStream random;
  MediaCatalog catalog;
  Scene scene{catalog};
  Ui ui;
  SoundBoard sounds;
  Camera camera;
  DebugDraw debug;
  PhysicsWorld physics;
  AgentStore agents;
  std::map<EntityId, std::unique_ptr<Object>> objects;
  std::vector<EntityId> object_ids;  ///< The keys of `objects`.
  std::vector<Object*> by_body;      ///< The same objects by the number of their bodies.
  std::vector<EntityId> to_remove;   ///< In the order of the requests, each once.
  std::vector<LineSnapshot> physics_lines;
  Navigation navigation;
  std::optional<InfluenceMap> influence;
  const std::uint64_t number;  ///< Unique in the process; nothing in a run depends on it.
  std::uint64_t tick = 0;
  std::uint32_t next_entity = 1;
  bool draw_physics = false;
  bool told_crowded = false;
};

}  // namespace soarbox::world
