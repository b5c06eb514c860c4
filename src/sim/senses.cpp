// SPDX-License-Identifier: BSD-2-Clause
#include "sim/senses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "sim/arena.h"
#include "sim/attention.h"
#include "sim/directions.h"
#include "sim/foreign_bodies.h"
#include "vocabulary/vocabulary_percepts.h"
#include "world/sight.h"

namespace soarbox::sim {
namespace {

using vocabulary::RowOf;

using world::Vec3;

constexpr float kMessagesStay_s = 3;
constexpr float kHappeningsStay_s = 1;
constexpr float kHere_m = 1.5f;
constexpr std::string_view kOrder = "order";

std::string_view YesNo(bool truth) {
  return truth ? "yes" : "no";
}

double SecondsOf(const Actor& actor, std::uint64_t ticks) {
  return static_cast<double>(ticks) * static_cast<double>(actor.world().settings().step_s);
}

/// Valid until the agent gets another name; empty if there is no such agent.
std::string_view NameOfAgent(const Actor& actor, world::EntityId id) {
  const world::Agent* agent = actor.world().FindAgent(id);
  return agent == nullptr ? std::string_view() : agent->name();
}

/// Position and direction of an actor, read once for all objects that it looks at.
struct Standpoint {
  explicit Standpoint(const Actor& actor) : position(actor.body().Position()), forward(actor.body().Forward()) {}
  /// In integer degrees, as all bearings are perceived.
  double BearingTo(Vec3 point) const { return static_cast<double>(BearingToRound(position, forward, point)); }

