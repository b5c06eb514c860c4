// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "world/animation/bone_pose.h"
#include "world/entity_ids.h"
#include "world/math.h"
#include "world/media_catalog.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

struct WorldTransform;
class Animator;
class StateHash;

/// The scene tree: all visible things and their transforms. The root belongs to the sandbox. Each agent and each object
/// has a node below the root. Scripts can add children to any node.
///
/// Each node has a transform relative to its parent and at most one content: a drawable, a ring, a light or a particle
/// emitter. Calls with an unknown node or values that are not finite return NodeId::kNone, false or nothing, and change
/// nothing. Negative sizes count as 0. Names of meshes, materials and templates that the catalog does not contain are
/// replaced by a visible default, and the catalog reports each name once.
class Scene {
 public:
  explicit Scene(MediaCatalog& catalog);
  ~Scene();

  // Creation of a child at the parent's origin. The material is "White", except for meshes.
  /// A node without a content. `owner`: the agent or object that this node and its descendants belong to.
  NodeId CreateEmpty(NodeId parent, EntityId owner, bool owner_is_agent);
  /// A box around the node's origin; width along x, height along y, length along z.
  NodeId CreateBox(NodeId parent, float width_m, float height_m, float length_m, float u_tile = 1, float v_tile = 1);
  /// Upright, around the node's origin; height_m is the total height.
  NodeId CreateCapsule(NodeId parent, float height_m, float radius_m);
  /// A thin horizontal ring.
  NodeId CreateCircle(NodeId parent, float radius_m);
  /// Upright, with its base at the node's origin.
  NodeId CreateCylinder(NodeId parent, float height_m, float radius_m);
  /// A thin cylinder between two points in the parent's coordinates.
  NodeId CreateLine(NodeId parent, Vec3 from, Vec3 to);
  NodeId CreateMesh(NodeId parent, std::string_view mesh);
  /// Horizontal, facing up; length along z, width along x. The texture repeats every 2 m.
  NodeId CreatePlane(NodeId parent, float length_m, float width_m);
  NodeId CreateParticle(NodeId parent, std::string_view template_name);
  /// `direction`: in which the light shines, in the parent's coordinates.
  NodeId CreateDirectionalLight(NodeId parent, Vec3 direction);
  /// The node is placed at `position` in the parent's coordinates. The range is 30 m.
  NodeId CreatePointLight(NodeId parent, Vec3 position);

  /// Removes the node and its descendants. Fails for the root and the nodes of agents and objects.
  bool Remove(NodeId node);
  bool Contains(NodeId node) const;
  std::size_t node_count() const { return nodes_.size(); }
  /// Maximum depth of nodes. Computing a node's transform visits all its ancestors.
  static constexpr int kDeepest = 100;
  /// Number of ancestors of a node.
  int Depth(NodeId node) const;
  std::size_t light_count() const { return lights_; }

  // Transforms, relative to the parent.
  Vec3 Position(NodeId node) const;
  Quat Orientation(NodeId node) const;
  bool SetPosition(NodeId node, Vec3 position);
  bool SetOrientation(NodeId node, Quat orientation);
  bool SetScale(NodeId node, Vec3 scale);
  // In world space.
  Vec3 WorldPosition(NodeId node) const;
  /// Half the diagonal of the bounding box of the node and its descendants in world coordinates; 0 if they have
  /// no drawable or ring.
  float Radius(NodeId node) const;

  // Appearance.
  /// Sets the material of the node's own drawable.
  bool SetMaterial(NodeId node, std::string_view material);
  bool IsVisible(NodeId node) const;
  /// Applies to the node and its descendants.
  bool SetVisible(NodeId node, bool visible);
  /// Returns false if the node is not a line.
  bool SetLineStartEnd(NodeId node, Vec3 from, Vec3 to);

  // Lights. Return false if the node is not a light. Colours may exceed 1.
  bool SetLightDiffuse(NodeId node, Vec3 color);
  bool SetLightSpecular(NodeId node, Vec3 color);
  /// Sets the attenuation: constant 1, linear 4.5 / range, quadratic 75 / range^2.
  bool SetLightRange(NodeId node, float range_m);

  // Particles. Return false if the node is not an emitter.
  /// Plays the effect from its start.
  bool ResetParticle(NodeId node);
  /// In the node's coordinates; also turns emission on.
  bool SetParticleDirection(NodeId node, Vec3 direction);

