// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>

#include "sim/arena.h"
#include "sim/conduct.h"
#include "sim/directions.h"

namespace soarbox::sim {
namespace {

constexpr float kAimed_deg = 4;
constexpr float kGiveUp_s = 1;

StepResult Shoot(Actor& actor, Running& command) {
  if (!actor.weapon()) return StepResult::Failed("no-weapon");
  world::Weapon& weapon = *actor.weapon();
  const int rounds = static_cast<int>(command.Number("rounds", 1));

  // Shoots at the named place or agent, else at the present target.
  std::string_view reason;
  std::optional<Actor::Place> place;
  const bool names_place = command.Get("agent") || command.Get("x") || command.Get("waypoint") ||
                           command.Get("region") || command.Get("object");
  if (names_place) {
    place = actor.FindPlace(command, reason);
  } else if (actor.target() != world::kNoEntity) {
    if (const auto seen = actor.Find(actor.target(), reason)) place = Actor::Place{seen->position, actor.target()};
  } else {
    reason = "no-target";
  }
  if (!place) return StepResult::Failed(reason);
  const world::Agent* victim = actor.world().FindAgent(place->entity);
  if (victim != nullptr && victim->Health() <= 0)
    return command.count > 0 ? StepResult::Done() : StepResult::Failed("target-dead");

  const world::Vec3 towards = Flat(place->position - actor.body().Position());
  if (world::Length(towards) > weapon.settings().range_m) return StepResult::Failed("out-of-range");
  actor.Look(towards);
  switch (weapon.StateAt(actor.world().tick())) {
    case world::Weapon::State::kEmpty:
      return StepResult::Failed("empty");
    case world::Weapon::State::kReloading:
      return StepResult::Failed("reloading");
    case world::Weapon::State::kCooling:
      return StepResult::Going(static_cast<float>(command.count) / static_cast<float>(rounds));
    case world::Weapon::State::kReady:
      break;
  }
  const float off_deg = std::abs(BearingOf(actor.body().Position(), actor.body().Forward(), place->position));
  const bool in_view =
      victim == nullptr || HasLineOfSight(actor.world(), actor.body(), victim->Position(), place->entity);
  if (off_deg > kAimed_deg || !in_view) {
    if (in_view) command.mark_tick = command.ticks;
    const float waited_s = static_cast<float>(command.ticks - command.mark_tick) * actor.world().settings().step_s;
    if (waited_s > kGiveUp_s) return StepResult::Failed("not-in-view");
    return StepResult::Going(static_cast<float>(command.count) / static_cast<float>(rounds));
  }
  command.mark_tick = command.ticks;
  if (const auto shot = weapon.Fire(actor.world(), actor.body(), place->position, actor.Steadiness())) {
    actor.arena().OnShot(*shot);
    ++command.count;
  }
  if (command.count >= rounds) return StepResult::Done();
  return StepResult::Going(static_cast<float>(command.count) / static_cast<float>(rounds));
}

StepResult Reload(Actor& actor, Running& command) {
  if (!actor.weapon()) return StepResult::Failed("no-weapon");
  world::Weapon& weapon = *actor.weapon();
  if (command.ticks == 0) {
    if (weapon.rounds() >= weapon.settings().magazine) return StepResult::Failed("full");
    if (!weapon.BeginReload(actor.world())) return StepResult::Failed("no-ammunition");
    return StepResult::Going();
  }
  if (weapon.StateAt(actor.world().tick()) != world::Weapon::State::kReloading) return StepResult::Done();
  const float passed_s = static_cast<float>(command.ticks) * actor.world().settings().step_s;
  return StepResult::Going(passed_s / std::max(0.01f, weapon.settings().reload_s));
}

constexpr Conduct kFightConducts[] = {{"shoot", Shoot}, {"reload", Reload}};

}  // namespace

std::span<const Conduct> FightingConducts() {
  return kFightConducts;
}

}  // namespace soarbox::sim
