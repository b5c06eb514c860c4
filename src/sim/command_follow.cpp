// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

// Commands that refer to another agent.
namespace soarbox::sim {
namespace {

using world::Vec3;

constexpr float kMostPrediction_s = 2;
constexpr float kElbowRoom_m = 1.2f;

/// The agent that the command names, at its believed position.
std::optional<Actor::Sighting> Other(Actor& actor, const Running& command, world::EntityId& id,
                                     std::string_view& reason) {
  id = actor.arena().FindAgentNamed(command.Word("agent"));
  return actor.Find(id, reason);
}

Vec3 Ahead(const Actor& actor, const Actor::Sighting& other, float speed) {
  const float seconds = FlatDistance(actor.body().Position(), other.position) / std::max(speed, 0.1f);
  return other.position + Flat(other.velocity) * std::min(seconds, kMostPrediction_s);
}

/// A direction away from agents that are too near, so that followers do not push each other.
Vec3 MakeRoom(Actor& actor, world::EntityId but) {
  Vec3 sum;
  for (const auto& other : actor.arena().actors()) {
    if (other->id() == actor.id() || other->id() == but || !other->IsAlive()) continue;
    const Vec3 away = Flat(actor.body().Position() - other->body().Position());
    const float range = world::Length(away);
    if (range > 0.01f && range < kElbowRoom_m) sum += away / range * (kElbowRoom_m - range);
  }
  return sum;
}

StepResult Pursue(Actor& actor, Running& command) {
  std::string_view reason;
  world::EntityId id;
  const auto other = Other(actor, command, id, reason);
  if (!other) return StepResult::Failed(reason);
  const float within_m = static_cast<float>(command.Number("within", 1.5));
  const float range_m = FlatDistance(actor.body().Position(), other->position);
  if (command.ticks == 0) command.start_m = std::max(range_m, 0.01f);
  actor.way().remaining_m = std::max(0.0f, range_m - within_m);
  if (range_m <= within_m) return other->certain ? StepResult::Done() : StepResult::Failed("lost");
  const Vec3 wanted = world::Normalized(Flat(Ahead(actor, *other, actor.TopSpeed()) - actor.body().Position()));
  actor.Walk(FreeDirection(actor, wanted, std::min(range_m, 3.0f), id, command.turn_deg) * actor.TopSpeed());
  return StepResult::Going(1 - range_m / command.start_m);
}

StepResult Evade(Actor& actor, Running& command) {
  std::string_view reason;
  world::EntityId id;
  const auto other = Other(actor, command, id, reason);
  if (!other && !(command.goal && reason == "lost")) return StepResult::Failed(reason);
  const Vec3 danger = other ? Ahead(actor, *other, actor.TopSpeed()) : *command.goal;
  command.goal = danger;
  const float until_m = static_cast<float>(command.Number("until", 20));
  const float range_m = FlatDistance(actor.body().Position(), other ? other->position : danger);
  actor.way().remaining_m = std::max(0.0f, until_m - range_m);
  if (range_m >= until_m) return StepResult::Done();
  Vec3 away = world::Normalized(Flat(actor.body().Position() - danger));
  if (away == Vec3{}) away = Flat(actor.body().Forward());
  actor.Walk(FreeDirection(actor, away, 3, world::kNoEntity, command.turn_deg) * actor.TopSpeed());
  return StepResult::Going(range_m / until_m);
}

/// Moves to a spot that itself moves, and matches its velocity there.
void KeepSpot(Actor& actor, Running& command, Vec3 spot, Vec3 spot_velocity, float slack_m, world::EntityId id) {
  const Vec3 offset = Flat(spot - actor.body().Position());
  const float range_m = world::Length(offset);
  actor.way().remaining_m = std::max(0.0f, range_m - slack_m);
  Vec3 velocity = MakeRoom(actor, id) * 2;
  if (range_m > slack_m) {
    const Vec3 wanted = FreeDirection(actor, offset / range_m, std::min(range_m, 3.0f), id, command.turn_deg);
    velocity += wanted * std::min(actor.TopSpeed(), 1.5f * (range_m - slack_m) + world::Length(Flat(spot_velocity)));
  }
  actor.Walk(velocity);
}

StepResult Follow(Actor& actor, Running& command) {
  std::string_view reason;
  world::EntityId id;
  const auto other = Other(actor, command, id, reason);
  if (!other) return StepResult::Failed(reason);
  KeepSpot(actor, command, other->position, other->velocity, static_cast<float>(command.Number("gap", 2.5)), id);
  return StepResult::Going();
}

StepResult KeepFormation(Actor& actor, Running& command) {
  std::string_view reason;
  world::EntityId id;
  const auto other = Other(actor, command, id, reason);
  if (!other) return StepResult::Failed(reason);
  const Vec3 ahead = world::Normalized(Flat(other->forward));
  const Vec3 left{ahead.z, 0, -ahead.x};
  const Vec3 spot = other->position + left * static_cast<float>(command.Number("left", 0)) -
                    ahead * static_cast<float>(command.Number("back", 2));
  KeepSpot(actor, command, spot, other->velocity, 0.3f, id);
  return StepResult::Going();
}

/// The nearest spot behind a thing, as seen from the menace.
std::optional<Vec3> FindCover(Actor& actor, Vec3 menace, world::EntityId menace_id) {
  constexpr float kReach_m = 30;
  std::optional<Vec3> best;
  float best_m = kReach_m;
  const world::World& world = actor.world();
  for (const world::EntityId id : world.ObjectIds()) {
    const world::Object& object = *world.FindObject(id);
    if (object.kind() == world::ObjectKind::kPlane || object.kind() == world::ObjectKind::kSensor ||
        object.Radius() > 20)
      continue;
    const Vec3 center = object.Position();
    const Vec3 behind = world::Normalized(Flat(center - menace));
    for (const float turn : {0.0f, 25.0f, -25.0f}) {
      const Vec3 along = AlongHeading(HeadingOf(behind) + turn);
      Vec3 far = center + along * (object.Radius() + 2);
      far.y = center.y;
      // A ray from outside to the thing finds its surface on that side.
      const auto surface = world.RayCast(far, center);
      if (!surface || surface->entity != id) continue;
      Vec3 spot = surface->point + along * (actor.body().Radius() + 0.35f);
      spot.y = actor.body().Position().y;
      Vec3 eyes = menace;
      eyes.y += 0.6f;
      Vec3 head = spot;
      head.y += 0.2f;
      const auto between = world.RayCast(eyes, head);
      if (!between || between->entity == menace_id || between->entity == actor.id()) continue;
      const float range_m = FlatDistance(actor.body().Position(), spot);
      if (range_m >= best_m) continue;
      best_m = range_m;
      best = spot;
    }
  }
  return best;
}

StepResult TakeCover(Actor& actor, Running& command) {
  std::string_view reason;
  world::EntityId id;
  if (!command.goal) {
    const auto other = Other(actor, command, id, reason);
    if (!other) return StepResult::Failed(reason);
    command.goal = FindCover(actor, other->position, id);
    if (!command.goal) return StepResult::Failed("no-cover");
  }
  WalkOrder order;
  order.goal = *command.goal;
  order.within_m = 0.5f;
  order.speed_mps = actor.TopSpeed();
  const StepResult step = WalkTo(actor, command, order);
  if (step.state == StepResult::State::kDone) actor.SetStance("crouching");
  return step;
}

constexpr Conduct kFollowConducts[] = {
    {"pursue", Pursue},        {"evade", Evade}, {"follow", Follow}, {"keep-formation", KeepFormation},
    {"take-cover", TakeCover},
};

}  // namespace

std::span<const Conduct> FollowingConducts() {
  return kFollowConducts;
}

}  // namespace soarbox::sim
