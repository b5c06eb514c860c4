// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <numbers>

#include "world/refill.h"
#include "world/scene.h"
#include "world/scene_node.h"

// What the scene tree looks like in world space.
namespace soarbox::world {
namespace {

constexpr int kRingSegments = 32;

// A ring is drawn as lines, in the colour that its material's name stands for.
Color ColorOf(const std::string& material) {
  if (material.find("Red") != std::string::npos) return {1, 0, 0, 1};
  if (material.find("Green") != std::string::npos) return {0, 1, 0, 1};
  if (material.find("Blue") != std::string::npos) return {0, 0, 1, 1};
  if (material.find("Yellow") != std::string::npos) return {1, 1, 0, 1};
  return {1, 1, 1, 1};
}

void AddRing(const WorldTransform& transform, float radius_m, Color color, std::vector<LineSnapshot>& lines) {
  Vec3 last = transform.Apply({radius_m, 0, 0});
  for (int i = 1; i <= kRingSegments; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSegments;
    const Vec3 next = transform.Apply({radius_m * std::cos(angle), 0, radius_m * std::sin(angle)});
    lines.push_back({last, next, color});
    last = next;
  }
}

}  // namespace

void Scene::FillSnapshot(SceneSnapshot& snapshot, const BodyOf& body_of) const {
  snapshot.ambient = ambient_;
  snapshot.sky = sky_;
  snapshot.sky_rotation_deg = sky_rotation_deg_;
  snapshot.lines.clear();
  Refill<DrawableSnapshot> drawables(snapshot.drawables, snapshot.drawables.empty() ? nodes_.size() : 0);
  Refill<LightSnapshot> lights(snapshot.lights, 0);
  Refill<ParticleSnapshot> particles(snapshot.particles, 0);

  for (const auto& [id, node] : nodes_) {
    if (node.content == NodeContent::kNone) continue;
    const WorldTransform transform = TransformOf(node, &body_of);
    switch (node.content) {
      case NodeContent::kNone:
        break;
      case NodeContent::kDrawable: {
        DrawableSnapshot& drawable = drawables.Next();
        drawable = node.drawable;
        drawable.id = Number(id);
        drawable.owner_id = Number(node.owner);
        drawable.belongs_to_agent = node.owner_is_agent;
        drawable.position = transform.Apply(node.offset);
        drawable.orientation = transform.orientation * node.offset_turn;
        drawable.scale = transform.scale;
        drawable.visible = node.visible;
        if (node.animator) {
          drawable.bones = node.animator->Bones();
          drawable.shows_skeleton = node.animator->shows_skeleton();
        }
        break;
      }
      case NodeContent::kRing:
        if (node.visible) AddRing(transform, node.drawable.size.x, ColorOf(node.drawable.material), snapshot.lines);
        break;
      case NodeContent::kLight: {
        if (!node.visible) break;
        LightSnapshot& light = lights.Next();
        light = node.light;
        light.id = Number(id);
        light.position = transform.position;
        light.direction = Rotate(transform.orientation, node.light.direction);
        break;
      }
      case NodeContent::kParticle: {
        ParticleSnapshot& particle = particles.Next();
        particle = node.particle;
        particle.id = Number(id);
        particle.position = transform.position;
        particle.orientation = transform.orientation;
        particle.direction = Rotate(transform.orientation, node.particle.direction);
        particle.visible = node.visible;
        break;
      }
    }
  }
}

}  // namespace soarbox::world
