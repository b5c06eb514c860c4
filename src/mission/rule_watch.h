// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "explain/rule_wait.h"

namespace soarbox::explain {
class Inspector;
}
namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

struct AccountSettings;

/// Explains why a rule does not match now; nothing if it matches. If an element that the rule excludes exists, names
/// the rule that made it.
std::optional<explain::RuleWait> WhyRuleWaits(sim::Simulation& simulation, const std::string& agent,
                                              const std::string& rule);

/// Watches the rules of a file or an agent that have not fired yet. For each of them, stores the reason why it did not
/// match in the tick in which it came nearest to a match. At the end of the run, this reason can no longer be found:
/// for example, another operator is selected, or the message is gone.
///
/// A rule is nearer to a match if more of its conditions find an element with their attribute and value, whatever the
/// other conditions are. If this number is equal, the number of conditions that match in order decides. A reason is
/// computed only when a rule comes nearer than before.
class RuleWatch {
 public:
  /// Rules that came with the lesson are not watched. The settings must outlive this object.
  RuleWatch(sim::Simulation& simulation, const AccountSettings& settings);

  /// Call it once for each tick.
  void See();

  /// A rule that never fired.
  struct Waiting {
    std::string agent;
    explain::RuleWait why;
    double time_s = 0;
    bool was_there = false;         ///< A rule that fired makes the required element, so it existed for a moment.
    bool waits_for_others = false;  ///< It requires an element that other rules may add or remove; they may be the
                                    ///< cause.

    /// Another operator was selected, or none. Other rules may be the cause.
    bool WaitsForOperator() const { return why.found.kind == explain::RuleWait::Kind::kOperator; }
  };
  /// The constant attribute and value that a condition tests; empty: any.
  struct Asked {
    std::string attribute, value;
  };
  /// Call it at the end of the run. The result is in the order of the file; rules that only wait for an operator come
  /// last.
  std::vector<Waiting> Finish();

 private:
  struct Score {
    std::size_t values = 0;      ///< Number of conditions for which an element with the same attribute and value
                                 ///< exists.
    std::size_t matched = 0;     ///< Number of conditions that match in order.
    std::size_t attributes = 0;  ///< Number of conditions for which an element with the same attribute exists.
    auto operator<=>(const Score&) const = default;
  };
  struct Best {
    Score score;
    std::optional<Waiting> waiting;
    std::vector<Asked> asked;  ///< By the rule's positive conditions.
  };
  using Key = std::pair<std::string, std::string>;  ///< Agent, rule.

  void Look(explain::Inspector& inspector, const std::string& agent, const std::string& rule);

  sim::Simulation& simulation_;
  const AccountSettings& settings_;
  std::map<Key, Best> best_;
  std::vector<Key> order_;  ///< In the order of loading.
};

}  // namespace soarbox::mission
