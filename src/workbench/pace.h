// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>

#include "workbench/flow.h"

namespace soarbox::workbench {

/// How fast the user lets time flow in a window, and how much simulated time is due by the wall clock.
///
/// The world does not wait for frames: after a slow one it catches up with up to a quarter of a second, as fast as it
/// can for a tenth of a second; the rest is forgotten, so that the window keeps answering.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  void Obey(Flow flow);
  void Pause() { paused_ = true; }
  void Resume() { paused_ = false; }
  /// Simulated seconds per second.
  void SetSpeed(double speed);

  /// How many ticks of `step_s` are due now, if OutOfTime does not come before. Turns of `turn_ticks` end at multiples
  /// of it; the world is at `tick`.
  int TicksDue(double step_s, std::uint64_t tick = 0, int turn_ticks = 1);
  /// The ticks since TicksDue have taken so long that the next frame is due.
  bool OutOfTime() const;
  /// So many of the ticks that were due remain: a turn is stepped to its end, however slow the world is.
  void Owe(int ticks);
  /// Real time since TicksDue was called last does not count: something else took it (a reset, a dialog).
  void Skip() { last_ = Clock::now(); }
  /// How far the wall clock has come from the last tick to the next one, 0 to 1.
  double Blend(double step_s) const;

  bool paused() const { return paused_; }
  /// Simulated seconds per second; infinite: as many as can be.
  double speed() const;
  bool quit() const { return quit_; }

 private:
  using Clock = std::chrono::steady_clock;

  double speed_;
  bool unlimited_ = false;
  bool paused_ = false;
  bool quit_ = false;
  int steps_ = 0, turns_ = 0;
  bool is_turn_ = false;  ///< What is stepped.
  double earned_s_ = 0;
  Clock::time_point last_ = Clock::now();
};

}  // namespace soarbox::workbench
