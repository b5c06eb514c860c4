// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Avoidance of other agents (docs/spec/lua_api.md, ForceToAvoidAgents). An agent that touches another is pushed away
/// sideways; otherwise it steps aside for the agent that it would collide with first. The result does not depend on the
/// order of the calls of Look: between equal candidates, the lower index wins.
class Lookout {
 public:
  /// max_speed_mps and max_radius_m are upper bounds for all agents. self_index is an index in `all`.
  Lookout(std::size_t self_index, std::span<const AgentMotion> all, float look_ahead_s, float max_speed_mps,
          float max_radius_m);

  /// Agents with a centre farther away do not matter any more. Decreases as agents are looked at.
  float range_m() const;
  /// Takes one agent into account. Ignores self and dead agents.
  void Look(std::uint32_t index);
  /// The force, after all agents within range have been looked at. It has length 1; a push has the length of the
  /// sideways offset. Zero if the way is free.
  Vec3 Force() const;

 private:
  struct Meeting {
    std::uint32_t index;
    float in_s;
  };
  /// The force sideways away from it; zero if it is straight ahead or behind.
  Vec3 PushFrom(const AgentMotion& other) const;
  /// The time until the two bodies would overlap; nothing if they will not within the look-ahead time.
  std::optional<float> MeetsIn(const AgentMotion& other) const;
  /// -1: step to the right, 1: to the left, 0: the other agent gives way.
  float SideFor(const AgentMotion& other, float in_s) const;

  std::span<const AgentMotion> all_;
  const AgentMotion& self_;
  std::uint32_t self_index_;
  float look_ahead_s_, max_closing_mps_, touch_m_;
  std::optional<std::uint32_t> touching_;
  std::optional<Meeting> meeting_;
};

}  // namespace soarbox::world
