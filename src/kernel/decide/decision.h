// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
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

struct Engine;

/// The decide phase and the checks that a decision still stands.
///
/// Each goal has one context slot, ^operator. A slot without an operator is decided; one with an operator is a
/// no-change. Goals above the highest one whose operator preferences changed need not be looked at.
class Decision {
 public:
  explicit Decision(Engine& engine) : engine_(engine) {}

  /// Decides from the highest changed goal down, until something is decided: an operator, a new impasse.
  void Decide();
  /// Checks the goals from the highest changed one down to `level`: true if all decisions stand. If one does not, its
  /// operator or its impasse and everything below have been removed.
  bool CheckConsistency(GoalLevel level) { return changed_from_ == 0 || CheckChanged(level); }
  /// Takes the operator out of its slot and removes the states below.
  [[gnu::noinline]] void RemoveOperator(GoalLevel level, OperatorRemoval reason, WmeId acceptable = WmeId::kNone);
  /// Operator preferences of the goal at this level changed.
  void NoteContextChanged(GoalLevel level) {
    if (changed_from_ == 0 || level < changed_from_) changed_from_ = level;
  }
  void GoalRemoved(GoalLevel level) {
    if (changed_from_ >= level) changed_from_ = 0;
  }
  /// What the procedure says about a goal's slot now, without the random choice. Valid until the next call.
  PreferenceSemantics::Outcome Evaluate(const Goal& goal, Symbol forced = {}, DecisionTrace* trace = nullptr);
  /// The same, and who would be dropped and why. Valid until the next call.
  DecisionReport Explain(const Goal& goal);
  /// What the next decide phase would do, in the words of `decide predict`.
  std::string Predict();
  void Clear() {
    changed_from_ = 0;
    foretold_seed_ = 0;
  }

 private:
  /// Candidates that Evaluate handles without the whole procedure.
  static constexpr std::size_t kFewCandidates = 8;

  [[gnu::noinline]] bool CheckChanged(GoalLevel level);
  /// What most decisions are: few candidates that are acceptable, best, worst or indifferent. Decided from the slot's
  /// lists as they stand; false if it takes the whole procedure.
  bool EvaluateFew(const Slot& slot, PreferenceSemantics::Outcome& outcome);
  /// True if something new was decided, so that nothing below needs a look.
  bool DecideGoal(GoalLevel level);
  /// The state below already stands for this impasse.
  bool Faces(GoalLevel level, ImpasseType impasse, bool on_operator) const;
  void TellReason(const Goal& goal, const PreferenceSemantics::Outcome& outcome, Symbol selected, Symbol forced);
  bool EnterImpasse(GoalLevel level, ImpasseType impasse, bool on_operator, std::span<const Candidate> candidates);
  void Install(GoalLevel level, const Candidate& winner, Symbol forced);
  const Candidate& Pick(const PreferenceSemantics::Outcome& outcome);
  Symbol ForcedOperator(const Goal& goal) const;
  bool Stands(const Goal& goal);

  Engine& engine_;
  GoalLevel changed_from_ = 0;       ///< The highest goal whose operator preferences changed; 0: none.
  std::uint32_t foretold_seed_ = 0;  ///< What Predict drew with, for the next decision; 0: nothing was foretold.
  std::vector<SlotPreference> slot_preferences_;
  DecisionTrace trace_;
  std::vector<Symbol> forced_at_;                ///< By level: the operator, if the last one selected there was forced.
  std::array<Candidate, kFewCandidates> named_;  ///< Scratch of EvaluateFew.
  std::array<Candidate, kFewCandidates> few_;    ///< What its outcome shows.
};

}  // namespace soarbox::kernel
