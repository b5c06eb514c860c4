// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/decision_trace.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/preference_semantics.h"
#include "kernel/memory/working_memory.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

struct AgentCore;

/// The decide phase, and the checks whether earlier decisions are still consistent.
///
/// Each goal has one context slot, ^operator. The decide phase decides a slot without an operator. If the slot still
/// has its operator, that is a no-change impasse. Goals above the highest one whose operator preferences changed are
/// skipped.
class Decision {
 public:
  explicit Decision(AgentCore& core) : core_(core) {}

  /// Decides from the highest changed goal down, until an operator is selected or a new impasse arises.
  void Decide();
  /// Checks the goals from the highest changed one down to `level`. Returns true if all decisions are consistent. Else
  /// the operator or the impasse of the inconsistent goal, and everything below, have been removed.
  bool CheckConsistency(GoalLevel level) { return changed_from_ == 0 || CheckChanged(level); }
  /// Removes the operator from its slot, and the states below.
  [[gnu::noinline]] void RemoveOperator(GoalLevel level, OperatorRemoval reason, WmeId acceptable = WmeId::kNone);
  /// Operator preferences of the goal at this level changed.
  void NoteContextChanged(GoalLevel level) {
    if (changed_from_ == 0 || level < changed_from_) changed_from_ = level;
  }
  void GoalRemoved(GoalLevel level) {
    if (changed_from_ >= level) changed_from_ = 0;
  }
  /// Evaluates a goal's slot without the random choice. The result is valid until the next call.
  PreferenceSemantics::Outcome Evaluate(const Goal& goal, Symbol forced = {}, DecisionTrace* trace = nullptr);
  /// Like Evaluate, but also reports which candidates are dropped and why. Valid until the next call.
  DecisionReport Explain(const Goal& goal);
  /// The result of the next decide phase, in the format of `decide predict`.
  std::string Predict();
  void Clear() {
    changed_from_ = 0;
    foretold_seed_ = 0;
  }

 private:
  [[gnu::noinline]] bool CheckChanged(GoalLevel level);
  /// Returns true if something new was decided. The goals below then need no decision.
  bool DecideGoal(GoalLevel level);
  /// Whether the state below `level` was created for this impasse.
  bool Faces(GoalLevel level, ImpasseType impasse, bool on_operator) const;
  void TellReason(const Goal& goal, const PreferenceSemantics::Outcome& outcome, Symbol selected, Symbol forced);
  bool EnterImpasse(GoalLevel level, ImpasseType impasse, bool on_operator, std::span<const Candidate> candidates);
  void Install(GoalLevel level, const Candidate& winner, Symbol forced);
  const Candidate& Pick(const PreferenceSemantics::Outcome& outcome);
  Symbol ForcedOperator(const Goal& goal) const;
  bool Stands(const Goal& goal);

  AgentCore& core_;
  GoalLevel changed_from_ = 0;       ///< The highest goal whose operator preferences changed; 0: none.
  std::uint32_t foretold_seed_ = 0;  ///< The seed of Predict, for the next decision; 0: there was no prediction.
  std::vector<SlotPreference> slot_preferences_;
  DecisionTrace trace_;
  std::vector<Symbol> forced_at_;  ///< By level: the operator, if the last selection was forced.
};

}  // namespace soarbox::kernel
