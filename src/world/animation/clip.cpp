// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/clip.h"

#include <algorithm>

namespace soarbox::world {
namespace {

template <typename T>
T ValueAt(const BoneTrack<T>& track, float time_s, const T& otherwise) {
  if (track.values.empty()) return otherwise;
  const auto next = std::ranges::upper_bound(track.times_s, time_s);
  if (next == track.times_s.begin()) return track.values.front();
  if (next == track.times_s.end()) return track.values.back();
  const auto i = static_cast<std::size_t>(next - track.times_s.begin());
  if (track.holds) return track.values[i - 1];
  const float before_s = track.times_s[i - 1];
  return Between(track.values[i - 1], track.values[i], (time_s - before_s) / (*next - before_s));
}

}  // namespace

Clip::Clip(Settings settings, std::vector<std::vector<BonePose>> keys)
    : settings_(std::move(settings)), keys_(std::move(keys)) {}

Clip::Clip(Settings settings, std::vector<BoneMovement> movements)
    : settings_(std::move(settings)), movements_(std::move(movements)) {}

BonePose Clip::At(std::size_t bone, float time_s) const {
  if (!movements_.empty()) {
    const BoneMovement& movement = movements_[bone];
    const float at_s = std::clamp(time_s, 0.0f, settings_.length_s);
    return {ValueAt(movement.position, at_s, movement.bind.position),
            ValueAt(movement.orientation, at_s, movement.bind.orientation),
            ValueAt(movement.scale, at_s, movement.bind.scale)};
  }
  const float steps = static_cast<float>(keys_.size() - 1);
  const float at = std::clamp(time_s / settings_.length_s, 0.0f, 1.0f) * steps;
  const auto key = std::min(static_cast<std::size_t>(at), keys_.size() - 2);
  const float share = at - static_cast<float>(key);
  const BonePose& a = keys_[key][bone];
  const BonePose& b = keys_[key + 1][bone];
  return {Between(a.position, b.position, share), Between(a.orientation, b.orientation, share)};
}

}  // namespace soarbox::world
