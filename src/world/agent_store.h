// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "world/agent.h"
#include "world/agent_grid.h"
#include "world/agent_motion.h"
#include "world/physics_world.h"
#include "world/scene.h"
#include "world/steer_avoid_objects.h"
#include "world/team_numbers.h"
#include "world/world_settings.h"

namespace soarbox::world {

/// All agents of one world, their motions side by side for steering, and the index that finds neighbours.
///
/// Invariants: agent i (in creation order) and motion i belong together; a motion equals its body's state at all times;
/// max_speed and max_radius are upper bounds; ids are those of the agents that were not removed, in creation order.
class AgentStore {
 public:
  AgentStore(const WorldSettings& settings, PhysicsWorld& physics, Scene& scene)
      : seed_(settings.seed), physics_(physics), scene_(scene) {}

  /// The store that contains an agent.
  static AgentStore& Of(const Agent& agent) { return agent.store_; }

  Agent& Create(EntityId id, NodeId node, const AgentDef& def);
  /// Removes its body and its node. From now on, only Find returns the agent; ids(), Indices and the searches near a
  /// place leave it out. It keeps its index.
  void Remove(Agent& agent);
  /// Null for ids that are not agents'.
  Agent* Find(EntityId id) const;
  std::span<const EntityId> ids() const { return ids_; }
  Agent& agent(std::size_t index) const { return *agents_[index]; }
  std::size_t size() const { return agents_.size(); }

  /// Updates the motions from the bodies after a physics step.
  void ReadBodies();

  /// See PhysicsWorld::IsClearToEither.
  bool IsClearToEither(Vec3 from, Vec3 to, Vec3 other, const Agent& viewer, const Agent& target,
                       const BodiesAround* around) const {
    return physics_.IsClearToEither(from, to, other, viewer.body_, target.body_, around);
  }

  PhysicsWorld& physics() { return physics_; }
  Scene& scene() { return scene_; }
  std::span<const AgentMotion> motions() const { return motions_; }
  AgentMotion& motion(std::size_t index) { return motions_[index]; }
  const AgentMotion& motion(std::size_t index) const { return motions_[index]; }
  /// Call it after a change of position, speed or radius.
  void Moved(std::size_t index);
  void SpeedOrRadiusChanged(std::size_t index);
  float max_speed() const { return max_speed_; }
  float max_radius() const { return max_radius_; }

  /// See AgentGrid::Visit.
  template <class Visitor>
  void VisitNear(Vec3 center, float range_m, Visitor visit) {
    grid_.Update(motions_);
    grid_.Visit(motions_, center, range_m, visit);
  }
  /// Indices of a superset of the agents within range_m, in ascending order; with a team, only those in the team. Valid
  /// until the next call of this function. If the arguments are those of the previous call and no agent has moved
  /// since, returns the previous result: the forces of a flock often have the same range.
  std::span<const std::uint32_t> NearInOrder(Vec3 center, float range_m, std::optional<std::string_view> team = {});
  /// Afterwards several threads may call CopyNear, until an agent moves or is created.
  void PrepareCopyNear() { grid_.Update(motions_); }
  /// Replaces `found` by the result of NearInOrder.
  void CopyNear(Vec3 center, float range_m, std::vector<std::uint32_t>& found) const;
  /// Indices of the agents with these ids, in the same order; skips ids of other things. Valid until the next call.
  std::span<const std::uint32_t> Indices(std::span<const EntityId> ids);

 private:
  friend class Agent;
  /// Agents call it when they are created (`from` is ignored), and before they change their team.
  void ChangeTeam(std::size_t index, std::string_view from, std::string_view to);
  std::span<const std::uint32_t> OnlyTeam(std::string_view team);

  std::uint64_t seed_;
  PhysicsWorld& physics_;
  Scene& scene_;
  std::vector<std::unique_ptr<Agent>> agents_;
  std::vector<EntityId> ids_;
  std::vector<AgentMotion> motions_;
  std::vector<std::uint32_t> index_by_id_;  ///< kNoIndex for ids of other things.
  AgentGrid grid_;
  std::vector<std::uint32_t> scratch_;  ///< The result of Indices.
  std::vector<std::uint32_t> near_;     ///< The result of NearInOrder.
  Vec3 near_center_;
  float near_range_m_ = 0;
  bool near_is_valid_ = false;
  TeamNumbers teams_;
  std::vector<std::uint32_t> near_in_team_;       ///< The agents of near_team_ in near_.
  std::uint32_t near_team_ = TeamNumbers::kNone;  ///< kNone if near_in_team_ is not valid.
  float max_speed_ = 0;
  float max_radius_ = 0;
};

}  // namespace soarbox::world
