// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/match_support.h"

namespace soarbox::kernel {

/// As in Soar 9.6.3, the support of a new match depends on all matches of its rule. They are considered in turn: the
/// new one first, then the others, newest first. Each time, the actions of the new match are compared with the operator
/// that the considered match tests. If an action changes something other than this operator, the new match becomes
/// o-supported. If an action changes this operator and the new match is o-supported at this point, the support is
/// mixed: it becomes i-supported again. A match that is considered later can make it o-supported again.
bool MatchSupport::ByMatches(const RuleInfo& rule, const MatchSet::Arrival& arrival, const GoalView& goals,
                             const TokenPool& tokens, std::uint32_t other, std::uint32_t count) {
  if (arrival.production >= shared_.size()) {
    shared_.resize(arrival.production + 1u);
  }
  if (rule.Proposes(arrival.elements, wmes_, goals.level_of_goal)) {
    shared_[arrival.production] = SharedOperator();
    return false;
  }
  const auto tell = [&] {
    if (on_mixed_) {
      on_mixed_(static_cast<ProductionId>(arrival.production));
    }
  };
  const RuleInfo::OperatorUse own = rule.UseOfOperator(arrival.elements, arrival.goal, arrival.elements, wmes_);
  SharedOperator& shared = shared_[arrival.production];
  const std::uint32_t goals_removed = matches_.goals_removed();
  const bool has_a_say = own.elaborates || own.applies;
  if (count == 0) {
    shared = {own.selected, goals_removed, !has_a_say};
  }
  // For rules with many matches: if no match tests an operator of its goal, the others are not considered again for
  // each new match. So the total cost is linear.
  if (!has_a_say && shared.none_has_a_say && shared.goals_removed == goals_removed) {
    return false;
  }
  if (own.selected && shared.selected == own.selected && shared.goals_removed == goals_removed) {
    if (!own.elaborates || !own.applies || mixed_is_o_) {
      return own.applies;
    }
    for (std::uint32_t n = 0; n <= count; ++n) tell();
    return false;
  }
  bool applies = false;
  const auto consider = [&](const RuleInfo::OperatorUse& use) {
    applies |= use.applies;
    if (applies && use.elaborates && !mixed_is_o_) {
      applies = false;
      tell();
    }
  };
  consider(own);
  bool alike = true;
  bool none_has_a_say = !has_a_say;
  for (std::uint32_t token = other; token != kNil; token = tokens[token].next_in_bucket) {
    const std::span<const WmeId> tested = matches_.Wmes(static_cast<MatchId>(tokens[token].key));
    Symbol goal;
    GoalLevel level = 0;
    LowestGoal(rule, tested, goals, goal, level);
    const RuleInfo::OperatorUse use = rule.UseOfOperator(tested, goal, arrival.elements, wmes_);
    consider(use);
    alike &= use.selected == own.selected;
    none_has_a_say &= !use.elaborates && !use.applies;
  }
  shared = {alike ? own.selected : Symbol(), goals_removed, none_has_a_say};
  return applies;
}

}  // namespace soarbox::kernel
