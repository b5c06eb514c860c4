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

#include "mission/check_keys.h"
#include "mission/rule_pattern.h"

namespace soarbox::mission {

/// { min, max } of a number, both inclusive.
struct Bounds {
  std::optional<double> min, max;
  bool Hold(double value) const { return (!min || value >= *min) && (!max || value <= *max); }
  bool empty() const { return !min && !max; }
};

/// A condition of a check: KEY = VALUE with restrictions.
struct Condition {
  const KeyRow* row = nullptr;
  std::vector<std::string> words;  ///< Any of these words.
  bool truth = true;
  Bounds bounds;                                          ///< For gauges and counters; for `near`, the distance.
  std::vector<std::pair<std::string, std::string>> with;  ///< Parameters of a command, message or operator.
  std::string status, reason;                             ///< For an answer to a command.
  std::optional<int> level;                               ///< Level of an operator, from 1.
  std::string selected_by;                                ///< For an operator: "only", "preference", "chance".
  std::string is;                                         ///< Value of an element.
  char support = 0;                                       ///< 'i', 'o'; 0: any.
  std::optional<int> count;                               ///< Minimum number of such elements at the same time.
  int line = 0;
};

/// Which of several agents must satisfy a check.
enum class Who : std::uint8_t {
  kEach,      ///< Each, not necessarily in the same tick.
  kAny,       ///< At least one.
  kTogether,  ///< All in the same tick.
  kSome,      ///< A number of them in the same tick.
};

/// How the conditions of a check must be satisfied.
enum class Mode : std::uint8_t {
  kComesTrue,  ///< In at least one tick.
  kAlways,     ///< In each tick.
  kNever,      ///< In no tick.
  kTimes,      ///< They become true a number of times.
  kWhenever,   ///< They become true soon after each occurrence of another check.
};

inline constexpr std::size_t kNoCheck = std::numeric_limits<std::size_t>::max();

/// [[check]]: what must or must not become true, for which agents, and when. Also used for [[mistake]] of a lesson.
struct Check {
  std::string name;
  int line = 0;
  std::string file;

  std::vector<std::string> agents;
  std::string team, item;
  Who who = Who::kEach;
  int some = 0;

  std::vector<Condition> conditions;  ///< All must be true in the same tick.

  Mode mode = Mode::kComesTrue;
  std::optional<double> by_s, for_s, from_s, within_s, after_s;
  std::size_t after = kNoCheck, before = kNoCheck, until = kNoCheck, whenever = kNoCheck;  ///< Indices of other checks.
  Bounds times;

  std::string hint;
  std::size_t unless = kNoCheck;  ///< For a mistake: it is ignored if this check came true.
  RulePattern written;            ///< For a mistake: it applies only if a rule of the learner matches this; empty:
                                  ///< always.
  RulePattern unwritten;          ///< For a mistake: it is ignored if a rule of the learner matches this.
  bool marker = false;            ///< Not a requirement; other checks refer to it.
  std::optional<int> pass;        ///< Number of seeds for which this check must be true, counted separately.
};

/// A scenario and its checks.
struct Mission {
  std::filesystem::path file;  ///< The file that contains the checks.
  std::string name;            ///< For users: "soar_hallway".
  std::string scenario;        ///< As an argument of `soarbox run`.
  int scenario_line = 0;       ///< The line of a mission file that names it.
  std::vector<std::uint64_t> seeds;
  std::optional<int> pass;        ///< Number of seeds that must pass; nothing: all.
  std::optional<double> seconds;  ///< Simulated duration of a run; nothing: the scenario's, else 60.
  std::optional<double> wall_s;   ///< Maximum processor time of one run.
  std::vector<Check> checks;
  std::vector<Check> mistakes;  ///< For a lesson.
};

/// Which data the checks of a mission need, so that nothing else is collected.
struct Wants {
  bool notes = false, firings = false, insight = false;
  bool decisions = false;                                     ///< How operators were selected.
  bool learned = false, numbers = false, retrievals = false;  ///< From the Inspector.
  std::vector<std::string> elements;                          ///< Paths from the top state.
};
Wants WantsOf(const Mission& mission);
/// Adds the data that these checks need, for example metrics of a sweep.
void AddWants(std::span<const Check> checks, Wants& wants);

}  // namespace soarbox::mission
