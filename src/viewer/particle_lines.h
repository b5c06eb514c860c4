// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// The sandbox's two particle effects (lua_api.md section 11), drawn as glowing lines: "Bullet", a short streak, and
/// "BulletImpact", a burst of sparks that fall. What sparks there are depends on the emitter's id alone.
class ParticleLines {
 public:
  /// Appends what the scene's particles look like at its time.
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
