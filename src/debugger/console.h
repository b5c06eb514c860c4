// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "sim/simulation.h"

namespace soarbox::debugger {

struct ConsoleLine {
  enum class Kind : std::uint8_t { kInput, kOutput, kError, kHint } kind = Kind::kOutput;
  std::uint64_t tick = 0;
  std::string text;  ///< One line, without its line end.
};

/// A console for one agent. Its lines are Soar commands. Lines for an agent without a mind, and lines that begin with
/// "lua ", are Lua for the agent's script; lines that begin with "lua-sandbox " are Lua for the sandbox's script. Lua
/// runs at the beginning of the next tick and answers with the value of an expression. Soar commands take effect at
/// once, between two ticks. All lines pass through Simulation::Submit, so that a recording contains them.
class Console {
 public:
  explicit Console(std::string agent) : agent_(std::move(agent)) {}

  const std::string& agent() const { return agent_; }
  /// Executes a line and stores its output. After an error it also stores a hint with similar names. Ignores blank
  /// lines.
  void Run(sim::Simulation& simulation, const std::string& line);
  /// Stores a line that cannot be executed now, with the reason.
  void Refuse(const std::string& line, std::string_view why);
  /// Adds output that others (edits, debuggers, a replayed input) caused, from a tick's events. Skips the console's own
  /// lines.
  void Add(const sim::EventList& events);
  const std::deque<ConsoleLine>& lines() const { return lines_; }
  void Clear() { lines_.clear(); }

  static constexpr std::size_t kMostLines = 5'000;

 private:
  /// Returns false if the line is not Lua.
  bool RunLua(sim::Simulation& simulation, const std::string& line);
  void Keep(ConsoleLine::Kind kind, std::uint64_t tick, std::string_view text);

  std::string agent_;
  std::deque<ConsoleLine> lines_;
  std::string typed_lua_;        ///< The last line of Lua that the user entered.
  std::deque<std::string> own_;  ///< Lines of this console whose events have not arrived yet.
};

/// Completions of the last word of a line.
struct Completion {
  std::size_t begin = 0;           ///< Where that word begins in the line.
  std::vector<std::string> words;  ///< Sorted; empty if there are none.
  std::string common;              ///< The common beginning of all words. The Tab key inserts it.
};
Completion Complete(explain::Inspector& mind, std::string_view line);

/// Commands and rules with a name similar to a word of this line; empty if there are none.
std::vector<std::string> NearMisses(explain::Inspector& mind, std::string_view line);

std::string ToText(const std::deque<ConsoleLine>& lines);

}  // namespace soarbox::debugger
