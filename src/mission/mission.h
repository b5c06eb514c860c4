// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mission/keys.h"
#include "mission/rule_pattern.h"

namespace soarbox::mission {

/// { min, max } of a number; both are allowed values.
struct Bounds {
  std::optional<double> min, max;
  bool Hold(double value) const { return (!min || value >= *min) && (!max || value <= *max); }
  bool empty() const { return !min && !max; }
};

/// One thing that a check looks at: KEY = VALUE with what narrows it.
struct Condition {
  const KeyRow* row = nullptr;
  std::vector<std::string> words;  ///< Any of these.
  bool truth = true;
  Bounds bounds;                                          ///< Of gauges and counters; of `near` its range.
  std::vector<std::pair<std::string, std::string>> with;  ///< Parameters of a command, message or operator.
  std::string status, reason;                             ///< Of a command's answer.
  std::optional<int> level;                               ///< Of an operator, from 1.
  std::string selected_by;                                ///< Of an operator: "only", "preference", "chance".
  std::string is;                                         ///< Value of an element.
  char support = 0;                                       ///< 'i', 'o'; 0: any.
  std::optional<int> count;                               ///< Of an element: at least this many of them at once.
  int line = 0;
};

/// Whom a check is about, if it names several.
enum class Who : std::uint8_t {
  kEach,      ///< Each at a moment of its own.
  kAny,       ///< One of them is enough.
  kTogether,  ///< All in one tick.
  kSome,      ///< So many in one tick.
};

/// How a check is decided.
enum class Mode : std::uint8_t {
  kComesTrue,  ///< In some tick all conditions hold.
  kAlways,     ///< In each tick they do.
  kNever,      ///< In no tick they do.
  kTimes,      ///< They come true so many times.
  kWhenever,   ///< They come true soon after each occurrence of another check.
};

inline constexpr std::size_t kNoCheck = std::numeric_limits<std::size_t>::max();

/// [[check]]: what must come true, or must not, of whom, and when. [[mistake]] of a lesson is one, too.
struct Check {
  std::string name;
  int line = 0;
  std::string file;

  std::vector<std::string> agents;
  std::string team, item;
  Who who = Who::kEach;
  int some = 0;

  std::vector<Condition> conditions;  ///< All must hold in the same tick.

  Mode mode = Mode::kComesTrue;
  std::optional<double> by_s, for_s, from_s, within_s, after_s;
  std::size_t after = kNoCheck, before = kNoCheck, until = kNoCheck, whenever = kNoCheck;  ///< Other checks.
  Bounds times;

  std::string hint;
  std::size_t unless = kNoCheck;  ///< Of a mistake: it is none if this check came true.
  RulePattern written;            ///< Of a mistake: a rule of the learner fits this; empty: any rule.
  RulePattern unwritten;          ///< Of a mistake: it is none if a rule of the learner fits this.
  bool marker = false;            ///< A moment to refer to, not a requirement.
  std::optional<int> pass;        ///< Counted over the seeds by itself.
};

/// A scenario with what is to be checked of it.
struct Mission {
  std::filesystem::path file;  ///< In which the checks stand.
  std::string name;            ///< For people: "soar_hallway".
  std::string scenario;        ///< As `soarbox run` takes it.
  int scenario_line = 0;       ///< In which a mission file names it.
  std::vector<std::uint64_t> seeds;
  std::optional<int> pass;        ///< So many seeds must pass; none: all.
  std::optional<double> seconds;  ///< How long a run lasts; none: the scenario's, else 60.
  std::optional<double> wall_s;   ///< Processor time of one run at most.
  std::vector<Check> checks;
  std::vector<Check> mistakes;  ///< Of a lesson.
};

/// What the checks of a mission ask for, so that nothing else is looked at.
struct Wants {
  bool notes = false, firings = false, insight = false;
  bool decisions = false;                                     ///< How operators came to be selected.
  bool learned = false, numbers = false, retrievals = false;  ///< Of what the inspector tells.
  std::vector<std::string> elements;                          ///< Paths from the top state.
};
Wants WantsOf(const Mission& mission);
/// Adds what these checks ask for: metrics of a sweep, for example.
void AddWants(std::span<const Check> checks, Wants& wants);

}  // namespace soarbox::mission
