// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "record/branch.h"
#include "sim/simulation.h"

namespace soarbox::workbench {

/// Rebuilds the world and its minds at a past tick by simulating again, for a limited time per call.
class RebuiltWorld {
 public:
  /// Starts a branch that simulates up to a tick.
  using Begin = std::function<Result<std::unique_ptr<record::Branch>>(std::uint64_t tick)>;
  enum class Way : std::uint8_t {
    kToOneTick,  ///< Each requested tick needs a new branch.
    kOnward,     ///< The branch continues to later ticks. After an error, no other tick is rebuilt.
  };
  RebuiltWorld(Way way, Begin begin) : way_(way), begin_(std::move(begin)) {}

  /// Sets the tick to rebuild.
  void Aim(std::uint64_t tick);
  /// Stops rebuilding.
  void GiveUp();
  /// Continues to simulate for about `most_s` seconds of real time.
  void Advance(double most_s);
  /// The simulation at the requested tick; null while it is not there.
  sim::Simulation* world();
  /// Why it is not there: the progress, or the error.
  std::string Note() const;
  /// False after an error: the world will not be available.
  bool IsPossible() const { return trouble_.empty(); }
  /// Marks the world as changed by the user. It is rebuilt for the next requested tick.
  void Spoil() { is_spoilt_ = true; }
  /// Hands over the branch, whose simulation is at the requested tick. Call it only if world() is not null.
  std::unique_ptr<record::Branch> Take() { return std::move(branch_); }

 private:
  Way way_;
  Begin begin_;
  std::optional<std::uint64_t> tick_;
  std::unique_ptr<record::Branch> branch_;
  std::string trouble_;
  bool is_spoilt_ = false;
};

}  // namespace soarbox::workbench
