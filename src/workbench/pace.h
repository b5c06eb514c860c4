// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>

#include "workbench/flow.h"

namespace soarbox::workbench {

/// Converts real time to ticks that are due, at a speed that the user controls.
///
/// Of the real time since the last frame, at most a quarter of a second counts. The due ticks may run for a tenth of a
/// second (OutOfTime), without a speed limit for 40 ms. The remaining ticks are dropped, so that the window stays
/// responsive. On a slow machine, the world is therefore slower than real time.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  void Obey(Flow flow);
  void Pause() { paused_ = true; }
  void Resume() { paused_ = false; }
  /// In simulated seconds per second.
  void SetSpeed(double speed);

  /// Number of ticks of `step_s` seconds that are due now; OutOfTime may end them earlier. The world is at `tick`;
  /// turns end at multiples of `turn_ticks`.
  int TicksDue(double step_s, std::uint64_t tick = 0, int turn_ticks = 1);
  /// Whether the ticks since TicksDue have taken so long that the next frame is due.
  bool OutOfTime() const;
  /// The caller reports how many of the due ticks it has not run. They are due again if they belong to a turn that is
  /// being stepped; else they are dropped.
  void Owe(int ticks);
  /// Ignores the real time since the last call of TicksDue, because something else used it (a reset, a dialog).
  void Skip() { last_ = Clock::now(); }
  /// The fraction of a tick by which real time is ahead of the last tick, 0 to 1. While paused or without a speed
  /// limit: 1.
  double Blend(double step_s) const;

  bool paused() const { return paused_; }
  /// In simulated seconds per second; infinite: as fast as possible.
  double speed() const;
  bool quit() const { return quit_; }

 private:
  using Clock = std::chrono::steady_clock;

  double speed_;
  bool unlimited_ = false;
  bool paused_ = false;
  bool quit_ = false;
  int steps_ = 0, turns_ = 0;
  bool is_turn_ = false;  ///< The ticks of `steps_` belong to a turn.
  double earned_s_ = 0;   ///< Simulated time that has not become a due tick yet.
  Clock::time_point last_ = Clock::now();
};

}  // namespace soarbox::workbench
