// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

struct ConsoleLine {
  enum class Kind : std::uint8_t { kInput, kOutput, kError, kHint } kind = Kind::kOutput;
  std::uint64_t tick = 0;
  std::string text;  ///< One line, without its end.
};

/// A command line for one agent. Its lines are Soar commands; those of an agent without a mind, and those that begin
/// with "lua ", are Lua for its script, and "lua-sandbox " is Lua for the sandbox's. Lua runs at the beginning of the
/// next tick; the value of an expression is its answer. What is typed takes effect at once, between two ticks, through
/// the simulation's door: a recording keeps it.
class Console {
 public:
  explicit Console(std::string agent) : agent_(std::move(agent)) {}

  const std::string& agent() const { return agent_; }
  /// Carries out a line and keeps what it printed; an error keeps a hint at what may have been meant. Blank lines do
  /// nothing.
  void Run(sim::Simulation& simulation, const std::string& line);
  /// Keeps a line that cannot be carried out now, and why.
  void Refuse(const std::string& line, std::string_view why);
  /// Adds what others (edits, debuggers, a replayed input) made the agent do, from a tick's events; not its own lines.
  void Add(const sim::EventList& events);
  const std::deque<ConsoleLine>& lines() const { return lines_; }
  void Clear() { lines_.clear(); }

  static constexpr std::size_t kMostLines = 5'000;

 private:
  /// False if the line is no Lua.
  bool RunLua(sim::Simulation& simulation, const std::string& line);
  void Keep(ConsoleLine::Kind kind, std::uint64_t tick, std::string_view text);

  std::string agent_;
  std::deque<ConsoleLine> lines_;
  std::string typed_lua_;        ///< Whose answer is still to come, or has come.
  std::deque<std::string> own_;  ///< Lines of its own whose events are still to come.
};

/// How the word that a line ends with may go on.
struct Completion {
  std::size_t begin = 0;           ///< Where that word begins.
  std::vector<std::string> words;  ///< Sorted; empty: nothing is known.
  std::string common;              ///< What all have in common: what the Tab key adds stands in it.
};
Completion Complete(explain::Inspector& mind, std::string_view line);

/// Commands and rules that are spelt like a word of this line; empty if none is.
std::vector<std::string> NearMisses(explain::Inspector& mind, std::string_view line);

std::string ToText(const std::deque<ConsoleLine>& lines);
Json ToJson(const std::deque<ConsoleLine>& lines);

}  // namespace soarbox::debugger
