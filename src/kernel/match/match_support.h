// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/match/goal_view.h"
#include "kernel/match/match_set.h"
#include "kernel/match/rule_info.h"
#include "kernel/match/token_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// Determines the goal and the support of new matches.
class [[gnu::visibility("hidden")]] MatchSupport {
 public:
  MatchSupport(const MatchSet& matches, const WmeTable& wmes) : matches_(matches), wmes_(wmes) {}

  /// See Rete::MixedSupportIsO and Rete::OnMixedSupport.
  void MixedIsO(bool is_o) {
    mixed_is_o_ = is_o;
  }
  void OnMixed(std::function<void(ProductionId)> tell) {
    on_mixed_ = std::move(tell);
  }

  /// The lowest goal among the identifiers of a match.
  [[gnu::always_inline]] void LowestGoal(const RuleInfo& rule, std::span<const WmeId> matched, const GoalView& goals,
                                         Symbol& goal, GoalLevel& level) const {
    const Wme* const table = wmes_.data();
    for (const std::uint16_t condition : rule.id_conditions) {
      const Symbol id = table[Index(matched[condition])].id;
      const GoalLevel found = goals.LevelOf(id);
      if (found > level) {
        level = found;
        goal = id;
      }
    }
  }
  /// Whether a new match is o-supported, for a rule whose support depends on its matches. `other`: the tokens of the
  /// other matches, `count` of them, newest first.
  bool ByMatches(const RuleInfo& rule, const MatchSet::Arrival& arrival, const GoalView& goals, const TokenPool& tokens,
                 std::uint32_t other, std::uint32_t count);
  /// A rule is new, or ByMatches was not called for some of its matches.
  void Forget(std::uint32_t rule) {
    if (rule < shared_.size()) {
      shared_[rule] = SharedOperator();
    }
  }

 private:
  /// The operator that all matches of a rule test, as long as the goals do not change.
  struct SharedOperator {
    Symbol selected;  ///< None: they differ, or it is unknown.
    std::uint32_t goals_removed = 0;
    bool none_has_a_say = false;  ///< None of the matches tests an operator of its goal.
  };

  const MatchSet& matches_;
  const WmeTable& wmes_;
  std::function<void(ProductionId)> on_mixed_;
  bool mixed_is_o_ = false;
  std::vector<SharedOperator> shared_;  ///< By rule, for rules that have matched.
};

}  // namespace soarbox::kernel
