// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "diagnostics/result.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

enum class BreakKind : std::uint8_t {
  kFire,      ///< A rule of this name fires.
  kMatch,     ///< A rule of this name has a whole match that it did not have the tick before.
  kElement,   ///< An element like this comes: "S1 ^color red", "^color *", "* ^operator * +".
  kRemoved,   ///< An element like this goes.
  kNumber,    ///< A number comes to fulfil this: "^health < 20". It did not fulfil it before.
  kOperator,  ///< An operator of this name is selected; empty: any.
  kImpasse,   ///< An impasse like this: "tie", "operator no-change"; empty: any.
  kCommand,   ///< A command of this name is said; empty: any.
  kFailed,    ///< A command of this name ends with an error; empty: any.
  kDeath,     ///< The agent dies. It says nothing else: what is meant is the agent.
  kCheck,     ///< A check of the mission is decided, or another way than before; empty: any. Of no agent.
  kTime,      ///< The world comes to this second: "12.5". Of no agent.
};
/// How users and programs name a kind.
struct BreakKindWords {
  std::string_view name;   ///< "fire".
  std::string_view title;  ///< After "Stop the world when": "a rule fires".
  std::string_view hint;   ///< What to write beside it.
};
/// In the order of BreakKind.
inline constexpr BreakKindWords kBreakKinds[] = {
    {"fire", "a rule fires", "the rule's name; * for anything"},
    {"match", "a rule matches", "the rule's name; * for anything"},
    {"element", "an element appears", "* ^attribute value"},
    {"removed", "an element is removed", "* ^attribute value"},
    {"number", "a number passes a limit", "^health < 20"},
    {"operator", "an operator is selected", "the operator's name; empty: any"},
    {"impasse", "an impasse occurs", "tie, operator no-change; empty: any"},
    {"command", "a command is given", "the command's name; empty: any"},
    {"failed", "a command fails", "the command's name; empty: any"},
    {"death", "an agent dies", "nothing more"},
    {"check", "a check is decided", "the check's name; empty: any"},
    {"time", "the world comes to a time", "seconds: 12.5"},
};
inline std::string_view NameOf(BreakKind kind) {
  return kBreakKinds[static_cast<std::size_t>(kind)].name;
}
std::optional<BreakKind> BreakKindNamed(std::string_view name);

struct Breakpoint {
  int number = 0;
  BreakKind kind = BreakKind::kFire;
  std::string agent;  ///< Empty: any with a Soar mind.
  std::string what;   ///< Words may hold * for anything.
  bool enabled = true;
  std::uint64_t hits = 0;
};

struct BreakHit {
  int number = 0;
  std::string agent;
  std::uint64_t tick = 0;
  std::string why;  ///< "breakpoint 2: scout: rule attack*enemy fired"
};

/// Looks in each finished tick for what the user waits for. The run itself is the same with breakpoints and
/// without; whoever drives it pauses when there is a hit.
class Breakpoints {
 public:
  /// Fails if no mind can have such a thing: no name of a rule, an element without attribute, no number to compare
  /// with.
  Result<int> Set(BreakKind kind, std::string agent, std::string what);
  bool Clear(int number);
  void ClearAll() { list_.clear(); }
  bool Enable(int number, bool on);
  const std::vector<Breakpoint>& list() const { return list_; }

  /// Has the minds tell as much as the breakpoints need. Before each tick; costs nothing if there are none.
  void Prepare(sim::Simulation& simulation);
  /// After each tick, with what happened in it: what was hit, in order; empty: continue.
  std::vector<BreakHit> Check(const sim::Simulation& simulation, const sim::EventList& events);

 private:
  std::optional<std::string> CauseInMind(const Breakpoint& point, const sim::Simulation& simulation,
                                         const sim::MindReport& report);
  /// Why a number is a hit. Notes which numbers fulfil what is asked.
  std::optional<std::string> NumberCause(const Breakpoint& point, const sim::MindReport& report);

  std::vector<Breakpoint> list_;
  int last_number_ = 0;
  std::set<std::string> noted_;                       ///< Agents that were asked to tell all.
  std::map<std::pair<int, std::string>, bool> held_;  ///< By breakpoint, and agent or "agent ID ^attribute": the rule
                                                      ///< had a match, the number fulfilled what is asked.
};

/// Whether an element is like "ID ^ATTRIBUTE VALUE [+]"; parts may be left out or hold *.
bool IsLike(const explain::ElementFact& element, std::string_view pattern);

std::string ToText(const std::vector<Breakpoint>& list);
Json ToJson(const std::vector<Breakpoint>& list);

}  // namespace soarbox::debugger
