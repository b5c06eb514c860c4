// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// How loud a sound arrives on the left and on the right, each 0 to 1: in full up to 5 m, half of it at twice the
/// distance, and from its side.
struct Heard {
  float left = 0, right = 0;
};
Heard HeardAt(const world::SoundSnapshot& sound, const world::CameraSnapshot& ear);

/// Plays the sounds of a scene, once each. The device is opened with the first sound; without one all is silent.
class SoundPlayer {
 public:
  SoundPlayer();
  ~SoundPlayer();
  SoundPlayer(const SoundPlayer&) = delete;
  SoundPlayer& operator=(const SoundPlayer&) = delete;

  /// Begins the sounds that are new in this scene. Those of the first scene, and those after a jump back, stay silent,
  /// and so does a moment of the past (`is_live` false).
  void Take(const world::SceneSnapshot& scene, const world::CameraSnapshot& ear, bool is_live);

 private:
  struct Device;
  std::unique_ptr<Device> device_;
  std::optional<std::uint32_t> last_;
};

}  // namespace soarbox::viewer
