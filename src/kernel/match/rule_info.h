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

/// The data of a rule that the match needs in addition to its nodes; computed once when the rule is added.
///
/// Support (docs/spec/kernel_features.md, section 10): a declared support decides. A rule that creates operator
/// preferences for a goal is i-supported. A rule that tests the selected operator of its lowest goal is o-supported
/// unless its actions change only that operator. For most rules the support is determined here; for others it depends
/// on the goals of each match.
struct RuleInfo {
  enum class Support : std::uint8_t { kI, kO, kByMatch };

  ProductionPtr rule;
  std::uint32_t node = 0xFFFFFFFFu;  ///< Its production node.
  std::uint16_t positives = 0;       ///< Positive top-level conditions.
  Support support = Support::kI;
  std::span<const std::uint16_t> id_conditions;        ///< Positive conditions that bind a new identifier variable.
  std::span<const std::uint16_t> operator_conditions;  ///< Positive conditions that may test a selected operator.
  std::span<const BindingSite> proposal_ids;           ///< The identifiers of actions that create operator preferences.
  std::span<const BindingSite> action_ids;  ///< Bound identifiers of actions that change working memory; each once.
  bool has_other_action_ids = false;        ///< Such actions with other identifiers (new ones, functions).

  explicit RuleInfo(ProductionPtr production);
  RuleInfo(const RuleInfo&) = delete;
  RuleInfo& operator=(const RuleInfo&) = delete;

  // Only for Support::kByMatch; `elements` as in MatchSet.

  /// True if the actions propose an operator to a goal: such a match is i-supported.
  bool Proposes(std::span<const WmeId> elements, const WmeTable& wmes, std::span<const GoalLevel> level_of_goal) const;
  /// The effect of a match's actions on the operators that a match of the same rule (this one or another) tests.
  struct OperatorUse {
    bool elaborates = false;  ///< An action changes the operator.
    bool applies = false;     ///< An action changes something else.
    Symbol selected;          ///< The tested operator; none if there is none, or more than one.
  };
  /// `goal`: the lowest one of `tested`; `actor`: the elements of the acting match.
  OperatorUse UseOfOperator(std::span<const WmeId> tested, Symbol goal, std::span<const WmeId> actor,
                            const WmeTable& wmes) const;

 private:
  std::unique_ptr<std::uint16_t[]> lists_;  ///< The lists, one after the other.
};

/// Returns true if the actions are equal in Soar's comparison: variables are compared by where they are bound, not by
/// name. Actions after the first call, and arguments that only one of two calls has, are ignored. With
/// `ignore_rl_value`, the numbers of RL rules may differ.
bool SameActions(const Production& a, const Production& b, bool ignore_rl_value);
/// Equal for rules with equal actions (ignoring the number of RL rules).
std::uint32_t ActionsDigest(const Production& production);

}  // namespace soarbox::kernel
