// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>

#include "viewer/viewer.h"

namespace soarbox::app {

/// The user's hold on the flow of time in a window, and the simulated time that the wall clock has earned.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  void Obey(viewer::ViewerCommand command);
  void Pause() { paused_ = true; }

  /// How many ticks of `step_s` are due now.
  int TicksDue(double step_s);
  /// How far the wall clock has come from the last tick to the next one, 0 to 1.
  double Blend(double step_s) const;

  bool paused() const { return paused_; }
  double speed() const { return speed_; }
  bool quit() const { return quit_; }

 private:
  using Clock = std::chrono::steady_clock;

  double speed_;
  bool paused_ = false;
  bool quit_ = false;
  int steps_ = 0;
  double earned_s_ = 0;
  Clock::time_point last_ = Clock::now();
};

}  // namespace soarbox::app
