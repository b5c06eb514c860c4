// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent_store.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace soarbox::world {
namespace {

constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

/// Sorts distinct numbers. If they are dense enough, marks them in a bit set, which takes a third of the time.
void Sort(std::vector<std::uint32_t>& numbers) {
  constexpr std::size_t kFew = 12, kBits = 64, kMostWords = 64;
  if (numbers.size() < kFew) return std::sort(numbers.begin(), numbers.end());
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  const std::uint32_t first = *least;
  const std::size_t words = (*most - first) / kBits + 1;
  if (words > std::min(kMostWords, numbers.size())) return std::sort(numbers.begin(), numbers.end());
  std::array<std::uint64_t, kMostWords> marks;
  std::fill_n(marks.begin(), words, 0);
  for (const std::uint32_t number : numbers) marks[(number - first) / kBits] |= 1ull << ((number - first) % kBits);
  auto next = numbers.begin();
  for (std::size_t word = 0; word < words; ++word) {
    for (std::uint64_t left = marks[word]; left != 0; left &= left - 1)
      *next++ = first + static_cast<std::uint32_t>(word * kBits) + static_cast<std::uint32_t>(std::countr_zero(left));
  }
}

}  // namespace

Agent& AgentStore::Create(EntityId id, NodeId node, const AgentDef& def) {
  const std::size_t index = agents_.size();
  motions_.emplace_back();
  ids_.push_back(id);
  near_is_valid_ = false;
  if (index_by_id_.size() <= Number(id)) index_by_id_.resize(Number(id) + 1, kNoIndex);
  index_by_id_[Number(id)] = static_cast<std::uint32_t>(index);
  agents_.push_back(std::unique_ptr<Agent>(new Agent(*this, id, node, index, def, seed_)));
  SpeedOrRadiusChanged(index);
  return *agents_.back();
}

void AgentStore::Remove(Agent& agent) {
  agent.RemovePhysics();
  scene_.RemoveOwned(agent.node_);
  agent.node_ = NodeId::kNone;
  agent.health_ = 0;
  AgentMotion& motion = motions_[agent.index_];
  motion.velocity = {};
  motion.speed = motion.radius = 0;
  motion.alive = false;
  motion.gone = true;
  std::erase(ids_, agent.id_);
  for (const auto& other : agents_)
    if (other->Leader() == agent.id_) other->SetLeader(kNoEntity);
  grid_.Invalidate();
  near_is_valid_ = false;
}

Agent* AgentStore::Find(EntityId id) const {
  if (Number(id) >= index_by_id_.size()) return nullptr;
  const std::uint32_t index = index_by_id_[Number(id)];
  return index == kNoIndex ? nullptr : agents_[index].get();
}

void AgentStore::ReadBodies() {
  max_speed_ = 0;
  max_radius_ = 0;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    AgentMotion& motion = motions_[i];
    if (agents_[i]->HasBody()) {
      agents_[i]->is_node_placed_ = false;
      const Vec3 position = physics_.Position(agents_[i]->body_);
      if (position != motion.position) scene_.BodyMoved(agents_[i]->node_, position, motion.orientation);
      motion.position = position;
      motion.velocity = physics_.Velocity(agents_[i]->body_);
      motion.speed = std::sqrt(motion.velocity.x * motion.velocity.x + motion.velocity.z * motion.velocity.z);
    }
    SpeedOrRadiusChanged(i);
  }
  grid_.Invalidate();
  near_is_valid_ = false;
}

void AgentStore::Moved(std::size_t index) {
  grid_.Moved(static_cast<std::uint32_t>(index));
  near_is_valid_ = false;
}

void AgentStore::SpeedOrRadiusChanged(std::size_t index) {
  max_speed_ = std::max(max_speed_, std::abs(motions_[index].speed));
  max_radius_ = std::max(max_radius_, motions_[index].radius);
}

void AgentStore::CopyNear(Vec3 center, float range_m, std::vector<std::uint32_t>& found) const {
  found.clear();
  grid_.Query(motions_, center, range_m, found);
  Sort(found);
}

std::span<const std::uint32_t> AgentStore::NearInOrder(Vec3 center, float range_m,
                                                       std::optional<std::string_view> team) {
  if (!near_is_valid_ || center != near_center_ || range_m != near_range_m_) {
    grid_.Update(motions_);
    CopyNear(center, range_m, near_);
    near_center_ = center;
    near_range_m_ = range_m;
    near_is_valid_ = true;
    near_team_ = TeamNumbers::kNone;
  }
  return team ? OnlyTeam(*team) : near_;
}

/// The agents of the team in near_.
std::span<const std::uint32_t> AgentStore::OnlyTeam(std::string_view team) {
  const std::uint32_t number = teams_.Find(team);
  if (number == TeamNumbers::kNone) return {};
  if (number == near_team_) return near_in_team_;
  near_in_team_.resize(near_.size());
  std::size_t count = 0;
  for (const std::uint32_t index : near_) {
    near_in_team_[count] = index;
    count += motions_[index].team == number ? 1 : 0;
  }
  near_in_team_.resize(count);
  near_team_ = number;
  return near_in_team_;
}

void AgentStore::ChangeTeam(std::size_t index, std::string_view from, std::string_view to) {
  if (motions_[index].team != TeamNumbers::kNone) teams_.Leave(from);
  motions_[index].team = teams_.Join(to);
  near_team_ = TeamNumbers::kNone;
}

std::span<const std::uint32_t> AgentStore::Indices(std::span<const EntityId> ids) {
  scratch_.clear();
  for (const EntityId id : ids) {
    const std::uint32_t index = Number(id) < index_by_id_.size() ? index_by_id_[Number(id)] : kNoIndex;
    if (index != kNoIndex && !motions_[index].gone) scratch_.push_back(index);
  }
  return scratch_;
}

}  // namespace soarbox::world
