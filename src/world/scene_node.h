// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "world/animation/animator.h"
#include "world/scene.h"

// For the scene*.cpp files only.
namespace soarbox::world {

enum class NodeContent : std::uint8_t { kNone, kDrawable, kRing, kLight, kParticle };

/// One node of the scene tree: a transform relative to the parent, and at most one visible content.
struct Scene::Node {
  NodeId id = NodeId::kNone;
  Node* above = nullptr;  ///< Its parent; null for the root.
  std::vector<Node*> children;
  Vec3 position;
  Quat orientation;
  Vec3 scale{1, 1, 1};
  // For the nodes of agents and objects: the present pose of their body, at which they are drawn.
  Vec3 body_position;
  Quat body_orientation;
  EntityId owner = EntityId::kSandbox;
  bool owner_is_agent = false;
  bool belongs_to_entity = false;  ///< It is the node of an agent, an object or the sandbox; scripts cannot remove it.
  bool visible = true;
  int bone = -1;  ///< Index of the bone of the parent's skeleton that it is attached to; -1: attached to the parent
                  ///< itself.

  NodeContent content = NodeContent::kNone;
  // kDrawable and kRing. Only shape, mesh, material, size and texture are used.
  DrawableSnapshot drawable;
  bool is_line = false;
  Vec3 offset;                         ///< Offset of the drawable's centre, in the node's coordinates.
  Quat offset_turn;                    ///< Rotation of the drawable, in the node's coordinates.
  MeshBounds bounds;                   ///< Bounding box of the drawable, in its own coordinates.
  std::unique_ptr<Animator> animator;  ///< For meshes with a skeleton.
  // kLight; position and direction are in the node's coordinates.
  LightSnapshot light;
  // kParticle; position and direction are in the node's coordinates.
  ParticleSnapshot particle;

  // State of the cached snapshot (scene_fill.cpp).
  static constexpr std::size_t kNotWaiting = ~std::size_t{0};
  bool was_moved = true;                         ///< Its transform may have changed since it was drawn.
  bool is_in_place = false;                      ///< It had no transform of its own when it was drawn.
  bool has_offset = false;                       ///< Its drawable had an offset or a rotation when it was drawn.
  bool has_new_look = true;                      ///< More than its transform has changed since it was drawn.
  std::size_t waits_at = kNotWaiting;            ///< Index in the list of changed nodes.
  std::uint64_t drawn_in = 0;                    ///< The last refresh that visited it.
  std::uint64_t drawn_pose = 0;                  ///< The animator's change count for the drawn pose.
  SharedList<DrawableSnapshot>::Place drawn_at;  ///< Its position in the cached list; entries may have been added or
                                                 ///< removed since.
  std::vector<LineSnapshot> ring_lines;          ///< kRing.

  bool HasBody() const { return belongs_to_entity && owner != EntityId::kSandbox; }
};

/// A transform in world space.
struct WorldTransform {
  Vec3 position;
  Quat orientation;
  Vec3 scale{1, 1, 1};
  Vec3 Apply(Vec3 v) const { return position + Rotate(orientation, {v.x * scale.x, v.y * scale.y, v.z * scale.z}); }
};

}  // namespace soarbox::world
