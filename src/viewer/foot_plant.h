// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/skin_mesh.h"

namespace soarbox::viewer {

/// Keeps a soldier's feet where they are set down while the body moves and turns over them.
///
/// Movements are made for certain speeds and ways; between those, and whenever a body turns, starts or stops, soles
/// that carry it would slide. From one tick to the next this holds them where they came down, by bending the legs; feet
/// that are in the air go back to where the movement has them. A soldier who stands and has turned or stopped away from
/// his feet takes small steps. Only what is drawn changes: the world knows nothing of it.
class FootPlant {
 public:
  /// The next tick: `bones` of the soldier in the model, which stands at `place`; moves those of the legs.
  void Follow(const SkinPlace& place, float seconds, std::vector<world::BonePose>& bones);
  /// The next tick does not follow from the last one.
  void Forget() { known_ = false; }

 private:
  struct Foot {
    bool stands = false;
    bool on_heel = false;  ///< What it stands on; else the ball.
    world::Vec3 at;        ///< Where that is held; in the world.
    float yaw = 0;         ///< The direction it points in, likewise; about the upright axis.
    // How it is drawn away from the movement: the ankle by `offset` in the world, turned by `turn`.
    world::Vec3 offset;
    float turn = 0;
    float step = -1;  ///< 0..1 while it steps back to where the movement has it; -1: it does not.
    world::Vec3 step_offset;
    float step_turn = 0;
  };
  struct Sole;

  void Hold(Foot& foot, const Foot& other, const Sole& sole, bool is_new, float seconds, float speed_mps);
  void BeginStep(Foot& foot);

  Foot feet_[2];
  world::Vec3 last_place_;
  float still_s_ = 0;
  bool known_ = false, is_lying_ = false;
};

}  // namespace soarbox::viewer
