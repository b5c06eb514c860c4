// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "viewer/half_turn.h"
#include "viewer/interpolate.h"

namespace soarbox::viewer {
namespace {

using world::CameraSnapshot;
using world::Quat;
using world::Vec3;

constexpr float kRadiansPerPixel = 0.15f * kPi / 180;
constexpr float kFastFactor = 20;
constexpr float kSpeed_mps = 5;
constexpr float kSteepest = 0.996f;  // Sine of the steepest look up or down.
constexpr float kGlide_s = 0.45f;
constexpr float kUsualFov_deg = 45, kEyesFov_deg = 70, kMapFov_deg = 30;
constexpr float kNearest_m = 1.5f, kFurthestEye_m = 600;

Quat About(Vec3 axis, float angle) {
  const float s = std::sin(angle / 2);
  return {std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s};
}

/// The orientation with this heading (0: -z) and this pitch down.
Quat Looking(float yaw, float pitch) {
  return world::Normalized(About({0, 1, 0}, yaw) * About({1, 0, 0}, pitch));
}

float YawOf(Quat q) {
  Vec3 ahead = Rotate(q, {0, 0, -1});
  // Straight down: the top of the picture defines the heading.
  if (std::abs(ahead.y) > 0.999f) ahead = Rotate(q, {0, ahead.y < 0 ? 1.0f : -1.0f, 0});
  return std::atan2(-ahead.x, -ahead.z);
}

float PitchOf(Quat q) {
  return std::asin(std::clamp(Rotate(q, {0, 0, -1}).y, -1.0f, 1.0f));
}

Vec3 MiddleOf(const world::AgentSnapshot& agent) {
  return agent.position + Vec3{0, 0.3f, 0};
}

Vec3 EyesOf(const world::AgentSnapshot& agent) {
  return agent.position + Vec3{0, agent.height_m * 0.42f, 0};
}

const Quat kDown = Looking(0, -kPi / 2);

}  // namespace

void CameraRig::MoveTo(const CameraSnapshot& pose) {
  if (!world::IsFinite(pose.position) || !world::IsFinite(pose.orientation)) return;
  pose_ = pose;
  pose_.orientation = world::Normalized(pose.orientation);
  pose_.vertical_fov_deg =
      std::clamp(std::isfinite(pose.vertical_fov_deg) ? pose.vertical_fov_deg : kUsualFov_deg, 5.0f, 150.0f);
  shown_ = pose_;
  velocity_ = {};
  drift_ = {};
  mode_ = CameraMode::kFree;
  on_the_way_ = 1;
  keeps_ = false;
}

void CameraRig::BeginKeeping() {
  if (mode_ != CameraMode::kFree && mode_ != CameraMode::kMap) return;
  if (!keeps_) drift_ = {};
  keeps_ = true;
  keeper_.Begin();
}

void CameraRig::Keep(std::span<const FramedBody> agents, std::span<const Vec3> places, float aspect, float seconds,
                     std::span<const FramedBody> scenery) {
  if (!keeps_) return;
  const auto goal = keeper_.Follow(agents, places, pose_, aspect, seconds, scenery);
  if (!goal) return;
  pose_ = *goal;
  if (mode_ == CameraMode::kMap) {
    distance_ = std::clamp(goal->position.y, 25.0f, kFurthestEye_m);
    pivot_ = {goal->position.x, 0, goal->position.z};
    pose_.position = pivot_ + Vec3{0, distance_, 0};
  }
}

void CameraRig::StopKeeping() {
  if (!keeps_) return;
  keeps_ = false;
  velocity_ = drift_ = {};
  on_the_way_ = 1;
  pose_ = shown_;
  if (mode_ != CameraMode::kMap) return;
  pivot_ = {shown_.position.x, 0, shown_.position.z};
  distance_ = std::clamp(shown_.position.y, 5.0f, kFurthestEye_m);
}

void CameraRig::Approach(float seconds) {
  // A critically damped spring, solved exactly: the same at any frame rate.
  constexpr float kPull = 2.6f;
  const Vec3 away = shown_.position - pose_.position;
  const Vec3 step = (drift_ + away * kPull) * seconds;
  const float fade = std::exp(-kPull * seconds);
  shown_.position = pose_.position + (away + step) * fade;
  drift_ = (drift_ - step * kPull) * fade;
  const float turn = 1 - std::exp(-4 * seconds);
  shown_.orientation = BetweenOrientations(shown_.orientation, pose_.orientation, turn);
  shown_.vertical_fov_deg += (pose_.vertical_fov_deg - shown_.vertical_fov_deg) * turn;
  const float off = std::abs(Dot(Rotate(shown_.orientation, {0, 0, -1}), Rotate(pose_.orientation, {0, 0, -1})));
  const bool is_there = world::LengthSquared(shown_.position - pose_.position) < 4e-6f &&
                        world::LengthSquared(drift_) < 4e-6f && off > 1 - 1e-6f;
  if (!is_there) return;
  shown_ = pose_;
  drift_ = {};
}

std::uint32_t CameraRig::agent() const {
  return mode_ == CameraMode::kFollow || mode_ == CameraMode::kEyes ? agent_ : 0;
}

void CameraRig::Glide() {
  from_ = shown_;
  on_the_way_ = 0;
  velocity_ = {};
}

void CameraRig::Arrive() {
  on_the_way_ = 1;
  shown_ = pose_;
  drift_ = {};
}

float CameraRig::Reach() const {
  if (mode_ != CameraMode::kFree) return distance_;
  return ReachAlong(Rotate(pose_.orientation, {0, 0, -1}));
}

float CameraRig::ReachAlong(Vec3 way) const {
  const float reach = way.y < -0.02f && pose_.position.y > 0 ? pose_.position.y / -way.y : 30;
  return std::clamp(reach, 2.0f, 120.0f);
}

void CameraRig::Zoom(const CameraInput& input, float nearest_m) {
  const float before = distance_;
  distance_ = std::clamp(distance_ * std::pow(0.88f, input.wheel), nearest_m, kFurthestEye_m);
  if (input.wheel == 0 || input.towards == Vec3{} || mode_ == CameraMode::kFollow) return;
  // The point under the cursor at the height of the pivot stays at its place.
  const Vec3 way = input.towards;
  const float fall = pose_.position.y - pivot_.y;
  if (!(way.y < -0.05f) || !(fall > 0)) return;
  const Vec3 under = pose_.position + way * (fall / -way.y);
  if (world::Distance(under, pivot_) < 4 * before) pivot_ += (under - pivot_) * (1 - distance_ / before);
}

bool CameraRig::SetMode(CameraMode mode, const world::AgentSnapshot* agent) {
  const bool needs_agent = mode == CameraMode::kFollow || mode == CameraMode::kEyes;
  if (needs_agent && agent == nullptr) return false;
  if (mode == mode_ && (!needs_agent || agent->id == agent_)) {
    StopKeeping();
    return true;
  }
  Glide();
  keeps_ = false;
  const CameraMode before = mode_;
  const float reach = Reach();
  if (agent != nullptr) agent_ = agent->id;
  if (before == CameraMode::kMap || before == CameraMode::kEyes) pose_.vertical_fov_deg = kUsualFov_deg;
  const float yaw = before == CameraMode::kMap ? 0 : YawOf(shown_.orientation);
  const bool is_level = before == CameraMode::kEyes || before == CameraMode::kMap;
  switch (mode) {
    case CameraMode::kFree:
      if (is_level) {
        // When leaving the agent's eyes or the map: start a little behind and above the last view.
        pose_.orientation = Looking(yaw, -0.5f);
        const Vec3 middle = before == CameraMode::kMap ? pivot_ : pose_.position;
        const float away = before == CameraMode::kMap ? distance_ * 0.6f : 9;
        pose_.position = middle - Rotate(pose_.orientation, {0, 0, -1}) * away;
      }
      break;
    case CameraMode::kOrbit:
    case CameraMode::kFollow: {
      // A body cannot be seen from ground level, so start a little above it.
      const float pitch = is_level ? -0.45f : std::clamp(PitchOf(shown_.orientation), -1.3f, -0.2f);
      pose_.orientation = Looking(yaw, pitch);
      pivot_ = agent != nullptr ? MiddleOf(*agent) : pose_.position + Rotate(shown_.orientation, {0, 0, -1}) * reach;
      if (agent == nullptr) {
        pivot_.y = std::clamp(pivot_.y, 0.0f, 3.0f);
        distance_ = std::max(reach, 4.0f);
      } else {
        distance_ = std::clamp(world::Distance(pivot_, shown_.position), 4.0f, 12.0f);
      }
      break;
    }
    case CameraMode::kEyes:
      look_yaw_ = look_pitch_ = 0;
      pose_.vertical_fov_deg = kEyesFov_deg;
      break;
    case CameraMode::kMap: {
      const bool has_pivot = before == CameraMode::kOrbit || before == CameraMode::kFollow;
      const Vec3 below = has_pivot ? pivot_ : pose_.position + Rotate(shown_.orientation, {0, 0, -1}) * reach;
      pivot_ = before == CameraMode::kEyes ? pose_.position : below;
      pivot_.y = 0;
      distance_ = std::clamp(1.6f * reach, 25.0f, kFurthestEye_m);
      pose_.orientation = kDown;
      pose_.vertical_fov_deg = kMapFov_deg;
      break;
    }
  }
  mode_ = mode;
  return true;
}

void CameraRig::Frame(std::span<const world::AgentSnapshot* const> agents, float aspect, bool best_side,
                      std::span<const Vec3> places, bool from_above, std::span<const FramedBody> scenery) {
  if (agents.empty()) return;
  Glide();
  std::vector<FramedBody> bodies;
  for (const world::AgentSnapshot* agent : agents)
    bodies.push_back({agent->position, {}, agent->radius_m, agent->height_m});
  const auto pose_from = [&](Quat orientation, float fov_deg) {
    return FramingPose(WithPlaces(bodies, places, orientation, fov_deg, aspect, scenery), orientation, fov_deg, aspect);
  };
  Vec3 low = agents.front()->position, high = low;
  for (const FramedBody& body : bodies) {
    const Vec3 p = body.position;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 middle = (low + high) * 0.5f;
  if (mode_ == CameraMode::kMap) {
    const CameraSnapshot pose = pose_from(kDown, kMapFov_deg);
    pivot_ = {pose.position.x, 0, pose.position.z};
    distance_ = std::clamp(pose.position.y, 25.0f, kFurthestEye_m);
    return;
  }
  if (mode_ == CameraMode::kFollow && agents.size() == 1 && agents.front()->id == agent_) {
    distance_ = 6.5f;
    return;
  }
  if (mode_ == CameraMode::kFollow || mode_ == CameraMode::kEyes) {
    mode_ = CameraMode::kFree;
    pose_.vertical_fov_deg = kUsualFov_deg;
  }
  const float fov = pose_.vertical_fov_deg;
  const float pitch = from_above ? -1.05f : std::clamp(PitchOf(shown_.orientation), -1.05f, -0.42f);
  CameraSnapshot best = pose_from(Looking(YawOf(shown_.orientation), pitch), fov);
  constexpr int kSides = 12;
  for (int side = 0; best_side && side < kSides; ++side) {
    // Chooses the side from which the camera is nearest. A later side must be clearly better than an earlier one.
    const CameraSnapshot pose = pose_from(Looking(2 * kPi * static_cast<float>(side) / kSides, pitch), fov);
    if (world::Distance(pose.position, middle) < 0.93f * world::Distance(best.position, middle)) best = pose;
  }
  best.position.y = std::max(best.position.y, 0.5f);
  pose_ = best;
  pivot_ = middle;
  distance_ = std::clamp(world::Distance(middle, best.position), kNearest_m, kFurthestEye_m);
}

void CameraRig::GoTo(Vec3 way) {
  constexpr float kFurthestClick_m = 400;
  if (!(way.y < -0.02f) || !(shown_.position.y > 0)) return;
  const float away = shown_.position.y / -way.y;
  if (away > kFurthestClick_m || mode_ == CameraMode::kEyes) return;
  Glide();
  keeps_ = false;
  if (mode_ == CameraMode::kFollow) mode_ = CameraMode::kOrbit;
  pivot_ = shown_.position + way * away;
  if (mode_ != CameraMode::kFree) {
    distance_ = std::clamp(0.6f * distance_, mode_ == CameraMode::kMap ? 25.0f : 6.0f, kFurthestEye_m);
    return;
  }
  distance_ = std::clamp(0.5f * away, std::min(away, 6.0f), 40.0f);
  pose_.position = pivot_ - Rotate(pose_.orientation, {0, 0, -1}) * distance_;
  pose_.position.y = std::max(pose_.position.y, 0.5f);
}

void CameraRig::Turn(float dx, float dy) {
  pose_.orientation = About({0, 1, 0}, -dx * kRadiansPerPixel) * pose_.orientation;
  const Quat tilted = pose_.orientation * About({1, 0, 0}, -dy * kRadiansPerPixel);
  const float before = Rotate(pose_.orientation, {0, 0, -1}).y, after = Rotate(tilted, {0, 0, -1}).y;
  if (std::abs(after) < kSteepest || std::abs(after) < std::abs(before)) pose_.orientation = tilted;
  pose_.orientation = world::Normalized(pose_.orientation);
}

void CameraRig::Fly(const CameraInput& input, float seconds) {
  if (input.looking) Turn(input.mouse_dx, input.mouse_dy);
  const Quat q = pose_.orientation;
  if (input.wheel != 0) {
    // The point under the cursor stays at its place.
    const Vec3 way = input.towards != Vec3{} ? input.towards : Rotate(q, {0, 0, -1});
    pose_.position += way * (ReachAlong(way) * (1 - std::pow(0.88f, input.wheel)));
    pose_.position.y = std::max(pose_.position.y, 0.2f);
  }
  const Vec3 wish = world::Normalized(Rotate(q, {-input.left, input.up, -input.forward}));
  const Vec3 wanted = wish * kSpeed_mps * (input.fast ? kFastFactor : 1.0f);
  // The same exponential approach starts and stops the camera at any frame rate.
  const float keep = std::exp(-10 * seconds);
  velocity_ = wanted + (velocity_ - wanted) * keep;
  const bool moves = input.forward != 0 || input.left != 0 || input.up != 0;
  if (!moves && world::LengthSquared(velocity_) < 1e-6f) velocity_ = {};
  pose_.position += velocity_ * seconds;
}

void CameraRig::Circle(const CameraInput& input, float seconds, float) {
  if (input.looking) Turn(input.mouse_dx, input.mouse_dy);
  Zoom(input, kNearest_m);
  if (mode_ == CameraMode::kOrbit) {
    const float yaw = YawOf(pose_.orientation);
    const float speed = distance_ * (input.fast ? 3.0f : 0.8f);
    pivot_ += Rotate(Looking(yaw, 0), world::Normalized(Vec3{-input.left, input.up, -input.forward})) * speed * seconds;
  }
  pose_.position = pivot_ - Rotate(pose_.orientation, {0, 0, -1}) * distance_;
  pose_.position.y = std::max(pose_.position.y, 0.3f);
}

void CameraRig::Look(const CameraInput& input, float seconds, const world::AgentSnapshot& agent) {
  if (input.looking) {
    look_yaw_ -= input.mouse_dx * kRadiansPerPixel;
    look_pitch_ = std::clamp(look_pitch_ - input.mouse_dy * kRadiansPerPixel, -1.2f, 1.2f);
  }
  pose_.vertical_fov_deg = std::clamp(pose_.vertical_fov_deg * std::pow(0.92f, input.wheel), 20.0f, 100.0f);
  const float yaw = std::atan2(-agent.forward.x, -agent.forward.z);
  const Quat wanted = Looking(yaw + look_yaw_, -0.04f + look_pitch_);
  // A head turns smoothly and does not jump.
  const float turn = on_the_way_ < 1 || input.looking ? 1.0f : 1 - std::exp(-12 * seconds);
  pose_.orientation = BetweenOrientations(pose_.orientation, wanted, turn);
  const Vec3 ahead = world::Normalized(Vec3{agent.forward.x, 0, agent.forward.z});
  pose_.position = EyesOf(agent) + ahead * (0.5f * agent.radius_m);
}

void CameraRig::Hover(const CameraInput& input, float seconds, float height_px) {
  Zoom(input, 5);
  const float metres_per_px = 2 * distance_ * std::tan(pose_.vertical_fov_deg * kPi / 360) / height_px;
  if (input.looking) pivot_ += Vec3{-input.mouse_dx, 0, -input.mouse_dy} * metres_per_px;
  const float speed = distance_ * (input.fast ? 2.0f : 0.5f);
  pivot_ += world::Normalized(Vec3{-input.left, 0, -input.forward}) * speed * seconds;
  distance_ = std::clamp(distance_ * std::pow(2.0f, input.up * seconds), 5.0f, kFurthestEye_m);
  pose_.orientation = kDown;
  pose_.position = pivot_ + Vec3{0, distance_, 0};
}

void CameraRig::Update(const CameraInput& input, float seconds, const world::AgentSnapshot* agent, float height_px) {
  seconds = std::clamp(seconds, 0.0f, 0.1f);
  const bool steers = input.forward != 0 || input.left != 0 || input.up != 0 || input.panning;
  const bool turns = input.looking && (input.mouse_dx != 0 || input.mouse_dy != 0);
  const bool drags = input.panning && (input.mouse_dx != 0 || input.mouse_dy != 0);
  if (turns || drags || input.wheel != 0 || input.forward != 0 || input.left != 0 || input.up != 0) StopKeeping();
  const bool needs_agent = mode_ == CameraMode::kFollow || mode_ == CameraMode::kEyes;
  if (needs_agent && agent == nullptr) SetMode(CameraMode::kFree, nullptr);
  if (mode_ == CameraMode::kFollow && steers) SetMode(input.panning ? CameraMode::kOrbit : CameraMode::kFree, nullptr);
  if (mode_ == CameraMode::kEyes && steers) SetMode(CameraMode::kFree, nullptr);
  if (input.panning && mode_ != CameraMode::kMap) {
    const float metres_per_px = 2 * Reach() * std::tan(pose_.vertical_fov_deg * kPi / 360) / height_px;
    const Vec3 shift = Rotate(pose_.orientation, {-input.mouse_dx, input.mouse_dy, 0}) * metres_per_px;
    pose_.position += shift;
    pivot_ += shift;
    pose_.position.y = std::max(pose_.position.y, 0.2f);
  }
  switch (mode_) {
    case CameraMode::kFree:
      Fly(input, seconds);
      break;
    case CameraMode::kFollow:
      pivot_ = MiddleOf(*agent);
      [[fallthrough]];
    case CameraMode::kOrbit:
      Circle(input, seconds, height_px);
      break;
    case CameraMode::kEyes:
      Look(input, seconds, *agent);
      break;
    case CameraMode::kMap: {
      CameraInput held = input;
      held.looking = input.looking || input.panning;
      Hover(held, seconds, height_px);
      break;
    }
  }
  if (keeps_) return Approach(seconds);
  if (on_the_way_ >= 1) {
    shown_ = pose_;
    return;
  }
  on_the_way_ = std::min(1.0f, on_the_way_ + seconds / kGlide_s);
  const float way = on_the_way_ * on_the_way_ * (3 - 2 * on_the_way_);
  shown_.position = from_.position + (pose_.position - from_.position) * way;
  shown_.orientation = BetweenOrientations(from_.orientation, pose_.orientation, way);
  shown_.vertical_fov_deg = from_.vertical_fov_deg + (pose_.vertical_fov_deg - from_.vertical_fov_deg) * way;
}

}  // namespace soarbox::viewer
