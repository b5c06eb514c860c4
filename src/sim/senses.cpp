// SPDX-License-Identifier: BSD-2-Clause
#include "sim/senses.h"

#include <algorithm>
#include <cmath>

#include "sim/arena.h"
#include "sim/directions.h"
#include "sim/vocabulary_percepts.h"
#include "world/sight.h"

namespace soarbox::sim {
namespace {

using world::Vec3;

constexpr float kMessagesStay_s = 3;
constexpr float kHappeningsStay_s = 1;
constexpr float kHere_m = 1.5f;

std::string_view YesNo(bool truth) {
  return truth ? "yes" : "no";
}

double Seconds(const Actor& actor, std::uint64_t ticks) {
  return static_cast<double>(ticks) * static_cast<double>(actor.world().settings().step_s);
}

std::string NameOfAgent(const Actor& actor, world::EntityId id) {
  const world::Agent* agent = actor.world().FindAgent(id);
  return agent == nullptr ? std::string() : agent->name();
}

double BearingTo(const Actor& actor, Vec3 point) {
  return static_cast<double>(BearingOf(actor.body().Position(), actor.body().Forward(), point));
}

std::string_view WeaponWord(const Actor& actor) {
  if (!actor.weapon()) return "none";
  switch (actor.weapon()->StateAt(actor.world().tick())) {
    case world::Weapon::State::kReady:
      return "ready";
    case world::Weapon::State::kCooling:
      return "cooling";
    case world::Weapon::State::kReloading:
      return "reloading";
    case world::Weapon::State::kEmpty:
      return "empty";
  }
  return "none";
}

void SenseSelf(const Actor& actor, PerceptList& list) {
  const world::Agent& body = actor.body();
  PerceptList& self = AddObject(list, RowOf("self"), 0, 14);
  AddWord(self, RowOf("self.name"), body.name());
  AddWord(self, RowOf("self.team"), body.Team());
  PerceptList& position = AddObject(self, RowOf("self.position"), 0, 2);
  AddNumber(position, RowOf("self.position.x"), static_cast<double>(body.Position().x));
  AddNumber(position, RowOf("self.position.z"), static_cast<double>(body.Position().z));
  const double heading = std::round(static_cast<double>(HeadingOf(body.Forward())));
  AddNumber(self, RowOf("self.heading"), heading < 0 ? heading + 360 : heading);
  AddNumber(self, RowOf("self.speed"), static_cast<double>(body.Speed()));
  AddNumber(self, RowOf("self.health"), std::ceil(static_cast<double>(body.Health())));
  AddWord(self, RowOf("self.stance"), actor.stance());
  AddWord(self, RowOf("self.weapon"), WeaponWord(actor));
  if (actor.weapon()) {
    AddNumber(self, RowOf("self.ammunition"), actor.weapon()->rounds());
    AddNumber(self, RowOf("self.reserve"), actor.weapon()->reserve());
  }
  if (const std::string target = NameOfAgent(actor, actor.target()); !target.empty())
    AddWord(self, RowOf("self.target"), target);
  if (const std::string leader = NameOfAgent(actor, body.Leader()); !leader.empty())
    AddWord(self, RowOf("self.leader"), leader);
  std::uint32_t key = 0;
  for (const std::string& thing : actor.carried()) AddWord(self, RowOf("self.carries"), thing, ++key);
}

void SensePath(const Actor& actor, PerceptList& list) {
  PerceptList& path = AddObject(list, RowOf("path"));
  AddWord(path, RowOf("path.status"), actor.way().status);
  if (!actor.way().command.empty()) AddWord(path, RowOf("path.command"), actor.way().command);
  if (actor.way().remaining_m) AddNumber(path, RowOf("path.remaining"), static_cast<double>(*actor.way().remaining_m));
  constexpr float kAhead_m = 3;
  Vec3 eye = actor.body().Position();
  eye.y += 0.4f - actor.body().Height() / 2;
  const Vec3 ahead = eye + actor.body().Forward() * (kAhead_m + actor.body().Radius());
  AddWord(path, RowOf("path.free-ahead"), YesNo(!actor.world().RayCast(eye, ahead)));
}

void AddField(PerceptList& list, const world::Message::Field& field) {
  Percept& made = list.emplace_back();
  made.attribute = field.name;
  std::visit([&](const auto& value) { made.value = value; }, field.value);
}

void SenseMessages(const Actor& actor, PerceptList& list) {
  const std::uint64_t stay = static_cast<std::uint64_t>(kMessagesStay_s / actor.world().settings().step_s);
  for (const world::Message& message : actor.board().messages()) {
    if (message.tick + stay < actor.world().tick() || message.about == "order") continue;
    if (!world::MessageBoard::IsFor(message, actor.id(), actor.body().Team())) continue;
    PerceptList& heard = AddObject(list, RowOf("message"), message.number);
    AddWord(heard, RowOf("message.from"), NameOfAgent(actor, message.from));
    AddWord(heard, RowOf("message.about"), message.about);
    AddNumber(heard, RowOf("message.time"), Seconds(actor, message.tick));
    for (const world::Message::Field& field : message.fields) AddField(heard, field);
  }
}

void SenseHappenings(const Actor& actor, PerceptList& list) {
  const std::uint64_t stay = static_cast<std::uint64_t>(kHappeningsStay_s / actor.world().settings().step_s);
  for (const Happening& happening : actor.happenings()) {
    if (happening.tick + stay < actor.world().tick()) continue;
    PerceptList& felt = AddObject(list, RowOf("event"), happening.number);
    AddWord(felt, RowOf("event.type"), happening.type);
    if (!happening.by.empty()) AddWord(felt, RowOf("event.by"), happening.by);
    AddNumber(felt, RowOf("event.bearing"), static_cast<double>(happening.bearing_deg));
    if (happening.damage > 0) AddNumber(felt, RowOf("event.damage"), static_cast<double>(happening.damage));
    AddNumber(felt, RowOf("event.time"), Seconds(actor, happening.tick));
  }
}

void SenseOrder(const Actor& actor, PerceptList& list) {
  if (!actor.order()) return;
  const world::Message& message = *actor.order();
  PerceptList& order = AddObject(list, RowOf("order"), message.number);
  const std::string from = NameOfAgent(actor, message.from);
  AddWord(order, RowOf("order.from"), from.empty() ? "user" : from);
  AddNumber(order, RowOf("order.time"), Seconds(actor, message.tick));
  for (const world::Message::Field& field : message.fields) AddField(order, field);
}

void SenseAgents(const Actor& actor, PerceptList& list) {
  list.reserve(list.size() + actor.contacts().size());
  for (const auto& [id, contact] : actor.contacts()) {
    const world::Agent& other = *actor.world().FindAgent(id);
    PerceptList& seen = AddObject(list, RowOf("agent"), Number(id), 14);
    AddWord(seen, RowOf("agent.name"), other.name());
    AddWord(seen, RowOf("agent.team"), other.Team());
    AddWord(seen, RowOf("agent.relation"), other.Team() == actor.body().Team() ? "friend" : "enemy");
    AddWord(seen, RowOf("agent.visible"), YesNo(contact.visible));
    const bool now = contact.noticed_tick + 1 >= actor.world().tick() || contact.source != Contact::Source::kMemory;
    AddWord(seen, RowOf("agent.known-by"),
            contact.visible                                      ? "sight"
            : now && contact.source == Contact::Source::kHearing ? "hearing"
                                                                 : "memory");
    AddNumber(seen, RowOf("agent.range"), static_cast<double>(FlatDistance(actor.body().Position(), contact.position)));
    AddNumber(seen, RowOf("agent.bearing"), BearingTo(actor, contact.position));
    PerceptList& position = AddObject(seen, RowOf("agent.position"), 0, 2);
    AddNumber(position, RowOf("agent.position.x"), static_cast<double>(contact.position.x));
    AddNumber(position, RowOf("agent.position.z"), static_cast<double>(contact.position.z));
    AddNumber(seen, RowOf("agent.speed"), static_cast<double>(world::Length(Flat(contact.velocity))));
    AddNumber(seen, RowOf("agent.facing"),
              std::abs(static_cast<double>(BearingOf(contact.position, contact.forward, actor.body().Position()))));
    AddWord(seen, RowOf("agent.alive"), YesNo(contact.alive));
    const double age_s = Seconds(actor, actor.world().tick() - contact.noticed_tick);
    const double base = contact.visible ? 1 : contact.source == Contact::Source::kHearing ? 0.6 : 0.9;
    AddNumber(seen, RowOf("agent.last-seen"), contact.visible ? 0 : age_s);
    const double memory_s = static_cast<double>(std::max(0.1f, actor.kind().senses.memory_s));
    AddNumber(seen, RowOf("agent.confidence"), contact.visible ? 1 : base * std::max(0.0, 1 - age_s / memory_s));
  }
}

/// Whether the eyes take in a point so far away in that direction.
bool IsInView(const Actor& actor, Vec3 point) {
  const SenseSettings& senses = actor.kind().senses;
  if (FlatDistance(actor.body().Position(), point) > senses.sight_m) return false;
  return std::abs(BearingTo(actor, point)) <= static_cast<double>(senses.view_deg) / 2;
}

void SenseObjects(const Actor& actor, PerceptList& list) {
  const world::World& world = actor.world();
  for (const world::EntityId id : world.ObjectIds()) {
    const world::Object& object = *world.FindObject(id);
    if (object.kind() == world::ObjectKind::kPlane || id == actor.arena().ground() || object.removal_requested())
      continue;
    const Vec3 center = object.Position();
    if (!IsInView(actor, center) || !HasLineOfSight(world, actor.body(), center, id)) continue;
    PerceptList& seen = AddObject(list, RowOf("object"), Number(id), 7);
    AddWord(seen, RowOf("object.name"), actor.arena().NameOfObject(id));
    const bool is_item = actor.arena().places().items.contains(id);
    const world::ObjectKind kind = object.kind();
    AddWord(seen, RowOf("object.kind"),
            is_item                                     ? "item"
            : kind == world::ObjectKind::kBox           ? "box"
            : kind == world::ObjectKind::kMesh          ? "mesh"
            : kind == world::ObjectKind::kPhysicsSphere ? "sphere"
                                                        : "capsule");
    AddNumber(seen, RowOf("object.range"), static_cast<double>(FlatDistance(actor.body().Position(), center)));
    AddNumber(seen, RowOf("object.bearing"), BearingTo(actor, center));
    PerceptList& position = AddObject(seen, RowOf("object.position"), 0, 2);
    AddNumber(position, RowOf("object.position.x"), static_cast<double>(center.x));
    AddNumber(position, RowOf("object.position.z"), static_cast<double>(center.z));
    AddNumber(seen, RowOf("object.radius"), static_cast<double>(object.Radius()));
    AddWord(seen, RowOf("object.moves"), YesNo(object.Mass() > 0));
  }
}

void SensePlaces(const Actor& actor, PerceptList& list) {
  const Vec3 here = actor.body().Position();
  const Places& places = actor.arena().places();
  std::uint32_t index = 0;
  for (const Waypoint& waypoint : places.waypoints) {
    ++index;
    if (!actor.kind().senses.Has("waypoints")) break;
    PerceptList& known = AddObject(list, RowOf("waypoint"), index);
    AddWord(known, RowOf("waypoint.name"), waypoint.name);
    AddNumber(known, RowOf("waypoint.index"), index);
    const float range_m = FlatDistance(here, waypoint.position);
    AddNumber(known, RowOf("waypoint.range"), static_cast<double>(range_m));
    AddNumber(known, RowOf("waypoint.bearing"), BearingTo(actor, waypoint.position));
    AddWord(known, RowOf("waypoint.here"), YesNo(range_m <= kHere_m));
  }
  index = 0;
  for (const Region& region : places.regions) {
    ++index;
    if (!actor.kind().senses.Has("regions")) break;
    PerceptList& known = AddObject(list, RowOf("region"), index);
    AddWord(known, RowOf("region.name"), region.name);
    AddWord(known, RowOf("region.inside"), YesNo(region.Contains(here)));
    AddNumber(known, RowOf("region.range"), static_cast<double>(FlatDistance(here, region.center)));
    AddNumber(known, RowOf("region.bearing"), BearingTo(actor, region.center));
  }
}

/// The noise of the senses: a sum of uniform numbers from the agent's own stream.
Vec3 Noise(Actor& actor) {
  const float sigma_m = actor.kind().senses.noise_m;
  if (sigma_m <= 0) return {};
  const auto bell = [&] {
    float sum = 0;
    for (int i = 0; i < 12; ++i) sum += actor.body().random().Unit();
    return sum - 6;
  };
  const float x = bell(), z = bell();
  return {x * sigma_m, 0, z * sigma_m};
}

/// Whom the actor may notice now or has noticed before, in ascending id: nobody else changes what it knows.
std::vector<world::EntityId> NearOrKnown(const Actor& actor) {
  constexpr float kSlack_m = 0.01f;
  const SenseSettings& senses = actor.kind().senses;
  const auto near = AgentsNear(actor.body(), std::max({senses.sight_m, senses.hearing_m, 0.0f}) + kSlack_m);
  std::vector<world::EntityId> all;
  all.reserve(near.size() + actor.contacts().size());
  auto contact = actor.contacts().begin();
  for (const world::EntityId id : near) {
    for (; contact != actor.contacts().end() && contact->first < id; ++contact) all.push_back(contact->first);
    if (contact != actor.contacts().end() && contact->first == id) ++contact;
    all.push_back(id);
  }
  for (; contact != actor.contacts().end(); ++contact) all.push_back(contact->first);
  return all;
}

}  // namespace

PerceptList SenseOwnBody(const Actor& actor) {
  const SenseSettings& senses = actor.kind().senses;
  PerceptList list;
  list.reserve(8);
  if (senses.Has("time")) AddNumber(list, RowOf("time"), actor.world().time_s());
  if (senses.Has("self")) SenseSelf(actor, list);
  if (senses.Has("path")) SensePath(actor, list);
  if (senses.Has("messages")) SenseMessages(actor, list);
  if (senses.Has("events")) SenseHappenings(actor, list);
  if (senses.Has("orders")) SenseOrder(actor, list);
  return list;
}

void NoticeOthers(Actor& actor) {
  const SenseSettings& senses = actor.kind().senses;
  const world::World& world = actor.world();
  auto& contacts = actor.contacts();
  for (const world::EntityId id : NearOrKnown(actor)) {
    if (id == actor.id()) continue;
    const world::Agent& other = *world.FindAgent(id);
    const float range_m = FlatDistance(actor.body().Position(), other.Position());
    const bool seen = IsInView(actor, other.Position()) && (SeesAgent(actor.body(), other, other.Position()) ||
                                                            SeesAgent(actor.body(), other, world::EyesOf(other)));
    // Who runs is heard at the full range, who walks at a part of it.
    const float loudness = std::clamp(other.Speed() / 4, 0.0f, 1.0f);
    const bool heard = !seen && other.Health() > 0 && range_m <= senses.hearing_m * loudness;
    const auto known = contacts.find(id);
    if (known != contacts.end()) known->second.visible = seen;
    if (!seen && !heard) {
      if (known == contacts.end()) continue;
      if (known->second.noticed_tick + 1 < world.tick() && known->second.source == Contact::Source::kSight)
        known->second.source = Contact::Source::kMemory;
      if (Seconds(actor, world.tick() - known->second.noticed_tick) > static_cast<double>(senses.memory_s))
        contacts.erase(known);
      continue;
    }
    Contact& contact = contacts[id];
    contact.agent = id;
    contact.source = seen ? Contact::Source::kSight : Contact::Source::kHearing;
    contact.visible = seen;
    contact.noticed_tick = world.tick();
    contact.position = other.Position() + Noise(actor);
    contact.velocity = other.Velocity();
    contact.forward = other.Forward();
    contact.alive = other.Health() > 0;
  }
}

PerceptList SenseSurroundings(const Actor& actor) {
  const SenseSettings& senses = actor.kind().senses;
  PerceptList list;
  if (senses.Has("agents")) SenseAgents(actor, list);
  if (senses.Has("objects")) SenseObjects(actor, list);
  SensePlaces(actor, list);
  return list;
}

bool IsSenseTick(const Actor& actor) {
  const float rate_hz = std::clamp(actor.kind().senses.rate_hz, 0.1f, 1000.0f);
  const std::uint64_t every = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::lround(1 / (rate_hz * actor.world().settings().step_s))));
  const std::uint64_t tick = actor.world().tick();
  return tick <= 1 || tick % every == Number(actor.id()) % every;
}

void HearOrders(Actor& actor) {
  for (const world::Message& message : actor.board().messages()) {
    if (message.about != "order" || (actor.order() && message.number <= actor.order()->number)) continue;
    if (world::MessageBoard::IsFor(message, actor.id(), actor.body().Team())) actor.order() = message;
  }
}

}  // namespace soarbox::sim
