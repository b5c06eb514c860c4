// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace soarbox::explain {
class Inspector;
}
namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

struct AccountSettings;

/// Explains why a rule does not match now: "requires ^next 3, but it is 2"; empty if it matches. If an element that the
/// rule excludes exists, names the rule that made it.
std::string WhyRuleWaits(sim::Simulation& simulation, const std::string& agent, const std::string& rule);

/// Watches the rules of a file or an agent that have not fired yet. For each of them, stores the reason why it did not
/// match in the tick in which it came nearest to a match. At the end of a run the reason is lost: another operator is
/// selected, and the message is gone.
///
/// The measure is first the number of its conditions that find an element, then the number of conditions that match in
/// order. A rule that fails only because of an absent attribute is therefore nearer to a match if all other elements
/// exist. A reason is computed only when a rule comes nearer than before.
class RuleWatch {
 public:
  /// Rules that came with the lesson are not watched. The settings must outlive this object.
  RuleWatch(sim::Simulation& simulation, const AccountSettings& settings);

  /// Call it once for each tick.
  void See();

  /// A rule that never fired.
  struct Waiting {
    std::string agent, rule;
    std::string why;  ///< "requires ^next 3, but it is 2"
    double time_s = 0;
    std::string wanted, maker;      ///< If a rule that fired makes the required element: the element and that rule. The
                                    ///< element existed for a moment.
    bool waits_for_others = false;  ///< It requires an element that other rules may add or remove; they may be the
                                    ///< cause.
    bool waits_for_operator = false;  ///< Another operator was selected, or none; other rules may be the cause.
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
    Waiting waiting;
  };
  using Key = std::pair<std::string, std::string>;  ///< Agent, rule.

  void Look(explain::Inspector& inspector, const std::string& agent, const std::string& rule);

  sim::Simulation& simulation_;
  const AccountSettings& settings_;
  std::map<Key, Best> best_;
  std::vector<Key> order_;  ///< In the order of loading.
};

}  // namespace soarbox::mission
