// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "world/scene.h"
#include "world/scene_node.h"

// For the scene*.cpp files only.
namespace soarbox::world {

/// What there is to see, as the last snapshot showed it, and what has changed since.
///
/// Invariants: a node that differs from the picture, or hangs below one that moved, is in `waiting` or below a node
/// that is, or below a body whose pose has changed; each node is there once. Of removed nodes, nothing is left but the
/// ids of their drawables in `gone`.
struct Scene::Picture {
  std::vector<Node*> waiting;
  std::vector<NodeId> gone;
  SharedList<DrawableSnapshot> drawables;
  // The few that are all made again when one of them changes, from nodes in creation order.
  std::vector<const Node*> light_nodes, particle_nodes, ring_nodes;
  std::vector<LightSnapshot> lights;
  std::vector<ParticleSnapshot> particles;
  bool few_changed = false;
  std::uint64_t few_version = 0;  ///< Of lights, particles, ambient light and sky.
  std::uint64_t refreshings = 0;
};

}  // namespace soarbox::world
