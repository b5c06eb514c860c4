// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace soarbox::world {
namespace {

constexpr std::size_t kMaxStrays = 64;
constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();
constexpr float kNowhere_m = std::numeric_limits<float>::quiet_NaN();

}  // namespace

void AgentGrid::Moved(std::uint32_t index) {
  if (!valid_ || index >= places_.size() || places_[index] == kNoPlace) return;
  Entry& entry = entries_[places_[index]];
  if (std::isnan(entry.x_m)) return;
  if (strays_.size() >= kMaxStrays) {
    valid_ = false;
    return;
  }
  entry.x_m = kNowhere_m;
  strays_.push_back(index);
}

std::size_t AgentGrid::LayOut(std::span<const AgentMotion> agents) {
  std::int32_t last_x = 0, last_z = 0;
  first_x_ = first_z_ = 0;
  bool is_first = true;
  for (const AgentMotion& agent : agents) {
    if (agent.gone) continue;
    const std::int32_t x = CellOf(agent.position.x), z = CellOf(agent.position.z);
    first_x_ = is_first ? x : std::min(first_x_, x);
    first_z_ = is_first ? z : std::min(first_z_, z);
    last_x = is_first ? x : std::max(last_x, x);
    last_z = is_first ? z : std::max(last_z, z);
    is_first = false;
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
  places_.resize(agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) {
    places_[i] = kNoPlace;
    if (agents[i].gone) continue;
    places_[i] = Bucket(CellOf(agents[i].position.x), CellOf(agents[i].position.z)) + 1;
    ++starts_[places_[i]];
  }
  for (std::size_t i = 1; i <= buckets; ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_[buckets]);
  // Fill from the back, so that starts_ needs no second copy: afterwards each bucket's end has become its start.
  for (std::size_t i = agents.size(); i-- > 0;) {
    if (agents[i].gone) continue;
    const Vec3 position = agents[i].position;
    const std::uint32_t place = --starts_[places_[i]];
    entries_[place] = {position.x, position.z, static_cast<std::uint32_t>(i)};
    places_[i] = place;
  }
  for (std::size_t i = 0; i < buckets; ++i) starts_[i] = starts_[i + 1];
  starts_[buckets] = static_cast<std::uint32_t>(entries_.size());
  strays_.clear();
  valid_ = true;
}

void AgentGrid::Update(std::span<const AgentMotion> agents) {
  if (!valid_ || places_.size() != agents.size()) Rebuild(agents);
}

void AgentGrid::Query(std::span<const AgentMotion> agents, Vec3 center, float range_m,
                      std::vector<std::uint32_t>& found) const {
  Visit(agents, center, range_m, [&](std::uint32_t index) {
    found.push_back(index);
    return range_m;
  });
}

}  // namespace soarbox::world
