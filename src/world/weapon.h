// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "world/ids.h"
#include "world/math.h"

namespace soarbox::world {

class Agent;
class BodiesAround;
class StateHash;
class World;

/// What a weapon can do. Shots are rays: they arrive at once and fly straight.
struct WeaponSettings {
  float range_m = 50;
  float damage = 20;        ///< Health that a hit takes.
  float spread_deg = 1.5f;  ///< Standard deviation of the direction; drawn from the shooter's own stream.
  int magazine = 10;        ///< Rounds that a magazine holds.
  int reserve = 40;         ///< Further rounds that its owner carries.
  float interval_s = 0.5f;  ///< Between two shots.
  float reload_s = 2;
  float heard_m = 60;  ///< How far a shot is heard.
};

/// One shot as it went.
struct Shot {
  EntityId shooter = kNoEntity;
  Vec3 from, to;             ///< `to`: where it ended.
  EntityId hit = kNoEntity;  ///< What it hit, an agent or an object.
  float damage = 0;          ///< Health that it took.
  bool killed = false;
};

/// One weapon in somebody's hands: rounds and times. Times are in ticks of the world.
class Weapon {
 public:
  enum class State : std::uint8_t { kReady, kCooling, kReloading, kEmpty };

  Weapon() = default;
  explicit Weapon(const WeaponSettings& settings)
      : settings_(settings), rounds_(settings.magazine), reserve_(settings.reserve) {}

  const WeaponSettings& settings() const { return settings_; }
  State StateAt(std::uint64_t tick) const;
  int rounds() const { return rounds_; }
  int reserve() const { return reserve_; }
  void AddReserve(int rounds) { reserve_ += rounds; }

  /// Fires at a point from the shooter's eyes. Nothing if it is not ready. Agents that are hit lose health; a fixed
  /// or moving thing stops the shot. `steadiness` scales the spread: 1 standing, less when crouching.
  std::optional<Shot> Fire(World& world, Agent& shooter, Vec3 at, float steadiness);
  /// False if there is nothing to load or the magazine is full.
  bool BeginReload(const World& world);
  /// Call it once per tick: a reload that is over fills the magazine.
  void Update(std::uint64_t tick);

  void AddTo(StateHash& hash) const;

 private:
  WeaponSettings settings_;
  int rounds_ = 0, reserve_ = 0;
  std::uint64_t ready_at_ = 0;
  std::uint64_t reloaded_at_ = 0;  ///< 0: no reload is under way.
};

/// Where an agent looks from: a little below the top of its capsule.
Vec3 EyesOf(const Agent& agent);
/// Whether nothing but the target itself is between an agent's eyes and a point. `around`: AroundEyes of the agent, if
/// the point is in that view.
bool HasLineOfSight(const World& world, const Agent& from, Vec3 to, EntityId target,
                    const BodiesAround* around = nullptr);

}  // namespace soarbox::world
