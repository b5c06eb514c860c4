// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "mind/event_log.h"
#include "vocabulary/percept.h"

namespace sml {
class Agent;
}

namespace soarbox::sim {

/// How much is recorded of what minds do. kNone costs nothing.
enum class MindDetail : std::uint8_t {
  kNone,
  kDecisions,  ///< Operators and impasses, with their reasons.
  kAll,        ///< Also rules that fire and are retracted, and elements that are added and removed.
};

/// Records what one mind does in a tick, for inspection after the tick. It only adds events and never queries the
/// running mind.
class MindLog {
 public:
  MindLog();
  ~MindLog();
  MindLog(MindLog&&) noexcept;
  MindLog& operator=(MindLog&&) noexcept;

  /// Starts to record the agent, which must outlive the log. kNone stops recording.
  void Listen(sml::Agent& agent, MindDetail detail);
  /// Removes the events of the previous tick.
  void Clear();

  /// The events of this tick, which callers may add to. The address stays the same during the life of the log.
  mind::EventLog& events();
  const mind::EventLog& events() const;
  /// Adds a command on the output link, with the rule that made it.
  void NoteCommand(std::uint64_t timetag, std::string_view name, const vocabulary::PerceptList& parameters);
  /// The operators that are selected in the goal stack now, from the top: "engage > aim". Empty if there is none, or if
  /// operators are not recorded.
  std::string Operators() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace soarbox::sim
