// SPDX-License-Identifier: BSD-2-Clause
#include "world/sight.h"

#include "world/agent_store.h"
#include "world/limits.h"
#include "world/rotation.h"
#include "world/weapon.h"

namespace soarbox::world {

bool SeesAgent(const Agent& from, const Agent& target, Vec3 point, const BodiesAround* around) {
  const Vec3 eyes = EyesOf(from);
  if (LengthSquared(point - eyes) < 1e-6f || !IsFinite(eyes) || !IsFinite(point)) return true;
  const Vec3 begin = LimitPosition(eyes), end = LimitPosition(point);
  return begin == end || AgentStore::Of(from).IsClear(begin, end, from, target, around);
}

BodiesAround AroundEyes(const Agent& from, float range_m) {
  // What is seen may be far above or below.
  constexpr float kSlack_m = 0.1f, kHigh_m = 1e6f;
  return AgentStore::Of(from).physics().Around(EyesOf(from), {range_m + kSlack_m, kHigh_m, range_m + kSlack_m});
}

std::vector<EntityId> AgentsNear(const Agent& agent, float range_m) {
  const AgentStore& store = AgentStore::Of(agent);
  std::vector<std::uint32_t> indices;
  store.CopyNear(agent.Position(), range_m, indices);
  std::vector<EntityId> near;
  near.reserve(indices.size());
  for (const std::uint32_t index : indices) near.push_back(store.ids()[index]);
  return near;
}

}  // namespace soarbox::world
