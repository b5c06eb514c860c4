// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/rig.h"

#include <map>
#include <mutex>

#include "world/body_meshes.h"

namespace soarbox::world {
namespace {

struct KeptRigs {
  std::mutex mutex;
  std::map<std::string, Rig, std::less<>> by_model;  ///< Its elements keep their addresses.
};

KeptRigs& AllKeptRigs() {
  static KeptRigs rigs;
  return rigs;
}

}  // namespace

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

void KeepRig(Rig rig) {
  KeptRigs& rigs = AllKeptRigs();
  const std::scoped_lock lock(rigs.mutex);
  std::string key = rig.model;
  rigs.by_model.try_emplace(std::move(key), std::move(rig));
}

const Rig* FindRig(std::string_view model) {
  KeptRigs& rigs = AllKeptRigs();
  const std::scoped_lock lock(rigs.mutex);
  const auto found = rigs.by_model.find(model);
  return found == rigs.by_model.end() ? nullptr : &found->second;
}

const Rig& EmptyRig() {
  static const Rig rig;
  return rig;
}

const Rig* RigOfMesh(std::string_view mesh) {
  if (const BodyMesh* const body = FindBodyMesh(mesh)) return &body->rig();
  // Only keys of files have this mark.
  return mesh.find('#') == std::string_view::npos ? nullptr : FindRig(mesh);
}

std::vector<std::string_view> Rig::BoneNames() const {
  std::vector<std::string_view> names;
  for (const Skeleton::Bone& bone : skeleton.bones()) names.emplace_back(bone.name);
  return names;
}

}  // namespace soarbox::world
