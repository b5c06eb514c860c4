// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "world/agent_motion.h"
#include "world/entity_ids.h"
#include "world/math.h"
#include "world/path.h"
#include "world/shown_state.h"
#include "world/steer_wander.h"
#include "world/world_random.h"
#include "world/world_settings.h"

namespace soarbox::world {

class AgentStore;
struct Neighbourhood;
enum class BodyId : std::uint32_t;

/// The identity of an agent. Its physical properties come from AgentDefaults.
struct AgentDef {
  std::string name;    ///< Shown in labels; "agent-<id>" if empty.
  std::string kind;    ///< "lua", "soar seeking", ...
  std::string script;  ///< File name of its body script.
  AgentDefaults defaults;
};

/// One agent: an upright capsule that physics moves but never turns, and the properties that scripts read and write.
///
/// Owned by the World and destroyed with it, even if it was removed earlier; found by id (World::FindAgent).
/// Position is the centre of the capsule: the feet are at y - height / 2. All getters are current, also in the middle
/// of a tick. Values that are not finite are refused (the setter returns false and changes nothing); sizes and
/// positions are clamped to the limits of the physics. Used by the simulation's thread only.
class Agent {
 public:
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  EntityId id() const { return id_; }
  /// Its scene node, the parent of its drawables. It is moved to the body by World::SyncAgent.
  NodeId node() const { return node_; }
  const std::string& name() const { return name_; }
  const std::string& kind() const { return kind_; }
  const std::string& script() const { return script_; }
  /// The agent's own random stream, seeded from the world's seed and the agent's id.
  RandomStream& random() { return random_; }

  // Motion.
  Vec3 Position() const { return motion().position; }
  /// Moves body and node; does not change the velocity.
  bool SetPosition(Vec3 position);
  Vec3 Forward() const { return motion().forward; }
  Vec3 Left() const { return motion().left; }
  Vec3 Up() const { return motion().up; }
  Quat Orientation() const { return motion().orientation; }
  /// Sets the direction in which it faces (any length; may tilt). Refuses zero and vertical vectors.
  bool SetForward(Vec3 forward);
  /// In m/s, including the vertical part. Without a body: forward times the stored speed.
  Vec3 Velocity() const { return motion().velocity; }
  /// Without a body, only stores the horizontal speed.
  bool SetVelocity(Vec3 velocity);
  /// Horizontal speed in m/s.
  float Speed() const { return motion().speed; }
  /// Has no effect while the agent has a body.
  bool SetSpeed(float speed);
  /// Position after `seconds` (at least 0) at the present velocity.
  Vec3 PredictFuturePosition(float seconds) const;
  /// Applies a force in newtons at the centre of mass, for the next step only; forces add up. Ignored without a body.
  bool ApplyForce(Vec3 force_n);
  /// Removes the body for good. Afterwards the agent does not collide, and only SetPosition and SetForward move it.
  void RemovePhysics();
  bool HasBody() const;

  // Properties. Lengths, speeds and forces are clamped to >= 0.
  float Height() const { return height_m_; }
  /// Rebuilds the capsule around the same centre. Velocity and forces are lost.
  bool SetHeight(float height_m);
  float Radius() const { return motion().radius; }
  /// Rebuilds the capsule as SetHeight does.
  bool SetRadius(float radius_m);
  float Mass() const { return mass_kg_; }
  /// The body gets max(0, mass); 0 makes it immovable.
  bool SetMass(float mass_kg);
  float MaxForce() const { return max_force_n_; }
  bool SetMaxForce(float newtons);
  /// The world does not limit the velocity to it; callers must do so (ClampHorizontalSpeed).
  float MaxSpeed() const { return max_speed_mps_; }
  bool SetMaxSpeed(float mps);
  float Health() const { return health_; }
  /// Not clamped. If it is <= 0, others stop avoiding the agent; nothing else changes.
  bool SetHealth(float health);
  /// Its score, if it takes part in a game. Nothing in the world depends on it.
  std::optional<float> Score() const { return score_; }
  bool SetScore(float score);
  const std::string& Team() const { return team_; }
  void SetTeam(std::string_view team);
  Vec3 Target() const { return target_; }
  bool SetTarget(Vec3 target);
  float TargetRadius() const { return target_radius_m_; }
  bool SetTargetRadius(float metres);
  /// The agent that this one follows; kNoEntity if none.
  EntityId Leader() const { return leader_; }
  void SetLeader(EntityId leader) {
    leader_ = leader;
    PropertyChanged();
  }

  // State of its mind, only for labels and panels.
  const std::string& LastCommand() const { return last_command_; }
  void SetLastCommand(std::string_view command) { SetLabel(command, last_command_); }
  /// What its script shows of its state (Agent.Show). Nothing in the world depends on it.
  const ShownState& Shown() const { return shown_; }
  void Show(std::string_view topic, std::vector<ShownRow> rows, std::uint64_t tick) {
    if (shown_.Show(topic, std::move(rows), tick)) ++texts_;
  }
  bool Failed() const { return failed_; }
  void SetFailed(bool failed) { failed_ = failed; }

