// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sim/mind_notes.h"

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

/// What one mind does within a tick, for whoever looks at the tick afterwards. Notes only; nothing is read while the
/// mind runs.
class MindLog {
 public:
  MindLog();
  ~MindLog();
  MindLog(MindLog&&) noexcept;
  MindLog& operator=(MindLog&&) noexcept;

  /// Listens to the agent from now on, which must live as long as this. kNone: no longer.
  void Listen(sml::Agent& agent, MindDetail detail);
  /// Forgets the tick before.
  void Clear();

  /// What has been noted in this tick, to add to or to copy; stays where it is for the life of the log.
  MindNotes& notes();
  const MindNotes& notes() const;
  /// The same in words, made when they are asked for first. Valid until the log is added to; one thread at a time.
  const MindWords& words() const;
  /// The operators chosen in the goal stack now, from the top: "engage > aim"; empty if there is none, or nobody tells.
  std::string Operators() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace soarbox::sim
