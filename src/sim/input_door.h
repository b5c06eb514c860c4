// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "sim/input.h"

namespace soarbox::sim {

/// The queue of all inputs of a simulation, by tick, and the inputs of the last tick in the order in which they took
/// effect. The inputs, the scenario and the seed determine the entire run.
class InputDoor {
 public:
  /// Maximum number of inputs for one tick. Further inputs are refused, so that they cannot block the world.
  static constexpr std::size_t kMostPerTick = 10'000;

  /// Adds an input to the queue of its tick, after those that are already there. An input for a past tick takes effect
  /// in the next tick. If nothing came between, a camera pose or the value of an axis replaces the previous one, and
  /// moves of the pointer are added up. Returns false if there are too many inputs for the tick; the input is then
  /// dropped.
  bool Submit(Input input);
  /// Records an input that took effect between two ticks: a debugger's command to the minds' kernel. Beyond
  /// kMostPerTick, it is not recorded.
  void Note(InputValue value);

  /// Begins a tick: removes the inputs of the previous tick from taken(), and moves the queued inputs of this tick to
  /// it.
  void BeginTick(std::uint64_t tick);
  /// The inputs of the tick. The first `noted()` of them took effect before the tick began.
  std::span<const Input> taken() const { return taken_; }
  std::size_t noted() const { return noted_count_; }
  std::size_t waiting() const { return waiting_.size(); }

 private:
  std::deque<Input> waiting_;  ///< Sorted by tick.
  InputList noted_;            ///< For the next tick.
  InputList taken_;
  std::size_t noted_count_ = 0;
  std::uint64_t tick_ = 0;
};

}  // namespace soarbox::sim
