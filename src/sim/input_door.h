// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "sim/input.h"

namespace soarbox::sim {

/// The one door of a simulation: what waits to come in, by tick, and what came in for the last tick, in the order in
/// which it took effect. That list, the scenario and the seed determine the whole run.
class InputDoor {
 public:
  /// The door refuses more for one tick, so that a flood from outside cannot hold up the world.
  static constexpr std::size_t kMostPerTick = 10'000;

  /// Files an input for its tick, after those that are already there. What comes too late takes effect in the next
  /// tick. A camera pose or the value of an axis replaces the previous one if nothing came between, and moves of the
  /// pointer add up. False:
  /// refused, because there are too many for this tick.
  bool Submit(Input input);
  /// Files something that already took effect, between two ticks: what a debugger said to the minds' kernel.
  void Note(InputValue value);

  /// Opens for this tick: forgets what came in for the previous one, and takes what waits.
  void BeginTick(std::uint64_t tick);
  /// What came in for the tick; the first `noted()` of them took effect before it began.
  std::span<const Input> taken() const { return taken_; }
  std::size_t noted() const { return noted_count_; }
  std::size_t waiting() const { return waiting_.size(); }

 private:
  std::deque<Input> waiting_;  ///< In ascending tick.
  InputList noted_;            ///< For the next tick.
  InputList taken_;
  std::size_t noted_count_ = 0;
  std::uint64_t tick_ = 0;
};

}  // namespace soarbox::sim
