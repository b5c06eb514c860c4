// SPDX-License-Identifier: BSD-2-Clause
#include "world/scene.h"

#include <algorithm>
#include <limits>

#include "world/rotation.h"
#include "world/scene_node.h"
#include "world/scene_picture.h"

namespace soarbox::world {
namespace {

/// Applies a parent's transform. Most have no translation or scale, and many no rotation.
void Hang(WorldTransform& below, const Vec3& position, const Quat& orientation, const Vec3& scale) {
  if (below.position == Vec3{}) {
    below.position = position;
  } else {
    below.position = position + Rotate(orientation, {below.position.x * scale.x, below.position.y * scale.y,
                                                     below.position.z * scale.z});
  }
  below.orientation = below.orientation == Quat{} ? orientation : orientation * below.orientation;
  below.scale = {below.scale.x * scale.x, below.scale.y * scale.y, below.scale.z * scale.z};
}

}  // namespace

Scene::Scene(MediaCatalog& catalog) : catalog_(catalog), picture_(std::make_unique<Picture>()) {
  Node root;
  root.belongs_to_entity = true;
  Add(NodeId::kNone, std::move(root));
}

Scene::~Scene() = default;

Scene::Node* Scene::Find(NodeId node) {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? nullptr : &found->second;
}

const Scene::Node* Scene::Find(NodeId node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? nullptr : &found->second;
}

bool Scene::Contains(NodeId node) const {
  return Find(node) != nullptr;
}

int Scene::Depth(NodeId node) const {
  int depth = -1;
  for (const Node* at = Find(node); at; at = at->above) ++depth;
  return depth;
}

NodeId Scene::Add(NodeId parent, Node node) {
  Node* above = Find(parent);
  if (!above && !nodes_.empty()) return NodeId::kNone;
  if (above && parent != NodeId::kRoot && Depth(parent) >= kDeepest) return NodeId::kNone;
  const NodeId id{next_++};
  if (above && !node.belongs_to_entity) {
    node.owner = above->owner;
    node.owner_is_agent = above->owner_is_agent;
  }
  node.id = id;
  node.above = above;
  if (node.animator) animated_.push_back(id);
  if (node.content == NodeContent::kLight) ++lights_;
  Node& added = nodes_.emplace_hint(nodes_.end(), id, std::move(node))->second;
  if (above) above->children.push_back(&added);
  Changed(added);
  return id;
}

bool Scene::Remove(NodeId node) {
  const Node* found = Find(node);
  if (!found || found->belongs_to_entity) return false;
  RemoveOwned(node);
  return true;
}

void Scene::RemoveOwned(NodeId node) {
  Node* found = Find(node);
  if (!found) return;
  if (found->above) std::erase(found->above->children, found);
  RemoveTree(*found);
}

void Scene::RemoveTree(Node& top) {
  std::vector<Node*> waiting{&top};
  while (!waiting.empty()) {
    Node& next = *waiting.back();
    waiting.pop_back();
    waiting.insert(waiting.end(), next.children.begin(), next.children.end());
    if (next.animator) ForgetAnimations(next.id);
    if (next.content == NodeContent::kLight) --lights_;
    Forget(next);
    nodes_.erase(next.id);
  }
}

Vec3 Scene::Position(NodeId node) const {
  const Node* found = Find(node);
  return found ? found->position : Vec3{};
}

Quat Scene::Orientation(NodeId node) const {
  const Node* found = Find(node);
  return found ? found->orientation : Quat{};
}

bool Scene::SetPosition(NodeId node, Vec3 position) {
  Node* found = Find(node);
  if (!found || node == NodeId::kRoot || !IsFinite(position)) return false;
  found->position = position;
  Moved(*found);
  return true;
}

bool Scene::SetOrientation(NodeId node, Quat orientation) {
  Node* found = Find(node);
  if (!found || node == NodeId::kRoot || !IsFinite(orientation)) return false;
  found->orientation = Normalized(orientation);
  Moved(*found);
  return true;
}

bool Scene::SetScale(NodeId node, Vec3 scale) {
  Node* found = Find(node);
  if (!found || node == NodeId::kRoot || !IsFinite(scale)) return false;
  found->scale = scale;
  Moved(*found);
  return true;
}

void Scene::PlaceWorldNode(NodeId node, Vec3 position, Quat orientation) {
  // The nodes of agents and objects are children of the root, which never moves.
  if (Node* found = Find(node)) {
    found->position = position;
    found->orientation = orientation;
    BodyMoved(*found, position, orientation);
  }
}

void Scene::BodyMoved(NodeId node, Vec3 position, Quat orientation) {
  if (Node* found = Find(node)) BodyMoved(*found, position, orientation);
}

void Scene::BodyMoved(Node& node, Vec3 position, Quat orientation) {
  if (node.body_position == position && node.body_orientation == orientation) return;
  node.body_position = position;
  node.body_orientation = orientation;
  Moved(node);
}

WorldTransform Scene::Transform(NodeId node) const {
  const Node* found = Find(node);
  return found ? TransformOf(*found) : WorldTransform{};
}

WorldTransform Scene::TransformOf(const Node& node, bool by_body) {
  WorldTransform result;
  // The root never moves.
  for (const Node* at = &node; at->above; at = at->above) {
    const bool is_body = by_body && at->HasBody();
    const Vec3& position = is_body ? at->body_position : at->position;
    const Quat& orientation = is_body ? at->body_orientation : at->orientation;
    if (at->bone >= 0 && at->above->animator) {
      const BonePose hung =
          at->above->animator->NowPose().WorkOut(static_cast<std::size_t>(at->bone)) * BonePose{position, orientation};
      Hang(result, hung.position, hung.orientation, at->scale);
    } else {
      Hang(result, position, orientation, at->scale);
    }
  }
  return result;
}

Vec3 Scene::WorldPosition(NodeId node) const {
  return Transform(node).position;
}

float Scene::Radius(NodeId node) const {
  constexpr float kFar = std::numeric_limits<float>::max();
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  std::vector<const Node*> waiting;
  if (const Node* top = Find(node)) waiting.push_back(top);
  while (!waiting.empty()) {
    const Node* found = waiting.back();
    waiting.pop_back();
    waiting.insert(waiting.end(), found->children.begin(), found->children.end());
    if (found->content != NodeContent::kDrawable && found->content != NodeContent::kRing) continue;
    const WorldTransform transform = TransformOf(*found);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 local{corner & 1 ? found->bounds.max.x : found->bounds.min.x,
                       corner & 2 ? found->bounds.max.y : found->bounds.min.y,
                       corner & 4 ? found->bounds.max.z : found->bounds.min.z};
      const Vec3 at = transform.Apply(found->offset + Rotate(found->offset_turn, local));
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
  }
  return low.x <= high.x ? Length(high - low) / 2 : 0.0f;
}

bool Scene::SetMaterial(NodeId node, std::string_view material) {
  Node* found = Find(node);
  if (!found || (found->content != NodeContent::kDrawable && found->content != NodeContent::kRing)) return false;
  found->drawable.material = catalog_.LookUpMaterial(material);
  Changed(*found);
  return true;
}

bool Scene::IsVisible(NodeId node) const {
  const Node* found = Find(node);
  return found && found->visible;
}

bool Scene::SetVisible(NodeId node, bool visible) {
  Node* top = Find(node);
  if (!top) return false;
  std::vector<Node*> waiting{top};
  while (!waiting.empty()) {
    Node* found = waiting.back();
    waiting.pop_back();
    found->visible = visible;
    found->has_new_look = true;
    waiting.insert(waiting.end(), found->children.begin(), found->children.end());
  }
  Changed(*top);
  return true;
}

bool Scene::SetLightDiffuse(NodeId node, Vec3 color) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(color)) return false;
  found->light.diffuse = color;
  Changed(*found);
  return true;
}

