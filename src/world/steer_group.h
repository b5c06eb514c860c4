// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Which agents are neighbours for a group force: all nearer than 3 radii of self, and those within max_distance_m
/// whose direction is less than max_angle_deg off self's forward.
struct Neighbourhood {
  float max_distance_m = 0;
  float max_angle_deg = 180;
};

/// The maximum distance of a neighbour of an agent with this radius.
float NeighbourhoodRange(float radius_m, float max_distance_m);

// The three flocking forces (Reynolds, "Flocks, Herds, and Schools", 1987). `others` are indices into `all`, summed up
// in this order; self_index is skipped. The result has unit length, or is zero without neighbours.

/// Away from the neighbours; nearer ones count more.
Vec3 SteerSeparate(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                   const Neighbourhood& neighbourhood);
/// Towards the middle of the neighbours.
Vec3 SteerCombine(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                  const Neighbourhood& neighbourhood);
/// Towards the mean direction of the neighbours.
Vec3 SteerAlign(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                const Neighbourhood& neighbourhood);

}  // namespace soarbox::world
