// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::world {

class Agent;
class BodiesAround;
class StateHash;
class World;

/// The properties of a weapon. Shots are rays: they fly straight and hit at once.
struct WeaponSettings {
  float range_m = 50;
  float damage = 20;        ///< Health that a hit removes.
  float spread_deg = 1.5f;  ///< Standard deviation of the direction. Random numbers come from the shooter's own stream.
  int magazine = 10;        ///< Capacity of the magazine, in rounds.
  int reserve = 40;         ///< Further rounds that its owner carries.
  float interval_s = 0.5f;  ///< Minimum time between two shots.
  float reload_s = 2;
  float heard_m = 60;  ///< Distance at which a shot is heard.
};

/// One shot and its result.
struct Shot {
  EntityId shooter = kNoEntity;
  Vec3 from, to;             ///< `to`: the end of the shot.
  EntityId hit = kNoEntity;  ///< The agent or object that it hit.
  float damage = 0;          ///< Health that it removed.
  bool killed = false;
};

/// A weapon of an agent: its rounds and times. Times are in ticks of the world.
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

  /// Fires from the shooter's eyes at a point. Returns nothing if the weapon is not ready. An agent that is hit loses
  /// health; objects stop the shot. `steadiness` scales the spread: 1 when standing, less when crouching.
  std::optional<Shot> Fire(World& world, Agent& shooter, Vec3 at, float steadiness);
  /// Starts to reload. Returns false if there are no rounds or the magazine is full.
  bool BeginReload(const World& world);
  /// Call it once per tick. Fills the magazine when a reload is complete.
  void Update(std::uint64_t tick);

  void AddTo(StateHash& hash) const;

 private:
  WeaponSettings settings_;
  int rounds_ = 0, reserve_ = 0;
  std::uint64_t ready_at_ = 0;
  std::uint64_t reloaded_at_ = 0;  ///< 0: not reloading.
};

/// Position of an agent's eyes: a little below the top of its capsule.
Vec3 EyesOf(const Agent& agent);
/// Whether nothing except the target is between an agent's eyes and a point. `around`: AroundEyes of the agent if the
/// point is in that view, or null.
bool HasLineOfSight(const World& world, const Agent& from, Vec3 to, EntityId target,
                    const BodiesAround* around = nullptr);

}  // namespace soarbox::world
