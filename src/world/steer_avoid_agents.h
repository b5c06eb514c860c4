// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Getting out of each other's way (docs/spec/lua_api.md, ForceToAvoidAgents): an agent that touches another is pushed
/// off sideways; else it steps aside for the one that it would run into first. The answer does not depend on the order
/// in which others are looked at: between equals, the lower index counts.
class Lookout {
 public:
  /// No agent of `all` is faster or wider than these limits; self_index is one of them.
  Lookout(std::size_t self_index, std::span<const AgentMotion> all, float look_ahead_s, float max_speed_mps,
          float max_radius_m);

  /// Agents whose centre is farther away no longer matter. Shrinks as others are looked at.
  float range_m() const;
  /// Takes one agent into account; self and the dead do not count.
  void Look(std::uint32_t index);
  /// The force, once all within range have been looked at. Of length 1, or shorter for a push; zero: the way is free.
  Vec3 Force() const;

 private:
  struct Meeting {
    std::uint32_t index;
    float in_s;
  };
  /// Sideways off from it; zero if it is straight ahead or behind.
  Vec3 PushFrom(const AgentMotion& other) const;
  /// How soon the other's body and its own would overlap; nothing if they would not within the time that counts.
  std::optional<float> MeetsIn(const AgentMotion& other) const;
  /// -1: step to the right, 1: to the left, 0: the other one yields.
  float SideFor(const AgentMotion& other, float in_s) const;

  std::span<const AgentMotion> all_;
  const AgentMotion& self_;
  std::uint32_t self_index_;
  float look_ahead_s_, max_closing_mps_, touch_m_;
  std::optional<std::uint32_t> touching_;
  std::optional<Meeting> meeting_;
};

}  // namespace soarbox::world
