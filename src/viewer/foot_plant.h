// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/skin_mesh.h"

namespace soarbox::viewer {

/// Keeps a soldier's feet in place on the ground while the body moves and turns.
///
/// Animations are made for certain speeds and directions. At other speeds, and when a body turns, starts or stops, the
/// soles that carry it would slide. FootPlant keeps the soles where they touched the ground by bending the legs. Feet
/// in the air return to the animation. A soldier who stands still and whose feet differ too much from the animation
/// takes small steps. Only the picture changes, never the world.
class FootPlant {
 public:
  /// Processes the next tick. `bones` are the soldier's bones in model space, and `place` is the model's place; moves
  /// the bones of the legs.
  void Follow(const SkinPlace& place, float seconds, std::vector<world::BonePose>& bones);
  /// The next tick does not follow the last one.
  void Forget() { known_ = false; }

 private:
  struct Foot {
    bool stands = false;
    bool on_heel = false;  ///< The heel carries the body; if false, the ball of the foot does.
    world::Vec3 at;        ///< Where that part is held, in world space.
    float yaw = 0;         ///< The direction of the foot while it is held, about the vertical axis.
    // Difference from the animation: the ankle is moved by `offset` in world space and turned by `turn`.
    world::Vec3 offset;
    float turn = 0;
    float step = -1;  ///< 0..1 during a step back to the animation; -1: no step.
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
