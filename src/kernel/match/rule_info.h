// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/match/wme.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// What the match must know of a rule besides its nodes, computed once when it is added.
///
/// Support (kernel_features section 10): a declared support decides. A rule that makes operator preferences on a goal
/// is i-supported. A rule that tests the selected operator of its lowest goal is o-supported unless its actions change
/// only that operator. Most rules are decided here; for the others the goals of each match decide.
struct RuleInfo {
  enum class Support : std::uint8_t { kI, kO, kByMatch };

  ProductionPtr rule;
  std::uint32_t node = 0xFFFFFFFFu;  ///< Its production node.
  std::uint16_t positives = 0;       ///< Positive top-level conditions.
  Support support = Support::kI;
  std::span<const std::uint16_t> id_conditions;        ///< Positive conditions that bring a new identifier variable.
  std::span<const std::uint16_t> operator_conditions;  ///< Positive conditions that may test a selected operator.
  std::span<const BindingSite> proposal_ids;           ///< The identifiers of actions that make operator preferences.
  std::span<const BindingSite> action_ids;  ///< Bound identifiers of actions that change working memory; each once.
  bool has_other_action_ids = false;        ///< Such actions with other identifiers (new ones, functions).

  explicit RuleInfo(ProductionPtr production);
  RuleInfo(const RuleInfo&) = delete;
  RuleInfo& operator=(const RuleInfo&) = delete;

  // Only for Support::kByMatch; `elements` as in MatchSet.

  /// True if the actions propose an operator to a goal: such a match is i-supported.
  bool Proposes(std::span<const WmeId> elements, const WmeTable& wmes, std::span<const GoalLevel> level_of_goal) const;
  /// What the actions of a match do to the operators that a match of the same rule (this one or another) tests.
  struct OperatorUse {
    bool elaborates = false;  ///< An action changes the operator.
    bool applies = false;     ///< An action changes something else.
    Symbol selected;          ///< The tested operator; none if there is none, or more than one.
  };
  /// `goal`: the lowest one of `tested`; `actor`: the elements of the match that acts.
  OperatorUse UseOfOperator(std::span<const WmeId> tested, Symbol goal, std::span<const WmeId> actor,
                            const WmeTable& wmes) const;

 private:
  std::unique_ptr<std::uint16_t[]> lists_;  ///< The lists, one behind the other.
};

/// True if the actions do the same, as far as Soar compares them: variables count by where they are bound, not by name.
/// What follows the first call among the actions does not count, nor do arguments that only one of two calls has. With
/// `ignore_rl_value` the number of two RL rules' preferences may differ.
bool SameActions(const Production& a, const Production& b, bool ignore_rl_value);
/// Equal for rules with the same actions (ignoring the number of RL rules).
std::uint32_t ActionsDigest(const Production& production);

}  // namespace soarbox::kernel
