// SPDX-License-Identifier: BSD-2-Clause
#include "sim/overlays.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

using world::AgentOverlay;
using world::EntityId;
using world::Vec3;

constexpr double kSpeechStays_s = 4;

std::uint32_t NumberOrNone(EntityId id) {
  return id == world::kNoEntity ? 0 : Number(id);
}

double SecondsSince(const world::World& world, std::uint64_t tick) {
  return static_cast<double>(world.tick() - std::min(tick, world.tick())) *
         static_cast<double>(world.settings().step_s);
}

void AddContacts(const Actor& actor, AgentOverlay& out) {
  for (const auto& [id, contact] : actor.contacts()) {
    world::ContactSnapshot& seen = out.contacts.emplace_back();
    seen.agent_id = Number(id);
    seen.position = contact.position;
    seen.forward = contact.forward;
    seen.age_s = SecondsSince(actor.world(), contact.noticed_tick);
    seen.memory_s = static_cast<double>(std::max(0.1f, actor.kind().senses.memory_s));
    seen.visible = contact.visible;
    seen.heard = contact.source == Contact::Source::kHearing;
    seen.alive = contact.alive;
  }
}

/// Adds an agent that commands control, or that has at least senses.
void AddActor(const Actor& actor, AgentOverlay& out) {
  const SenseSettings& senses = actor.kind().senses;
  out.has_senses = true;
  if (senses.Has("agents") || senses.Has("objects")) {
    out.sight_m = senses.sight_m;
    out.view_deg = std::clamp(senses.view_deg, 0.0f, 360.0f);
  }
  out.hearing_m = senses.hearing_m;
  out.target_id = NumberOrNone(actor.target());
  for (const Running& command : actor.running()) {
    if (command.row == nullptr) continue;
    // Movement is the most informative of several commands.
    const bool is_of_legs = command.row->part == vocabulary::BodyPart::kLegs;
    if (out.doing.empty() || is_of_legs) out.doing = command.said.name;
    if (!is_of_legs) continue;
    out.path = command.path;
    if (command.goal) out.goal = command.goal;
    if (!command.path.empty()) out.goal = command.path.back();
  }
  AddContacts(actor, out);
}

/// Adds an agent that a script controls: its path and target are those that the script has set.
void AddScripted(const world::Agent& body, AgentOverlay& out) {
  const std::span<const Vec3> points = body.PathPoints();
  out.path.assign(points.begin(), points.end());
  out.path_is_whole = true;
  if (out.path.empty() && out.leader_id == 0 && body.Target() != Vec3{}) out.goal = body.Target();
}

/// Adds the place to which the thesis' ^distance is measured: see Minds::PerceiveDistance.
void AddMeasured(const world::World& world, const world::Agent& body, const Minds::Mind& mind, AgentOverlay& out) {
  const world::Agent* leader = body.Leader() != world::kNoEntity ? world.FindAgent(body.Leader()) : nullptr;
  if (leader != nullptr) {
    out.measured = leader->Position();
  } else if (!mind.follows_leader) {
    out.measured = body.Target();
  }
}

std::string TextOf(const world::Message& message) {
  std::string text = message.about;
  for (const world::Message::Field& field : message.fields) {
    text += text.size() == message.about.size() ? ": " : ", ";
    text += field.name + " ";
    if (const auto* word = std::get_if<std::string>(&field.value)) {
      text += *word;
    } else if (const auto* whole = std::get_if<std::int64_t>(&field.value)) {
      text += std::to_string(*whole);
    } else {
      char number[32];
      std::snprintf(number, sizeof number, "%.4g", std::get<double>(field.value));
      text += number;
    }
  }
  return text;
}

/// The position of the name of a thing or item: above it.
Vec3 TopOf(const world::Object& object) {
  constexpr float kHighest_m = 2.5f;
  return object.Position() + Vec3{0, std::min(object.Radius(), kHighest_m), 0};
}

void AddPlaces(const Arena& arena, std::vector<world::PlaceSnapshot>& out) {
  using Kind = world::PlaceSnapshot::Kind;
  const Places& places = arena.places();
  for (const Waypoint& waypoint : places.waypoints) out.push_back({Kind::kWaypoint, waypoint.name, waypoint.position});
  for (const Region& region : places.regions) out.push_back({Kind::kRegion, region.name, region.center});
  for (const auto& [id, name] : places.object_names) {
    const world::Object* object = arena.world().FindObject(id);
    if (object == nullptr) continue;
    const bool is_item = places.items.contains(id);
    out.push_back({is_item ? Kind::kItem : Kind::kThing, name, TopOf(*object)});
  }
}

}  // namespace

world::OverlaySnapshot TakeOverlays(const Arena& arena, Minds& minds, const world::OverlayWants& wants) {
  const world::World& world = arena.world();
  world::OverlaySnapshot all;
  all.tick = world.tick();
  const auto actors = arena.actors();
  auto actor = actors.begin();
  all.agents.reserve(world.AgentIds().size());
  for (const EntityId id : world.AgentIds()) {
    const world::Agent& body = *world.FindAgent(id);
    AgentOverlay& out = all.agents.emplace_back();
    out.id = Number(id);
    out.eyes = world::EyesOf(body);
    out.leader_id = NumberOrNone(body.Leader());
    while (actor != actors.end() && (*actor)->id() < id) ++actor;
    const bool has_actor = actor != actors.end() && (*actor)->id() == id;
    const Minds::Mind* mind = minds.Find(id);
    if (mind != nullptr) out.operator_name = mind->soar.record().Operators();
    if (has_actor) AddActor(**actor, out);
    if (mind != nullptr && mind->settings.has_distance) AddMeasured(world, body, *mind, out);
    if (!has_actor || (mind != nullptr && mind->is_scripted)) AddScripted(body, out);
  }
  for (const Arena::PastShot& past : arena.past().shots) {
    const bool hit_agent = world.FindAgent(past.shot.hit) != nullptr;
    all.shots.push_back({past.shot.from, past.shot.to, Number(past.shot.shooter), hit_agent ? Number(past.shot.hit) : 0,
                         SecondsSince(world, past.tick)});
  }
  for (const world::Message& message : arena.board().messages()) {
    const double age_s = SecondsSince(world, message.tick);
    if (age_s > kSpeechStays_s || message.from == world::kNoEntity || message.about == "order") continue;
    all.speech.push_back({Number(message.from), NumberOrNone(message.to), TextOf(message), age_s});
  }
  AddPlaces(arena, all.places);
  world.AddOverlays(wants, all);
  return all;
}

}  // namespace soarbox::sim
