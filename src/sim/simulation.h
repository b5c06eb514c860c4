// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "diagnostics/result.h"
#include "sim/event.h"
#include "sim/scenario.h"
#include "sim/soar_host.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {
class World;
}

namespace soarbox::sim {

struct SimulationSettings {
  std::uint64_t seed = 1;      ///< Of the world, the scripts and the minds.
  int screen_width_px = 1280;  ///< What scripts are told; the window follows it.
  int screen_height_px = 720;
  bool every_command = false;  ///< Report each command of each tick, not only news.
  SoarSettings soar;           ///< Its seed is taken from `seed`.
};

/// A scenario in motion: the world, its scripts and its minds, advanced tick by tick.
///
/// The same scenario, settings and inputs give the same run, bit for bit. Used by one thread at a time.
class Simulation {
 public:
  /// Builds the world and runs the scenario's set-up. Fails only if there is nothing to run at all (the sandbox script
  /// cannot be read or does not compile, the kernel cannot start); everything else is reported through events.
  static Result<std::unique_ptr<Simulation>> Create(const Scenario& scenario, const SimulationSettings& settings);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances the world by one step: events, sense, decide, act, move.
  void Tick();
  /// Lets debuggers that are attached have their say; called while the world is paused. Tick does so by itself.
  void Idle();

  std::uint64_t tick() const;
  double time_s() const;
  world::World& world();
  const world::World& world() const;
  world::SceneSnapshot Snapshot() const;
  /// Hash of all that decides the world's future (World::Hash).
  std::uint64_t StateHash() const;
  std::size_t soar_agents() const;

  /// What happened since the last call.
  EventList TakeEvents();

  // Input, delivered to the scripts at the next tick. Key and button names are the sandbox's: "f1_key", "left_button".
  void Key(std::string_view key, bool pressed);
  void MouseButton(std::string_view button, bool pressed);

  /// What scripts are told that a frame and a tick cost, in microseconds. A window reports it for the scripts'
  /// performance panel; without it they see the nominal times, so that headless runs stay the same.
  void ReportTimes(double frame_us, double tick_us);

  /// Runs the scripts' clean-up once; no tick may follow.
  void Finish();

 private:
  struct Impl;
  explicit Simulation(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::sim
