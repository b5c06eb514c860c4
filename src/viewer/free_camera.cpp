// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/free_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soarbox::viewer {
namespace {

using world::Quat;
using world::Vec3;

constexpr float kRadiansPerPixel = 0.15f * std::numbers::pi_v<float> / 180.0f;
constexpr float kFastFactor = 20;
constexpr float kSteepest = 0.996f;  // Sine of the steepest look up or down.

Quat About(Vec3 axis, float angle) {
  const float s = std::sin(angle / 2);
  return {std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s};
}

Quat Unit(Quat q) {
  const float length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return length > 0 ? Quat{q.w / length, q.x / length, q.y / length, q.z / length} : Quat{};
}

}  // namespace

void FreeCamera::MoveTo(const world::CameraSnapshot& pose) {
  const float number = pose.position.x + pose.position.y + pose.position.z + pose.orientation.w + pose.orientation.x +
                       pose.orientation.y + pose.orientation.z;
  if (!std::isfinite(number)) return;
  pose_ = pose;
  pose_.orientation = Unit(pose.orientation);
  pose_.vertical_fov_deg =
      std::clamp(std::isfinite(pose.vertical_fov_deg) ? pose.vertical_fov_deg : 45.0f, 5.0f, 150.0f);
  velocity_ = {};
  following_ = false;
}

void FreeCamera::Turn(float dx, float dy) {
  pose_.orientation = About({0, 1, 0}, -dx * kRadiansPerPixel) * pose_.orientation;
  const Quat tilted = pose_.orientation * About({1, 0, 0}, -dy * kRadiansPerPixel);
  const float before = Rotate(pose_.orientation, {0, 0, -1}).y, after = Rotate(tilted, {0, 0, -1}).y;
  if (std::abs(after) < kSteepest || std::abs(after) < std::abs(before)) pose_.orientation = tilted;
  pose_.orientation = Unit(pose_.orientation);
}

void FreeCamera::Update(const CameraInput& input, float seconds) {
  seconds = std::clamp(seconds, 0.0f, 0.1f);
  if (input.looking) Turn(input.mouse_dx, input.mouse_dy);
  const bool moves = input.forward != 0 || input.left != 0 || input.up != 0;
  if (following_ && moves) following_ = false;
  if (following_) {
    distance_ = std::clamp(distance_ * std::pow(0.88f, input.wheel), 1.5f, 200.0f);
    return;
  }
  speed_ = std::clamp(speed_ * std::pow(1.2f, input.wheel), 0.5f, 100.0f);

  const Quat q = pose_.orientation;
  const Vec3 wish = world::Normalized(Rotate(q, {-input.left, input.up, -input.forward}));
  const Vec3 wanted = wish * speed_ * (input.fast ? kFastFactor : 1.0f);
  // The same exponential approach starts and stops the camera, whatever the frame rate.
  const float keep = std::exp(-10 * seconds);
  velocity_ = wanted + (velocity_ - wanted) * keep;
  if (!moves && world::LengthSquared(velocity_) < 1e-6f) velocity_ = {};
  pose_.position += velocity_ * seconds;
}

void FreeCamera::Follow(Vec3 target) {
  if (!following_) {
    distance_ = std::clamp(world::Distance(target, pose_.position), 4.0f, 12.0f);
    // From the ground up, a body is not to be seen; begin a little above it.
    if (forward().y > -0.15f) {
      const Vec3 flat = world::Normalized(Vec3{forward().x, 0, forward().z});
      const float yaw = std::atan2(-flat.x, -flat.z);
      pose_.orientation = Unit(About({0, 1, 0}, yaw) * About({1, 0, 0}, -0.35f));
    }
    velocity_ = {};
  }
  following_ = true;
  target_ = target;
  pose_.position = target_ - forward() * distance_;
  pose_.position.y = std::max(pose_.position.y, 0.3f);
}

}  // namespace soarbox::viewer
