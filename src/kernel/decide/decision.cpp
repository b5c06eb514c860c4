// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/decision.h"

#include <algorithm>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_core.h"
#include "kernel/decide/exploration.h"

namespace soarbox::kernel {

PreferenceSemantics::Outcome Decision::Evaluate(const Goal& goal, Symbol forced, DecisionTrace* trace) {
  const WorkingMemory& memory = core_.memory;
  const Slot& slot = memory.slot(goal.operator_slot);
  slot_preferences_.clear();
  for (const PreferenceId first : {slot.acceptable, slot.others}) {
    for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
      const Preference& preference = memory.preference(p);
      SlotPreference view;
      view.type = preference.type;
      view.value = preference.value;
      view.referent = preference.referent;
      view.preference = p;
      if (preference.referent.IsNumber()) view.number = core_.symbols.NumberValue(preference.referent);
      slot_preferences_.push_back(view);
    }
  }
  return core_.semantics.Decide(slot_preferences_, forced, trace);
}

DecisionReport Decision::Explain(const Goal& goal) {
  const PreferenceSemantics::Outcome outcome = Evaluate(goal, {}, &trace_);
  const Symbol selected = core_.descriptions.OperatorOf(goal);
  const bool is_forced = selected && goal.level < forced_at_.size() && forced_at_[goal.level] == selected;
  return {goal.id, goal.level, outcome.impasse, selected, is_forced, slot_preferences_, outcome.candidates, trace_};
}

Symbol Decision::ForcedOperator(const Goal& goal) const {
  if (core_.forced_operator.size() < 2) return {};
  const WorkingMemory& memory = core_.memory;
  for (PreferenceId p = memory.slot(goal.operator_slot).acceptable; p != PreferenceId::kNone;
       p = memory.preference(p).next_in_slot) {
    if (ToString(core_.symbols, memory.preference(p).value) == core_.forced_operator) {
      return memory.preference(p).value;
    }
  }
  return {};
}

// The decide phase ----------------------------------------------------------------------------------------------------

void Decision::Decide() {
  if (foretold_seed_ != 0) core_.random.Seed(std::exchange(foretold_seed_, 0));
  if (core_.goals.empty()) return;
  const GoalLevel first = changed_from_ != 0 ? changed_from_ : static_cast<GoalLevel>(core_.goals.depth());
  changed_from_ = 0;
  for (GoalLevel level = first; level <= core_.goals.depth(); ++level) {
    Slot& slot = core_.memory.mutable_slot(core_.goals.at(level).operator_slot);
    const bool is_open = std::exchange(slot.changed, false) && slot.wmes == WmeId::kNone;
    if (!is_open && level < core_.goals.depth()) continue;  // It is decided, and nothing has changed.
    if (DecideGoal(level)) break;
  }
  changed_from_ = 0;
  core_.exploration.ReduceAutomatically();
}

bool Decision::DecideGoal(GoalLevel level) {
  const Goal& goal = core_.goals.at(level);
  if (core_.memory.slot(goal.operator_slot).wmes != WmeId::kNone) {
    return EnterImpasse(level, ImpasseType::kNoChange, true, {});
  }
  const Symbol forced = ForcedOperator(goal);
  const bool is_told = core_.observers.Wants(Event::kReason);
  const PreferenceSemantics::Outcome outcome = Evaluate(goal, forced, is_told ? &trace_ : nullptr);
  if (outcome.impasse != ImpasseType::kNone || outcome.candidates.empty()) {
    const bool is_on_operator = outcome.impasse != ImpasseType::kNone;
    const ImpasseType impasse = is_on_operator ? outcome.impasse : ImpasseType::kNoChange;
    if (is_told && !Faces(level, impasse, is_on_operator)) TellReason(goal, outcome, {}, forced);
    return EnterImpasse(level, impasse, is_on_operator, outcome.candidates);
  }
  const Candidate& winner = Pick(outcome);
  if (is_told) TellReason(goal, outcome, winner.value, forced);
  if (core_.modules.Wants(ModuleHook::kChoices)) core_.modules.OperatorChosen(level, outcome.candidates, winner);
  if (level > 1) core_.selections.OperatorSelected(level, winner.value, static_cast<bool>(forced));
  Install(level, winner, forced);
  return true;
}

