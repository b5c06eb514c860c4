// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "world/scene.h"
#include "world/scene_node.h"
#include "world/scene_picture.h"

// Converts the scene tree to world coordinates.
namespace soarbox::world {
namespace {

constexpr int kRingSegments = 32;

// A ring is drawn as lines in the colour of its material.
Color ColorOf(const std::string& material) {
  if (material.find("Red") != std::string::npos) return {1, 0, 0, 1};
  if (material.find("Green") != std::string::npos) return {0, 1, 0, 1};
  if (material.find("Blue") != std::string::npos) return {0, 0, 1, 1};
  if (material.find("Yellow") != std::string::npos) return {1, 1, 0, 1};
  return {1, 1, 1, 1};
}

void MakeRing(const WorldTransform& transform, float radius_m, Color color, std::vector<LineSnapshot>& lines) {
  lines.clear();
  Vec3 last = transform.Apply({radius_m, 0, 0});
  for (int i = 1; i <= kRingSegments; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSegments;
    const Vec3 next = transform.Apply({radius_m * std::cos(angle), 0, radius_m * std::sin(angle)});
    lines.push_back({last, next, color});
    last = next;
  }
}

/// The scale of a node in the world.
template <typename Node>
Vec3 ScaleOf(const Node& node) {
  Vec3 scale = node.scale;
  for (const Node* at = node.above; at->above; at = at->above)
    scale = {scale.x * at->scale.x, scale.y * at->scale.y, scale.z * at->scale.z};
  return scale;
}

/// Ids ascend in lists of nodes.
template <typename Node>
void AddOnce(std::vector<const Node*>& list, const Node& node) {
  const auto at =
      std::lower_bound(list.begin(), list.end(), node.id, [](const Node* n, auto id) { return n->id < id; });
  if (at == list.end() || *at != &node) list.insert(at, &node);
}

}  // namespace

void Scene::Changed(Node& node) {
  node.has_new_look = true;
  Moved(node);
}

void Scene::Moved(Node& node) {
  node.was_moved = true;
  if (node.waits_at != Node::kNotWaiting) return;
  node.waits_at = picture_->waiting.size();
  picture_->waiting.push_back(&node);
}

void Scene::Forget(Node& node) {
  Picture& picture = *picture_;
  if (node.waits_at != Node::kNotWaiting) {
    Node* last = picture.waiting.back();
    picture.waiting[node.waits_at] = last;
    last->waits_at = node.waits_at;
    picture.waiting.pop_back();
  }
  if (node.drawn_in == 0) return;
  switch (node.content) {
    case NodeContent::kNone:
      break;
    case NodeContent::kDrawable:
      picture.gone.push_back(node.id);
      break;
    case NodeContent::kRing:
      std::erase(picture.ring_nodes, &node);
      break;
    case NodeContent::kLight:
      picture.few_changed = true;
      std::erase(picture.light_nodes, &node);
      break;
    case NodeContent::kParticle:
      picture.few_changed = true;
      std::erase(picture.particle_nodes, &node);
      break;
  }
}

/// How a node hangs on a bone, if its drawable and that of the carrier are drawn where their nodes are, and the carrier
/// hangs on no bone itself.
HungSnapshot Scene::HungOf(const Node& node) {
  const Node* const carrier = node.above;
  if (node.bone < 0 || node.has_offset || carrier->content != NodeContent::kDrawable || !carrier->animator ||
      carrier->bone >= 0 || carrier->was_moved || carrier->has_offset || carrier->drawn_in == 0)
    return {};
  return {Number(carrier->id), static_cast<std::uint32_t>(node.bone), node.position, node.orientation};
}

/// Updates the cached drawable of one node.
void Scene::Redraw(Node& node, HungThings hung) const {
  Picture& picture = *picture_;
  switch (node.content) {
    case NodeContent::kNone:
      break;
    case NodeContent::kDrawable: {
      const std::uint32_t id = Number(node.id);
      SharedList<DrawableSnapshot>::Place& place = node.drawn_at;
      place = picture.drawables.Find(id, place);
      const bool is_new = picture.drawables.IsEnd(place) || picture.drawables.At(place).id != id;
      if (is_new) {
        DrawableSnapshot drawable;
        drawable.id = id;
        place = picture.drawables.Insert(place, std::move(drawable));
      }
      if (std::exchange(node.was_moved, false)) {
        node.is_in_place =
            node.bone < 0 && node.position == Vec3{} && node.orientation == Quat{} && node.scale == Vec3{1, 1, 1};
        node.has_offset = node.offset != Vec3{} || node.offset_turn != Quat{};
      }
      // The drawable of most bodies is a direct child without a transform of its own.
      const Node* const body = node.above;
      const bool is_body = node.is_in_place && body->HasBody() && body->bone < 0 && !body->above->above;
      DrawableSnapshot& drawable = picture.drawables.Edit(place);
      drawable.hung = HungOf(node);
      const bool is_unplaced = drawable.hung.on != 0 && hung == HungThings::kNotPlaced;
      WorldTransform transform{body->body_position, body->body_orientation, body->scale};
      if (is_unplaced) {
        picture.has_unplaced = true;
        transform = {drawable.position, drawable.orientation, ScaleOf(node)};
      } else if (!is_body) {
        transform = TransformOf(node, true);
      }
      if (std::exchange(node.has_new_look, false)) {
        drawable.owner_id = Number(node.owner);
        drawable.belongs_to_agent = node.owner_is_agent;
        drawable.shape = node.drawable.shape;
        drawable.mesh = node.drawable.mesh;
        drawable.material = node.drawable.material;
        drawable.size = node.drawable.size;
        drawable.texture_repeats = node.drawable.texture_repeats;
        drawable.visible = node.visible;
      }
      drawable.position = node.has_offset ? transform.Apply(node.offset) : transform.position;
      drawable.orientation = node.has_offset ? transform.orientation * node.offset_turn : transform.orientation;
      drawable.scale = transform.scale;
      if (node.animator) {
        if (is_new || node.drawn_pose != node.animator->changes()) drawable.bones = BodyBones(node.animator->NowPose());
        drawable.shows_skeleton = node.animator->shows_skeleton();
        node.drawn_pose = node.animator->changes();
      }
      break;
    }
    case NodeContent::kRing:
      AddOnce<Node>(picture.ring_nodes, node);
      node.ring_lines.clear();
      if (node.visible)
        MakeRing(TransformOf(node, true), node.drawable.size.x, ColorOf(node.drawable.material), node.ring_lines);
      break;
    case NodeContent::kLight:
      AddOnce<Node>(picture.light_nodes, node);
      picture.few_changed = true;
      break;
    case NodeContent::kParticle:
      AddOnce<Node>(picture.particle_nodes, node);
      picture.few_changed = true;
      break;
  }
}

void Scene::Refresh(HungThings hung) const {
  Picture& picture = *picture_;
  ++picture.refreshings;
  for (const NodeId id : picture.gone) {
    const auto place = picture.drawables.Find(Number(id));
    if (!picture.drawables.IsEnd(place) && picture.drawables.At(place).id == Number(id)) picture.drawables.Erase(place);
  }
  picture.gone.clear();
  // The recursion is limited by kDeepest.
  const auto redraw_all = [&](const auto& self, Node& node) -> void {
    if (std::exchange(node.drawn_in, picture.refreshings) == picture.refreshings) return;
    if (node.content != NodeContent::kNone) Redraw(node, hung);
    for (Node* child : node.children) self(self, *child);
  };
  for (Node* node : picture.waiting) {
    node->waits_at = Node::kNotWaiting;
    redraw_all(redraw_all, *node);
  }
  picture.waiting.clear();
  // Animations move bones without a change of nodes.
  for (const NodeId id : animated_) {
    Node& node = const_cast<Node&>(*Find(id));
    if (node.drawn_pose != node.animator->changes()) redraw_all(redraw_all, node);
  }
  if (hung == HungThings::kPlaced && std::exchange(picture.has_unplaced, false)) PlaceHung(picture.drawables);
  if (!picture.few_changed) return;
  picture.few_changed = false;
  ++picture.few_version;
  picture.lights.clear();
  for (const Node* node : picture.light_nodes) {
    if (!node->visible) continue;
    const WorldTransform transform = TransformOf(*node, true);
    LightSnapshot& light = picture.lights.emplace_back(node->light);
    light.id = Number(node->id);
    light.position = transform.position;
    light.direction = Rotate(transform.orientation, node->light.direction);
  }
  picture.particles.clear();
  for (const Node* node : picture.particle_nodes) {
    const WorldTransform transform = TransformOf(*node, true);
    ParticleSnapshot& particle = picture.particles.emplace_back(node->particle);
    particle.id = Number(node->id);
    particle.position = transform.position;
    particle.orientation = transform.orientation;
    particle.direction = Rotate(transform.orientation, node->particle.direction);
    particle.visible = node->visible;
  }
}

void Scene::FillSnapshot(SceneSnapshot& snapshot, bool is_known, HungThings hung) const {
  Refresh(hung);
  const Picture& picture = *picture_;
  snapshot.drawables = picture.drawables;
  if (!is_known || snapshot.kept.few != picture.few_version) {
    snapshot.lights = picture.lights;
    snapshot.particles = picture.particles;
    snapshot.kept.few = picture.few_version;
    snapshot.ambient = ambient_;
    snapshot.sky = sky_;
    snapshot.sky_rotation_deg = sky_rotation_deg_;
  }
  snapshot.lines.clear();
  for (const Node* node : picture.ring_nodes)
    snapshot.lines.insert(snapshot.lines.end(), node->ring_lines.begin(), node->ring_lines.end());
}

}  // namespace soarbox::world
