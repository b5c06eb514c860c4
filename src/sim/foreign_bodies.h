// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <span>
#include <string>

#include "sim/arena.h"
#include "sim/foreign_kind.h"
#include "sim/input.h"

namespace soarbox::sim {

/// Bodies that other simulations own. Our agents perceive, hear and hit them like any other body. They have no mind
/// here, and move as their owners last reported.
///
/// Reports of owners are inputs. Recordings contain them, and a replay needs no network. Between two inputs a body
/// moves by dead reckoning. The next input corrects its error within half a second; an error of more than 5 m, at once.
/// Agents are never destroyed; bodies that have left stay in the world, hidden below the ground. Owned by the
/// simulation.
class ForeignBodies {
 public:
  /// Maximum number of bodies at a time. Further ones are refused with a warning.
  static constexpr std::size_t kMost = 10'000;

  ForeignBodies(world::World& world, Arena& arena, Arena::Report report);

  /// `kinds`: the kinds of bodies in the scenario, which inputs refer to by name.
  void Apply(const ForeignBodyInput& input, std::span<const BodyKind> kinds);
  void Apply(const ForeignGoneInput& input);
  void Apply(const ForeignShotInput& input);
  void Apply(const ForeignMessageInput& input);
  /// Moves each body to its position at the end of this tick. Call it after the actors' step and before the physics
  /// step.
  void Move();
  /// The id in its simulation; empty for our own agents.
  std::string_view IdOf(world::EntityId agent) const;
  /// kNoEntity if there is no body with this id.
  world::EntityId Find(const std::string& id) const;
  bool empty() const { return bodies_.empty(); }
  void AddTo(world::StateHash& hash) const;

 private:
  struct Body {
    world::EntityId agent = world::kNoEntity;
    ForeignBodyInput said;
    std::uint64_t said_tick = 0;
    world::Vec3 off;  ///< When the last input came: vector from the shown position to the correct one.
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
  std::map<world::EntityId, std::string> ids_;  ///< Ids of the bodies that are present.
  bool told_of_limit_ = false;
};

}  // namespace soarbox::sim
