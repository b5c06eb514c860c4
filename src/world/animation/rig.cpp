// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/rig.h"

namespace soarbox::world {

int Rig::FindClip(std::string_view name) const {
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name() == name) return static_cast<int>(i);
  }
  return -1;
}

std::vector<std::string_view> Rig::ClipNames() const {
  std::vector<std::string_view> names;
  for (const Clip& clip : clips) names.emplace_back(clip.name());
  return names;
}

std::vector<std::string_view> Rig::BoneNames() const {
  std::vector<std::string_view> names;
  for (const Skeleton::Bone& bone : skeleton.bones()) names.emplace_back(bone.name);
  return names;
}

}  // namespace soarbox::world