bool Scene::SetLightSpecular(NodeId node, Vec3 color) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(color)) return false;
  found->light.specular = color;
  Changed(*found);
  return true;
}

bool Scene::SetLightRange(NodeId node, float range_m) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(range_m) || range_m <= 0) return false;
  found->light.range_m = range_m;
  found->light.attenuation[0] = 1;
  found->light.attenuation[1] = 4.5f / range_m;
  found->light.attenuation[2] = 75.0f / (range_m * range_m);
  Changed(*found);
  return true;
}

bool Scene::ResetParticle(NodeId node) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kParticle) return false;
  ++found->particle.restarts;
  Changed(*found);
  return true;
}

bool Scene::SetParticleDirection(NodeId node, Vec3 direction) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kParticle || !IsFinite(direction)) return false;
  found->particle.has_direction = true;
  found->particle.direction = direction;
  Changed(*found);
  return true;
}

void Scene::SetAmbient(Vec3 color) {
  if (IsFinite(color)) ambient_ = color;
  picture_->few_changed = true;
}

void Scene::SetSky(std::string_view name, Vec3 rotation_deg) {
  sky_ = catalog_.LookUpSky(name);
  sky_rotation_deg_ = IsFinite(rotation_deg) ? rotation_deg : Vec3{};
  picture_->few_changed = true;
}

}  // namespace soarbox::world
