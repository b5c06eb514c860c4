// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/body_bones.h"

#include <mutex>
#include <utility>

#include "world/animation/pose.h"

namespace soarbox::world {

struct BodyBones::Held {
  Held(Pose from, std::vector<BonePose> given) : pose(std::move(from)), bones(std::move(given)) {}

  Pose pose;  ///< If it has no rig, the bones were given.
  mutable std::once_flag worked_out;
  mutable std::vector<BonePose> bones;
};

BodyBones::BodyBones(std::vector<BonePose> bones) {
  if (!bones.empty()) held_ = std::make_shared<const Held>(Pose{}, std::move(bones));
}

BodyBones::BodyBones(Pose pose) : held_(std::make_shared<const Held>(std::move(pose), std::vector<BonePose>{})) {}

const std::vector<BonePose>& BodyBones::value() const {
  static const std::vector<BonePose> kNone;
  if (held_ == nullptr) return kNone;
  const Held& held = *held_;
  if (held.pose.rig != nullptr) std::call_once(held.worked_out, [&held] { held.pose.WorkOut(held.bones); });
  return held.bones;
}

const Pose* BodyBones::pose() const {
  return held_ == nullptr || held_->pose.rig == nullptr ? nullptr : &held_->pose;
}

}  // namespace soarbox::world
