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

/// One node of the scene tree: a transform relative to the parent, and at most one thing to see.
struct Scene::Node {
  NodeId id = NodeId::kNone;
  Node* above = nullptr;  ///< Null: the root.
  std::vector<Node*> children;
  Vec3 position;
  Quat orientation;
  Vec3 scale{1, 1, 1};
  // Of the nodes of agents and objects: where their bodies are now, which is where they are drawn.
  Vec3 body_position;
  Quat body_orientation;
  EntityId owner = EntityId::kSandbox;
  bool owner_is_agent = false;
  bool belongs_to_entity = false;  ///< The node of an agent, an object or the sandbox; scripts cannot remove it.
  bool visible = true;
  int bone = -1;  ///< Of the parent's skeleton, which this node hangs on; -1: on the parent itself.

  NodeContent content = NodeContent::kNone;
  // kDrawable and kRing; shape, mesh, material, size and texture only.
  DrawableSnapshot drawable;
  bool is_line = false;
  Vec3 offset;                         ///< Of the drawable's centre, in the node's space.
  Quat offset_turn;                    ///< Of the drawable, in the node's space.
  MeshBounds bounds;                   ///< Around the drawable, in its own space.
  std::unique_ptr<Animator> animator;  ///< Of meshes with a skeleton.
  // kLight; position and direction in the node's space.
  LightSnapshot light;
  // kParticle; position and direction in the node's space.
  ParticleSnapshot particle;

  // Of the picture that is kept (scene_fill.cpp).
  static constexpr std::size_t kNotWaiting = ~std::size_t{0};
  bool was_moved = true;               ///< Its own transform may have changed since it was drawn.
  bool is_in_place = false;            ///< It hangs above it without a transform of its own, when it was drawn.
  bool has_offset = false;             ///< Its drawable has an offset or a turn, when it was drawn.
  bool has_new_look = true;            ///< More than its place has changed since it was drawn.
  std::size_t waits_at = kNotWaiting;  ///< In the list of those that have changed since.
  std::uint64_t drawn_in = 0;          ///< The last refresh that saw it.
  std::uint64_t drawn_pose = 0;        ///< The animator's pose that is in the picture.
  SharedList<DrawableSnapshot>::Place drawn_at;  ///< Where it was in the picture; others may have come or gone since.
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
