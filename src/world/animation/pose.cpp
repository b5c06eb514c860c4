// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/pose.h"

#include "world/animation/rig.h"

namespace soarbox::world {
namespace {

/// A weighted sum of poses.
class Mix {
 public:
  /// `has_scales`: bones of models from files may have a scale; others need no sum of it.
  explicit Mix(bool has_scales) : has_scales_(has_scales) {}
  void Add(const BonePose& pose, float weight) {
    const Quat q = pose.orientation;
    const float dot = turn_.w * q.w + turn_.x * q.x + turn_.y * q.y + turn_.z * q.z;
    const float w = dot < 0 ? -weight : weight;
    turn_ = {turn_.w + w * q.w, turn_.x + w * q.x, turn_.y + w * q.y, turn_.z + w * q.z};
    place_ += pose.position * weight;
    if (has_scales_) scale_ += pose.scale * weight;
    sum_ += weight;
  }
  float sum() const { return sum_; }
  BonePose Mean() const {
    BonePose mean{place_ / sum_, Normalized(turn_)};
    if (has_scales_) mean.scale = scale_ / sum_;
    return mean;
  }

 private:
  Quat turn_{0, 0, 0, 0};
  Vec3 place_, scale_;
  bool has_scales_;
  float sum_ = 0;
};

}  // namespace

/// The pose relative to the parent.
BonePose Pose::Local(std::size_t bone) const {
  const bool has_scales = !rig->model.empty();
  Mix mix(has_scales);
  const bool is_lower = !rig->is_lower_body.empty() && rig->is_lower_body[bone];
  for (std::size_t i = 0; i < played; ++i) {
    if (parts[i].clip >= rig->clips.size()) continue;
    const Clip& clip = rig->clips[parts[i].clip];
    const float share = is_lower && clip.upper_body() ? 1 - legs : 1.0f;
    if (share > 0) mix.Add(clip.At(bone, parts[i].time_s), parts[i].weight * share);
  }
  const float rest = 1 - mix.sum();
  if (rest > 0) {
    Mix below(has_scales);
    for (std::size_t i = played; i < parts.size(); ++i) {
      if (parts[i].weight > 0 && parts[i].clip < rig->clips.size())
        below.Add(rig->clips[parts[i].clip].At(bone, parts[i].time_s), parts[i].weight);
    }
    mix.Add(below.sum() > 0 ? below.Mean() : rig->skeleton.bones()[bone].bind, rest);
  }
  return mix.Mean();
}

void Pose::WorkOut(std::vector<BonePose>& bones) const {
  std::vector<BonePose> local(rig->skeleton.bones().size());
  for (std::size_t i = 0; i < local.size(); ++i) local[i] = Local(i);
  rig->skeleton.ToModel(local, bones);
}

BonePose Pose::WorkOut(std::size_t bone) const {
  const int parent = rig->skeleton.bones()[bone].parent;
  return parent < 0 ? Local(bone) : WorkOut(static_cast<std::size_t>(parent)) * Local(bone);
}

}  // namespace soarbox::world
