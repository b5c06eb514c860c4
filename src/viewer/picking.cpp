// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace soarbox::viewer {

using world::Vec3;

Projection::Projection(const world::CameraSnapshot& camera, int width_px, int height_px)
    : eye_(camera.position),
      forward_(Rotate(camera.orientation, {0, 0, -1})),
      right_(Rotate(camera.orientation, {1, 0, 0})),
      up_(Rotate(camera.orientation, {0, 1, 0})),
      width_(static_cast<float>(width_px)),
      height_(static_cast<float>(height_px)) {
  const float half_angle = camera.vertical_fov_deg * std::numbers::pi_v<float> / 360;
  pixels_per_slope_ = height_ / 2 / std::tan(half_angle);
}

Vec3 Projection::RayThrough(ScreenPoint pixel) const {
  const float x = (pixel.x - width_ / 2) / pixels_per_slope_, y = (height_ / 2 - pixel.y) / pixels_per_slope_;
  return world::Normalized(forward_ + right_ * x + up_ * y);
}

std::optional<ScreenPoint> Projection::Project(Vec3 point) const {
  const Vec3 away = point - eye_;
  const float depth = Dot(away, forward_);
  if (!(depth >= 0.1f)) return std::nullopt;  // Also excludes NaN.
  return ScreenPoint{width_ / 2 + Dot(away, right_) / depth * pixels_per_slope_,
                     height_ / 2 - Dot(away, up_) / depth * pixels_per_slope_};
}

std::uint32_t Projection::AgentAt(ScreenPoint pixel, const std::vector<world::AgentSnapshot>& agents) const {
  constexpr float kTolerancePx = 5;
  const Vec3 ray = RayThrough(pixel);
  std::uint32_t best = 0;
  float best_depth = std::numeric_limits<float>::max();
  for (const world::AgentSnapshot& agent : agents) {
    // The capsule's axis is a segment. Compare the ray with the point of the segment that is nearest to it.
    const float half = std::max(0.0f, agent.height_m / 2 - agent.radius_m);
    const Vec3 axis{0, 1, 0}, between = agent.position - eye_;
    const float slant = Dot(ray, axis), spread = 1 - slant * slant;
    const float along_axis = spread < 1e-5f ? 0 : (slant * Dot(between, ray) - Dot(between, axis)) / spread;
    const Vec3 near = agent.position + axis * std::clamp(along_axis, -half, half);
    const float depth = Dot(near - eye_, ray);
    if (depth <= 0.1f || depth >= best_depth) continue;
    const float away = world::Distance(near, eye_ + ray * depth);
    if (away > agent.radius_m + kTolerancePx * depth / pixels_per_slope_) continue;
    best = agent.id;
    best_depth = depth;
  }
  return best;
}

std::vector<std::uint32_t> Projection::AgentsIn(ScreenPoint from, ScreenPoint to,
                                                const std::vector<world::AgentSnapshot>& agents) const {
  const auto [left, right] = std::minmax(from.x, to.x);
  const auto [top, bottom] = std::minmax(from.y, to.y);
  std::vector<std::uint32_t> inside;
  for (const world::AgentSnapshot& agent : agents) {
    const auto at = Project(agent.position);
    if (at && at->x >= left && at->x <= right && at->y >= top && at->y <= bottom) inside.push_back(agent.id);
  }
  return inside;
}

}  // namespace soarbox::viewer
