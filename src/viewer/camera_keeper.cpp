// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/camera_keeper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/body_meshes.h"
#include "world/rotation.h"

namespace soarbox::viewer {
namespace {

using world::CameraSnapshot;
using world::Quat;
using world::Vec3;

/// The camera starts to move when an agent will leave the inner kInside of the view within kSoon_s.
constexpr float kInside = 0.93f, kSoon_s = 0.8f;
/// The new view has space for the movement of agents in this time.
constexpr float kRoom_s = 1.6f;
/// The picture is too wide if the camera could come nearer by this fraction. After kWideFor_s it does.
constexpr float kTooWide = 0.6f, kWideFor_s = 2.5f;
/// How long the area where agents have been is remembered, and the length of a step.
constexpr float kRecent_s = 3, kRecentStep_s = 0.25f;
/// Maximum distance of the camera for showing places. For agents it is kFurthest_m; those in the middle have priority.
constexpr float kPlacesWithin_m = 46, kFurthest_m = 260;
constexpr float kPlaceRadius_m = 0.6f, kPlaceHeight_m = 0.6f;
/// Scenery is added to the picture if it is at most kBeside_m from what is already there and at most kLongestPiece_m
/// long. If a world has more than kMostPieces pieces of scenery, none is added.
constexpr float kBeside_m = 6, kLongestPiece_m = 16, kSceneryWithin_m = 58;
constexpr std::size_t kMostPieces = 100;

float Tangent(float fov_deg) {
  return std::tan(fov_deg * std::numbers::pi_v<float> / 360);
}

Vec3 Lowest(Vec3 a, Vec3 b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3 Highest(Vec3 a, Vec3 b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

Vec3 Middle(std::span<const FramedBody> bodies) {
  Vec3 low = bodies.front().position, high = low;
  for (const FramedBody& body : bodies) {
    low = Lowest(low, body.position);
    high = Highest(high, body.position);
  }
  return (low + high) * 0.5f;
}

/// Whether head and feet are within this fraction of the picture.
bool IsInside(const FramedBody& body, Vec3 at, const CameraSnapshot& pose, float aspect, float share) {
  const Vec3 right = Rotate(pose.orientation, {1, 0, 0}), up = Rotate(pose.orientation, {0, 1, 0}),
             ahead = Rotate(pose.orientation, {0, 0, -1});
  const float slope_y = share * Tangent(pose.vertical_fov_deg), slope_x = slope_y * aspect;
  for (const float y : {-0.5f, 0.5f}) {
    const Vec3 away = at + Vec3{0, y * body.height_m, 0} - pose.position;
    const float depth = Dot(away, ahead);
    if (depth < 1 || std::abs(Dot(away, right)) > slope_x * depth || std::abs(Dot(away, up)) > slope_y * depth)
      return false;
  }
  return true;
}

/// The present positions of all bodies, and their expected positions after kRoom_s.
std::vector<FramedBody> WithRoom(std::span<const FramedBody> bodies) {
  std::vector<FramedBody> all(bodies.begin(), bodies.end());
  for (const FramedBody& body : bodies) {
    FramedBody& later = all.emplace_back(body);
    later.position += Vec3{body.velocity.x, 0, body.velocity.z} * kRoom_s;
  }
  return all;
}

/// Leaves out bodies that are so far away that the others would be tiny. The ones nearest to the centre of all are
/// kept.
std::vector<FramedBody> WithinReach(std::span<const FramedBody> bodies, const CameraSnapshot& goal, float aspect) {
  std::vector<FramedBody> kept(bodies.begin(), bodies.end());
  const auto reaches = [&](std::size_t count) {
    const std::span<const FramedBody> some(kept.data(), count);
    const CameraSnapshot pose = FramingPose(some, goal.orientation, goal.vertical_fov_deg, aspect);
    return world::Distance(pose.position, Middle(some)) <= kFurthest_m;
  };
  if (reaches(kept.size())) return kept;
  Vec3 mean;
  for (const FramedBody& body : kept) mean += body.position * (1 / static_cast<float>(kept.size()));
  std::stable_sort(kept.begin(), kept.end(), [&](const FramedBody& a, const FramedBody& b) {
    return world::Distance(a.position, mean) < world::Distance(b.position, mean);
  });
  std::size_t fits = 1, too_many = kept.size();
  while (too_many - fits > 1) {
    const std::size_t half = (fits + too_many) / 2;
    (reaches(half) ? fits : too_many) = half;
  }
  kept.resize(fits);
  return kept;
}

/// An orientation that suits a view of a scene: not along the ground, and straight down only on a map.
Quat Comfortable(Quat orientation) {
  const Vec3 ahead = Rotate(orientation, {0, 0, -1});
  if (ahead.y < -0.999f) return orientation;
  const float pitch = std::clamp(std::asin(std::clamp(ahead.y, -1.0f, 1.0f)), -1.05f, -0.42f);
  const float yaw = std::atan2(-ahead.x, -ahead.z);
  const Quat turn{std::cos(yaw / 2), 0, std::sin(yaw / 2), 0}, tilt{std::cos(pitch / 2), std::sin(pitch / 2), 0, 0};
  return world::Normalized(turn * tilt);
}

/// The corners of the base of a box or a figure; empty for other things and parts of the landscape.
std::vector<FramedBody> CornersOf(const world::DrawableSnapshot& drawable) {
  const Vec3 at = drawable.position;
  if (drawable.belongs_to_agent || !drawable.visible || !world::IsFinite(at)) return {};
  if (drawable.shape == world::ShapeKind::kMesh && world::FindBodyMesh(drawable.mesh.value()) != nullptr)
    return {{at + Vec3{0, 0.9f, 0}, {}, 0.5f, 1.8f}};
  if (drawable.shape != world::ShapeKind::kBox) return {};
  const Vec3 size{drawable.size.x * drawable.scale.x, drawable.size.y * drawable.scale.y,
                  drawable.size.z * drawable.scale.z};
  if (std::max({size.x, size.y, size.z}) > kLongestPiece_m) return {};
  std::vector<FramedBody> corners;
  for (const float x : {-0.5f, 0.5f})
    for (const float z : {-0.5f, 0.5f})
      corners.push_back({at + Rotate(drawable.orientation, {x * size.x, 0, z * size.z}), {}, 0.1f, size.y});
  return corners;
}

}  // namespace

CameraSnapshot FramingPose(std::span<const FramedBody> bodies, Quat orientation, float vertical_fov_deg, float aspect) {
  // A margin at the sides, for labels and the window's bars.
  const float slope_y = 0.80f * Tangent(vertical_fov_deg);
  const float slope_x = 0.86f * Tangent(vertical_fov_deg) * std::max(aspect, 0.2f);
  const Vec3 right = Rotate(orientation, {1, 0, 0}), up = Rotate(orientation, {0, 1, 0}),
             ahead = Rotate(orientation, {0, 0, -1});
  // For each direction, each point keeps the camera behind two planes; the outermost planes determine its place.
  float to_right = -1e9f, to_left = -1e9f, to_top = -1e9f, to_bottom = -1e9f, nearest = 1e9f;
  for (const FramedBody& body : bodies) {
    for (const float y : {-0.5f, 0.5f}) {
      const Vec3 at = body.position + Vec3{0, y * body.height_m, 0};
      const float x = Dot(at, right), z = Dot(at, ahead), reach = 2 * body.radius_m;
      to_right = std::max(to_right, x + reach - z * slope_x);
      to_left = std::max(to_left, reach - x - z * slope_x);
      to_top = std::max(to_top, Dot(at, up) + reach - z * slope_y);
      to_bottom = std::max(to_bottom, reach - Dot(at, up) - z * slope_y);
      nearest = std::min(nearest, z);
    }
  }
  constexpr float kAway_m = 6.5f;  // A single agent must not fill the window.
  const float depth =
      std::min({-(to_right + to_left) / (2 * slope_x), -(to_top + to_bottom) / (2 * slope_y), nearest - kAway_m});
  const float x = (to_right - to_left) / 2, y = (to_top - to_bottom) / 2;
  CameraSnapshot pose;
  pose.position = right * x + up * y + ahead * depth;
  pose.orientation = orientation;
  pose.vertical_fov_deg = vertical_fov_deg;
  return pose;
}

void RecentGround::Note(std::span<const FramedBody> agents, float seconds) {
  for (Span& span : spans_) span.age_s += seconds;
  while (!spans_.empty() && spans_.front().age_s > kRecent_s) spans_.pop_front();
  if (agents.empty()) return;
  if (spans_.empty() || spans_.back().age_s > kRecentStep_s)
    spans_.push_back({agents.front().position, agents.front().position});
  for (const FramedBody& agent : agents) {
    spans_.back().low = Lowest(spans_.back().low, agent.position);
    spans_.back().high = Highest(spans_.back().high, agent.position);
  }
}

void RecentGround::AddTo(std::vector<FramedBody>& bodies) const {
  if (spans_.empty()) return;
  Vec3 low = spans_.front().low, high = spans_.front().high;
  for (const Span& span : spans_) {
    low = Lowest(low, span.low);
    high = Highest(high, span.high);
  }
  for (const float x : {low.x, high.x})
    for (const float z : {low.z, high.z}) bodies.push_back({.position = {x, low.y, z}, .velocity = {}});
}

std::vector<FramedBody> WithPlaces(std::span<const FramedBody> agents, std::span<const Vec3> places, Quat orientation,
                                   float vertical_fov_deg, float aspect, std::span<const FramedBody> scenery) {
  std::vector<FramedBody> all(agents.begin(), agents.end());
  if (agents.empty()) return all;
  const Vec3 middle = Middle(agents);
  std::vector<Vec3> nearest(places.begin(), places.end());
  std::stable_sort(nearest.begin(), nearest.end(),
                   [&](Vec3 a, Vec3 b) { return world::Distance(a, middle) < world::Distance(b, middle); });
  for (const Vec3 place : nearest) {
    if (!world::IsFinite(place)) continue;
    all.push_back({place + Vec3{0, kPlaceHeight_m / 2, 0}, {}, kPlaceRadius_m, kPlaceHeight_m});
    const CameraSnapshot pose = FramingPose(all, orientation, vertical_fov_deg, aspect);
    if (world::Distance(pose.position, Middle(all)) > kPlacesWithin_m) all.pop_back();
  }
  if (scenery.empty()) return all;
  const std::size_t without = all.size();
  all.insert(all.end(), scenery.begin(), scenery.end());
  const CameraSnapshot pose = FramingPose(all, orientation, vertical_fov_deg, aspect);
  if (world::Distance(pose.position, Middle(all)) > kSceneryWithin_m) all.resize(without);
  return all;
}

std::vector<FramedBody> SceneryAround(const world::SceneSnapshot& scene, std::span<const Vec3> places) {
  Vec3 low{1e9f, 1e9f, 1e9f}, high = low * -1;
  const auto reach = [&](Vec3 at) {
    low = Lowest(low, at);
    high = Highest(high, at);
  };
  for (const world::AgentSnapshot& agent : scene.agents)
    if (world::IsFinite(agent.position)) reach(agent.position);
  for (const Vec3 place : places)
    if (world::IsFinite(place)) reach(place);
  std::vector<FramedBody> found;
  if (low.x > high.x) return found;
  std::vector<std::vector<FramedBody>> pieces;
  for (const world::DrawableSnapshot& drawable : scene.drawables) {
    if (std::vector<FramedBody> corners = CornersOf(drawable); !corners.empty()) pieces.push_back(std::move(corners));
    if (pieces.size() > kMostPieces) return found;
  }
  // Things next to something in the picture are added, too.
  for (bool grows = true; grows;) {
    grows = false;
    for (std::vector<FramedBody>& piece : pieces) {
      const bool is_near = std::ranges::any_of(piece, [&](const FramedBody& corner) {
        return corner.position.x > low.x - kBeside_m && corner.position.x < high.x + kBeside_m &&
               corner.position.z > low.z - kBeside_m && corner.position.z < high.z + kBeside_m;
      });
      if (!is_near) continue;
      for (const FramedBody& corner : piece) reach(corner.position);
      found.insert(found.end(), piece.begin(), piece.end());
      piece.clear();
      grows = true;
    }
  }
  return found;
}

std::optional<CameraSnapshot> CameraKeeper::Follow(std::span<const FramedBody> agents, std::span<const Vec3> places,
                                                   const CameraSnapshot& goal, float aspect, float seconds,
                                                   std::span<const FramedBody> scenery) {
  if (agents.empty()) return std::nullopt;
  const std::vector<FramedBody> kept = WithinReach(agents, goal, aspect);
  const Quat orientation = Comfortable(goal.orientation);
  const auto frame = [&] {
    const std::vector<FramedBody> all =
        WithPlaces(WithRoom(kept), places, orientation, goal.vertical_fov_deg, aspect, scenery);
    CameraSnapshot pose = FramingPose(all, orientation, goal.vertical_fov_deg, aspect);
    pose.position.y = std::max(pose.position.y, 0.5f);
    return pose;
  };
  const bool all_stay = std::all_of(kept.begin(), kept.end(), [&](const FramedBody& body) {
    const Vec3 later = body.position + Vec3{body.velocity.x, 0, body.velocity.z} * kSoon_s;
    return IsInside(body, body.position, goal, aspect, kInside) && IsInside(body, later, goal, aspect, kInside);
  });
  if (!all_stay) {
    wide_s_ = 0;
    return frame();
  }
  const CameraSnapshot near = frame();
  const Vec3 middle = Middle(kept);
  const bool is_wide = world::Distance(near.position, middle) < kTooWide * world::Distance(goal.position, middle);
  wide_s_ = is_wide ? wide_s_ + seconds : 0;
  if (wide_s_ < kWideFor_s) return std::nullopt;
  wide_s_ = 0;
  return near;
}

}  // namespace soarbox::viewer
