// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Draws the sandbox's two particle effects (lua_api.md section 11) as glowing lines: "Bullet", a short streak, and
/// "BulletImpact", a burst of falling sparks. The sparks depend only on the emitter's id.
class ParticleLines {
 public:
  /// Appends the lines of the scene's particles at the scene's time.
  void AddLines(const world::SceneSnapshot& scene, std::vector<world::LineSnapshot>& lines);

 private:
  struct Start {
    std::uint32_t restarts = 0;
    double time_s = 0;
    std::uint64_t seen = 0;
  };
  std::map<std::uint32_t, Start> starts_;
  std::uint64_t calls_ = 0;
};

}  // namespace soarbox::viewer
