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
#include "world/ids.h"
#include "world/math.h"
#include "world/media_catalog.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {

struct WorldTransform;
class Animator;
class StateHash;

/// The scene tree: what there is to see and where. The sandbox is the root; each agent and each object has a node of
/// its own under the root, and scripts hang more under any node.
///
/// Each node has a transform relative to its parent and at most one content: a drawable, a ring, a light or a particle
/// emitter. Calls with an unknown node return NodeId::kNone, false or nothing and change nothing; so do values that are
/// not finite. Sizes below 0 count as 0. Meshes, materials and templates that the catalog does not know get a visible
/// stand-in and are reported by the catalog, once per name.
class Scene {
 public:
  explicit Scene(MediaCatalog& catalog);
  ~Scene();

  // Creation: a new child of parent, at the parent's origin, of material "White" unless it is a mesh.
  /// Nothing to see. owner: the agent or object that this node and the nodes below it belong to.
  NodeId CreateEmpty(NodeId parent, EntityId owner, bool owner_is_agent);
  /// Centred box; width along x, height along y, length along z.
  NodeId CreateBox(NodeId parent, float width_m, float height_m, float length_m, float u_tile = 1, float v_tile = 1);
  /// Upright, centred; height is the total height.
  NodeId CreateCapsule(NodeId parent, float height_m, float radius_m);
  /// A thin horizontal ring.
  NodeId CreateCircle(NodeId parent, float radius_m);
  /// Upright; its base is at the node's origin.
  NodeId CreateCylinder(NodeId parent, float height_m, float radius_m);
  /// A thin cylinder from one point to another, in parent space.
  NodeId CreateLine(NodeId parent, Vec3 from, Vec3 to);
  NodeId CreateMesh(NodeId parent, std::string_view mesh);
  /// Horizontal, facing up; length along z, width along x; the texture repeats every 2 m.
  NodeId CreatePlane(NodeId parent, float length_m, float width_m);
  NodeId CreateParticle(NodeId parent, std::string_view template_name);
  /// Direction in parent space; the way that the light goes.
  NodeId CreateDirectionalLight(NodeId parent, Vec3 direction);
  /// The node is placed at position (parent space); range 30 m.
  NodeId CreatePointLight(NodeId parent, Vec3 position);

  /// Destroys the node and all below it. The root and the nodes of agents and objects cannot be removed this way.
  bool Remove(NodeId node);
  bool Contains(NodeId node) const;
  std::size_t node_count() const { return nodes_.size(); }
  /// Nodes hang at most this deep below each other: whoever asks where one is goes through all above it.
  static constexpr int kDeepest = 100;
  /// How many nodes are above this one.
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
  /// Half the diagonal of the world-space bounding box of the node and all below it; 0 if there is nothing to see.
  float Radius(NodeId node) const;

  // Looks.
  /// The material of the drawable that is attached to the node itself.
  bool SetMaterial(NodeId node, std::string_view material);
  bool IsVisible(NodeId node) const;
  /// Applies to the node and all below it.
  bool SetVisible(NodeId node, bool visible);
  /// False if the node is not a line.
  bool SetLineStartEnd(NodeId node, Vec3 from, Vec3 to);

  // Lights; false if the node is none. Colours may exceed 1.
  bool SetLightDiffuse(NodeId node, Vec3 color);
  bool SetLightSpecular(NodeId node, Vec3 color);
  /// Attenuation: constant 1, linear 4.5 / range, quadratic 75 / range^2.
  bool SetLightRange(NodeId node, float range_m);

  // Particles; false if the node is no emitter.
  /// Plays the effect again from its start.
  bool ResetParticle(NodeId node);
  /// In the node's space; turns emission on.
  bool SetParticleDirection(NodeId node, Vec3 direction);

