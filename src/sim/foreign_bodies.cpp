// SPDX-License-Identifier: BSD-2-Clause
#include "sim/foreign_bodies.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "sim/directions.h"
#include "world/state_hash.h"

namespace soarbox::sim {
namespace {

constexpr float kSmooth_s = 0.5f;  ///< Time in which the error of a position is corrected.
constexpr float kJump_m = 5;       ///< Larger errors are corrected at once.
constexpr float kLongest_s = 60;   ///< Maximum time of dead reckoning.
constexpr float kBelow_m = 60;     ///< Depth at which bodies that have left are hidden.
constexpr std::size_t kMostFields = 20;

}  // namespace

ForeignBodies::ForeignBodies(world::World& world, Arena& arena, Arena::Report report)
    : world_(world), arena_(arena), report_(std::move(report)) {}

void ForeignBodies::Warn(std::string message) {
  RunEvent event;
  event.kind = EventKind::kDiagnostic;
  event.diagnostic.severity = Severity::kWarning;
  event.diagnostic.message = std::move(message);
  report_(std::move(event));
}

world::EntityId ForeignBodies::Make(const ForeignBodyInput& input, std::span<const BodyKind> kinds) {
  world::AgentDef def;
  def.name = input.name;
  // The id distinguishes it from another agent with the same name.
  if (def.name.empty() || arena_.FindAgentNamed(def.name) != world::kNoEntity) def.name += "@" + input.id;
  def.kind = kForeignKind;
  const world::EntityId id = world_.CreateAgent(def);
  if (id == world::kNoEntity) return id;
  const auto named = std::find_if(kinds.begin(), kinds.end(), [&](const BodyKind& k) { return k.name == input.body; });
  arena_.Add(id, named == kinds.end() ? BodyKinds().front() : *named);
  // Only its owner moves it.
  world_.FindAgent(id)->SetMaxForce(0);
  return id;
}

float ForeignBodies::Age(const Body& body) const {
  return std::min(static_cast<float>(world_.tick() - body.said_tick) * world_.settings().step_s, kLongest_s);
}

world::Vec3 ForeignBodies::PlaceOf(const Body& body) const {
  const float age_s = Age(body);
  const float rest = std::max(0.0f, 1 - age_s / kSmooth_s);
  return body.said.position + body.said.velocity * age_s + body.said.acceleration * (age_s * age_s / 2) +
         body.off * rest;
}

void ForeignBodies::Apply(const ForeignBodyInput& input, std::span<const BodyKind> kinds) {
  auto at = bodies_.find(input.id);
  // Dead bodies stay where they fell. If a body is alive again, a new body is created.
  if (at != bodies_.end() && input.health > 0 && world_.FindAgent(at->second.agent)->Health() <= 0) {
    ids_.erase(at->second.agent);
    bodies_.erase(at);
    at = bodies_.end();
  }
  const bool is_new = at == bodies_.end();
  if (is_new) {
    if (bodies_.size() >= kMost) {
      if (!std::exchange(told_of_limit_, true))
        Warn("there are " + std::to_string(kMost) + " foreign bodies: further ones are left out");
      return;
    }
    Body made;
    made.agent = Make(input, kinds);
    if (made.agent == world::kNoEntity) return Warn("the world cannot hold another foreign body");
    ids_[made.agent] = input.id;
    at = bodies_.emplace(input.id, std::move(made)).first;
  }
  Body& body = at->second;
  const world::Vec3 off = is_new ? world::Vec3{} : PlaceOf(body) - input.position;
  body.off = world::Length(off) > kJump_m ? world::Vec3{} : off;
  body.said = input;
  body.said_tick = world_.tick();
  world::Agent& agent = *world_.FindAgent(body.agent);
  agent.SetTeam(input.team);
  agent.SetHealth(input.health);
  if (Actor* actor = arena_.Find(body.agent)) actor->SetStance(input.stance == "crouching" ? "crouching" : "standing");
  if (is_new) agent.SetPosition(input.position + world::Vec3{0, agent.Height() / 2, 0});
}

void ForeignBodies::Apply(const ForeignGoneInput& input) {
  const auto at = bodies_.find(input.id);
  if (at == bodies_.end()) return;
  world::Agent& agent = *world_.FindAgent(at->second.agent);
  arena_.Tell(agent.id(), "leaves", "its simulation no longer reports it");
  agent.SetHealth(0);
  world_.scene().SetVisible(agent.node(), false);
  agent.SetPosition(agent.Position() - world::Vec3{0, kBelow_m, 0});
  ids_.erase(at->second.agent);
  bodies_.erase(at);
}

void ForeignBodies::Hurt(world::EntityId victim, float damage, bool& killed) {
  world::Agent& agent = *world_.FindAgent(victim);
  if (agent.Health() <= 0 || damage <= 0) return;
  agent.SetHealth(std::max(0.0f, agent.Health() - damage));
  killed = agent.Health() <= 0;
}

void ForeignBodies::Apply(const ForeignShotInput& input) {
  world::Shot shot;
  shot.shooter = Find(input.id);
  shot.from = input.from;
  shot.to = input.to;
  const world::EntityId target = input.target.empty() ? world::kNoEntity : arena_.FindAgentNamed(input.target);
  if (target != world::kNoEntity && IdOf(target).empty()) {
    shot.hit = target;
    shot.damage = std::max(0.0f, input.damage);
    Hurt(target, shot.damage, shot.killed);
  }
  for (std::size_t i = 0; input.radius_m > 0 && i < world_.AgentIds().size(); ++i) {
    const world::EntityId id = world_.AgentIds()[i];
    const world::Agent& agent = *world_.FindAgent(id);
    const float range_m = world::Distance(agent.Position(), input.to);
    if (id == shot.hit || !IdOf(id).empty() || range_m >= input.radius_m || agent.Health() <= 0) continue;
    bool killed = false;
    Hurt(id, input.damage * (1 - range_m / input.radius_m), killed);
    if (killed) arena_.Tell(id, "dies", "by a detonation");
  }
  if (shot.shooter != world::kNoEntity) return arena_.OnShot(shot);
  if (shot.killed) arena_.Tell(shot.hit, "dies", "shot by somebody who is not in this world");
}

void ForeignBodies::Apply(const ForeignMessageInput& input) {
  const auto from = bodies_.find(input.id);
  if (from == bodies_.end()) return;
  world::Message message;
  message.from = from->second.agent;
  message.team = input.team.empty() ? from->second.said.team : input.team;
  message.about = input.about;
  std::istringstream words(input.text);
  std::string name, value;
  while (message.fields.size() < kMostFields && words >> name >> value) message.fields.push_back({name, value});
  arena_.board().Post(std::move(message), world_.tick());
}

void ForeignBodies::Move() {
  for (auto& [id, body] : bodies_) {
    world::Agent& agent = *world_.FindAgent(body.agent);
    // Damage by our shots is valid only when the owner reports it.
    if (agent.Health() > 0) agent.SetHealth(body.said.health);
    if (agent.Health() <= 0) continue;
    const float age_s = Age(body);
    const float step_s = world_.settings().step_s;
    const world::Vec3 velocity = body.said.velocity + body.said.acceleration * age_s;
    agent.SetForward(AlongHeading(body.said.heading_deg + body.said.turn_dps * age_s));
    // The physics step moves it to its position.
    agent.SetPosition(PlaceOf(body) + world::Vec3{0, agent.Height() / 2, 0} - velocity * step_s);
    agent.SetVelocity(velocity);
    world_.SyncAgent(body.agent);
  }
}

std::string_view ForeignBodies::IdOf(world::EntityId agent) const {
  const auto at = ids_.find(agent);
  return at == ids_.end() ? std::string_view() : std::string_view(at->second);
}

world::EntityId ForeignBodies::Find(const std::string& id) const {
  const auto at = bodies_.find(id);
  return at == bodies_.end() ? world::kNoEntity : at->second.agent;
}

void ForeignBodies::AddTo(world::StateHash& hash) const {
  for (const auto& [id, body] : bodies_) {
    hash.Add(std::string_view(id));
    hash.Add(body.said.position);
    hash.Add(body.said.velocity);
    hash.Add(body.said_tick);
  }
}

}  // namespace soarbox::sim
