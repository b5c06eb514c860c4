// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

enum class BreakKind : std::uint8_t {
  kFire,      ///< A rule of this name fires.
  kMatch,     ///< A rule of this name has a complete match that it did not have in the tick before.
  kElement,   ///< An element like this is added: "S1 ^color red", "^color *", "* ^operator * +".
  kRemoved,   ///< An element like this is removed.
  kNumber,    ///< A number begins to satisfy this: "^health < 20". It did not satisfy it before.
  kOperator,  ///< An operator of this name is selected; empty: any.
  kImpasse,   ///< An impasse like this: "tie", "operator no-change"; empty: any.
  kCommand,   ///< A command of this name is given; empty: any.
  kFailed,    ///< A command of this name ends with an error; empty: any.
  kDeath,     ///< The agent dies. The breakpoint has no text: only its agent matters.
  kCheck,     ///< A check of the mission gets a result, or another result than before; empty: any. It belongs to no
              ///< agent.
  kTime,      ///< The world reaches this second: "12.5". It belongs to no agent.
};
/// The words for a kind in commands and panels.
struct BreakKindWords {
  std::string_view name;   ///< "fire".
  std::string_view title;  ///< After "Stop the world when": "a rule fires".
  std::string_view hint;   ///< What to enter for the kind.
};
/// In the order of BreakKind.
inline constexpr BreakKindWords kBreakKinds[] = {
    {"fire", "a rule fires", "the rule's name; * for any text"},
    {"match", "a rule matches", "the rule's complete name"},
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
  std::string agent;  ///< Empty: any agent with a Soar mind; for kDeath, any agent.
  std::string
      what;  ///< The pattern; words may contain * for any text. For kImpasse, it may be a part of the impasse's name.
  bool enabled = true;
  std::uint64_t hits = 0;
};

struct BreakHit {
  int number = 0;
  std::string agent;
  std::uint64_t tick = 0;
  std::string why;        ///< "breakpoint 2: scout: rule attack*enemy fired"
  std::string rule = {};  ///< The rule that fired; empty if something else was the cause.
};

/// Checks after each tick whether a breakpoint was hit. Breakpoints do not change the run; the caller pauses it after a
/// hit.
class Breakpoints {
 public:
  /// Why a breakpoint was hit.
  struct Cause {
    // Not explicit: most causes are only a text.
    Cause(std::string text, std::string rule = {})  // NOLINT(google-explicit-constructor)
        : text(std::move(text)), rule(std::move(rule)) {}
    std::string text;
    std::string rule;  ///< As in BreakHit.
  };
  /// Adds a breakpoint and returns its number. Fails if the pattern does not have the form of its kind: the name of
  /// a rule, an element with an attribute, a comparison with a number, or a time above 0.
  Result<int> Set(BreakKind kind, std::string agent, std::string what);
  bool Clear(int number);
  void ClearAll() { list_.clear(); }
  bool Enable(int number, bool on);
  const std::vector<Breakpoint>& list() const { return list_; }

  /// Sets the detail that the minds record to what the breakpoints need. Call it before each tick. Costs nothing
  /// without breakpoints.
  void Prepare(sim::Simulation& simulation);
  /// Call after each tick, with its events. Returns the hits in order of the breakpoints; empty if the run can
  /// continue.
  std::vector<BreakHit> Check(const sim::Simulation& simulation, const sim::EventList& events);

 private:
  std::optional<Cause> CauseInMind(const Breakpoint& point, const sim::Simulation& simulation,
                                   const sim::MindReport& report);
  /// Returns why a number is a hit. Also records which numbers satisfy the breakpoint now.
  std::optional<Cause> NumberCause(const Breakpoint& point, const sim::MindReport& report);

  std::vector<Breakpoint> list_;
  int last_number_ = 0;
  std::set<std::string> noted_;                       ///< Agents whose minds record all details.
  std::map<std::pair<int, std::string>, bool> held_;  ///< By breakpoint, and by agent or "agent ID ^attribute": whether
                                                      ///< the rule had a match, or the number satisfied the breakpoint.
};

/// Whether an element matches "ID ^ATTRIBUTE VALUE [+]". Parts may be omitted or contain *.
bool IsLike(const explain::ElementFact& element, std::string_view pattern);

std::string ToText(const std::vector<Breakpoint>& list);

}  // namespace soarbox::debugger
