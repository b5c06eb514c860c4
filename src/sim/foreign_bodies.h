// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <span>
#include <string>

#include "sim/arena.h"
#include "sim/foreign_kind.h"
#include "sim/input.h"

namespace soarbox::sim {

/// Bodies that other simulations own: others perceive, hear and hit them like any body. They have no mind here, and
/// move as their owners said last.
///
/// What owners say comes in as inputs, so a recording holds it and a replay needs no network. Between two inputs a body
/// moves on by dead reckoning; when the next input comes, it corrects its error within half a second. Bodies that have
/// left stay in the world (agents are never destroyed), hidden below the ground. Owned by the simulation.
class ForeignBodies {
 public:
  /// It refuses more at a time, with a warning.
  static constexpr std::size_t kMost = 10'000;

  ForeignBodies(world::World& world, Arena& arena, Arena::Report report);

  /// `kinds`: those of the scenario; inputs name bodies by them.
  void Apply(const ForeignBodyInput& input, std::span<const BodyKind> kinds);
  void Apply(const ForeignGoneInput& input);
  void Apply(const ForeignShotInput& input);
  void Apply(const ForeignMessageInput& input);
  /// Puts each body where it is at the end of this tick; call it between the actors' step and the world's.
  void Move();
  /// Empty for agents of our own.
  std::string_view IdOf(world::EntityId agent) const;
  /// kNoEntity if there is nobody with this id.
  world::EntityId Find(const std::string& id) const;
  bool empty() const { return bodies_.empty(); }
  void AddTo(world::StateHash& hash) const;

 private:
  struct Body {
    world::EntityId agent = world::kNoEntity;
    ForeignBodyInput said;
    std::uint64_t said_tick = 0;
    world::Vec3 off;  ///< From where it was shown to where it should have been, when that was said.
  };
  world::EntityId Make(const ForeignBodyInput& input, std::span<const BodyKind> kinds);
  world::Vec3 PlaceOf(const Body& body) const;
  float Age(const Body& body) const;
  void Hurt(world::EntityId victim, float damage, bool& killed);
  void Warn(std::string message);

  world::World& world_;
  Arena& arena_;
  Arena::Report report_;
  std::map<std::string, Body> bodies_;
  std::map<world::EntityId, std::string> ids_;  ///< Of those that are there.
  bool told_of_limit_ = false;
};

}  // namespace soarbox::sim
