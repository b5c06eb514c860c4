// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "world/scene.h"
#include "world/scene_node.h"

// For the scene*.cpp files only.
namespace soarbox::world {

/// The visible content of the last snapshot, and the changes since then.
///
/// Invariants: a node is out of date if it differs from the cache, or if it is a descendant of a node that moved. Each
/// node that is out of date is in `waiting`, has an ancestor there, or is below a body whose pose has changed.
/// `waiting` contains each node once. Of removed nodes, only the ids of their drawables remain, in `gone`.
struct Scene::Picture {
  std::vector<Node*> waiting;
  std::vector<NodeId> gone;
  SharedList<DrawableSnapshot> drawables;
  // Contents that are rebuilt together when one of them changes, from nodes in the order of creation.
  std::vector<const Node*> light_nodes, particle_nodes, ring_nodes;
  std::vector<LightSnapshot> lights;
  std::vector<ParticleSnapshot> particles;
  bool has_unplaced = false;  ///< Some drawables that hang on bones may not be placed yet.
  bool few_changed = false;
  std::uint64_t few_version = 0;  ///< Version of lights, particles, ambient light and sky.
  std::uint64_t refreshings = 0;
};

}  // namespace soarbox::world
