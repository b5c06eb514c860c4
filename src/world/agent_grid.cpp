// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace soarbox::world {
namespace {

constexpr float kCell_m = 4.0f;
constexpr std::size_t kMaxStrays = 64;

// Positions are limited (PhysicsWorld::kMaxCoordinate_m); agents without a body are limited likewise.
std::int32_t CellOf(float coordinate) {
  return static_cast<std::int32_t>(std::floor(coordinate / kCell_m));
}

}  // namespace

void AgentGrid::Moved(std::uint32_t index) {
  if (!valid_ || index >= is_stray_.size() || is_stray_[index]) return;
  if (strays_.size() >= kMaxStrays) {
    valid_ = false;
    return;
  }
  is_stray_[index] = true;
  strays_.push_back(index);
}

std::size_t AgentGrid::LayOut(std::span<const AgentMotion> agents) {
  std::int32_t last_x = 0, last_z = 0;
  first_x_ = first_z_ = 0;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const std::int32_t x = CellOf(agents[i].position.x), z = CellOf(agents[i].position.z);
    first_x_ = i == 0 ? x : std::min(first_x_, x);
    first_z_ = i == 0 ? z : std::min(first_z_, z);
    last_x = i == 0 ? x : std::max(last_x, x);
    last_z = i == 0 ? z : std::max(last_z, z);
  }
  const std::int64_t width = std::int64_t{last_x} - first_x_ + 1, rows = std::int64_t{last_z} - first_z_ + 1;
  in_rows_ = width * rows <= static_cast<std::int64_t>(4 * agents.size() + 256);
  if (!in_rows_) return std::bit_ceil(agents.size() * 2 + 2);
  width_ = static_cast<std::int32_t>(width);
  rows_ = static_cast<std::int32_t>(rows);
  return static_cast<std::size_t>(width * rows);
}

std::uint32_t AgentGrid::Bucket(std::int32_t x, std::int32_t z) const {
  if (in_rows_) return static_cast<std::uint32_t>((z - first_z_) * width_ + (x - first_x_));
  const auto mask = static_cast<std::uint32_t>(starts_.size() - 2);
  const std::uint32_t hash = static_cast<std::uint32_t>(x) * 0x8da6b343u ^ static_cast<std::uint32_t>(z) * 0xd8163841u;
  return (hash ^ (hash >> 15)) & mask;
}

void AgentGrid::Rebuild(std::span<const AgentMotion> agents) {
  const std::size_t buckets = LayOut(agents);
  starts_.assign(buckets + 1, 0);
  entries_.resize(agents.size());
  for (const AgentMotion& agent : agents) ++starts_[Bucket(CellOf(agent.position.x), CellOf(agent.position.z)) + 1];
  for (std::size_t i = 1; i <= buckets; ++i) starts_[i] += starts_[i - 1];
  // Fill from the back, so that starts_ needs no second copy: afterwards each bucket's end has become its start.
  for (std::size_t i = agents.size(); i-- > 0;) {
    const std::int32_t x = CellOf(agents[i].position.x), z = CellOf(agents[i].position.z);
    entries_[--starts_[Bucket(x, z) + 1]] = {x, z, static_cast<std::uint32_t>(i)};
  }
  for (std::size_t i = 0; i < buckets; ++i) starts_[i] = starts_[i + 1];
  starts_[buckets] = static_cast<std::uint32_t>(agents.size());
  strays_.clear();
  is_stray_.assign(agents.size(), false);
  valid_ = true;
}

void AgentGrid::Update(std::span<const AgentMotion> agents) {
  if (!valid_ || is_stray_.size() != agents.size()) Rebuild(agents);
}

void AgentGrid::Query(std::span<const AgentMotion> agents, Vec3 center, float range_m,
                      std::vector<std::uint32_t>& found) const {
  // Rounding errs on the side of looking at one agent too many.
  const float range_squared = range_m * range_m * 1.0001f + 0.001f;
  const auto is_near = [&](const AgentMotion& agent) {
    const float x_m = agent.position.x - center.x, z_m = agent.position.z - center.z;
    return !(x_m * x_m + z_m * z_m > range_squared);
  };
  const float cells_across = 2 * range_m / kCell_m + 2;
  if (!(cells_across * cells_across < static_cast<float>(agents.size()))) {
    for (std::uint32_t i = 0; i < agents.size(); ++i) {
      if (is_near(agents[i])) found.push_back(i);
    }
    return;
  }
  const std::int32_t x_first = CellOf(center.x - range_m), x_last = CellOf(center.x + range_m);
  const std::int32_t z_first = CellOf(center.z - range_m), z_last = CellOf(center.z + range_m);
  const auto look = [&](const Entry& entry) {
    if (!is_stray_[entry.agent] && is_near(agents[entry.agent])) found.push_back(entry.agent);
  };
  if (in_rows_) {
    const std::int32_t from = std::max(x_first, first_x_), to = std::min(x_last, first_x_ + width_ - 1);
    for (std::int32_t z = std::max(z_first, first_z_); from <= to && z <= std::min(z_last, first_z_ + rows_ - 1); ++z) {
      const std::uint32_t end = starts_[Bucket(to, z) + 1];
      for (std::uint32_t i = starts_[Bucket(from, z)]; i < end; ++i) look(entries_[i]);
    }
  } else {
    for (std::int32_t z = z_first; z <= z_last; ++z) {
      for (std::int32_t x = x_first; x <= x_last; ++x) {
        const std::uint32_t bucket = Bucket(x, z);
        for (std::uint32_t i = starts_[bucket]; i < starts_[bucket + 1]; ++i) {
          if (entries_[i].x == x && entries_[i].z == z) look(entries_[i]);
        }
      }
    }
  }
  found.insert(found.end(), strays_.begin(), strays_.end());
}

}  // namespace soarbox::world
