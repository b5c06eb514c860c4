// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/skeleton.h"

namespace soarbox::world {

int Skeleton::Add(std::string name, int parent, const BonePose& bind_in_model) {
  Bone bone;
  bone.name = std::move(name);
  bone.parent = parent;
  bone.bind = parent < 0 ? bind_in_model : Inverse(BindInModel(parent)) * bind_in_model;
  bones_.push_back(std::move(bone));
  bind_in_model_.push_back(bind_in_model);
  return count() - 1;
}

int Skeleton::AddToParent(std::string name, int parent, const BonePose& bind) {
  bind_in_model_.push_back(parent < 0 ? bind : BindInModel(parent) * bind);
  bones_.push_back({std::move(name), parent, bind});
  return count() - 1;
}

int Skeleton::Find(std::string_view name) const {
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    if (bones_[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

void Skeleton::ToModel(const std::vector<BonePose>& local, std::vector<BonePose>& model) const {
  model.resize(bones_.size());
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const int parent = bones_[i].parent;
    model[i] = parent < 0 ? local[i] : model[static_cast<std::size_t>(parent)] * local[i];
  }
}

}  // namespace soarbox::world
