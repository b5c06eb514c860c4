// SPDX-License-Identifier: BSD-2-Clause
#include "world/weapon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/agent.h"
#include "world/bodies_around.h"
#include "world/state_hash.h"
#include "world/world.h"
#include "world/world_random.h"

namespace soarbox::world {
namespace {

constexpr float kEyesBelowTop_m = 0.15f;

std::uint64_t TicksOf(const World& world, float seconds) {
  return static_cast<std::uint64_t>(std::ceil(std::max(0.0f, seconds) / world.settings().step_s));
}

/// A sum of uniform random numbers approximates the normal distribution, with the same result on every machine.
float Bell(RandomStream& random) {
  float sum = 0;
  for (int i = 0; i < 6; ++i) sum += random.Unit();
  return (sum - 3.0f) * std::numbers::sqrt2_v<float>;
}

}  // namespace

Vec3 EyesOf(const Agent& agent) {
  Vec3 eyes = agent.Position();
  eyes.y += agent.Height() / 2 - kEyesBelowTop_m;
  return eyes;
}

bool HasLineOfSight(const World& world, const Agent& from, Vec3 to, EntityId target, const BodiesAround* around) {
  const Vec3 eyes = EyesOf(from);
  if (LengthSquared(to - eyes) < 1e-6f) return true;
  if (around != nullptr) return around->MeetsNoOther(eyes, to, from.id(), target);
  const std::optional<RayHit> hit = world.RayCast(eyes, to);
  return !hit || hit->entity == target || hit->entity == from.id();
}

Weapon::State Weapon::StateAt(std::uint64_t tick) const {
  if (reloaded_at_ != 0) return State::kReloading;
  if (rounds_ <= 0) return State::kEmpty;
  return tick < ready_at_ ? State::kCooling : State::kReady;
}

std::optional<Shot> Weapon::Fire(World& world, Agent& shooter, Vec3 at, float steadiness) {
  if (StateAt(world.tick()) != State::kReady) return std::nullopt;
  --rounds_;
  ready_at_ = world.tick() + TicksOf(world, settings_.interval_s);

  Shot shot;
  shot.shooter = shooter.id();
  shot.from = EyesOf(shooter);
  Vec3 along = Normalized(at - shot.from);
  if (along == Vec3{}) along = shooter.Forward();
  const float spread = settings_.spread_deg * steadiness * std::numbers::pi_v<float> / 180;
  const Vec3 side = Normalized(Cross({0, 1, 0}, along));
  const Vec3 up = Cross(along, side);
  const float to_side = Bell(shooter.random()) * spread, to_top = Bell(shooter.random()) * spread;
  along = Normalized(along + side * to_side + up * to_top);
  shot.to = shot.from + along * settings_.range_m;

  if (const std::optional<RayHit> hit = world.RayCast(shot.from, shot.to)) {
    shot.to = hit->point;
    shot.hit = hit->entity;
    if (Agent* victim = world.FindAgent(hit->entity); victim != nullptr && victim->Health() > 0) {
      shot.damage = std::min(settings_.damage, victim->Health());
      victim->SetHealth(victim->Health() - shot.damage);
      shot.killed = victim->Health() <= 0;
    }
  }
  return shot;
}

bool Weapon::BeginReload(const World& world) {
  if (reloaded_at_ != 0) return true;
  if (reserve_ <= 0 || rounds_ >= settings_.magazine) return false;
  reloaded_at_ = world.tick() + std::max<std::uint64_t>(1, TicksOf(world, settings_.reload_s));
  return true;
}

void Weapon::Update(std::uint64_t tick) {
  if (reloaded_at_ == 0 || tick < reloaded_at_) return;
  reloaded_at_ = 0;
  const int taken = std::min(settings_.magazine - rounds_, reserve_);
  rounds_ += taken;
  reserve_ -= taken;
}

void Weapon::AddTo(StateHash& hash) const {
  hash.Add(static_cast<std::uint64_t>(rounds_));
  hash.Add(static_cast<std::uint64_t>(reserve_));
  hash.Add(ready_at_);
  hash.Add(reloaded_at_);
}

}  // namespace soarbox::world
