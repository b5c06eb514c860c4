// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

struct Pose;

/// The bones of one body as it is shown: where they are in its mesh, by index. Those of a pose are worked out when
/// somebody first asks for them. Never changes once it is made, so all who hold it share it, on any thread.
class BodyBones {
 public:
  BodyBones() = default;
  /// Reads like the value itself.
  BodyBones(std::vector<BonePose> bones);
  explicit BodyBones(Pose pose);

  const std::vector<BonePose>& value() const;
  operator const std::vector<BonePose>&() const { return value(); }
  /// There are none: the body has no skeleton.
  bool empty() const { return held_ == nullptr; }
  std::size_t size() const { return value().size(); }
  const BonePose& operator[](std::size_t index) const { return value()[index]; }
  /// What they follow from; null: they are as they were given.
  const Pose* pose() const;
  /// They are one in memory, so they are equal without a comparison.
  bool IsSame(const BodyBones& other) const { return held_ == other.held_; }

 private:
  struct Held;
  std::shared_ptr<const Held> held_;  ///< Null: empty.
};

}  // namespace soarbox::world
