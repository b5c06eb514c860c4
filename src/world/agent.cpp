// SPDX-License-Identifier: BSD-2-Clause
#include "world/agent.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "world/agent_store.h"
#include "world/limits.h"
#include "world/physics_world.h"
#include "world/rotation.h"
#include "world/scene.h"
#include "world/state_hash.h"

namespace soarbox::world {
namespace {

float HorizontalLength(Vec3 v) {
  return std::sqrt(v.x * v.x + v.z * v.z);
}

bool SetAtLeastZero(float value, float& property) {
  if (!IsFinite(value)) return false;
  property = std::max(0.0f, value);
  return true;
}

}  // namespace

Agent::Agent(AgentStore& store, EntityId id, NodeId node, std::size_t index, const AgentDef& def, std::uint64_t seed)
    : store_(store),
      id_(id),
      node_(node),
      index_(index),
      body_(BodyId::kNone),
      name_(def.name.empty() ? "agent-" + std::to_string(Number(id)) : def.name),
      kind_(def.kind),
      script_(def.script),
      random_(seed, Number(id)),
      height_m_(def.defaults.height_m),
      mass_kg_(def.defaults.mass_kg),
      max_force_n_(def.defaults.max_force_n),
      max_speed_mps_(def.defaults.max_speed_mps),
      health_(def.defaults.health),
      target_radius_m_(def.defaults.target_radius_m) {
  motion().radius = def.defaults.radius_m;
  motion().alive = health_ > 0;
  store_.ChangeTeam(index_, {}, team_);
  RebuildBody();
}

AgentMotion& Agent::motion() {
  return store_.motion(index_);
}
const AgentMotion& Agent::motion() const {
  return store_.motion(index_);
}
bool Agent::HasBody() const {
  return body_ != BodyId::kNone;
}

void Agent::MoveNode() {
  store_.scene().PlaceWorldNode(node_, motion().position, motion().orientation);
  is_node_placed_ = true;
}

void Agent::RebuildBody() {
  if (HasBody()) store_.physics().Remove(body_);
  BodyDef def;
  def.shape = BodyShape::kCapsule;
  def.size = {Radius(), height_m_, 0};
  def.mass_kg = mass_kg_;
  def.upright = true;
  def.position = Position();
  def.orientation = Orientation();
  def.owner = id_;
  body_ = store_.physics().Add(def);
  motion().velocity = {};
  motion().speed = 0;
}

void Agent::SetTeam(std::string_view team) {
  if (team == team_) return;
  store_.ChangeTeam(index_, team_, team);
  SetLabel(team, team_);
  PropertyChanged();
}

bool Agent::SetPosition(Vec3 position) {
  if (!IsFinite(position)) return false;
  motion().position = LimitPosition(position);
  if (HasBody()) store_.physics().SetPosition(body_, motion().position);
  store_.Moved(index_);
  MoveNode();
  return true;
}

bool Agent::SetForward(Vec3 forward) {
  Quat rotation;
  if (!FacingAlong(forward, rotation)) return false;
  AgentMotion& moving = motion();
  moving.orientation = rotation;
  moving.left = Rotate(rotation, {1, 0, 0});
  moving.up = Rotate(rotation, {0, 1, 0});
  moving.forward = Rotate(rotation, {0, 0, 1});
  if (HasBody()) {
    store_.physics().SetOrientation(body_, rotation);
  } else {
    moving.velocity = moving.forward * moving.speed;
  }
  MoveNode();
  return true;
}

bool Agent::SetVelocity(Vec3 velocity) {
  if (!IsFinite(velocity)) return false;
  AgentMotion& moving = motion();
  const Vec3 limited = LimitVelocity(velocity);
  moving.speed = HorizontalLength(limited);
  if (HasBody()) {
    store_.physics().SetVelocity(body_, limited);
    moving.velocity = limited;
  } else {
    moving.velocity = moving.forward * moving.speed;
  }
  store_.SpeedOrRadiusChanged(index_);
  return true;
}

bool Agent::SetSpeed(float speed) {
  if (!IsFinite(speed)) return false;
  if (HasBody()) return true;
  AgentMotion& moving = motion();
  moving.speed = std::clamp(speed, -PhysicsWorld::kMaxSpeed_mps, PhysicsWorld::kMaxSpeed_mps);
  moving.velocity = moving.forward * moving.speed;
  store_.SpeedOrRadiusChanged(index_);
  return true;
}

Vec3 Agent::PredictFuturePosition(float seconds) const {
  return IsFinite(seconds) ? Position() + Velocity() * std::max(0.0f, seconds) : Position();
}

bool Agent::ApplyForce(Vec3 force_n) {
  if (!IsFinite(force_n)) return false;
  if (HasBody()) store_.physics().ApplyForce(body_, LimitForce(force_n));
  return true;
}

void Agent::RemovePhysics() {
  if (!HasBody()) return;
  store_.physics().Remove(body_);
  body_ = BodyId::kNone;
  PropertyChanged();
  motion().velocity = Forward() * Speed();
}

bool Agent::SetHeight(float height_m) {
  if (!IsFinite(height_m)) return false;
  height_m_ = std::clamp(height_m, 0.0f, PhysicsWorld::kMaxSize_m);
  PropertyChanged();
  if (HasBody()) RebuildBody();
  return true;
}

bool Agent::SetRadius(float radius_m) {
  if (!IsFinite(radius_m)) return false;
  motion().radius = std::clamp(radius_m, 0.0f, PhysicsWorld::kMaxSize_m);
  PropertyChanged();
  store_.SpeedOrRadiusChanged(index_);
  if (HasBody()) RebuildBody();
  return true;
}

bool Agent::SetMass(float mass_kg) {
  if (!IsFinite(mass_kg)) return false;
  mass_kg_ = mass_kg;
  PropertyChanged();
  if (HasBody()) {
    store_.physics().SetMass(body_, std::max(0.0f, mass_kg));
    motion().velocity = store_.physics().Velocity(body_);
    motion().speed = HorizontalLength(motion().velocity);
  }
  return true;
}

bool Agent::SetMaxForce(float newtons) {
  PropertyChanged();
  return SetAtLeastZero(newtons, max_force_n_);
}
bool Agent::SetMaxSpeed(float mps) {
  PropertyChanged();
  return SetAtLeastZero(mps, max_speed_mps_);
}
bool Agent::SetTargetRadius(float metres) {
  PropertyChanged();
  return SetAtLeastZero(metres, target_radius_m_);
}

bool Agent::SetHealth(float health) {
  if (!IsFinite(health)) return false;
  health_ = health;
  PropertyChanged();
  motion().alive = health > 0;
  return true;
}

bool Agent::SetScore(float score) {
  if (!std::isfinite(score)) return false;
  score_ = score;
  return true;
}

bool Agent::SetTarget(Vec3 target) {
  if (!IsFinite(target)) return false;
  target_ = target;
  PropertyChanged();
  return true;
}

void Agent::SetPath(std::span<const Vec3> points, bool cyclic) {
  std::vector<Vec3> usable;
  usable.reserve(points.size());
  for (const Vec3 point : points) {
    if (IsFinite(point)) usable.push_back(LimitPosition(point));
  }
  path_ = Path(usable, cyclic, Radius());
  has_path_ = true;
  PropertyChanged();
}

std::uint64_t Agent::MakeHashOfProperties() const {
  StateHash hash;
  hash.Add(Radius(), height_m_);
  hash.Add(mass_kg_, max_force_n_);
  hash.Add(max_speed_mps_, health_);
  hash.Add(target_);
  hash.Add(target_radius_m_);
  hash.Add(std::string_view(team_));
  hash.Add(static_cast<std::uint64_t>(Number(leader_)));
  hash.Add(static_cast<std::uint64_t>(HasBody()));
  // Path steering continues along the old points after RemovePath, so they are always part of the hash.
  hash.Add(static_cast<std::uint64_t>(has_path_));
  for (const Vec3 point : path_.points()) hash.Add(point);
  return hash.value();
}

std::span<const Vec3> Agent::PathPoints() const {
  return has_path_ ? path_.points() : std::span<const Vec3>{};
}

std::optional<Vec3> Agent::NearestPointOnPath(Vec3 point) const {
  if (!has_path_ || path_.empty() || !IsFinite(point)) return std::nullopt;
  return path_.NearestTo(point).point;
}

std::optional<float> Agent::DistanceAlongPath(Vec3 point) const {
  if (!has_path_ || path_.empty() || !IsFinite(point)) return std::nullopt;
  return path_.NearestTo(point).distance_along_m;
}

std::optional<Vec3> Agent::PointOnPath(float distance_m) const {
  if (!has_path_ || path_.empty() || !IsFinite(distance_m)) return std::nullopt;
  return path_.PointAt(distance_m);
}

}  // namespace soarbox::world