const Candidate& Decision::Pick(const PreferenceSemantics::Outcome& outcome) {
  if (outcome.candidates.size() == 1) return outcome.candidates.front();
  if (core_.observers.Wants(Event::kExploration)) {
    const std::vector<double> chances = SelectionChances(outcome.candidates, core_.exploration);
    for (std::size_t n = 0; n < outcome.candidates.size(); ++n) {
      const Candidate& candidate = outcome.candidates[n];
      const double value = NumericValue(candidate, core_.exploration);
      core_.observers.Notify(Event::kExploration,
                             [&](Observer& o) { o.OnCandidate(core_.agent, candidate.value, value, chances[n]); });
    }
  }
  return outcome.candidates[Choose(outcome.candidates, core_.exploration, core_.random)];
}

void Decision::Install(GoalLevel level, const Candidate& winner, Symbol forced) {
  if (forced && forced_at_.size() <= level) forced_at_.resize(level + 1u);
  if (level < forced_at_.size()) forced_at_[level] = forced;
  if (core_.goals.depth() > level) {
    core_.goal_changes.RemoveFrom(static_cast<GoalLevel>(level + 1), GoalRemoval::kDecision);
  }
  const Goal& goal = core_.goals.at(level);
  core_.memory.mutable_slot(goal.operator_slot).changed_since_selected = false;
  core_.changes.Add(WmeKind::kSlot, goal.id, words::kOperator, winner.value, goal.operator_slot, winner.preference);
  // If this preference is removed while another one still proposes the operator, the operator's element stays.
  // Therefore the element refers to the preference.
  core_.preferences.AddReference(winner.preference);
  if (core_.modules.Wants(ModuleHook::kChoices)) core_.modules.OperatorInstalled(level, winner.value);
  if (!core_.forced_operator.empty() && ToString(core_.symbols, winner.value) == core_.forced_operator) {
    core_.forced_operator.clear();
  }
}

bool Decision::Faces(GoalLevel level, ImpasseType impasse, bool on_operator) const {
  if (core_.goals.depth() <= level) return false;
  const Goal& below = core_.goals.at(static_cast<GoalLevel>(level + 1));
  return below.impasse == impasse && below.impasse_on_operator == on_operator;
}

void Decision::TellReason(const Goal& goal, const PreferenceSemantics::Outcome& outcome, Symbol selected,
                          Symbol forced) {
  if (slot_preferences_.empty()) return;
  const DecisionReport report{
      goal.id,           goal.level,         outcome.impasse, selected, static_cast<bool>(forced) && forced == selected,
      slot_preferences_, outcome.candidates, trace_};
  core_.observers.Notify(Event::kReason, [&](Observer& o) { o.OnDecided(core_.agent, report); });
}

bool Decision::EnterImpasse(GoalLevel level, ImpasseType impasse, bool on_operator,
                            std::span<const Candidate> candidates) {
  if (core_.goals.depth() > level) {
    if (Faces(level, impasse, on_operator)) {
      if (impasse != ImpasseType::kNoChange) core_.goal_changes.UpdateItems(level, candidates);
      return false;
    }
    core_.goal_changes.RemoveFrom(static_cast<GoalLevel>(level + 1), GoalRemoval::kWrongImpasseType);
  }
  if (impasse == ImpasseType::kNoChange && !on_operator && core_.settings.wait_snc) return true;
  if (impasse == ImpasseType::kNoChange &&
      core_.goals.depth() >= static_cast<std::size_t>(core_.settings.max_goal_depth)) {
    core_.run.GoalStackLimit();
  }
  core_.goal_changes.MakeSubstate(impasse, on_operator, candidates);
  return true;
}

// Inconsistent decisions ----------------------------------------------------------------------------------------------

