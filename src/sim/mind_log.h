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

/// How much is noted of what minds do. Off, it costs nothing.
enum class MindDetail : std::uint8_t {
  kNone,
  kDecisions,  ///< Operators and impasses, and why.
  kAll,        ///< Also rules that fire and retract, and elements that come and go.
};

/// What one mind does within a tick, for whoever looks at the tick afterwards: facts only; nothing is read while the
/// mind runs.
class MindLog {
 public:
  MindLog();
  ~MindLog();
  MindLog(MindLog&&) noexcept;
  MindLog& operator=(MindLog&&) noexcept;

  /// Listens from now on to the agent, which must live as long as this. kNone: stops listening.
  void Listen(sml::Agent& agent, MindDetail detail);
  /// Forgets the tick before.
  void Clear();

  /// What happened in this tick, to add to or to copy; its address stays the same for the life of the log.
  mind::EventLog& events();
  const mind::EventLog& events() const;
  /// A command came to the output link; by then the rule that made it is known.
  void NoteCommand(std::uint64_t timetag, std::string_view name, const vocabulary::PerceptList& parameters);
  /// The operators selected in the goal stack now, from the top: "engage > aim"; empty if there is none, or nobody
  /// reports them.
  std::string Operators() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace soarbox::sim
