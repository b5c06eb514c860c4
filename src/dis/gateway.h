// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "dis/exercise_view.h"
#include "dis/pdu_codec.h"
#include "dis/settings.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::dis {

/// What has passed a gateway so far.
struct Traffic {
  std::uint64_t sent = 0, unsent = 0;      ///< PDUs; what the system did not take.
  std::uint64_t received = 0;              ///< PDUs of this exercise, and of others than ourselves.
  std::uint64_t foreign_exercise = 0;      ///< PDUs that were left out because they belong to another exercise.
  std::uint64_t too_many = 0;              ///< PDUs of entities beyond `most_entities`.
  std::array<std::uint64_t, 5> refused{};  ///< By Refusal.
  std::size_t entities = 0;                ///< Foreign ones that are there.
  double received_per_s = 0, sent_per_s = 0;

  /// How many were dropped, by reason; reasons that never came are left out.
  std::vector<std::pair<std::string, std::uint64_t>> Dropped() const;
};

/// Joins a run to an exercise of other simulations (IEEE 1278.1, Distributed Interactive Simulation).
///
/// Before each tick it turns what has arrived into inputs, at most one per entity and tick, so that whoever records the
/// run records them, too. After each tick it tells the others what our agents did. The run itself knows of no network.
/// Memory grows with the entities that are taken, never with what arrives. Used by the run's thread.
class Gateway {
 public:
  static Result<std::unique_ptr<Gateway>> Open(const Settings& settings);
  /// Tells the others that our entities leave.
  ~Gateway();
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;

  /// Submits what has arrived.
  void Receive(sim::Simulation& simulation);
  /// Sends what changed in the tick that is over.
  void Send(const sim::Simulation& simulation);
  /// While the run stands still: takes orders, and tells the others that our entities are still there.
  void Idle(sim::Simulation& simulation);
  /// The manager of the exercise wants the run to stand still.
  bool IsFrozen() const;

  const Settings& settings() const;
  const Traffic& traffic() const;
  /// No other machine hears or is heard.
  bool IsOfThisMachine() const;
  /// The first `most` foreign entities that are there.
  std::vector<ForeignEntity> Entities(std::size_t most) const;
  /// One line: where, who, and what has passed.
  std::string Describe() const;

 private:
  struct Impl;
  explicit Gateway(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::dis
