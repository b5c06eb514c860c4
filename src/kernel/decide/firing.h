// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/instantiation.h"
#include "kernel/match/match_set.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

struct AgentCore;

/// Fires rules: creates the instantiation of a match and executes the rule's actions, which create preferences (not yet
/// asserted) and call functions. New identifiers are created in the order in which the actions mention them.
class Firing {
 public:
  explicit Firing(AgentCore& core) : core_(core) {
    made_.reserve(16);
    new_identifiers_.reserve(8);
    argument_stack_.reserve(8);
  }

  /// Fires a match of `rule` that was taken from the match set. Rules excised meanwhile leave the network at the end of
  /// the elaboration.
  ///
  /// All callees are inlined, except those marked noinline: code that few firings need must not cost registers.
  [[gnu::flatten]] void Fire(const PendingMatch& match, const Production& rule);
  /// The first identifier that the actions would change and whose level is `level` or higher up (a smaller number);
  /// else none.
  Symbol TouchedAbove(const PendingMatch& match, GoalLevel level) const;
  /// Instantiations created in this pass and not yet asserted, oldest first. They are held until asserted.
  std::vector<InstantiationId>& made() { return made_; }
  /// Stores, for learning, the preference that created each matched element at this level.
  void TraceConditions(InstantiationId id, std::span<const WmeId> wmes);
  /// The clone of a preference at a level (the same result), or kNone.
  PreferenceId CloneAtLevel(PreferenceId preference, GoalLevel level) const;
  /// The trace of an element as a condition of a match at this level: what it tested, and the element's creator.
  ConditionTrace LookAt(WmeId wme, GoalLevel level) const;

  /// The level of the identifier that the running action changes.
  GoalLevel object_level() const { return level_; }

 private:
  void RunActions(const Production& rule, InstantiationId id);
  [[gnu::noinline]] void TellMade(InstantiationId id);
  [[gnu::noinline]] void TellFiring(InstantiationId id);
  [[gnu::noinline]] void TellFired(InstantiationId id);
  /// Builds a rule with the matched constants from a template (learn/rl_template.h).
  [[gnu::noinline]] void RunTemplate(const Production& rule, InstantiationId id);
  /// Like LookAt, and adds references to what the trace refers to.
  ConditionTrace TraceOf(WmeId wme, GoalLevel level);
  /// Adds the elements that deep-copy copied to the trace: the firing depends on them, too.
  [[gnu::noinline]] void TraceCopied(InstantiationId id);
  void RunAction(const Action& action, std::uint16_t number, InstantiationId id);
  /// The value of a right-hand-side term; none if a function failed or returns nothing.
  Symbol Evaluate(const RhsValue& value) {
    if (value.kind == RhsValueKind::kConstant) return value.symbol();
    return value.kind == RhsValueKind::kBound ? BoundValue(value.site()) : EvaluateRare(value);
  }
  Symbol BoundValue(BindingSite site) const;
  /// Evaluates new identifiers and functions.
  [[gnu::noinline]] Symbol EvaluateRare(const RhsValue& value);

  AgentCore& core_;
  std::vector<InstantiationId> made_;
  std::vector<WmeId> wmes_;  ///< Elements of the firing match. It is a copy, because the match set may grow meanwhile.
  std::vector<Symbol> new_identifiers_;
  std::vector<Symbol> argument_stack_;
  GoalLevel match_level_ = 0;  ///< Level of the firing match.
  bool o_support_ = false;
  GoalLevel level_ = 0;  ///< Level of the identifiers that the current action creates.
};

}  // namespace soarbox::kernel
