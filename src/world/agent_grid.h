// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Finds the agents near a place: a grid over the ground plane, sorted by counting. Its cells lie row by row, so that a
/// query reads each row at once; where agents stand too far apart for that, cells are hashed.
///
/// Invariant: every agent is either in the cell of its position or on the list of strays, which every query looks at.
/// Moved() puts an agent on that list; when it grows long, the next query rebuilds the grid. Queries return a superset
/// of the agents within the range, each once; callers test the distance themselves.
class AgentGrid {
 public:
  /// The number of agents or all their positions have changed.
  void Invalidate() { valid_ = false; }
  /// One agent has moved.
  void Moved(std::uint32_t index);
  /// Brings the grid up to date; to be called before Query.
  void Update(std::span<const AgentMotion> agents);
  /// Appends the indices of all agents within range_m of center, and perhaps of others, to found; order unspecified
  /// but reproducible. Several threads may ask at a time.
  void Query(std::span<const AgentMotion> agents, Vec3 center, float range_m, std::vector<std::uint32_t>& found) const;

 private:
  struct Entry {
    std::int32_t x, z;
    std::uint32_t agent;
  };
  void Rebuild(std::span<const AgentMotion> agents);
  /// Chooses between rows and hashes; returns the number of buckets.
  std::size_t LayOut(std::span<const AgentMotion> agents);
  std::uint32_t Bucket(std::int32_t x, std::int32_t z) const;

  bool valid_ = false;
  bool in_rows_ = false;
  std::int32_t first_x_ = 0, first_z_ = 0;  ///< Of the rows.
  std::int32_t width_ = 0, rows_ = 0;       ///< In cells.
  std::vector<Entry> entries_;              ///< Sorted by bucket.
  std::vector<std::uint32_t> starts_;       ///< First entry of each bucket; one more than there are buckets.
  std::vector<std::uint32_t> strays_;
  std::vector<bool> is_stray_;
};

}  // namespace soarbox::world
