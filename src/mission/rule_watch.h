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

/// Why a rule does not match now, "requires ^next 3, but it is 2"; empty if it does. If something that the rule
/// excludes is there, the rule that made it is named.
std::string WhyRuleWaits(sim::Simulation& simulation, const std::string& agent, const std::string& rule);

/// Follows the rules of a file, or of an agent, that have not fired yet, and keeps for each what it waited for at the
/// tick at which it got furthest. At the end of a run it is too late to ask: the operator is another one, and the
/// message is gone.
///
/// How far a rule gets: first how many of its conditions find an element at all, then how many match one after the
/// other. So a rule that an absent attribute blocks counts as further when everything else is there. A rule is
/// explained only when it gets further than before.
class RuleWatch {
 public:
  /// Rules that came with the lesson are not followed. The settings must live longer.
  RuleWatch(sim::Simulation& simulation, const AccountSettings& settings);

  /// Call once for each tick.
  void See();

  /// A rule that never fired.
  struct Waiting {
    std::string agent, rule;
    std::string why;  ///< "requires ^next 3, but it is 2"
    double time_s = 0;
    std::string wanted, maker;      ///< If a rule that fired makes what it waits for: both; it was there for a moment.
    bool waits_for_others = false;  ///< For something that may come, or that may go: perhaps other rules are why.
    bool waits_for_operator = false;  ///< Another operator was selected, or none: other rules are why.
  };
  /// Call at the end. In the order of the file, rules that only wait for an operator last.
  std::vector<Waiting> Finish();

 private:
  struct Score {
    std::size_t values = 0;      ///< Conditions that find an element with their attribute and value.
    std::size_t matched = 0;     ///< Conditions that match one after the other.
    std::size_t attributes = 0;  ///< Conditions that find an element with their attribute.
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
  std::vector<Key> order_;  ///< As the rules were loaded.
};

}  // namespace soarbox::mission
