// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/clip.h"

#include <algorithm>

namespace soarbox::world {

Clip::Clip(Settings settings, std::vector<std::vector<BonePose>> keys)
    : settings_(std::move(settings)), keys_(std::move(keys)) {}

BonePose Clip::At(std::size_t bone, float time_s) const {
  const float steps = static_cast<float>(keys_.size() - 1);
  const float at = std::clamp(time_s / settings_.length_s, 0.0f, 1.0f) * steps;
  const auto key = std::min(static_cast<std::size_t>(at), keys_.size() - 2);
  const float share = at - static_cast<float>(key);
  const BonePose& a = keys_[key][bone];
  const BonePose& b = keys_[key + 1][bone];
  return {Between(a.position, b.position, share), Between(a.orientation, b.orientation, share)};
}

}  // namespace soarbox::world
