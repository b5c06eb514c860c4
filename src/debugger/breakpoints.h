// SPDX-License-Identifier: BSD-2-Clause
#pragma once

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
  kFire,     ///< A rule of this name fires.
  kMatch,    ///< A rule of this name has a whole match that it did not have the tick before.
  kElement,  ///< An element like this comes: "S1 ^color red", "^color *", "* ^operator * +".
  kImpasse,  ///< An impasse like this: "tie", "operator no-change"; empty: any.
  kCommand,  ///< A command of this name is said; empty: any.
};
std::string_view NameOf(BreakKind kind);
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
  /// Fails for a name or an element that no mind can have.
  Result<int> Set(BreakKind kind, std::string agent, std::string what);
  bool Clear(int number);
  void ClearAll() { list_.clear(); }
  bool Enable(int number, bool on);
  const std::vector<Breakpoint>& list() const { return list_; }

  /// Has the minds tell as much as the breakpoints need. Before each tick; costs nothing if there are none.
  void Prepare(sim::Simulation& simulation);
  /// After each tick: what was hit in it, in order; empty: continue.
  std::vector<BreakHit> Check(const sim::Simulation& simulation);

 private:
  std::vector<Breakpoint> list_;
  int last_number_ = 0;
  std::set<std::string> noted_;                          ///< Agents that were asked to tell all.
  std::map<std::pair<int, std::string>, bool> matched_;  ///< By breakpoint and agent: it had a match the tick before.
};

/// Whether an element is like "ID ^ATTRIBUTE VALUE [+]"; parts may be left out or hold *.
bool IsLike(const explain::ElementFact& element, std::string_view pattern);

std::string ToText(const std::vector<Breakpoint>& list);
Json ToJson(const std::vector<Breakpoint>& list);

}  // namespace soarbox::debugger
