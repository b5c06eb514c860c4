// SPDX-License-Identifier: BSD-2-Clause
#include "dis/state_sender.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "sim/arena.h"
#include "sim/directions.h"
#include "sim/foreign_bodies.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::dis {
namespace {

/// A rifle bullet, used if the table has no type: anti-personnel, ballistic, small arms.
constexpr EntityType kBullet{2, 8, 0, 2, 1, 0, 0};
constexpr double kMuzzle_mps = 900;
constexpr float kStandsStill_mps = 0.2f, kRuns_mps = 3.5f;

std::uint32_t PostureOf(const sim::Actor* actor, float speed_mps) {
  if (actor != nullptr && actor->stance() == "crouching") return appearance::kCrouching;
  if (actor != nullptr && actor->stance() == "prone") return appearance::kProne;
  if (speed_mps < kStandsStill_mps) return appearance::kStanding;
  return speed_mps < kRuns_mps ? appearance::kWalking : appearance::kRunning;
}

/// 0 unhurt, 1 slightly, 2 badly, 3 dead.
std::uint32_t DamageOf(float health, float full) {
  if (health <= 0) return 3;
  const float left = full > 0 ? health / full : 1;
  return left < 0.5f ? 2 : left < 0.85f ? 1 : 0;
}

std::string TextOf(const world::Message::Value& value) {
  std::string text;
  if (const auto* word = std::get_if<std::string>(&value)) text = *word;
  if (const auto* number = std::get_if<std::int64_t>(&value)) text = std::to_string(*number);
  if (const auto* number = std::get_if<double>(&value)) text = std::to_string(*number);
  std::replace(text.begin(), text.end(), ' ', '-');
  return text.empty() ? "-" : text;
}

}  // namespace

std::uint32_t RelativeTimestamp(double seconds) {
  const double hours = std::fmod(seconds, 3600) / 3600;
  return static_cast<std::uint32_t>(hours * 2147483648.0) << 1;
}

bool StateSender::IsOurs(const sim::Simulation& simulation, world::EntityId id) const {
  const world::Agent* agent = simulation.world().FindAgent(id);
  return agent != nullptr && agent->kind() != sim::kForeignKind;
}

StateSender::Entity& StateSender::EntityOf(const world::Agent& agent) {
  Entity& entity = entities_[agent.id()];
  if (entity.number == 0) entity.number = static_cast<std::uint16_t>(std::min<std::size_t>(entities_.size(), 65533));
  entity.name = agent.name();
  return entity;
}

std::string StateSender::NameOf(std::uint16_t number) const {
  for (const auto& [id, entity] : entities_)
    if (entity.number == number) return entity.name;
  return {};
}

EntityId StateSender::IdOf(const sim::Simulation& simulation, world::EntityId id) const {
  if (const auto ours = entities_.find(id); ours != entities_.end())
    return {settings_.site, settings_.application, ours->second.number};
  EntityId foreign;
  const std::string text(simulation.foreign().IdOf(id));
  unsigned parts[3] = {};
  if (std::sscanf(text.c_str(), "%u:%u:%u", &parts[0], &parts[1], &parts[2]) != 3) return foreign;
  return {static_cast<std::uint16_t>(parts[0]), static_cast<std::uint16_t>(parts[1]),
          static_cast<std::uint16_t>(parts[2])};
}

EntityState StateSender::StateOf(const sim::Simulation& simulation, const world::Agent& agent, bool is_still) {
  const sim::Actor* actor = simulation.arena().Find(agent.id());
  const bool is_alive = agent.Health() > 0;
  EntityState state;
  state.id = {settings_.site, settings_.application, EntityOf(agent).number};
  state.force = settings_.ForceOf(agent.Team());
  state.type = settings_.TypeOf(actor != nullptr ? std::string_view(actor->kind().name) : std::string_view("walker"));
  const world::Vec3 feet = agent.Position() - world::Vec3{0, agent.Height() / 2, 0};
  state.position = frame_.ToEarth(ToVector(feet));
  if (!is_still && is_alive) state.velocity = frame_.TurnToEarth(ToVector(agent.Velocity()));
  const world::Vec3 forward = sim::AlongHeading(sim::HeadingOf(agent.Forward()));
  state.orientation = frame_.ToEuler(ToVector(forward), {0, 1, 0});
  state.algorithm = is_alive ? DeadReckoning::kFpw : DeadReckoning::kStatic;
  const float full = actor != nullptr ? actor->kind().health : 100;
  state.appearance = DamageOf(agent.Health(), full) << appearance::kDamageShift;
  if (state.type.kind == 3) {
    state.appearance |= (is_alive ? PostureOf(actor, is_still ? 0 : agent.Speed()) : appearance::kProne)
                        << appearance::kPostureShift;
    if (actor != nullptr && actor->kind().armed && is_alive) state.appearance |= 3u << appearance::kWeaponShift;
  }
  if (is_still) state.appearance |= appearance::kFrozen;
  state.marking = agent.name().substr(0, 11);
  return state;
}

bool StateSender::MustBeTold(const Entity& entity, const EntityState& now, const world::Agent& agent, double now_s,
                             double sim_s) const {
  if (now_s - entity.sent_at_s >= settings_.heartbeat_s) return true;
  if (now.appearance != entity.sent.appearance || now.force != entity.sent.force) return true;
  const Vector supposed = entity.sent_position + entity.sent_velocity * (sim_s - entity.sent_at_sim_s);
  const Vector off = ToVector(agent.Position()) - supposed;
  if (Dot(off, off) > settings_.threshold_m * settings_.threshold_m) return true;
  const float turned = sim::WrapDegrees(sim::HeadingOf(agent.Forward()) - entity.sent_heading_deg);
  return std::abs(static_cast<double>(turned)) > settings_.threshold_deg;
}

