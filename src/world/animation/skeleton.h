// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// The bones of a body: a tree in which each bone comes after its parent. Shared by all bodies of one kind and
/// immutable after it was built.
class Skeleton {
 public:
  struct Bone {
    std::string name;
    int parent = -1;  ///< -1: the bone has no parent.
    BonePose bind;    ///< Relative to the parent, in the pose in which the mesh was modelled.
  };

  /// Adds a bone with its bind pose relative to the model; returns its index. The parent must exist.
  int Add(std::string name, int parent, const BonePose& bind_in_model);
  /// The same with the bind pose relative to the parent, which may have a scale.
  int AddToParent(std::string name, int parent, const BonePose& bind);

  const std::vector<Bone>& bones() const { return bones_; }
  int count() const { return static_cast<int>(bones_.size()); }
  /// Index of a bone; -1 if there is no bone of that name.
  int Find(std::string_view name) const;
  /// The bind pose of a bone relative to the model.
  const BonePose& BindInModel(int bone) const { return bind_in_model_[static_cast<std::size_t>(bone)]; }

  /// Converts poses relative to parents to poses relative to the model.
  void ToModel(const std::vector<BonePose>& local, std::vector<BonePose>& model) const;

 private:
  std::vector<Bone> bones_;
  std::vector<BonePose> bind_in_model_;
};

}  // namespace soarbox::world
