// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Finds the agents near a place: a grid over the ground plane, sorted by counting. Its cells lie row by row, so that a
/// query reads each row at once. If agents are too far apart for that, cells are hashed.
///
/// Invariant: every agent that was not removed is in the cell of its position, stored together with the position, or on
/// the list of strays. Every query searches that list. Moved() puts an agent on it. When the list is long, the next
/// Update rebuilds the grid. Queries may also find agents beyond the range; callers test the distance themselves. After
/// Update, several threads may query at a time.
class AgentGrid {
 public:
  /// Call it after the number of agents or all their positions have changed.
  void Invalidate() { valid_ = false; }
  /// Call it after one agent has moved.
  void Moved(std::uint32_t index);
  /// Brings the grid up to date; call it before Query and Visit.
  void Update(std::span<const AgentMotion> agents);
  /// Appends the indices of all agents within range_m of center to `found`, each once. The order is unspecified but
  /// reproducible.
  void Query(std::span<const AgentMotion> agents, Vec3 center, float range_m, std::vector<std::uint32_t>& found) const;
  /// Calls visit(index) for all agents within range_m of center, those in near cells usually first. `visit` returns the
  /// range that is still of interest; agents beyond it may be skipped from then on. In a crowd, it is therefore called
  /// for a few agents only.
  template <class Visitor>
  void Visit(std::span<const AgentMotion> agents, Vec3 center, float range_m, Visitor visit) const;

 private:
  struct Entry {
    float x_m, z_m;  ///< NaN or infinite for a stray.
    std::uint32_t agent;
  };
  static constexpr float kCell_m = 4.0f;
  // Positions of all agents are limited to PhysicsWorld::kMaxCoordinate_m.
  static std::int32_t CellOf(float coordinate) {
    // Rounds down without calling std::floor, which would cost as much as testing an agent.
    const float cell = coordinate / kCell_m;
    const auto towards_0 = static_cast<std::int32_t>(cell);
    return towards_0 - (static_cast<float>(towards_0) > cell ? 1 : 0);
  }

  void Rebuild(std::span<const AgentMotion> agents);
  /// Chooses between rows and hashes. Returns the number of buckets.
  std::size_t LayOut(std::span<const AgentMotion> agents);
  std::uint32_t Bucket(std::int32_t x, std::int32_t z) const;

  bool valid_ = false;
  bool in_rows_ = false;
  std::int32_t first_x_ = 0, first_z_ = 0;  ///< First cell of the rows.
  std::int32_t width_ = 0, rows_ = 0;       ///< In cells.
  std::vector<Entry> entries_;              ///< Sorted by bucket.
  std::vector<std::uint32_t> starts_;       ///< First entry of each bucket; has one more element than there are
                                            ///< buckets.
  std::vector<std::uint32_t> strays_;
  std::vector<std::uint32_t> places_;  ///< Of each agent in entries_; kNoPlace for removed agents.
};

template <class Visitor>
void AgentGrid::Visit(std::span<const AgentMotion> agents, Vec3 center, float range_m, Visitor visit) const {
  // Slightly larger than exact, so that rounding never excludes an agent: neither by its distance nor by its cell.
  const auto squared = [](float range) { return range * range * 1.0001f + 0.001f; };
  float range = range_m, range_squared = squared(range);
  // More than the errors of rounding coordinates.
  const float rounding_m = 0.001f + std::max(std::abs(center.x), std::abs(center.z)) * 2e-7f;
  const auto reach = [&] { return range * 1.0001f + rounding_m; };
  // Processes batches, so that the memory of all agents of a batch is prefetched before the first is visited.
  std::array<std::uint32_t, 32> batch;
  const auto scan = [&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      std::size_t count = 0;
      for (; begin < end && count < batch.size(); ++begin) {
        const Entry& entry = entries_[begin];
        const float x_m = entry.x_m - center.x, z_m = entry.z_m - center.z;
        if (!(x_m * x_m + z_m * z_m <= range_squared)) continue;
        __builtin_prefetch(&agents[entry.agent]);
        batch[count++] = entry.agent;
      }
      for (std::size_t i = 0; i < count; ++i) range = visit(batch[i]);
      if (count > 0) range_squared = squared(range);
    }
  };
  for (const std::uint32_t stray : strays_) range = visit(stray);
  range_squared = squared(range);

  const float cells_across = 2 * reach() / kCell_m + 2;
  if (!(cells_across * cells_across < static_cast<float>(entries_.size()))) return scan(0, entries_.size());
  if (!in_rows_) {
    const std::int32_t x_last = CellOf(center.x + reach()), z_last = CellOf(center.z + reach());
    for (std::int32_t z = CellOf(center.z - reach()); z <= z_last; ++z) {
      for (std::int32_t x = CellOf(center.x - reach()); x <= x_last; ++x) {
        // Several cells may share a bucket; the positions of the agents distinguish them.
        const std::uint32_t bucket = Bucket(x, z);
        for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i)
          if (CellOf(entries_[i].x_m) == x && CellOf(entries_[i].z_m) == z) scan(i, i + 1);
      }
    }
    return;
  }

  const auto scan_row = [&](std::int32_t z, std::int32_t from, std::int32_t to) {
    const std::int32_t row = z - first_z_;
    if (row < 0 || row >= rows_) return;
    from = std::max(from - first_x_, 0);
    to = std::min(to - first_x_, width_ - 1);
    const std::uint32_t* const starts = &starts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_)];
    if (from <= to) scan(starts[from], starts[to + 1]);
  };
  // First the cell of the position and its neighbours, then the remaining cells of the rows from there outwards.
  const std::int32_t own_x = CellOf(center.x), own_z = CellOf(center.z);
  for (std::int32_t z = own_z - 1; z <= own_z + 1; ++z) scan_row(z, own_x - 1, own_x + 1);
  const auto first_x = [&] { return CellOf(center.x - reach()); };
  const auto last_x = [&] { return CellOf(center.x + reach()); };
  for (std::int32_t z = own_z - 1; z <= own_z + 1; ++z) {
    scan_row(z, first_x(), own_x - 2);
    scan_row(z, own_x + 2, last_x());
  }
  // Distances to the next rows on both sides.
  float below_m = center.z - static_cast<float>(own_z - 1) * kCell_m;
  float above_m = static_cast<float>(own_z + 2) * kCell_m - center.z;
  for (std::int32_t step = 2; below_m <= reach() || above_m <= reach(); ++step) {
    if (below_m <= reach()) scan_row(own_z - step, first_x(), last_x());
    if (above_m <= reach()) scan_row(own_z + step, first_x(), last_x());
    below_m += kCell_m;
    above_m += kCell_m;
  }
}

}  // namespace soarbox::world
