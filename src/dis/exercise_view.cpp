// SPDX-License-Identifier: BSD-2-Clause
#include "dis/exercise_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dis/state_sender.h"
#include "sim/directions.h"

namespace soarbox::dis {
namespace {

constexpr std::size_t kMostHits = 2000, kMostComments = 500;
constexpr double kDegrees = 180 / std::numbers::pi;
/// Entities that are further away are not in the world.
constexpr double kFarthest_m = 1e5;
constexpr double kFastest_mps = 2000;

bool IsIn(const Vector& local) {
  return std::abs(local.x) < kFarthest_m && std::abs(local.y) < kFarthest_m && std::abs(local.z) < kFarthest_m;
}

Vector Limited(Vector v, double most) {
  const double length = std::sqrt(Dot(v, v));
  return length > most ? v * (most / length) : v;
}

/// The remaining health of a damaged entity.
float HealthOf(std::uint32_t looks) {
  constexpr float kLeft[] = {100, 70, 35, 0};
  return kLeft[looks >> appearance::kDamageShift & appearance::kDamageMask];
}

/// Converts a text to one word for rules.
std::string Word(std::string text) {
  for (char& c : text)
    if (c == ' ' || c == '|') c = '-';
  return text;
}

}  // namespace

ExerciseView::Taken ExerciseView::Take(const Body& body, double now_s) {
  if (const auto* state = std::get_if<EntityState>(&body)) {
    if (IsOurs(state->id)) return Taken::kOurs;
    auto at = heard_.find(state->id);
    if ((state->appearance & appearance::kDeactivated) != 0) {
      if (at == heard_.end()) return Taken::kYes;
      gone_.push_back(state->id);
      heard_.erase(at);
      return Taken::kYes;
    }
    if (at == heard_.end()) {
      if (heard_.size() >= settings_.most_entities) return Taken::kTooMany;
      at = heard_.emplace(state->id, Heard{}).first;
    }
    at->second = {now_s, *state, true};
    return Taken::kYes;
  }
  if (const auto* hit = std::get_if<Detonation>(&body)) {
    if (IsOurs(hit->shooter)) return Taken::kOurs;
    if (hits_.size() >= kMostHits) return Taken::kTooMany;
    hits_.push_back(*hit);
    return Taken::kYes;
  }
  if (const auto* comment = std::get_if<Comment>(&body)) {
    if (IsOurs(comment->from)) return Taken::kOurs;
    if (comments_.size() >= kMostComments) return Taken::kTooMany;
    comments_.push_back(*comment);
    return Taken::kYes;
  }
  // Fire and Collision are ignored: a shot is shown by its Detonation, and collisions are computed here.
  const auto* fire = std::get_if<Fire>(&body);
  const auto* collision = std::get_if<Collision>(&body);
  return (fire != nullptr && IsOurs(fire->shooter)) || (collision != nullptr && IsOurs(collision->issuer))
             ? Taken::kOurs
             : Taken::kYes;
}

void ExerciseView::ForgetSilent(double now_s) {
  std::erase_if(heard_, [&](const auto& entry) {
    const bool is_silent = now_s - entry.second.at_s > settings_.timeout_s;
    if (is_silent) gone_.push_back(entry.first);
    return is_silent;
  });
}

std::vector<ForeignEntity> ExerciseView::List(double now_s, std::size_t most) const {
  std::vector<ForeignEntity> list;
  for (const auto& [id, heard] : heard_) {
    if (list.size() >= most) break;
    const EntityState& state = heard.state;
    list.push_back({ToText(id), state.marking, settings_.TeamOf(state.force), std::string(settings_.BodyOf(state.type)),
                    ToText(state.type), now_s - heard.at_s});
  }
  return list;
}

sim::ForeignBodyInput ExerciseView::ToInput(const EntityState& state) const {
  sim::ForeignBodyInput input;
  input.id = ToText(state.id);
  input.name = Word(state.marking.empty() ? "entity-" + input.id : state.marking);
  input.team = settings_.TeamOf(state.force);
  input.body = settings_.BodyOf(state.type);
  input.health = HealthOf(state.appearance);
  const auto posture = state.appearance >> appearance::kPostureShift & appearance::kPostureMask;
  const bool is_low = posture == appearance::kCrouching || posture == appearance::kKneeling;
  input.stance = state.type.kind == 3 && is_low ? "crouching" : "standing";
  input.position = ToVec3(frame_.ToLocal(state.position));
  const Vector forward = frame_.ForwardOf(state.orientation);
  input.heading_deg = sim::HeadingOf(ToVec3(forward));
  const bool is_frozen = (state.appearance & appearance::kFrozen) != 0;
  if (is_frozen || state.algorithm == DeadReckoning::kStatic || state.algorithm == DeadReckoning::kOther) return input;
  input.velocity = ToVec3(Limited(frame_.TurnToLocal(state.velocity), kFastest_mps));
  const bool accelerates = state.algorithm == DeadReckoning::kRvw || state.algorithm == DeadReckoning::kFvw;
  if (accelerates) input.acceleration = ToVec3(Limited(frame_.TurnToLocal(state.acceleration), 100));
  const bool turns = state.algorithm == DeadReckoning::kRpw || state.algorithm == DeadReckoning::kRvw;
  // It rotates about the body's down axis to the right, towards smaller headings, because x is to the left of z.
  if (turns) input.turn_dps = static_cast<float>(std::clamp(-state.turn.z * kDegrees, -720.0, 720.0));
  return input;
}

sim::ForeignShotInput ExerciseView::ToInput(const Detonation& hit, const StateSender& ours) const {
  sim::ForeignShotInput input;
  input.id = ToText(hit.shooter);
  input.to = ToVec3(frame_.ToLocal(hit.position));
  input.from = input.to;
  if (const auto shooter = heard_.find(hit.shooter); shooter != heard_.end())
    input.from = ToVec3(frame_.ToLocal(shooter->second.state.position)) + world::Vec3{0, 1.5f, 0};
  const MunitionRow& munition = settings_.MunitionOf(hit.burst.munition);
  input.damage = munition.damage * static_cast<float>(std::clamp<int>(hit.burst.quantity, 1, 100));
  input.radius_m = munition.radius_m;
  if (IsOurs(hit.target) && hit.result == static_cast<std::uint8_t>(DetonationResult::kEntityImpact))
    input.target = ours.NameOf(hit.target.entity);
  return input;
}

std::vector<sim::InputValue> ExerciseView::TakeInputs(const StateSender& ours) {
  std::vector<sim::InputValue> inputs;
  for (const EntityId& id : std::exchange(gone_, {}))
    if (!heard_.contains(id)) inputs.emplace_back(sim::ForeignGoneInput{ToText(id)});
  for (auto& [id, heard] : heard_) {
    if (!std::exchange(heard.is_news, false)) continue;
    if (IsIn(frame_.ToLocal(heard.state.position))) inputs.emplace_back(ToInput(heard.state));
  }
  for (const Detonation& hit : std::exchange(hits_, {}))
    if (IsIn(frame_.ToLocal(hit.position))) inputs.emplace_back(ToInput(hit, ours));
  for (const Comment& comment : std::exchange(comments_, {})) {
    if (comment.texts.empty()) continue;
    sim::ForeignMessageInput input;
    input.id = ToText(comment.from);
    // Comments of Soarbox contain a subject, names with values, and a team; those of others are a text.
    const bool is_ours = comment.texts.size() == 3;
    input.about = is_ours ? Word(comment.texts[0]) : "comment";
    input.text = is_ours ? comment.texts[1] : "text " + Word(comment.texts[0]);
    if (is_ours) input.team = comment.texts[2];
    inputs.emplace_back(std::move(input));
  }
  return inputs;
}

}  // namespace soarbox::dis