void Decision::RemoveOperator(GoalLevel level, OperatorRemoval reason, WmeId acceptable) {
  const Goal& goal = core_.goals.at(level);
  if (core_.observers.Wants(Event::kDecisionTrace)) {
    const GoalInfo info = core_.descriptions.Describe(goal);
    WmeInfo wme;
    if (acceptable != WmeId::kNone) wme = core_.descriptions.Describe(acceptable);
    core_.observers.Notify(Event::kDecisionTrace,
                           [&](Observer& o) { o.OnOperatorRemoved(core_.agent, info, reason, wme); });
  }
  const SlotId slot = goal.operator_slot;
  core_.preferences.RemoveSelected(slot);
  if (core_.goals.depth() > level) {
    const GoalRemoval why =
        reason == OperatorRemoval::kInconsistent ? GoalRemoval::kInconsistent : GoalRemoval::kOperatorRemoval;
    core_.goal_changes.RemoveFrom(static_cast<GoalLevel>(level + 1), why);
  }
}

/// Whether the existing decision of a goal is still consistent. The decision is the installed operator or, if there is
/// none, the impasse of the state below, if any.
bool Decision::Stands(const Goal& goal) {
  const Slot& slot = core_.memory.slot(goal.operator_slot);
  const bool has_operator = slot.wmes != WmeId::kNone;
  const bool has_substate = core_.goals.depth() > goal.level;
  ImpasseType existing = ImpasseType::kNone;
  if (!has_operator && has_substate) existing = core_.goals.at(static_cast<GoalLevel>(goal.level + 1)).impasse;
  const PreferenceSemantics::Outcome outcome = Evaluate(goal);
  if (outcome.impasse != existing) return false;
  if (existing != ImpasseType::kNone) return true;
  const Symbol selected = core_.memory.wme(slot.wmes).value;
  return std::any_of(outcome.candidates.begin(), outcome.candidates.end(),
                     [&](const Candidate& candidate) { return candidate.value == selected; });
}

bool Decision::CheckChanged(GoalLevel level) {
  for (GoalLevel current = changed_from_; current <= level && current <= core_.goals.depth(); ++current) {
    const Goal& goal = core_.goals.at(current);
    const Slot& slot = core_.memory.slot(goal.operator_slot);
    const bool has_operator = slot.wmes != WmeId::kNone;
    if (!slot.changed || (!has_operator && core_.goals.depth() == current)) continue;
    if (Stands(goal)) continue;
    if (core_.observers.Wants(Event::kDecision)) {
      const GoalInfo info = core_.descriptions.Describe(goal);
      core_.observers.Notify(Event::kDecision, [&](Observer& o) { o.OnInconsistentDecision(core_.agent, info); });
    }
    if (has_operator) {
      RemoveOperator(current, OperatorRemoval::kInconsistent);
    } else {
      core_.goal_changes.RemoveFrom(static_cast<GoalLevel>(current + 1), GoalRemoval::kInconsistent);
    }
    core_.elaboration.ApplyBufferedChanges();
    return false;
  }
  return true;
}

std::string Decision::Predict() {
  // Seeds the stream, and the next decision uses the same seed. So the prediction comes true.
  do {
    foretold_seed_ = core_.random.Next32();
  } while (foretold_seed_ == 0);
  core_.random.Seed(foretold_seed_);
  if (core_.goals.empty()) return "none";
  const GoalLevel first = changed_from_ != 0 ? changed_from_ : static_cast<GoalLevel>(core_.goals.depth());
  for (GoalLevel level = first; level <= core_.goals.depth(); ++level) {
    const Goal& goal = core_.goals.at(level);
    if (core_.memory.slot(goal.operator_slot).wmes != WmeId::kNone) continue;
    const Symbol forced = ForcedOperator(goal);
    if (forced) core_.forced_operator.clear();  // As in Soar, a selection by command applies to one evaluation.
    const PreferenceSemantics::Outcome outcome = Evaluate(goal, forced);
    switch (outcome.impasse) {
      case ImpasseType::kTie:
        return "tie";
      case ImpasseType::kConflict:
        return "conflict";
      case ImpasseType::kConstraintFailure:
        return "constraint";
      case ImpasseType::kNoChange:
      case ImpasseType::kNone:
        break;
    }
    if (outcome.candidates.empty()) continue;
    return ToString(core_.symbols, Pick(outcome).value);
  }
  return "none";
}

}  // namespace soarbox::kernel
