// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Volume of a sound on the left and on the right, each 0 to 1. Up to 5 m a sound has its full volume; beyond that, the
/// volume is inversely proportional to the distance. A sound from one side is quieter on the other side.
struct Heard {
  float left = 0, right = 0;
};
Heard HeardAt(const world::SoundSnapshot& sound, const world::CameraSnapshot& ear);

/// Plays each sound of a scene once. Opens the audio device for the first sound; if there is no device, nothing is
/// played.
class SoundPlayer {
 public:
  SoundPlayer();
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  /// Starts the sounds that are new since the last call, if `is_live`. The first call and a jump back start nothing.
  void Take(const world::SceneSnapshot& scene, const world::CameraSnapshot& ear, bool is_live);

 private:
  struct Device;
  std::unique_ptr<Device> device_;
  std::optional<std::uint32_t> last_;
};

}  // namespace soarbox::viewer
