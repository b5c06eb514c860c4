// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/pace.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace soarbox::workbench {
namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8, 16};
/// Maximum real time that one frame adds to the time to simulate, and maximum duration of the ticks between two frames.
/// Without these limits, the ticks that are due on a slow machine would become more with each frame.
constexpr auto kLongestFrame = std::chrono::milliseconds(250);
constexpr auto kLongestTicks = std::chrono::milliseconds(100);
/// Without a speed limit, the window still draws 25 frames per second.
constexpr auto kUnlimitedTicks = std::chrono::milliseconds(40);

double NextFaster(double speed) {
  const double* next = std::upper_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
  return next == std::end(kSpeeds) ? speed : *next;
}

double NextSlower(double speed) {
  const double* next = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
  return next == std::begin(kSpeeds) ? speed : *(next - 1);
}

}  // namespace

void Pace::Obey(Flow flow) {
  switch (flow) {
    case Flow::kTogglePause:
      paused_ = !paused_;
      break;
    case Flow::kStepTick:
      paused_ = true;
      ++steps_;
      break;
    case Flow::kStepTurn:
      paused_ = true;
      ++turns_;
      break;
    case Flow::kFaster:
      if (!unlimited_) speed_ = NextFaster(speed_);
      break;
    case Flow::kSlower:
      // From unlimited to the highest limited speed.
      speed_ = unlimited_ ? *(std::end(kSpeeds) - 1) : NextSlower(speed_);
      unlimited_ = false;
      break;
    case Flow::kNormalSpeed:
      speed_ = 1;
      unlimited_ = false;
      break;
    case Flow::kUnlimited:
      unlimited_ = !unlimited_;
      break;
    case Flow::kStepDecision:
    case Flow::kStepPhase:
      paused_ = true;
      break;
    case Flow::kStepChange:
      paused_ = false;
      break;
    case Flow::kQuit:
      quit_ = true;
      break;
    default:
      break;
  }
}

void Pace::SetSpeed(double speed) {
  speed_ = std::clamp(speed, kSpeeds[0], *(std::end(kSpeeds) - 1));
  unlimited_ = false;
}

int Pace::TicksDue(double step_s, std::uint64_t tick, int turn_ticks) {
  const Clock::time_point now = Clock::now();
  const Clock::duration passed = std::min<Clock::duration>(now - last_, kLongestFrame);
  last_ = now;
  is_turn_ = turns_ > 0 || (is_turn_ && steps_ > 0);
  if (paused_ && turns_ > 0) {
    const auto turn = static_cast<std::uint64_t>(std::max(turn_ticks, 1));
    steps_ += static_cast<int>(static_cast<std::uint64_t>(turns_) * turn - tick % turn);
  }
  turns_ = 0;
  if (paused_) return std::exchange(steps_, 0);
  if (unlimited_) return std::numeric_limits<int>::max();
  earned_s_ += std::chrono::duration<double>(passed).count() * speed_;
  const int due = static_cast<int>(earned_s_ / step_s);
  earned_s_ = std::min(earned_s_ - due * step_s, step_s);
  return due;
}

bool Pace::OutOfTime() const {
  return Clock::now() - last_ > (unlimited_ ? kUnlimitedTicks : kLongestTicks);
}

void Pace::Owe(int ticks) {
  if (paused_ && is_turn_) steps_ += ticks;
}

double Pace::speed() const {
  return unlimited_ ? std::numeric_limits<double>::infinity() : speed_;
}

double Pace::Blend(double step_s) const {
  return paused_ || unlimited_ ? 1 : std::clamp(earned_s_ / step_s, 0.0, 1.0);
}

}  // namespace soarbox::workbench
