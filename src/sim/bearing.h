// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "world/animation/locomotion.h"
#include "world/ids.h"

namespace soarbox::world {
class Animator;
class StateHash;
class World;
}  // namespace soarbox::world

namespace soarbox::sim {

/// How a person's figure shows what the person does: the rifle goes up to shoot and stays up for a moment, kicks with
/// each shot, and is loaded; whoever is hit flinches. It moves nothing but the figure.
class Bearing {
 public:
  /// What the person does in a tick.
  struct Deeds {
    std::string_view stance = "standing";
    bool is_armed = false;
    bool shoots = false;   ///< A command to shoot is under way.
    bool reloads = false;  ///< The weapon is being loaded.
    int rounds = 0;        ///< In the magazine.
    float health = 100;
  };

  /// The mesh that shows it; without a mesh, nothing does.
  void SetFigure(world::NodeId figure) { figure_ = figure; }
  /// One tick.
  void Show(world::World& world, const Deeds& deeds);
  /// From now on the figure just falls.
  void End(world::World& world);

  void AddTo(world::StateHash& hash) const;

 private:
  void Begin(world::Animator& animator, std::string_view clip);
  void GoOn(world::Animator& animator, float seconds, bool reloads);

  world::NodeId figure_ = world::NodeId::kNone;
  bool is_shown_ = false;
  world::LocomotionStyle style_ = world::LocomotionStyle::kReady;
  float aims_s_ = 0;  ///< For how long the rifle stays up.
  Deeds last_;
  int clip_ = -1;  ///< Of what plays over the walk; -1: nothing does.
  bool loads_ = false;
};

}  // namespace soarbox::sim
