// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "world/agent.h"
#include "world/agent_store.h"
#include "world/rotation.h"
#include "world/steer_avoid_agents.h"
#include "world/steer_avoid_objects.h"
#include "world/steer_group.h"
#include "world/steer_path.h"
#include "world/steer_pursue.h"
#include "world/steer_seek.h"
#include "world/steer_speed.h"

// Collects the inputs of the steering forces: this agent and the others.
namespace soarbox::world {
namespace {

constexpr float kLongestLookAhead_s = 1000;

float LookAhead(float seconds) {
  if (!IsFinite(seconds)) return Agent::kDefaultLookAhead_s;
  return std::clamp(seconds, Agent::kDefaultLookAhead_s, kLongestLookAhead_s);
}

}  // namespace

Vec3 Agent::ForceToPosition(Vec3 target) const {
  return SteerSeek(motion(), target);
}
Vec3 Agent::ForceToFleePosition(Vec3 danger) const {
  return SteerFlee(motion(), danger);
}

Vec3 Agent::ForceToPursue(EntityId quarry, float max_prediction_s) const {
  const Agent* other = store_.Find(quarry);
  return other ? SteerPursue(motion(), other->motion(), max_prediction_s) : Vec3{};
}

Vec3 Agent::ForceToEvade(EntityId menace, float max_prediction_s) const {
  const Agent* other = store_.Find(menace);
  return other ? SteerEvade(motion(), other->motion(), max_prediction_s) : Vec3{};
}

Vec3 Agent::ForceToTargetSpeed(float speed_mps) const {
  return IsFinite(speed_mps) ? SteerTargetSpeed(motion(), speed_mps, max_force_n_) : Vec3{};
}

Vec3 Agent::ForceToWander(float delta) {
  return IsFinite(delta) ? SteerWander(motion(), wander_, random_, delta) : Vec3{};
}

Vec3 Agent::ForceToFollowPath(float look_ahead_s) const {
  return SteerFollowPath(motion(), path_, LookAhead(look_ahead_s));
}

Vec3 Agent::ForceToStayOnPath(float look_ahead_s) const {
  return SteerStayOnPath(motion(), path_, LookAhead(look_ahead_s));
}

Vec3 Agent::ForceToAvoidAgents(float look_ahead_s) const {
  Lookout lookout(index_, store_.motions(), LookAhead(look_ahead_s), store_.max_speed(), store_.max_radius());
  store_.VisitNear(Position(), lookout.range_m(), [&](std::uint32_t other) {
    lookout.Look(other);
    return lookout.range_m();
  });
  return lookout.Force();
}

Vec3 Agent::ForceToAvoidObjects(float look_ahead_s) const {
  return SteerAvoidObjects(motion(), store_.physics().Obstacles(), LookAhead(look_ahead_s));
}

Vec3 Agent::GroupForce(GroupSteering steer, float max_distance_m, float max_angle_deg, const Group& group) const {
  const Neighbourhood neighbourhood{std::max(0.0f, max_distance_m), max_angle_deg};
  if (const auto* indices = std::get_if<std::span<const std::uint32_t>>(&group))
    return steer(index_, store_.motions(), *indices, neighbourhood);
  const std::span<const EntityId> agents = std::get<std::span<const EntityId>>(group);
  const bool everybody = agents.data() == store_.ids().data() && agents.size() == store_.ids().size();
  const auto others = everybody
                          ? store_.NearInOrder(Position(), NeighbourhoodRange(Radius(), neighbourhood.max_distance_m))
                          : store_.Indices(agents);
  return steer(index_, store_.motions(), others, neighbourhood);
}

Vec3 Agent::ForceToSeparate(float max_distance_m, float max_angle_deg, const Group& agents) const {
  return GroupForce(SteerSeparate, max_distance_m, max_angle_deg, agents);
}

Vec3 Agent::ForceToCombine(float max_distance_m, float max_angle_deg, const Group& agents) const {
  return GroupForce(SteerCombine, max_distance_m, max_angle_deg, agents);
}

Vec3 Agent::ForceToAlign(float max_distance_m, float max_angle_deg, const Group& agents) const {
  return GroupForce(SteerAlign, max_distance_m, max_angle_deg, agents);
}

}  // namespace soarbox::world
