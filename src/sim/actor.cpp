// SPDX-License-Identifier: BSD-2-Clause
#include "sim/actor.h"

#include <algorithm>
#include <cmath>

#include "diagnostics/diagnostic.h"
#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"
#include "wording/sentences.h"
#include "world/state_hash.h"

namespace soarbox::sim {
namespace {

constexpr std::size_t kMostRunning = 32;
constexpr std::size_t kMostHappenings = 16;
constexpr float kTurnRate_deg_per_s = 360;

float SpeedFactor(const std::string& stance) {
  return stance == "standing" ? 1.0f : stance == "crouching" ? 0.5f : 0.2f;
}

}  // namespace

double Running::Number(std::string_view name, double otherwise) const {
  const vocabulary::Percept* given = Get(name);
  return given != nullptr ? given->Number().value_or(otherwise) : otherwise;
}

std::string Running::Word(std::string_view name) const {
  const vocabulary::Percept* given = Get(name);
  return given != nullptr && !given->IsObject() ? vocabulary::DescribeValue(*given) : std::string();
}

Actor::Actor(Arena& arena, world::World& world, world::EntityId id, BodyKind kind, bool is_scripted)
    : arena_(arena),
      world_(world),
      id_(id),
      body_(world.FindAgent(id)),
      kind_(std::move(kind)),
      walk_mps_(kind_.walk_mps),
      is_scripted_(is_scripted) {
  if (kind_.armed) weapon_.emplace(kind_.weapon);
}

const world::MessageBoard& Actor::board() const {
  return arena_.board();
}

void Actor::SetLooks(world::NodeId looks) {
  bearing_.SetFigure(looks);
  ShowBearing();
}

void Actor::Carry(CarriedThing thing) {
  carried_.push_back(std::move(thing));
  HoldLoad();
}

std::optional<CarriedThing> Actor::LetGo(std::string_view name) {
  const auto at =
      std::find_if(carried_.begin(), carried_.end(), [&](const CarriedThing& thing) { return thing.name == name; });
  if (at == carried_.end()) return std::nullopt;
  CarriedThing thing = std::move(*at);
  carried_.erase(at);
  HoldLoad();
  return thing;
}

float Actor::RadiusWithout(std::string_view name) const {
  float radius_m = load_ == world::NodeId::kNone ? body_->Radius() : own_radius_m_;
  for (const CarriedThing& thing : carried_) {
    if (thing.name != name) radius_m = std::max(radius_m, thing.item.HalfWidth_m());
  }
  return radius_m;
}

void Actor::HoldLoad() {
  if (load_ == world::NodeId::kNone) own_radius_m_ = body_->Radius();
  const auto widest = std::max_element(
      carried_.begin(), carried_.end(),
      [](const CarriedThing& a, const CarriedThing& b) { return a.item.HalfWidth_m() < b.item.HalfWidth_m(); });
  const bool is_wide = widest != carried_.end() && widest->item.HalfWidth_m() > own_radius_m_;
  if (!is_wide && load_ == world::NodeId::kNone) return;
  world::Scene& scene = world_.scene();
  scene.Remove(load_);
  load_ = world::NodeId::kNone;
  body_->SetRadius(is_wide ? widest->item.HalfWidth_m() : own_radius_m_);
  if (!is_wide) return;
  const Item& item = widest->item;
  load_ = item.shape == "column" ? scene.CreateCapsule(world_.NodeOf(id_), item.size.y, item.size.x / 2)
                                 : scene.CreateBox(world_.NodeOf(id_), item.size.x, item.size.y, item.size.z);
  scene.SetPosition(load_, {0, (body_->Height() + item.size.y) / 2, 0});
  if (!item.material.empty()) scene.SetMaterial(load_, item.material);
}

void Actor::SetStance(std::string_view stance) {
  stance_ = stance;
}

void Actor::ShowBearing() {
  Bearing::Deeds deeds{.stance = stance_, .is_armed = weapon_.has_value(), .health = body_->Health()};
  if (weapon_) {
    deeds.shoots =
        std::any_of(running_.begin(), running_.end(), [](const Running& r) { return r.said.name == "shoot"; });
    deeds.reloads = weapon_->StateAt(world_.tick()) == world::Weapon::State::kReloading;
    deeds.rounds = weapon_->rounds();
  }
  bearing_.Show(world_, deeds);
}

float Actor::speed_mps() const {
  return std::min(walk_mps_, body_->MaxSpeed()) * SpeedFactor(stance_);
}
float Actor::TopSpeed() const {
  return body_->MaxSpeed() * SpeedFactor(stance_);
}
float Actor::Steadiness() const {
  return (stance_ == "standing" ? 1.0f : stance_ == "crouching" ? 0.6f : 0.4f) + 0.3f * body_->Speed();
}

std::string Actor::WhichPlaces(const Running& command, std::string_view reason) const {
  const bool is_waypoint = reason == "no-such-waypoint";
  if (!is_waypoint && reason != "no-such-region") return {};
  const std::string kind = is_waypoint ? "waypoint" : "region";
  std::vector<std::string> names;
  for (const Waypoint& place : arena_.places().waypoints)
    if (is_waypoint) names.push_back(place.name);
  for (const Region& place : arena_.places().regions)
    if (!is_waypoint) names.push_back(place.name);
  const std::string given = command.Word(kind);
  std::string text = "there is no " + kind + " '" + given + "'";
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  if (const std::string_view near = Suggest(given, candidates); !near.empty())
    text += "; did you mean " + std::string(near) + "?";
  constexpr std::size_t kMostNamed = 8;
  const std::size_t more = names.size() > kMostNamed ? names.size() - kMostNamed : 0;
  names.resize(names.size() - more);
  if (more > 0) names.push_back(std::to_string(more) + " more");
  if (names.empty()) return text + "; the scenario has no " + kind + "s";
  if (!text.ends_with('?')) text += '.';
  return text + (names.size() == 1 ? " The only " + kind + " is " : " The " + kind + "s are ") + wording::Listed(names);
}

void Actor::End(const Running& command, Outcome::Status status, std::string_view reason, std::string text) {
  Outcome outcome;
  outcome.status = status;
  outcome.tag = command.said.tag;
  outcome.command = command.said.name;
  outcome.reason = reason;
  if (text.empty()) text = WhichPlaces(command, reason);
  if (const vocabulary::ReasonRow* row = vocabulary::FindReason(reason); row != nullptr && text.empty())
    text = row->meaning;
  outcome.text = std::move(text);
  outcomes_.push_back(std::move(outcome));
}

void Actor::Begin(const vocabulary::SaidCommand& command) {
  Running started;
  started.said = command;
  started.row = vocabulary::FindCommand(command.name);
  if (!IsAlive()) return End(started, Outcome::Status::kError, "dead");
  if (vocabulary::CommandFault fault = vocabulary::CheckCommand(command); !fault.ok()) {
    End(started, Outcome::Status::kError, fault.reason, fault.text);
    outcomes_.back().parameter = fault.parameter;
    outcomes_.back().brief = fault.brief;
    return;
  }
  const vocabulary::BodyPart part = started.row->part;
  if (part != vocabulary::BodyPart::kNone && part != vocabulary::BodyPart::kVoice &&
      part != vocabulary::BodyPart::kPosture) {
    for (const Running& other : running_)
      if (other.row->part == part) End(other, Outcome::Status::kInterrupted, {});
    std::erase_if(running_, [&](const Running& other) { return other.row->part == part; });
  }
  if (running_.size() >= kMostRunning) {
    End(running_.front(), Outcome::Status::kInterrupted, {});
    running_.erase(running_.begin());
  }
  if (part == vocabulary::BodyPart::kLegs) {
    way_.status = command.name == "stop" ? "none" : "moving";
    way_.command = command.name;
    way_.remaining_m.reset();
  }
  running_.push_back(std::move(started));
}

void Actor::Cancel(std::uint64_t tag) {
  const auto at = std::find_if(running_.begin(), running_.end(), [&](const Running& r) { return r.said.tag == tag; });
  if (at == running_.end()) return;
  if (at->row->part == vocabulary::BodyPart::kLegs) way_ = Way{};
  running_.erase(at);
}

std::vector<Outcome> Actor::TakeOutcomes() {
  return std::exchange(outcomes_, {});
}

bool Actor::OnlyWalks() const {
  if (is_scripted_) return true;
  if (!IsAlive()) return dead_;
  return std::ranges::all_of(running_, [](const Running& command) { return IsWalk(command.said.name); });
}

void Actor::Foresee() {
  if (is_scripted_ || !IsAlive()) return;
  for (Running& command : running_) ForeseeWander(*this, command);
}

void Actor::Step() {
  if (is_scripted_) return;
  if (!IsAlive()) return Die();
  if (weapon_) weapon_->Update(world_.tick());
  wanted_.reset();
  look_.reset();
  for (std::size_t i = 0; i < running_.size();) {
    Running& command = running_[i];
    const StepResult result = FindConduct(command.said.name)(*this, command);
    ++command.ticks;
    if (result.state == StepResult::State::kGoing) {
      const int tenths = static_cast<int>(std::clamp(result.progress, 0.0f, 1.0f) * 10);
      if (tenths != std::exchange(command.told_tenths, tenths) && (tenths > 0 || command.ticks > 1)) {
        End(command, Outcome::Status::kProgress, {});
        outcomes_.back().progress = static_cast<float>(tenths) / 10;
      }
      ++i;
      continue;
    }
    const bool done = result.state == StepResult::State::kDone;
    if (command.row->part == vocabulary::BodyPart::kLegs && command.said.name != "stop") {
      way_.status = done ? "arrived" : "blocked";
      way_.remaining_m.reset();
    }
    End(command, done ? Outcome::Status::kComplete : Outcome::Status::kError, result.reason);
    running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  MoveBody();
  ShowBearing();
}

/// Legs and neck: applies the velocity that the commands request, limited by the body's force, and turns towards it.
void Actor::MoveBody() {
  const float step_s = world_.settings().step_s;
  world::Vec3 wanted = Flat(wanted_.value_or(world::Vec3{}));
  if (const float speed = world::Length(wanted); speed > body_->MaxSpeed())
    wanted = wanted * (body_->MaxSpeed() / speed);
  const bool wants_rest = wanted == world::Vec3{} && world::Length(Flat(body_->Velocity())) < 0.02f;
  if (body_->HasBody() && body_->Mass() > 0 && !wants_rest) {
    world::Vec3 force = (wanted - Flat(body_->Velocity())) * (body_->Mass() / step_s);
    if (const float newtons = world::Length(force); newtons > body_->MaxForce())
      force = force * (body_->MaxForce() / newtons);
    body_->ApplyForce(force);
  }
  // Without a direction to look in, the body faces its direction of movement.
  world::Vec3 ahead = look_.value_or(world::Length(wanted) > 0.3f ? wanted : world::Vec3{});
  ahead.y = 0;
  if (ahead == world::Vec3{}) return;
  const float heading = HeadingOf(body_->Forward()), turn = WrapDegrees(HeadingOf(ahead) - heading);
  const float most = kTurnRate_deg_per_s * step_s;
  body_->SetForward(AlongHeading(heading + std::clamp(turn, -most, most)));
}

void Actor::Die() {
  if (std::exchange(dead_, true)) return;
  for (const Running& command : running_) End(command, Outcome::Status::kError, "dead");
  running_.clear();
  way_ = Way{};
  bearing_.End(world_);
  body_->SetLastCommand("dead");
  // Dead bodies are not obstacles, and shots pass through them.
  body_->RemovePhysics();
  body_->SetSpeed(0);
}

void Actor::Notice(Happening happening) {
  happening.number = ++happened_;
  happening.tick = world_.tick();
  happenings_.push_back(std::move(happening));
  if (happenings_.size() > kMostHappenings) happenings_.pop_front();
}

std::optional<Actor::Sighting> Actor::Find(world::EntityId agent, std::string_view& reason) const {
  const world::Agent* other = world_.FindAgent(agent);
  if (other == nullptr || other->IsGone()) {
    reason = "no-such-agent";
    return std::nullopt;
  }
  if (agent == id_) {
    reason = "itself";
    return std::nullopt;
  }
  const auto known = contacts_.find(agent);
  // Friends have radio contact, so that each knows where the others are.
  const bool is_friend = other->Team() == body_->Team();
  if (is_friend || (known != contacts_.end() && known->second.visible)) {
    return Sighting{other->Position(), other->Velocity(), other->Forward(), true, other->Health() > 0};
  }
  if (known == contacts_.end()) {
    reason = "never-noticed";
    return std::nullopt;
  }
  const Contact& contact = known->second;
  const double age_s =
      static_cast<double>(world_.tick() - contact.noticed_tick) * static_cast<double>(world_.settings().step_s);
  if (age_s > static_cast<double>(kind_.senses.memory_s)) {
    reason = "lost";
    return std::nullopt;
  }
  return Sighting{contact.position, contact.velocity, contact.forward, false, contact.alive};
}

std::optional<Actor::Place> Actor::FindPlace(const Running& command, std::string_view& reason) const {
  if (const vocabulary::Percept* x = command.Get("x"), *z = command.Get("z"); x != nullptr && z != nullptr) {
    return Place{{static_cast<float>(*x->Number()), body_->Position().y, static_cast<float>(*z->Number())}};
  }
  if (command.Get("waypoint") != nullptr) {
    if (const Waypoint* found = arena_.places().FindWaypoint(command.Word("waypoint"))) return Place{found->position};
    reason = "no-such-waypoint";
    return std::nullopt;
  }
  if (command.Get("region") != nullptr) {
    if (const Region* found = arena_.places().FindRegion(command.Word("region"))) return Place{found->center};
    reason = "no-such-region";
    return std::nullopt;
  }
  if (command.Get("object") != nullptr) {
    const world::EntityId id = arena_.FindObjectNamed(command.Word("object"));
    if (const world::Object* object = world_.FindObject(id)) return Place{object->Position(), id, object->Radius()};
    reason = "no-such-object";
    return std::nullopt;
  }
  if (command.Get("agent") != nullptr) {
    const world::EntityId id = arena_.FindAgentNamed(command.Word("agent"));
    const std::optional<Sighting> seen = Find(id, reason);
    if (!seen) return std::nullopt;
    return Place{seen->position, id, world_.FindAgent(id)->Radius()};
  }
  reason = "no-place";
  return std::nullopt;
}

void Actor::AddTo(world::StateHash& hash) const {
  bearing_.AddTo(hash);
  hash.Add(std::uint64_t{running_.size()});
  for (const Running& command : running_) {
    hash.Add(std::string_view(command.said.name));
    hash.Add(command.ticks);
  }
  hash.Add(std::string_view(stance_));
  hash.Add(walk_mps_);
  if (weapon_) weapon_->AddTo(hash);
  for (const auto& [id, contact] : contacts_) {
    hash.Add(static_cast<std::uint64_t>(Number(id)));
    hash.Add(contact.position);
    hash.Add(contact.noticed_tick);
  }
}

}  // namespace soarbox::sim
