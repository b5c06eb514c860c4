// SPDX-License-Identifier: BSD-2-Clause
#include "app/pace.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace soarbox::app {
namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8, 16};
/// A slow machine slows the world down rather than falling ever further behind.
constexpr int kMostTicksPerFrame = 64;
constexpr auto kLongestFrame = std::chrono::milliseconds(100);

double NextFaster(double speed) {
  const double* next = std::upper_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
  return next == std::end(kSpeeds) ? speed : *next;
}

double NextSlower(double speed) {
  const double* next = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
  return next == std::begin(kSpeeds) ? speed : *(next - 1);
}

}  // namespace

void Pace::Obey(viewer::ViewerCommand command) {
  switch (command) {
    case viewer::ViewerCommand::kTogglePause:
      paused_ = !paused_;
      break;
    case viewer::ViewerCommand::kSingleStep:
      paused_ = true;
      ++steps_;
      break;
    case viewer::ViewerCommand::kFaster:
      speed_ = NextFaster(speed_);
      break;
    case viewer::ViewerCommand::kSlower:
      speed_ = NextSlower(speed_);
      break;
    case viewer::ViewerCommand::kQuit:
      quit_ = true;
      break;
  }
}

int Pace::TicksDue(double step_s) {
  const Clock::time_point now = Clock::now();
  const Clock::duration passed = std::min<Clock::duration>(now - last_, kLongestFrame);
  last_ = now;
  if (paused_) return std::exchange(steps_, 0);
  earned_s_ += std::chrono::duration<double>(passed).count() * speed_;
  const int due = std::min(kMostTicksPerFrame, static_cast<int>(earned_s_ / step_s));
  earned_s_ = std::min(earned_s_ - due * step_s, step_s);
  return due;
}

double Pace::Blend(double step_s) const {
  return paused_ ? 1 : std::clamp(earned_s_ / step_s, 0.0, 1.0);
}

}  // namespace soarbox::app
