// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::world {

/// The sounds that started in the last second (scene_snapshot.h). They are only part of snapshots: nothing in the world
/// depends on them.
class SoundBoard {
 public:
  /// Starts a sound now. If there are more than kMostSounds, removes the oldest.
  void Play(std::string_view file, double now_s, float volume, std::optional<Vec3> position);

  void FillSnapshot(SceneSnapshot& snapshot) const;

 private:
  std::vector<SoundSnapshot> sounds_;
  std::uint32_t next_ = 1;
};

}  // namespace soarbox::world