  Vec3 position, forward;
};

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

template <typename Sink>
void SenseSelf(const Actor& actor, Sink& sink) {
  const world::Agent& body = actor.body();
  sink.Open(RowOf("self"));
  sink.Word(RowOf("self.name"), body.name());
  sink.Word(RowOf("self.team"), body.Team());
  sink.Open(RowOf("self.position"));
  sink.Number(RowOf("self.position.x"), static_cast<double>(body.Position().x));
  sink.Number(RowOf("self.position.z"), static_cast<double>(body.Position().z));
  sink.Close();
  const double heading = std::round(static_cast<double>(HeadingOf(body.Forward())));
  sink.Number(RowOf("self.heading"), heading < 0 ? heading + 360 : heading);
  sink.Number(RowOf("self.speed"), static_cast<double>(body.Speed()));
  sink.Number(RowOf("self.health"), std::ceil(static_cast<double>(body.Health())));
  sink.Word(RowOf("self.stance"), actor.stance());
  sink.Word(RowOf("self.weapon"), WeaponWord(actor));
  if (actor.weapon()) {
    sink.Number(RowOf("self.ammunition"), actor.weapon()->rounds());
    sink.Number(RowOf("self.reserve"), actor.weapon()->reserve());
  }
  if (const std::string_view target = NameOfAgent(actor, actor.target()); !target.empty())
    sink.Word(RowOf("self.target"), target);
  if (const std::string_view leader = NameOfAgent(actor, body.Leader()); !leader.empty())
    sink.Word(RowOf("self.leader"), leader);
  std::uint32_t key = 0;
  for (const CarriedThing& thing : actor.carried()) sink.Word(RowOf("self.carries"), thing.name, ++key);
  sink.Close();
}

template <typename Sink>
void SensePath(const Actor& actor, Sink& sink) {
  sink.Open(RowOf("path"));
  sink.Word(RowOf("path.status"), actor.way().status);
  if (!actor.way().command.empty()) sink.Word(RowOf("path.command"), actor.way().command);
  if (actor.way().remaining_m) sink.Number(RowOf("path.remaining"), static_cast<double>(*actor.way().remaining_m));
  constexpr float kAhead_m = 3, kHeight_m = 0.4f;
  const bool is_free = IsFreeAhead(actor.body(), kAhead_m + actor.body().Radius(), kHeight_m);
  sink.Word(RowOf("path.free-ahead"), YesNo(is_free));
  sink.Close();
}

/// Index of the first message that is recent enough to be heard.
std::size_t FirstHeard(const Actor& actor) {
  const auto& messages = actor.board().messages();
  const std::uint64_t stay = static_cast<std::uint64_t>(kMessagesStay_s / actor.world().settings().step_s);
  const auto is_old = [&](const world::Message& message) { return message.tick + stay < actor.world().tick(); };
  return static_cast<std::size_t>(std::partition_point(messages.begin(), messages.end(), is_old) - messages.begin());
}

/// Reports the messages from this index on that the actor hears.
template <typename Sink>
void SenseMessages(const Actor& actor, std::size_t first, Sink& sink) {
  const auto& messages = actor.board().messages();
  for (std::size_t n = first; n < messages.size(); ++n) {
    const world::Message& message = messages[n];
    if (!world::MessageBoard::IsFor(message, actor.id(), actor.body().Team()) || message.about == kOrder) continue;
    sink.Open(RowOf("message"), message.number);
    sink.Word(RowOf("message.from"), NameOfAgent(actor, message.from));
    sink.Word(RowOf("message.about"), message.about);
    sink.Number(RowOf("message.time"), SecondsOf(actor, message.tick));
    for (const world::Message::Field& field : message.fields) sink.Other(field.name, field.value);
    sink.Close();
  }
}

template <typename Sink>
void SenseHappenings(const Actor& actor, Sink& sink) {
  const std::uint64_t stay = static_cast<std::uint64_t>(kHappeningsStay_s / actor.world().settings().step_s);
  for (const Happening& happening : actor.happenings()) {
    if (happening.tick + stay < actor.world().tick()) continue;
    sink.Open(RowOf("event"), happening.number);
    sink.Word(RowOf("event.type"), happening.type);
    if (!happening.by.empty()) sink.Word(RowOf("event.by"), happening.by);
    sink.Number(RowOf("event.bearing"), static_cast<double>(happening.bearing_deg));
    if (happening.damage > 0) sink.Number(RowOf("event.damage"), static_cast<double>(happening.damage));
    sink.Number(RowOf("event.time"), SecondsOf(actor, happening.tick));
    sink.Close();
  }
}

template <typename Sink>
void SenseOrder(const Actor& actor, Sink& sink) {
  if (!actor.order()) return;
  const world::Message& message = *actor.order();
  sink.Open(RowOf("order"), message.number);
  const std::string_view from = NameOfAgent(actor, message.from);
  sink.Word(RowOf("order.from"), from.empty() ? "user" : from);
  sink.Number(RowOf("order.time"), SecondsOf(actor, message.tick));
  for (const world::Message::Field& field : message.fields) sink.Other(field.name, field.value);
  sink.Close();
}

/// The nearest friend and the nearest enemy in view that are alive; at equal distances, the first.
struct Nearest {
  world::EntityId friendly = world::kNoEntity, enemy = world::kNoEntity;
};

Nearest FindNearest(const Actor& actor) {
  Nearest nearest;
  float friend_m2 = 0, enemy_m2 = 0;
  const Vec3 here = actor.body().Position();
  for (const auto& [id, contact] : actor.contacts()) {
    if (!contact.visible || !contact.alive) continue;
    const bool is_friend = actor.world().FindAgent(id)->Team() == actor.body().Team();
    world::EntityId& best = is_friend ? nearest.friendly : nearest.enemy;
    float& best_m2 = is_friend ? friend_m2 : enemy_m2;
    const float range_m2 = world::LengthSquared(Flat(contact.position - here));
    if (best != world::kNoEntity && range_m2 >= best_m2) continue;
    best = id;
    best_m2 = range_m2;
  }
  return nearest;
}

template <typename Sink>
void SenseAgents(const Actor& actor, Sink& sink) {
  const Nearest nearest = FindNearest(actor);
  const Attention attention(actor);
  const Standpoint here(actor);
  for (const auto& [id, contact] : actor.contacts()) {
    if (!attention.Reaches(id, contact)) continue;
    const world::Agent& other = *actor.world().FindAgent(id);
    sink.Open(RowOf("agent"), Number(id));
    sink.Word(RowOf("agent.name"), other.name());
    sink.Word(RowOf("agent.team"), other.Team());
    sink.Word(RowOf("agent.relation"), other.Team() == actor.body().Team() ? "friend" : "enemy");
    if (other.kind() == kForeignKind) {
      sink.Word(RowOf("agent.foreign"), "yes");
      if (const Actor* foreign = actor.arena().Find(id)) sink.Word(RowOf("agent.kind"), foreign->kind().name);
    }
    sink.Word(RowOf("agent.visible"), YesNo(contact.visible));
    const bool now = contact.noticed_tick + 1 >= actor.world().tick() || contact.source != Contact::Source::kMemory;
    sink.Word(RowOf("agent.known-by"), contact.visible                                      ? "sight"
                                       : now && contact.source == Contact::Source::kHearing ? "hearing"
                                                                                            : "memory");
    sink.Number(RowOf("agent.range"), static_cast<double>(FlatDistance(here.position, contact.position)));
    sink.Number(RowOf("agent.bearing"), here.BearingTo(contact.position));
    sink.Word(RowOf("agent.nearest"), YesNo(id == nearest.friendly || id == nearest.enemy));
    sink.Open(RowOf("agent.position"));
    sink.Number(RowOf("agent.position.x"), static_cast<double>(contact.position.x));
    sink.Number(RowOf("agent.position.z"), static_cast<double>(contact.position.z));
    sink.Close();
    sink.Number(RowOf("agent.speed"), static_cast<double>(world::Length(Flat(contact.velocity))));
    sink.Number(RowOf("agent.facing"),
                std::abs(static_cast<double>(BearingToRound(contact.position, contact.forward, here.position))));
    sink.Word(RowOf("agent.alive"), YesNo(contact.alive));
    const double age_s = SecondsOf(actor, actor.world().tick() - contact.noticed_tick);
    const double base = contact.visible ? 1 : contact.source == Contact::Source::kHearing ? 0.6 : 0.9;
    sink.Number(RowOf("agent.last-seen"), contact.visible ? 0 : age_s);
    const double memory_s = static_cast<double>(std::max(0.1f, actor.kind().senses.memory_s));
    sink.Number(RowOf("agent.confidence"), contact.visible ? 1 : base * std::max(0.0, 1 - age_s / memory_s));
    sink.Close();
  }
}

/// The field of view of the eyes.
class FieldOfView {
 public:
  explicit FieldOfView(const Actor& actor)
      : here_(actor.body().Position()),
        forward_(actor.body().Forward()),
        sight_m_(actor.kind().senses.sight_m),
        half_deg_(static_cast<double>(actor.kind().senses.view_deg) / 2),
        cosine_(std::cos(actor.kind().senses.view_deg / 2 * std::numbers::pi_v<float> / 180)),
        ahead_m_(world::Length(Flat(forward_))) {}

