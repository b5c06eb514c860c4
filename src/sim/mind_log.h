// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

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

/// What one mind does within a tick, in words, for whoever looks at the tick afterwards. Notes only; nothing is read
/// while the mind runs.
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

  /// What changed on the input link: "path value", or "-path" for what has gone. Paths are attributes joined by dots;
  /// "agent#3" is the one of several with that key.
  std::vector<std::string>& percepts();
  const std::vector<std::string>& percepts() const;
  /// "move-to ^waypoint gate", and how commands went: "move-to: complete".
  const std::vector<std::string>& commands() const;
  /// For each of commands(): the rule that made it, where that is known and it is a command.
  const std::vector<std::string>& command_rules() const;
  /// Adds to commands(); `tag` is its time tag if it is one.
  void Say(std::string command, std::uint64_t tag = 0);
  /// "O: O1 (seek)", "==>S: S2 (operator tie)", "<==S: S2" with three blanks per level of the goal stack. A program
  /// that waits in a state (soar wait-snc) tells that once. A kernel in
  /// another process, or one that is not ours, does not tell them, nor details.
  const std::vector<std::string>& decisions() const;
  /// For each of decisions(): why it was taken ("the only one proposed; proposed by RULE"), or nothing.
  const std::vector<std::string>& reasons() const;
  /// The operators chosen in the goal stack now, from the top: "engage > aim"; empty if there is none, or nobody tells.
  std::string Operators() const;
  /// "fire RULE", "retract RULE", "+ 12: S1 ^a b", "- 12: S1 ^a b", after a count of the decisions before it: they
  /// stand between decisions()[count - 1] and decisions()[count].
  const std::vector<std::string>& details() const;

 private:
  struct Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace soarbox::sim
