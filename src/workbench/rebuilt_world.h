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

/// The world and its minds as they were at a past tick, simulated again a slice of time at once.
class RebuiltWorld {
 public:
  /// Begins the way to a tick.
  using Begin = std::function<Result<std::unique_ptr<record::Branch>>(std::uint64_t tick)>;
  enum class Way : std::uint8_t {
    kToOneTick,  ///< Another tick needs a way of its own.
    kOnward,     ///< The same way leads to later ticks; what goes wrong on it stays wrong.
  };
  RebuiltWorld(Way way, Begin begin) : way_(way), begin_(std::move(begin)) {}

  /// From now on the world of this tick is wanted.
  void Aim(std::uint64_t tick);
  /// None is wanted.
  void GiveUp();
  /// Goes on towards the tick for about so long.
  void Advance(double most_s);
  /// The world, at the tick that is wanted; null while it is not there.
  sim::Simulation* world();
  /// Why it is not there: how far it is, or what went wrong.
  std::string Note() const;
  /// False if something went wrong: it will not be there.
  bool IsPossible() const { return trouble_.empty(); }
  /// Somebody has changed the world: it is made anew for the next tick that is wanted.
  void Spoil() { is_spoilt_ = true; }
  /// Hands over the way that led to the world.
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
