// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Whom a group force counts as a neighbour: anybody nearer than 3 radii of self, and anybody within max_distance_m who
/// is less than max_angle_deg off self's forward.
struct Neighbourhood {
  float max_distance_m = 0;
  float max_angle_deg = 180;
};

/// The farthest that a neighbour can be.
float NeighbourhoodRange(const AgentMotion& self, const Neighbourhood& neighbourhood);

// The three flocking forces (Reynolds, "Flocks, Herds, and Schools", 1987). others are indices into all, summed up in
// their order; self_index is skipped. Unit length, or zero without neighbours.

/// Away from the neighbours, the nearest counting most.
Vec3 SteerSeparate(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                   const Neighbourhood& neighbourhood);
/// Towards the middle of the neighbours.
Vec3 SteerCombine(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                  const Neighbourhood& neighbourhood);
/// Towards the neighbours' mean direction.
Vec3 SteerAlign(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                const Neighbourhood& neighbourhood);

}  // namespace soarbox::world