void StateSender::AddStates(const sim::Simulation& simulation, double now_s, bool is_still, std::vector<Pdu>& pdus) {
  const double sim_s = simulation.time_s();
  for (const world::EntityId id : simulation.world().AgentIds()) {
    if (!IsOurs(simulation, id)) continue;
    const world::Agent& agent = *simulation.world().FindAgent(id);
    EntityState state = StateOf(simulation, agent, is_still);
    Entity& entity = EntityOf(agent);
    if (!MustBeTold(entity, state, agent, now_s, sim_s)) continue;
    entity.sent = state;
    entity.sent_at_s = now_s;
    entity.sent_at_sim_s = sim_s;
    entity.sent_position = ToVector(agent.Position());
    entity.sent_velocity = is_still || agent.Health() <= 0 ? Vector{} : ToVector(agent.Velocity());
    entity.sent_heading_deg = sim::HeadingOf(agent.Forward());
    pdus.push_back(Pdu{.body = std::move(state)});
  }
}

void StateSender::AddShots(const sim::Simulation& simulation, std::vector<Pdu>& pdus) {
  for (const sim::Arena::PastShot& past : simulation.arena().past().shots) {
    const world::Shot& shot = past.shot;
    if (past.tick != simulation.tick() || !IsOurs(simulation, shot.shooter)) continue;
    const Vector along = ToVector(shot.to - shot.from);
    const double range_m = std::sqrt(Dot(along, along));
    Fire fire;
    fire.shooter = IdOf(simulation, shot.shooter);
    fire.target = IdOf(simulation, shot.hit);
    fire.event = {settings_.site, settings_.application, ++events_};
    fire.position = frame_.ToEarth(ToVector(shot.from));
    fire.burst.munition = settings_.munitions.empty() ? kBullet : settings_.munitions.front().type.Type();
    if (range_m > 0) fire.velocity = frame_.TurnToEarth(along * (kMuzzle_mps / range_m));
    fire.range_m = static_cast<float>(range_m);
    Detonation hit;
    hit.shooter = fire.shooter;
    hit.target = fire.target;
    hit.event = fire.event;
    hit.velocity = fire.velocity;
    hit.position = frame_.ToEarth(ToVector(shot.to));
    hit.burst = fire.burst;
    const bool hits_entity = !fire.target.IsNobody();
    hit.result = static_cast<std::uint8_t>(hits_entity                    ? DetonationResult::kEntityImpact
                                           : shot.hit != world::kNoEntity ? DetonationResult::kOther
                                                                          : DetonationResult::kNone);
    pdus.push_back(Pdu{.body = fire});
    pdus.push_back(Pdu{.body = hit});
  }
}

void StateSender::AddCollisions(const sim::Simulation& simulation, std::vector<Pdu>& pdus) {
  for (const auto& actor : simulation.arena().actors()) {
    if (!IsOurs(simulation, actor->id())) continue;
    for (const sim::Happening& happening : actor->happenings()) {
      if (happening.tick != simulation.tick() || happening.type != "collision") continue;
      Collision collision;
      collision.issuer = IdOf(simulation, actor->id());
      collision.other = IdOf(simulation, simulation.arena().FindAgentNamed(happening.by));
      if (collision.other.IsNobody()) continue;
      collision.event = {settings_.site, settings_.application, ++events_};
      collision.velocity = frame_.TurnToEarth(ToVector(actor->body().Velocity()));
      collision.mass_kg = actor->body().Mass();
      collision.position_in_issuer.x = static_cast<double>(actor->body().Radius());
      pdus.push_back(Pdu{.body = collision});
    }
  }
}

void StateSender::AddMessages(const sim::Simulation& simulation, std::vector<Pdu>& pdus) {
  const world::MessageBoard& board = simulation.arena().board();
  for (std::size_t i = board.FirstAfter(last_message_); i < board.messages().size(); ++i) {
    const world::Message& message = board.messages()[i];
    if (!IsOurs(simulation, message.from)) continue;
    Comment comment;
    comment.from = IdOf(simulation, message.from);
    comment.to = IdOf(simulation, message.to);
    std::string fields;
    for (const world::Message::Field& field : message.fields)
      fields += (fields.empty() ? "" : " ") + field.name + " " + TextOf(field.value);
    comment.texts = {message.about.empty() ? "-" : message.about, std::move(fields), message.team};
    pdus.push_back(Pdu{.body = std::move(comment)});
  }
  last_message_ = board.posted();
}

std::vector<Pdu> StateSender::AfterTick(const sim::Simulation& simulation, double now_s) {
  std::vector<Pdu> pdus;
  AddStates(simulation, now_s, false, pdus);
  AddShots(simulation, pdus);
  AddCollisions(simulation, pdus);
  AddMessages(simulation, pdus);
  return pdus;
}

std::vector<Pdu> StateSender::WhileStill(const sim::Simulation& simulation, double now_s) {
  std::vector<Pdu> pdus;
  AddStates(simulation, now_s, true, pdus);
  return pdus;
}

std::vector<Pdu> StateSender::Leave() {
  std::vector<Pdu> pdus;
  for (auto& [id, entity] : entities_) {
    if (entity.sent_at_s < 0) continue;
    entity.sent.appearance |= appearance::kDeactivated;
    pdus.push_back(Pdu{.body = entity.sent});
  }
  return pdus;
}

}  // namespace soarbox::dis
