// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Sidesteps other agents (after Reynolds, 1999, unaligned collision avoidance). An agent that touches self is pushed
/// away from, sideways; failing that, the one with the earliest near miss within look_ahead_s is dodged to the left or
/// right (unit length). Of several that touch, or that miss at the same time, the one with the lowest index counts: it
/// does not matter in which order others are looked at.
class Lookout {
 public:
  /// No agent of `all` is faster or wider than told. self_index is one of them.
  Lookout(std::size_t self_index, std::span<const AgentMotion> all, float look_ahead_s, float max_speed_mps,
          float max_radius_m);

  /// Beyond this centre distance nobody matters; it shrinks with what was found.
  float range_m() const;
  /// Looks at one agent; self and the dead do not count.
  void Look(std::uint32_t index);
  /// What follows when all within range were looked at.
  Vec3 Force() const;

 private:
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  void Consider(const AgentMotion& other, std::uint32_t index, Vec3 apart);

  std::span<const AgentMotion> all_;
  const AgentMotion& self_;
  std::uint32_t self_index_;
  float fastest_mps_;  ///< That two can close in.
  float touching_m_;
  std::uint32_t touching_ = kNobody;
  std::uint32_t threat_ = kNobody;
  float threat_s_;  ///< When it comes nearest; without a threat, how far ahead is looked.
};

}  // namespace soarbox::world
