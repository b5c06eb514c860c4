// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

struct Pose;

/// The bones of one body as it is drawn: their poses in its mesh, by index. If they come from a Pose, they are computed
/// on first use. Immutable, so that copies share them, on any thread.
class BodyBones {
 public:
  BodyBones() = default;
  /// Implicit, so that it can be used like a vector.
  BodyBones(std::vector<BonePose> bones);
  explicit BodyBones(Pose pose);

  const std::vector<BonePose>& value() const;
  operator const std::vector<BonePose>&() const { return value(); }
  /// Whether the body has no skeleton.
  bool empty() const { return held_ == nullptr; }
  std::size_t size() const { return value().size(); }
  const BonePose& operator[](std::size_t index) const { return value()[index]; }
  /// The pose from which the bones are computed; null if the bones were given.
  const Pose* pose() const;
  /// Whether both share the same memory and are therefore equal.
  bool IsSame(const BodyBones& other) const { return held_ == other.held_; }

 private:
  struct Held;
  std::shared_ptr<const Held> held_;  ///< Null if empty.
};

}  // namespace soarbox::world
