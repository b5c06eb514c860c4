// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// The bones of a body: a tree in which each bone comes after its parent. All bodies of one kind share it; it never
/// changes after it was built.
class Skeleton {
 public:
  struct Bone {
    std::string name;
    int parent = -1;  ///< -1: the model itself.
    BonePose bind;    ///< Relative to the parent, in the pose that the mesh is built in.
  };

  /// Adds a bone whose bind pose is given relative to the model; returns its index. The parent must be there already.
  int Add(std::string name, int parent, const BonePose& bind_in_model);

  const std::vector<Bone>& bones() const { return bones_; }
  int count() const { return static_cast<int>(bones_.size()); }
  /// -1 if there is none of that name.
  int Find(std::string_view name) const;
  /// A bone's bind pose relative to the model.
  const BonePose& BindInModel(int bone) const { return bind_in_model_[static_cast<std::size_t>(bone)]; }

  /// Turns poses relative to parents into poses relative to the model.
  void ToModel(const std::vector<BonePose>& local, std::vector<BonePose>& model) const;

 private:
  std::vector<Bone> bones_;
  std::vector<BonePose> bind_in_model_;
};

}  // namespace soarbox::world