  bool Holds(Vec3 point) const {
    const Vec3 to = Flat(point - here_);
    const float range_m = world::Length(to);
    if (range_m > sight_m_) return false;
    // Far from the border of the view, the exact angle is not needed.
    constexpr float kNearEdge = 1e-3f;
    const float along = world::Dot(forward_, to), edge = cosine_ * range_m * ahead_m_;
    const float unsure = kNearEdge * range_m * ahead_m_;
    if (half_deg_ <= 180 && std::abs(along - edge) > unsure) return along > edge;
    return std::abs(static_cast<double>(BearingOf(here_, forward_, point))) <= half_deg_;
  }

 private:
  Vec3 here_, forward_;
  float sight_m_;
  double half_deg_;
  float cosine_, ahead_m_;
};

template <typename Sink>
void SenseObjects(const Actor& actor, Sink& sink) {
  if (actor.things().empty()) return;
  const Standpoint here(actor);
  std::map<std::string_view, std::pair<float, world::EntityId>> nearest;  // The nearest in view, by kind.
  for (const auto& [id, thing] : actor.things()) {
    if (!thing.visible) continue;
    const float range_m = FlatDistance(here.position, thing.position);
    const auto [best, is_first] = nearest.try_emplace(thing.kind, range_m, id);
    if (!is_first && range_m < best->second.first) best->second = {range_m, id};
  }
  for (const auto& [id, thing] : actor.things()) {
    const auto best = nearest.find(thing.kind);
    sink.Open(RowOf("object"), Number(id));
    sink.Word(RowOf("object.name"), thing.name);
    sink.Word(RowOf("object.kind"), thing.kind);
    sink.Word(RowOf("object.visible"), YesNo(thing.visible));
    sink.Number(RowOf("object.last-seen"),
                thing.visible ? 0 : SecondsOf(actor, actor.world().tick() - thing.seen_tick));
    sink.Word(RowOf("object.nearest"), YesNo(best != nearest.end() && best->second.second == id));
    sink.Number(RowOf("object.range"), static_cast<double>(FlatDistance(here.position, thing.position)));
    sink.Number(RowOf("object.bearing"), here.BearingTo(thing.position));
    sink.Open(RowOf("object.position"));
    sink.Number(RowOf("object.position.x"), static_cast<double>(thing.position.x));
    sink.Number(RowOf("object.position.z"), static_cast<double>(thing.position.z));
    sink.Close();
    sink.Number(RowOf("object.radius"), static_cast<double>(thing.radius_m));
    sink.Word(RowOf("object.moves"), YesNo(thing.moves));
    sink.Close();
  }
}

std::string_view WordOf(world::ObjectKind kind) {
  switch (kind) {
    case world::ObjectKind::kBox:
      return "box";
    case world::ObjectKind::kMesh:
      return "mesh";
    case world::ObjectKind::kPhysicsSphere:
      return "sphere";
    default:
      return "capsule";
  }
}

template <typename Sink>
void SensePlaces(const Actor& actor, Sink& sink) {
  const Places& places = actor.arena().places();
  if (places.waypoints.empty() && places.regions.empty()) return;
  const Standpoint here(actor);
  std::uint32_t index = 0;
  for (const Waypoint& waypoint : places.waypoints) {
    ++index;
    if (!actor.kind().senses.Has("waypoints")) break;
    sink.Open(RowOf("waypoint"), index);
    sink.Word(RowOf("waypoint.name"), waypoint.name);
    sink.Number(RowOf("waypoint.index"), index);
    const float range_m = FlatDistance(here.position, waypoint.position);
    sink.Number(RowOf("waypoint.range"), static_cast<double>(range_m));
    sink.Number(RowOf("waypoint.bearing"), here.BearingTo(waypoint.position));
    sink.Word(RowOf("waypoint.here"), YesNo(range_m <= kHere_m));
    sink.Close();
  }
  index = 0;
  for (const Region& region : places.regions) {
    ++index;
    if (!actor.kind().senses.Has("regions")) break;
    sink.Open(RowOf("region"), index);
    sink.Word(RowOf("region.name"), region.name);
    sink.Word(RowOf("region.inside"), YesNo(region.Contains(here.position)));
    sink.Number(RowOf("region.range"), static_cast<double>(FlatDistance(here.position, region.center)));
    sink.Number(RowOf("region.bearing"), here.BearingTo(region.center));
    sink.Close();
  }
}

/// Noise of the senses: a sum of uniform random numbers from the agent's own stream.
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

template <typename Sink>
void TellOwnBody(const Actor& actor, Sink& sink) {
  const SenseSettings& senses = actor.kind().senses;
  if (senses.Has("time")) sink.Number(RowOf("time"), actor.world().time_s());
  if (senses.Has("self")) SenseSelf(actor, sink);
  if (senses.Has("path")) SensePath(actor, sink);
  if (senses.Has("events")) SenseHappenings(actor, sink);
  if (senses.Has("orders")) SenseOrder(actor, sink);
}

template <typename Sink>
void TellSurroundings(const Actor& actor, Sink& sink) {
  const SenseSettings& senses = actor.kind().senses;
  if (senses.Has("agents")) SenseAgents(actor, sink);
  if (senses.Has("objects")) SenseObjects(actor, sink);
  SensePlaces(actor, sink);
}

/// The bodies that may hide others or things; nothing if it looks at so few that casting rays is cheaper.
std::optional<world::BodiesAround> LookAround(const Actor& actor, std::size_t others) {
  const SenseSettings& senses = actor.kind().senses;
  const std::size_t things = actor.world().ObjectIds().size();
  const std::size_t lines = others + (senses.Has("objects") ? things : 0);
  constexpr std::size_t kMany = 8, kBodiesOfLine = 8;
  constexpr float kClose_m = 15;
  if (lines <= kMany) return std::nullopt;
  if (senses.sight_m > kClose_m && actor.world().AgentIds().size() + things > kBodiesOfLine * lines)
    return std::nullopt;
  return world::AroundEyes(actor.body(), senses.sight_m, senses.view_deg);
}

void NoticeOthers(Actor& actor, std::span<const world::EntityId> near, const FieldOfView& view,
                  const world::BodiesAround* around) {
  const SenseSettings& senses = actor.kind().senses;
  const world::World& world = actor.world();
  const Vec3 here = actor.body().Position();
  Contacts& contacts = actor.contacts();
  // Visits the agents that it may perceive now or has perceived before, in ascending id. All others stay unknown.
  std::size_t known = 0;
  for (auto next = near.begin(); next != near.end() || known < contacts.size();) {
    const bool is_near = next != near.end() && (known == contacts.size() || *next <= contacts.At(known).first);
    const world::EntityId id = is_near ? *next++ : contacts.At(known).first;
    const bool is_known = known < contacts.size() && contacts.At(known).first == id;
    if (id == actor.id()) {
      known += is_known ? 1 : 0;
      continue;
    }
    const world::Agent& other = *world.FindAgent(id);
    const Vec3 place = other.Position();
    const bool seen = !other.IsGone() && view.Holds(place) && SeesAgent(actor.body(), other, around);
    // Running agents are heard at the full range, walking agents at a part of it.
    const float loudness = std::clamp(other.Speed() / 4, 0.0f, 1.0f);
    const bool heard = !seen && other.Health() > 0 && FlatDistance(here, place) <= senses.hearing_m * loudness;
    if (!is_known && !seen && !heard) continue;
    Contact& contact = (is_known ? contacts.At(known) : contacts.Insert(known, id)).second;
    contact.visible = seen;
    contact.agent = id;
    if (!seen && !heard) {
      if (contact.noticed_tick + 1 < world.tick() && contact.source == Contact::Source::kSight)
        contact.source = Contact::Source::kMemory;
      if (SecondsOf(actor, world.tick() - contact.noticed_tick) > static_cast<double>(senses.memory_s)) {
        contacts.Erase(known);
      } else {
        ++known;
      }
      continue;
    }
    ++known;
    contact.source = seen ? Contact::Source::kSight : Contact::Source::kHearing;
    contact.noticed_tick = world.tick();
    contact.position = place + Noise(actor);
    contact.velocity = other.Velocity();
    contact.forward = other.Forward();
    contact.alive = other.Health() > 0;
  }
}

void NoticeThings(Actor& actor, const FieldOfView& view, const world::BodiesAround* around) {
  if (!actor.kind().senses.Has("objects")) return;
  const world::World& world = actor.world();
  auto& things = actor.things();
  for (auto& [id, thing] : things) thing.visible = false;
  for (const world::EntityId id : world.ObjectIds()) {
    const world::Object& object = *world.FindObject(id);
    if (object.kind() == world::ObjectKind::kPlane || object.kind() == world::ObjectKind::kSensor ||
        id == actor.arena().ground() || object.removal_requested())
      continue;
    const Vec3 center = object.Position();
    if (!view.Holds(center) || !HasLineOfSight(world, actor.body(), center, id, around)) continue;
    SeenThing& thing = things[id];
    if (thing.name.empty()) {
      thing.name = actor.arena().NameOfObject(id);
      thing.kind = actor.arena().places().items.contains(id) ? "item" : WordOf(object.kind());
    }
    thing.position = center;
    if (actor.kind().senses.scene) {
      thing.orientation = object.Orientation();
      std::tie(thing.low, thing.high) = object.LocalBox();
    }
    thing.radius_m = object.Radius();
    thing.moves = object.Mass() > 0;
    thing.visible = true;
    thing.seen_tick = world.tick();
  }
  // Forgets things that it has not seen for a long time, and things that are not at their remembered position when it
  // looks there.
  const auto memory_s = static_cast<double>(actor.kind().senses.memory_s);
  std::erase_if(things, [&](const auto& known) {
    const SeenThing& thing = known.second;
    if (thing.visible) return false;
    if (SecondsOf(actor, world.tick() - thing.seen_tick) > memory_s) return true;
    return view.Holds(thing.position) && HasLineOfSight(world, actor.body(), thing.position, known.first, around);
  });
}

}  // namespace

void SenseOwnBody(const Actor& actor, InputMirror& mirror) {
  TellOwnBody(actor, mirror);
}
void SenseSurroundings(const Actor& actor, InputMirror& mirror) {
  TellSurroundings(actor, mirror);
}

void HearMessages(const Actor& actor, std::uint32_t& last, InputMirror& heard) {
  if (!actor.kind().senses.Has("messages")) return;
  const auto& messages = actor.board().messages();
  const std::size_t first = FirstHeard(actor);
  heard.Begin();
  while (heard.NextKey() != 0 && (first == messages.size() || heard.NextKey() < messages[first].number)) heard.Drop();
  heard.KeepRest();
  SenseMessages(actor, std::max(first, actor.board().FirstAfter(last)), heard);
  heard.End();
  last = actor.board().posted();
}

void Notice(Actor& actor) {
  const SenseSettings& senses = actor.kind().senses;
  constexpr float kSlack_m = 0.01f;
  const auto near = AgentsNear(actor.body(), std::max({senses.sight_m, senses.hearing_m, 0.0f}) + kSlack_m);
  const FieldOfView view(actor);
  const auto around = LookAround(actor, near.size() + actor.contacts().size());
  NoticeOthers(actor, near, view, around ? &*around : nullptr);
  NoticeThings(actor, view, around ? &*around : nullptr);
}

vocabulary::PerceptList AllPercepts(const Actor& actor) {
  vocabulary::PerceptLister lister;
  TellOwnBody(actor, lister);
  if (actor.kind().senses.Has("messages")) SenseMessages(actor, FirstHeard(actor), lister);
  TellSurroundings(actor, lister);
  return lister.list();
}

bool IsSenseTick(const Actor& actor) {
  const float rate_hz = std::clamp(actor.kind().senses.rate_hz, 0.1f, 1000.0f);
  const std::uint64_t every = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::lround(1 / (rate_hz * actor.world().settings().step_s))));
  const std::uint64_t tick = actor.world().tick();
  return tick <= 1 || tick % every == Number(actor.id()) % every;
}

void HearOrders(Actor& actor) {
  const world::MessageBoard& board = actor.board();
  for (std::size_t n = board.FirstAfter(actor.orders_heard()); n < board.messages().size(); ++n) {
    const world::Message& message = board.messages()[n];
    if (message.about == kOrder && world::MessageBoard::IsFor(message, actor.id(), actor.body().Team()))
      actor.order() = message;
  }
  actor.orders_heard() = board.posted();
}

}  // namespace soarbox::sim
