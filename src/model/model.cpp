// SPDX-License-Identifier: BSD-2-Clause
#include "model/model.h"

#include <map>
#include <mutex>

#include "world/asset_store.h"
#include "world/state_hash.h"

namespace soarbox::model {
namespace {

struct Models {
  std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<const Model>> by_hash;
};

Models& AllModels() {
  static Models models;
  return models;
}

void AddFrame(world::StateHash& hash, const Frame& frame) {
  for (const world::Vec3& part : {frame.x, frame.y, frame.z, frame.place}) hash.Add(part);
}

void AddPose(world::StateHash& hash, const world::BonePose& pose) {
  hash.Add(pose.position);
  hash.Add(pose.orientation);
  hash.Add(pose.scale);
}

template <typename T>
void AddTrack(world::StateHash& hash, const world::BoneTrack<T>& track) {
  hash.Add(static_cast<std::uint64_t>(track.values.size()) * 2 + static_cast<std::uint64_t>(track.holds));
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    hash.Add(track.times_s[i]);
    hash.Add(track.values[i]);
  }
}

void AddMovement(world::StateHash& hash, const Model& model) {
  for (const CornerSkin& skin : model.skins) {
    hash.Add(skin.position);
    hash.Add(skin.normal);
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      hash.Add(static_cast<std::uint64_t>(skin.joints[i]));
      hash.Add(skin.weights[i]);
    }
  }
  for (const Joint& joint : model.joints) {
    hash.Add(static_cast<std::uint64_t>(joint.bone));
    AddFrame(hash, joint.inverse_bind);
  }
  for (const world::Skeleton::Bone& bone : model.rig.skeleton.bones()) {
    hash.Add(std::string_view(bone.name));
    hash.Add(static_cast<std::uint64_t>(bone.parent + 1));
    AddPose(hash, bone.bind);
  }
  for (const world::Clip& clip : model.rig.clips) {
    hash.Add(std::string_view(clip.name()));
    hash.Add(clip.length_s());
    for (const world::BoneMovement& movement : clip.movements()) {
      AddTrack(hash, movement.position);
      AddTrack(hash, movement.orientation);
      AddTrack(hash, movement.scale);
    }
  }
}

std::uint64_t HashOfModel(const Model& model) {
  world::StateHash hash;
  for (const Corner& corner : model.corners) {
    hash.Add(corner.position);
    hash.Add(corner.normal);
    hash.Add(corner.red, corner.green);
    hash.Add(corner.blue);
  }
  for (const std::uint32_t index : model.indices) hash.Add(static_cast<std::uint64_t>(index));
  if (model.moves()) AddMovement(hash, model);
  return hash.value();
}

}  // namespace

std::string KeepModel(std::string_view name, Model model) {
  const std::uint64_t hash = HashOfModel(model);
  std::string key = world::AssetKey(name, hash);
  if (model.moves()) {
    model.rig.model = key;
    world::KeepRig(model.rig);
  }
  Models& models = AllModels();
  const std::scoped_lock lock(models.mutex);
  if (const auto found = models.by_hash.find(hash); found == models.by_hash.end())
    models.by_hash.emplace(hash, std::make_shared<const Model>(std::move(model)));
  return key;
}

std::shared_ptr<const Model> FindModel(std::string_view key) {
  const auto hash = world::HashInKey(key);
  if (!hash) return nullptr;
  Models& models = AllModels();
  const std::scoped_lock lock(models.mutex);
  const auto found = models.by_hash.find(*hash);
  return found == models.by_hash.end() ? nullptr : found->second;
}

std::vector<Frame> FramesOfJoints(const Model& model, const std::vector<world::BonePose>& bones) {
  std::vector<Frame> frames;
  frames.reserve(model.joints.size());
  for (const Joint& joint : model.joints) {
    if (joint.bone == Joint::kStill) {
      frames.push_back(joint.inverse_bind);
      continue;
    }
    const world::BonePose& pose =
        joint.bone < bones.size() ? bones[joint.bone] : model.rig.skeleton.BindInModel(joint.bone);
    frames.push_back(FrameOf(pose) * joint.inverse_bind);
  }
  return frames;
}

bool IsModelName(std::string_view name) {
  return name.ends_with(".glb") || name.ends_with(".gltf");
}

}  // namespace soarbox::model
