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

struct Engine;

/// Fires rules: makes the instantiation of a match and runs the rule's actions, which make preferences (not asserted
/// yet) and call functions. New identifiers are made in the order in which the actions name them.
class Firing {
 public:
  explicit Firing(Engine& engine) : engine_(engine) {
    made_.reserve(16);
    new_identifiers_.reserve(8);
    argument_stack_.reserve(8);
  }

  /// Fires a match of `rule` that was taken from the match set. Rules excised meanwhile leave when the elaboration
  /// ends.
  ///
  /// Everything it calls is inlined, except what is marked noinline: what few firings need must not cost registers.
  [[gnu::flatten]] void Fire(const PendingMatch& match, const Production& rule);
  /// The first identifier that the actions would touch and whose level is `level` or higher up (a smaller number), if
  /// there is one.
  Symbol TouchedAbove(const PendingMatch& match, GoalLevel level) const;
  /// Instantiations made in this pass and not asserted yet, oldest first. Held until asserted.
  std::vector<InstantiationId>& made() { return made_; }
  /// What learning follows: for each matched element the preference that made it at this level.
  void TraceConditions(InstantiationId id, std::span<const WmeId> wmes);
  /// The preference of the same result at a level, or kNone.
  PreferenceId CloneAtLevel(PreferenceId preference, GoalLevel level) const;
  /// What a condition of a match of this level tested, and who made it.
  ConditionTrace LookAt(WmeId wme, GoalLevel level) const;

  /// The level of the object that the running action says something of.
  GoalLevel object_level() const { return level_; }

 private:
  void RunActions(const Production& rule, InstantiationId id);
  [[gnu::noinline]] void TellMade(InstantiationId id);
  [[gnu::noinline]] void TellFiring(InstantiationId id);
  [[gnu::noinline]] void TellFired(InstantiationId id);
  /// Makes a rule with the matched constants (learn/rl_template.h).
  [[gnu::noinline]] void RunTemplate(const Production& rule, InstantiationId id);
  /// The same, and it holds what it names.
  ConditionTrace TraceOf(WmeId wme, GoalLevel level);
  /// What deep-copy copied is tested by the firing as well.
  [[gnu::noinline]] void TraceCopied(InstantiationId id);
  void RunAction(const Action& action, std::uint16_t number, InstantiationId id);
  /// The value of a right-hand-side term; none if a function failed or gives nothing.
  Symbol Evaluate(const RhsValue& value) {
    if (value.kind == RhsValueKind::kConstant) return value.symbol();
    return value.kind == RhsValueKind::kBound ? BoundValue(value.site()) : EvaluateRare(value);
  }
  Symbol BoundValue(BindingSite site) const;
  /// New identifiers and functions.
  [[gnu::noinline]] Symbol EvaluateRare(const RhsValue& value);

  Engine& engine_;
  std::vector<InstantiationId> made_;
  std::vector<WmeId> wmes_;  ///< Of the match that fires (the match set may grow while it does) and more.
  std::vector<Symbol> new_identifiers_;
  std::vector<Symbol> argument_stack_;
  GoalLevel match_level_ = 0;  ///< Of the match that fires.
  bool o_support_ = false;
  GoalLevel level_ = 0;  ///< Of identifiers that the action at hand makes.
};

}  // namespace soarbox::kernel
