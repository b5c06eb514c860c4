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
#include "dis/dis_settings.h"
#include "dis/exercise_view.h"
#include "dis/pdu_codec.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::dis {

/// Statistics of a gateway.
struct Traffic {
  std::uint64_t sent = 0, unsent = 0;      ///< PDUs sent; PDUs that the system did not accept.
  std::uint64_t received = 0;              ///< PDUs of this exercise from others.
  std::uint64_t foreign_exercise = 0;      ///< PDUs dropped because they belong to another exercise.
  std::uint64_t too_many = 0;              ///< PDUs dropped because of a limit: entities, or hits or messages at once.
  std::array<std::uint64_t, 5> refused{};  ///< By Refusal.
  std::size_t entities = 0;                ///< Number of foreign entities at present.
  double received_per_s = 0, sent_per_s = 0;

  /// Number of dropped PDUs by reason; reasons that never occurred are omitted.
  std::vector<std::pair<std::string, std::uint64_t>> Dropped() const;
};

/// Connects a run to an exercise of other simulations (IEEE 1278.1, Distributed Interactive Simulation).
///
/// Before each tick, it converts received PDUs to inputs, so that a recording contains them. Of each entity, only the
/// newest state since the last tick becomes an input. After each tick, it sends what our agents did. The run itself
/// does not use the network. The numbers of entities, hits and messages that are kept are limited. Used on the run's
/// thread.
class Gateway {
 public:
  static Result<std::unique_ptr<Gateway>> Open(const Settings& settings);
  /// Reports to others that our entities leave.
  ~Gateway();
  Gateway(const Gateway&) = delete;
  Gateway& operator=(const Gateway&) = delete;

  /// Submits received PDUs as inputs.
  void Receive(sim::Simulation& simulation);
  /// Sends what changed in the last tick.
  void Send(const sim::Simulation& simulation);
  /// Call it while the run is paused. Accepts orders, and reports that our entities still exist.
  void Idle(sim::Simulation& simulation);
  /// Whether the manager of the exercise has requested a pause.
  bool IsFrozen() const;

  const Settings& settings() const;
  const Traffic& traffic() const;
  /// Whether no other machine can receive from us or send to us.
  bool IsOfThisMachine() const;
  /// The first `most` foreign entities.
  std::vector<ForeignEntity> Entities(std::size_t most) const;
  /// A description on one line: address, identity and traffic.
  std::string Describe() const;

 private:
  struct Impl;
  explicit Gateway(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::dis