  // Bodies with a skeleton (scene_animation.cpp).
  /// Null if the node's own mesh has none. Valid until the node is removed.
  Animator* AnimatorOf(NodeId node);
  const Animator* AnimatorOf(NodeId node) const;
  /// The name by which others know one movement of a node: the same for the same movement.
  AnimationId AnimationOf(NodeId node, std::size_t clip);
  struct FoundAnimation {
    Animator* animator = nullptr;  ///< Null if the node was removed, or there never was such a movement.
    std::size_t clip = 0;
  };
  FoundAnimation FindAnimation(AnimationId animation);
  /// Hangs a node on a bone of a mesh: from now on it moves with the bone, and its place and turn are relative to the
  /// bone. False if the mesh has no such bone, if the node belongs to an agent, an object or the sandbox, if the mesh
  /// hangs below the node, or if something would hang too deep.
  bool AttachToBone(NodeId mesh, std::size_t bone, NodeId node, Vec3 position, Quat orientation);
  /// Where a bone is in the world: of the node's own skeleton, else of meshes that hang on its bones.
  std::optional<BonePose> BoneInWorld(NodeId node, std::string_view bone) const;
  /// The names of the bones that BoneInWorld finds.
  std::vector<std::string_view> BonesBelow(NodeId node) const;
  /// All nodes with a skeleton, in creation order.
  std::span<const NodeId> animated() const { return animated_; }
  /// What its movements and attachments are.
  void AddAnimationTo(StateHash& hash) const;

  // The whole.
  void SetAmbient(Vec3 color);
  Vec3 ambient() const { return ambient_; }
  /// An unknown sky gives a plain one, and a warning. Replaces any earlier sky.
  void SetSky(std::string_view name, Vec3 rotation_deg);

  /// Sets drawables, lights and particles, ambient light and sky, and begins the lines. Agents and objects are drawn
  /// where their bodies are, not where their nodes are, which follow a tick later. Works out only what has changed
  /// since the last snapshot, whoever took it. `is_known`: this snapshot has been filled from this scene before.
  void FillSnapshot(SceneSnapshot& snapshot, bool is_known) const;

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
  /// What hangs on the bones of a body, the first on top.
  static void AddCarried(const Node& body, std::vector<const Node*>& carried);
  WorldTransform Transform(NodeId node) const;
  /// `by_body`: with the bodies of agents and objects in place of their nodes.
  static WorldTransform TransformOf(const Node& node, bool by_body = false);
  // Give a node its drawable; also for the nodes of objects, which wear theirs themselves.
  void ShapeBox(Node& node, float width_m, float height_m, float length_m, float u_tile, float v_tile);
  void ShapeCapsule(Node& node, float height_m, float radius_m);
  void ShapeMesh(Node& node, std::string_view mesh);
  void ShapePlane(Node& node, float length_m, float width_m);
  /// The node of an agent or object goes to where its body is.
  void PlaceWorldNode(NodeId node, Vec3 position, Quat orientation);
  /// Its body has gone somewhere; the node follows later.
  void BodyMoved(NodeId node, Vec3 position, Quat orientation);
  void BodyMoved(Node& node, Vec3 position, Quat orientation);
  /// The node, and what is below it, looks different from now on.
  void Changed(Node& node);
  /// Only its place has changed.
  void Moved(Node& node);
  void Forget(Node& node);
  void Refresh() const;
  void Redraw(Node& node) const;

  MediaCatalog& catalog_;
  std::map<NodeId, Node> nodes_;
  std::vector<NodeId> animated_;
  struct AnimationName {
    NodeId node;
    std::uint32_t clip;
  };
  std::vector<AnimationName> animation_names_;  ///< By AnimationId - 1.
  std::map<std::pair<NodeId, std::uint32_t>, AnimationId> animation_ids_;
  std::size_t lights_ = 0;  ///< Nodes that are lights.
  std::uint32_t next_ = 1;
  Vec3 ambient_;
  std::string sky_;
  Vec3 sky_rotation_deg_;
  std::unique_ptr<Picture> picture_;  ///< What the last snapshot showed, and what has changed since.
};

}  // namespace soarbox::world