  /// It was removed (World::RemoveAgent): it has no body, no node and no health, and World::AgentIds leaves it out.
  bool IsGone() const { return motion().gone; }

  // Path.
  /// The radius of the path's tube is the present radius of the agent. Points that are not finite are skipped.
  void SetPath(std::span<const Vec3> points, bool cyclic);
  /// HasPath becomes false, but the path forces still steer along the old points (lua_api.md 17, quirk 5).
  void RemovePath() {
    has_path_ = false;
    PropertyChanged();
  }
  bool HasPath() const { return has_path_; }
  /// Points for scripts; empty if HasPath is false.
  std::span<const Vec3> PathPoints() const;
  /// The following three return nothing without a path, or if the path has no points.
  std::optional<Vec3> NearestPointOnPath(Vec3 point) const;
  std::optional<float> DistanceAlongPath(Vec3 point) const;
  std::optional<Vec3> PointOnPath(float distance_m) const;

  // Steering (lua_api.md 7). Each function returns a vector that the caller scales. Only functions that say so limit it
  // to MaxForce. Look-ahead times are raised to at least 0.1 s.
  static constexpr float kDefaultLookAhead_s = 0.1f;
  Vec3 ForceToPosition(Vec3 target) const;
  Vec3 ForceToFleePosition(Vec3 danger) const;
  /// Seeks (flees) the quarry's position after the time needed to reach it, at most max_prediction_s ahead.
  Vec3 ForceToPursue(EntityId quarry, float max_prediction_s) const;
  Vec3 ForceToEvade(EntityId menace, float max_prediction_s) const;
  /// Along forward; limited to MaxForce.
  Vec3 ForceToTargetSpeed(float speed_mps) const;
  /// Draws two numbers from the agent's stream. Scripts pass milliseconds as `delta`, which saturates the result
  /// (lua_api.md 17, quirk 4).
  Vec3 ForceToWander(float delta);
  Vec3 ForceToFollowPath(float look_ahead_s = kDefaultLookAhead_s) const;
  Vec3 ForceToStayOnPath(float look_ahead_s = kDefaultLookAhead_s) const;
  Vec3 ForceToAvoidAgents(float look_ahead_s = kDefaultLookAhead_s) const;
  Vec3 ForceToAvoidObjects(float look_ahead_s = kDefaultLookAhead_s) const;
  /// The agents that a group force considers, in order: their ids, or their indices in the AgentStore.
  using Group = std::variant<std::span<const EntityId>, std::span<const std::uint32_t>>;
  /// Group forces: unit vectors, or zero without neighbours. The agent itself and unknown ids are skipped. If `agents`
  /// is World::AgentIds() itself (not a copy), short distances use the spatial index; the result is the same.
  Vec3 ForceToSeparate(float max_distance_m, float max_angle_deg, const Group& agents) const;
  Vec3 ForceToCombine(float max_distance_m, float max_angle_deg, const Group& agents) const;
  Vec3 ForceToAlign(float max_distance_m, float max_angle_deg, const Group& agents) const;

 private:
  friend class AgentStore;
  friend class World;
  Agent(AgentStore& store, EntityId id, NodeId node, std::size_t index, const AgentDef& def, std::uint64_t seed);

  AgentMotion& motion();
  const AgentMotion& motion() const;
  void MoveNode();
  bool SetLabel(std::string_view text, std::string& label) {
    if (label == text) return false;
    label = text;
    ++texts_;
    return true;
  }
  /// Hash of all properties that determine its future, except its motion, random stream and wandering state. Cached
  /// until a setter calls PropertyChanged.
  std::uint64_t HashOfProperties() {
    if (!properties_are_known_) properties_ = MakeHashOfProperties();
    properties_are_known_ = true;
    return properties_;
  }
  std::uint64_t MakeHashOfProperties() const;
  void PropertyChanged() { properties_are_known_ = false; }
  void RebuildBody();
  using GroupSteering = Vec3 (*)(std::size_t self_index, std::span<const AgentMotion> all,
                                 std::span<const std::uint32_t> others, const Neighbourhood& neighbourhood);
  Vec3 GroupForce(GroupSteering steer, float max_distance_m, float max_angle_deg, const Group& group) const;

  AgentStore& store_;
  EntityId id_;
  NodeId node_;
  std::size_t index_;
  BodyId body_;
  std::string name_, kind_, script_;
  RandomStream random_;
  float height_m_, mass_kg_, max_force_n_, max_speed_mps_, health_, target_radius_m_;
  std::optional<float> score_;
  Vec3 target_;
  std::string team_ = "team1";
  EntityId leader_ = kNoEntity;
  std::string last_command_;
  ShownState shown_;
  std::uint32_t texts_ = 1;  ///< Changes with team, last command and shown state.
  bool failed_ = false;
  bool removal_requested_ = false;
  bool has_path_ = false;
  bool is_node_placed_ = false;  ///< The node is at the present position of the body.
  Path path_;
  WanderState wander_;
  std::uint64_t properties_ = 0;
  bool properties_are_known_ = false;
};

}  // namespace soarbox::world