  // Bodies with a skeleton (scene_animation.cpp).
  /// Null if the node's own mesh has no skeleton. Valid until the node is removed.
  Animator* AnimatorOf(NodeId node);
  const Animator* AnimatorOf(NodeId node) const;
  /// An id for one animation of a node. The same animation always has the same id.
  AnimationId AnimationOf(NodeId node, std::size_t clip);
  struct FoundAnimation {
    Animator* animator = nullptr;  ///< Null if the node was removed, or if there never was such an animation.
    std::size_t clip = 0;
  };
  FoundAnimation FindAnimation(AnimationId animation);
  /// Attaches a node to a bone of a mesh. It then moves with the bone; position and orientation are relative to the
  /// bone. Returns false and changes nothing in four cases: the mesh has no such bone; the node belongs to an agent, an
  /// object or the sandbox; the mesh is a descendant of the node; the tree would become too deep.
  bool AttachToBone(NodeId mesh, std::size_t bone, NodeId node, Vec3 position, Quat orientation);
  /// The pose of a bone in world coordinates. Searches the node's own skeleton, then those of meshes attached to its
  /// bones.
  std::optional<BonePose> BoneInWorld(NodeId node, std::string_view bone) const;
  /// Names of the bones that BoneInWorld finds.
  std::vector<std::string_view> BonesBelow(NodeId node) const;
  /// All nodes with a skeleton, in the order of creation.
  std::span<const NodeId> animated() const { return animated_; }
  /// Hashes the states of animations and attachments.
  void AddAnimationTo(StateHash& hash) const;

  // Settings of the entire scene.
  void SetAmbient(Vec3 color);
  Vec3 ambient() const { return ambient_; }
  /// Replaces the sky. An unknown name gives a plain sky and a warning.
  void SetSky(std::string_view name, Vec3 rotation_deg);

  /// Fills in drawables, lights, particles, ambient light and sky, and starts the list of lines. Agents and objects are
  /// drawn at the positions of their bodies; their nodes follow a tick later. Recomputes only what has changed since
  /// the last snapshot of any caller. `is_known`: this snapshot was filled from this scene before.
  void FillSnapshot(SceneSnapshot& snapshot, bool is_known, HungThings hung) const;

 private:
  friend class Agent;
  friend class AgentStore;
  friend class Object;
  friend class World;
  struct Node;

  struct Picture;

  NodeId Add(NodeId parent, Node node);
  Node* Find(NodeId node);
  const Node* Find(NodeId node) const;
  void RemoveTree(Node& top);
  void RemoveOwned(NodeId node);
  void ForgetAnimations(NodeId node);
  /// Adds the nodes that are attached to bones of a body, ancestors first.
  static void AddCarried(const Node& body, std::vector<const Node*>& carried);
  WorldTransform Transform(NodeId node) const;
  /// `by_body`: use the transforms of bodies for agents and objects, not those of their nodes.
  static WorldTransform TransformOf(const Node& node, bool by_body = false);
  static HungSnapshot HungOf(const Node& node);
  // The following set a node's drawable. They are also used for the nodes of objects.
  void ShapeBox(Node& node, float width_m, float height_m, float length_m, float u_tile, float v_tile);
  void ShapeCapsule(Node& node, float height_m, float radius_m);
  void ShapeMesh(Node& node, std::string_view mesh);
  void ShapePlane(Node& node, float length_m, float width_m);
  /// Moves the node of an agent or object to its body.
  void PlaceWorldNode(NodeId node, Vec3 position, Quat orientation);
  /// Stores the new pose of the body; the node follows later.
  void BodyMoved(NodeId node, Vec3 position, Quat orientation);
  void BodyMoved(Node& node, Vec3 position, Quat orientation);
  /// Call it when the appearance of the node or its descendants has changed.
  void Changed(Node& node);
  /// Call it when only its transform has changed.
  void Moved(Node& node);
  void Forget(Node& node);
  void Refresh(HungThings hung) const;
  void Redraw(Node& node, HungThings hung) const;

  MediaCatalog& catalog_;
  std::map<NodeId, Node> nodes_;
  std::vector<NodeId> animated_;
  struct AnimationName {
    NodeId node;
    std::uint32_t clip;
  };
  std::vector<AnimationName> animation_names_;  ///< By AnimationId - 1.
  std::map<std::pair<NodeId, std::uint32_t>, AnimationId> animation_ids_;
  std::size_t lights_ = 0;  ///< Number of nodes that are lights.
  std::uint32_t next_ = 1;
  Vec3 ambient_;
  std::string sky_;
  Vec3 sky_rotation_deg_;
  std::unique_ptr<Picture> picture_;  ///< The content of the last snapshot, and the changes since then.
};

}  // namespace soarbox::world
