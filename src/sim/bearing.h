// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "world/animation/locomotion.h"
#include "world/entity_ids.h"

namespace soarbox::world {
class Animator;
class StateHash;
class World;
}  // namespace soarbox::world

namespace soarbox::sim {

/// Animates what a person does: raises the rifle to shoot and keeps it raised for a moment, plays the recoil of each
/// shot and the loading, and flinches after a hit. It changes only the figure, not the body.
class Bearing {
 public:
  /// The actions of the person in a tick.
  struct Deeds {
    std::string_view stance = "standing";
    bool is_armed = false;
    bool shoots = false;   ///< A command to shoot is running.
    bool reloads = false;  ///< The weapon is being loaded.
    int rounds = 0;        ///< In the magazine.
    float health = 100;
  };

  /// Sets the mesh to animate. Without a mesh, nothing is animated.
  void SetFigure(world::NodeId figure) { figure_ = figure; }
  /// Animates one tick.
  void Show(world::World& world, const Deeds& deeds);
  /// Ends the animations, because the person has died.
  void End(world::World& world);

  void AddTo(world::StateHash& hash) const;

 private:
  void Begin(world::Animator& animator, std::string_view clip);
  void GoOn(world::Animator& animator, float seconds, bool reloads);

  world::NodeId figure_ = world::NodeId::kNone;
  bool is_shown_ = false;
  world::LocomotionStyle style_ = world::LocomotionStyle::kReady;
  float aims_s_ = 0;  ///< Remaining time for which the rifle stays raised, in s.
  Deeds last_;
  int clip_ = -1;  ///< The animation that plays over walking; -1: none.
  bool loads_ = false;
};

}  // namespace soarbox::sim
