// SPDX-License-Identifier: BSD-2-Clause
#include "world/sight.h"

#include "world/agent_store.h"
#include "world/limits.h"
#include "world/rotation.h"
#include "world/weapon.h"

namespace soarbox::world {

bool SeesAgent(const Agent& from, const Agent& target, const BodiesAround* around) {
  const Vec3 eyes = EyesOf(from), middle = target.Position(), head = EyesOf(target);
  constexpr float kTooNear_m2 = 1e-6f;
  if (LengthSquared(middle - eyes) < kTooNear_m2 || LengthSquared(head - eyes) < kTooNear_m2) return true;
  const Vec3 begin = LimitPosition(eyes), to = LimitPosition(middle), other = LimitPosition(head);
  if (begin == to || begin == other) return true;
  return AgentStore::Of(from).IsClearToEither(begin, to, other, from, target, around);
}

BodiesAround AroundEyes(const Agent& from, float range_m, float angle_deg) {
  return BodiesAround(AgentStore::Of(from).physics(), {EyesOf(from), range_m, from.Forward(), angle_deg});
}

bool IsFreeAhead(const Agent& from, float ahead_m, float height_m) {
  Vec3 place = from.Position();
  place.y += height_m - from.Height() / 2;
  const Vec3 end = place + from.Forward() * ahead_m;
  if (!IsFinite(place) || !IsFinite(end)) return true;
  return MeetsNothing(AgentStore::Of(from).physics(), LimitPosition(place), LimitPosition(end));
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
