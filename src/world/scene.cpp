// SPDX-License-Identifier: BSD-2-Clause
#include "world/scene.h"

#include <algorithm>
#include <limits>

#include "world/rotation.h"
#include "world/scene_node.h"

namespace soarbox::world {

Scene::Scene(MediaCatalog& catalog) : catalog_(catalog) {
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
  for (const Node* at = Find(node); at; at = Find(at->parent)) ++depth;
  return depth;
}

NodeId Scene::Add(NodeId parent, Node node) {
  Node* above = Find(parent);
  if (!above && !nodes_.empty()) return NodeId::kNone;
  if (above && parent != NodeId::kRoot && Depth(parent) >= kDeepest) return NodeId::kNone;
  const NodeId id{next_++};
  if (above) {
    above->children.push_back(id);
    if (!node.belongs_to_entity) {
      node.owner = above->owner;
      node.owner_is_agent = above->owner_is_agent;
    }
  }
  node.parent = parent;
  if (node.animator) animated_.push_back(id);
  if (node.content == NodeContent::kLight) ++lights_;
  nodes_.emplace_hint(nodes_.end(), id, std::move(node));
  return id;
}

bool Scene::Remove(NodeId node) {
  const Node* found = Find(node);
  if (!found || found->belongs_to_entity) return false;
  RemoveOwned(node);
  return true;
}

void Scene::RemoveOwned(NodeId node) {
  const Node* found = Find(node);
  if (!found) return;
  if (Node* above = Find(found->parent)) std::erase(above->children, node);
  RemoveTree(node);
}

void Scene::RemoveTree(NodeId node) {
  std::vector<NodeId> waiting{node};
  while (!waiting.empty()) {
    const NodeId next = waiting.back();
    waiting.pop_back();
    const auto found = nodes_.find(next);
    waiting.insert(waiting.end(), found->second.children.begin(), found->second.children.end());
    if (found->second.animator) ForgetAnimations(next);
    if (found->second.content == NodeContent::kLight) --lights_;
    nodes_.erase(found);
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
  return true;
}

bool Scene::SetOrientation(NodeId node, Quat orientation) {
  Node* found = Find(node);
  if (!found || node == NodeId::kRoot || !IsFinite(orientation)) return false;
  found->orientation = Normalized(orientation);
  return true;
}

bool Scene::SetScale(NodeId node, Vec3 scale) {
  Node* found = Find(node);
  if (!found || node == NodeId::kRoot || !IsFinite(scale)) return false;
  found->scale = scale;
  return true;
}

void Scene::PlaceWorldNode(NodeId node, Vec3 position, Quat orientation) {
  // The nodes of agents and objects hang under the root, which never moves.
  if (Node* found = Find(node)) {
    found->position = position;
    found->orientation = orientation;
  }
}

WorldTransform Scene::Transform(NodeId node, const BodyOf* body_of) const {
  const Node* found = Find(node);
  return found ? TransformOf(*found, body_of) : WorldTransform{};
}

WorldTransform Scene::TransformOf(const Node& node, const BodyOf* body_of) const {
  WorldTransform result;
  const Node* above = nullptr;
  for (const Node* at = &node; at; at = above) {
    const bool is_root = at->parent == NodeId::kNone;
    // The root, which is the first of all nodes, seldom turns or moves anything.
    if (is_root && at->position == Vec3{} && at->orientation == Quat{} && at->scale == Vec3{1, 1, 1}) break;
    above = is_root ? nullptr : at->parent == NodeId::kRoot ? &nodes_.begin()->second : Find(at->parent);
    WorldTransform local{at->position, at->orientation, at->scale};
    if (body_of && at->belongs_to_entity && at->owner != EntityId::kSandbox) {
      if (const std::optional<BonePose> body = (*body_of)(at->owner, at->owner_is_agent)) {
        local.position = body->position;
        local.orientation = body->orientation;
      }
    }
    if (at->bone >= 0 && above && above->animator) {
      const BonePose hung =
          above->animator->Bones()[static_cast<std::size_t>(at->bone)] * BonePose{local.position, local.orientation};
      local.position = hung.position;
      local.orientation = hung.orientation;
    }
    if (at == &node) {
      result = local;
      continue;
    }
    result.position = local.Apply(result.position);
    result.orientation = local.orientation * result.orientation;
    result.scale = {result.scale.x * local.scale.x, result.scale.y * local.scale.y, result.scale.z * local.scale.z};
  }
  return result;
}

Vec3 Scene::WorldPosition(NodeId node) const {
  return Transform(node).position;
}
Quat Scene::WorldOrientation(NodeId node) const {
  return Transform(node).orientation;
}

float Scene::Radius(NodeId node) const {
  constexpr float kFar = std::numeric_limits<float>::max();
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
  std::vector<NodeId> waiting{node};
  while (!waiting.empty()) {
    const NodeId next = waiting.back();
    waiting.pop_back();
    const Node* found = Find(next);
    if (!found) continue;
    waiting.insert(waiting.end(), found->children.begin(), found->children.end());
    if (found->content != NodeContent::kDrawable && found->content != NodeContent::kRing) continue;
    const WorldTransform transform = Transform(next);
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
  return true;
}

bool Scene::IsVisible(NodeId node) const {
  const Node* found = Find(node);
  return found && found->visible;
}

bool Scene::SetVisible(NodeId node, bool visible) {
  if (!Contains(node)) return false;
  std::vector<NodeId> waiting{node};
  while (!waiting.empty()) {
    Node* found = Find(waiting.back());
    waiting.pop_back();
    found->visible = visible;
    waiting.insert(waiting.end(), found->children.begin(), found->children.end());
  }
  return true;
}

bool Scene::SetLightDiffuse(NodeId node, Vec3 color) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(color)) return false;
  found->light.diffuse = color;
  return true;
}

bool Scene::SetLightSpecular(NodeId node, Vec3 color) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(color)) return false;
  found->light.specular = color;
  return true;
}

bool Scene::SetLightRange(NodeId node, float range_m) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kLight || !IsFinite(range_m) || range_m <= 0) return false;
  found->light.range_m = range_m;
  found->light.attenuation[0] = 1;
  found->light.attenuation[1] = 4.5f / range_m;
  found->light.attenuation[2] = 75.0f / (range_m * range_m);
  return true;
}

bool Scene::ResetParticle(NodeId node) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kParticle) return false;
  ++found->particle.restarts;
  return true;
}

bool Scene::SetParticleDirection(NodeId node, Vec3 direction) {
  Node* found = Find(node);
  if (!found || found->content != NodeContent::kParticle || !IsFinite(direction)) return false;
  found->particle.has_direction = true;
  found->particle.direction = direction;
  return true;
}

void Scene::SetAmbient(Vec3 color) {
  if (IsFinite(color)) ambient_ = color;
}

void Scene::SetSky(std::string_view name, Vec3 rotation_deg) {
  sky_ = catalog_.LookUpSky(name);
  sky_rotation_deg_ = IsFinite(rotation_deg) ? rotation_deg : Vec3{};
}

}  // namespace soarbox::world
