// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/elaboration.h"

#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {

void Elaboration::Clear() {
  active_ = 0;
  firing_ = FiringType::kIe;
  count_ = 0;
}

void Elaboration::BeginPhase() {
  active_ = 0;
  count_ = 0;
  firing_ = FiringType::kIe;
  for (GoalLevel level = 1; level <= core_.goals.depth(); ++level) core_.goals.at(level).has_saved_firing = false;
}

// The active level ----------------------------------------------------------------------------------------------------

bool Elaboration::HasIeWork(GoalLevel level) const {
  const MatchSet& matches = core_.rete.matches();
  return matches.HasAssertions(level, false) || matches.HasRetractions(level);
}

bool Elaboration::HasWork(GoalLevel level, bool apply) const {
  return HasIeWork(level) || (apply && core_.rete.matches().HasAssertions(level, true));
}

GoalLevel Elaboration::HighestActive(GoalLevel from, bool apply) const {
  for (GoalLevel level = from; level <= core_.goals.depth(); ++level) {
    if (HasWork(level, apply)) return level;
  }
  return 0;
}

FiringType Elaboration::TypeAt(GoalLevel level) const {
  return level == 0 || HasIeWork(level) ? FiringType::kIe : FiringType::kPe;
}

Elaboration::Next Elaboration::Determine(bool apply) {
  const GoalLevel active = HighestActive(1, apply);
  if (active == 0 && !core_.rete.matches().HasNoGoalRetractions()) {
    if (firing_ == FiringType::kIe && !core_.decision.CheckConsistency(static_cast<GoalLevel>(core_.goals.depth()))) {
      return Next::kInconsistent;
    }
    return Next::kPhaseEnds;
  }
  const AgentSettings& settings = core_.settings;
  if (count_ >= static_cast<std::uint32_t>(settings.max_elaborations) ||
      core_.counters.firings >= settings.most_firings) {
    core_.observers.Warn(apply ? WarningKind::kMaxElaborationsApply : WarningKind::kMaxElaborationsPropose,
                         apply ? "reached max-elaborations; proceeding to output phase"
                               : "reached max-elaborations; proceeding to decide phase");
    return Next::kPhaseEnds;
  }
  const GoalLevel previous = active_;
  active_ = active;
  if (apply) return DetermineApply(previous);
  firing_ = FiringType::kIe;
  if (previous == 0 || previous == active_) return Next::kElaborate;
  const GoalLevel through = active_ > previous ? previous : active_;
  return core_.decision.CheckConsistency(through) ? Next::kElaborate : Next::kInconsistent;
}

Elaboration::Next Elaboration::DetermineApply(GoalLevel previous) {
  if (previous == 0) {
    firing_ = TypeAt(active_);
    return Next::kElaborate;
  }
  if (active_ < previous) {
    if (previous <= core_.goals.depth()) {
      core_.goals.at(previous).saved_firing = firing_;
      core_.goals.at(previous).has_saved_firing = true;
    }
    if (!core_.decision.CheckConsistency(active_)) return Next::kInconsistent;
    firing_ = TypeAt(active_);
    return Next::kElaborate;
  }
  if (active_ > previous) {
    if (firing_ == FiringType::kIe && !HasIeWork(previous) && !core_.decision.CheckConsistency(previous)) {
      return Next::kInconsistent;
    }
    Goal& goal = core_.goals.at(active_);
    if (!goal.has_saved_firing) {
      firing_ = TypeAt(active_);
      return Next::kElaborate;
    }
    firing_ = goal.saved_firing;
    goal.has_saved_firing = false;
  }
  // The level has not changed.
  if (firing_ == FiringType::kIe && !HasIeWork(active_) && !core_.decision.CheckConsistency(active_)) {
    return Next::kInconsistent;
  }
  firing_ = TypeAt(active_);
  return Next::kElaborate;
}

// One elaboration -----------------------------------------------------------------------------------------------------

void Elaboration::Run(bool apply) {
  core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnElaborationBegin(core_.agent); });
  ++count_;
  core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnPreferencePhase(core_.agent, firing_, active_); });
  PreferencePhase(apply);
  core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnWorkingMemoryPhase(core_.agent, firing_); });
  ApplyWorkingMemoryChanges();
  // Elaborations are counted at their end: a rule that reads the statistics does not see the current one.
  ++core_.counters.elaborations;
  if (firing_ == FiringType::kPe) ++core_.counters.pe_elaborations;
  // Within one decision, rules may add elements in more than a hundred elaborations before the host checks the agent
  // again.
  constexpr std::uint32_t kElaborationsUntilMeasured = 4;
  if (count_ % kElaborationsUntilMeasured == 0) core_.StopIfOutgrown();
  core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnElaborationEnd(core_.agent); });
}

void Elaboration::PreferencePhase(bool apply) {
  if (core_.modules.Wants(ModuleHook::kRulesFire)) core_.modules.RulesFire();
  GoalLevel change_level = active_;
  bool first_pass = true;
  if (active_ == 0) {
    // Only matches of removed goals are left.
    ++core_.counters.inner_elaborations;
    core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnInnerElaboration(core_.agent, 0, {}); });
  }
  for (GoalLevel level = active_; level != 0; level = HighestActive(static_cast<GoalLevel>(level + 1), apply)) {
    if (core_.observers.Wants(Event::kElaboration)) {
      const Symbol goal = core_.goals.at(level).id;
      core_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnInnerElaboration(core_.agent, level, goal); });
    }
    FireLevel(level, first_pass, change_level);
    AssertNew();
    ++core_.counters.inner_elaborations;
    first_pass = false;
  }
  if (active_ != 0) RetractLevel(active_);
  RetractLevel(0);
}

void Elaboration::FireLevel(GoalLevel level, bool first_pass, GoalLevel& change_level) {
  MatchSet& matches = core_.rete.matches();
  put_back_.clear();
  const bool o_support = firing_ == FiringType::kPe;
  const bool has_any = matches.HasAssertions(level, o_support);
  while (matches.HasAssertions(level, o_support)) {
    const PendingMatch match = matches.TakeAssertion(level, o_support);
    const Production& rule = *core_.rete.production(match.production);
    if (rule.type == ProductionType::kJustification) {
      matches.Release(match.match);  // A justification that matches again does not fire.
      continue;
    }
    const Symbol touched = first_pass ? Symbol() : core_.firing.TouchedAbove(match, change_level);
    if (touched) {
      put_back_.push_back(match.match);
      if (core_.observers.Wants(Event::kFiring)) {
        FiringInfo info;
        info.production = match.production;
        info.rule = &rule;
        info.name = info.rule->name;
        info.goal = match.goal;
        info.level = match.level;
        info.wmes = matches.Wmes(match.match);
        info.touched = touched;
        info.change_level = change_level;
        core_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnInhibited(core_.agent, info); });
      }
      continue;
    }
    core_.firing.Fire(match, rule);
  }
  matches.PutBack(put_back_);
  if (has_any) change_level = level;  // Even if all of them are inhibited.
}

void Elaboration::AssertNew() {
  std::vector<InstantiationId>& made = core_.firing.made();
  if (made.empty()) return;
  WorkingMemory& memory = core_.memory;
  const auto is_o_reject = [](const Preference& preference) {
    return preference.o_supported && preference.type == PreferenceType::kReject;
  };
  const std::size_t to_search = core_.preferences.TakeORejectMade() ? made.size() : 0;
  for (std::size_t n = to_search; n-- > 0;) {
    for (PreferenceId p = core_.instantiations[made[n]].preferences; p != PreferenceId::kNone;
         p = memory.preference(p).next_of_instantiation) {
      if (is_o_reject(memory.preference(p))) o_rejects_.push_back(p);
    }
  }
  // Rejects are applied in the order of firing, the first action first.
  for (std::size_t n = o_rejects_.size(); n-- > 0;) core_.preferences.ApplyOReject(o_rejects_[n]);
  // The clones of the reject at other levels are spent, too: they are never asserted.
  for (std::size_t n = o_rejects_.size(); n-- > 0;) core_.preferences.SpendClones(o_rejects_[n]);
  o_rejects_.clear();
  for (std::size_t n = made.size(); n-- > 0;) {
    const InstantiationId id = made[n];
    if (core_.observers.Wants(Event::kAssertion)) {
      const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
      core_.observers.Notify(Event::kAssertion, [&](Observer& o) { o.OnInstantiationAsserted(core_.agent, info); });
    }
    PreferenceId next;
    for (PreferenceId p = core_.instantiations[id].preferences; p != PreferenceId::kNone; p = next) {
      next = memory.preference(p).next_of_instantiation;
      const Preference& preference = memory.preference(p);
      bool never = preference.is_spent || is_o_reject(preference);
      if (core_.instantiations[id].match == MatchId::kNone && !preference.o_supported) {
        never = true;  // A justification that does not match.
        core_.preferences.LeaveClones(p);
      }
      const bool asserted = !never && core_.preferences.Assert(p);
      if (asserted) {
        if (core_.modules.Wants(ModuleHook::kAsserted)) core_.modules.Asserted(p);
      } else {
#ifdef SOARBOX_CHECK_INVARIANTS
        if (!never) core_.CheckSupported(preference);
#endif
        core_.preferences.FreeIfUnused(p);
      }
    }
    core_.instantiations[id].held = false;
    core_.preferences.FreeIfUnused(id);
  }
  made.clear();
}

void Elaboration::RetractLevel(GoalLevel level) {
  MatchSet& matches = core_.rete.matches();
  while (matches.HasRetractions(level)) Retract(matches.TakeRetraction(level));
}

void Elaboration::Retract(MatchId match) {
  const InstantiationId id = core_.rete.matches().InstantiationOf(match);
  WorkingMemory& memory = core_.memory;
  bool told = false;
  core_.instantiations[id].held = true;
  PreferenceId next;
  for (PreferenceId p = core_.instantiations[id].preferences; p != PreferenceId::kNone; p = next) {
    next = memory.preference(p).next_of_instantiation;
    if (memory.preference(p).o_supported || !memory.preference(p).in_slot) continue;
    if (!told && core_.observers.Wants(Event::kFiring)) {
      told = true;
      const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
      core_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnRetracting(core_.agent, info); });
    }
    core_.preferences.Retract(p);
  }
  if (core_.observers.Wants(Event::kFiring)) {
    const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
    core_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnRetracted(core_.agent, info); });
  }
  core_.rete.matches().Release(match);
  core_.instantiations[id].match = MatchId::kNone;
  if (core_.modules.Wants(ModuleHook::kMatches)) core_.modules.MatchEnded(core_.instantiations[id].production);
  core_.instantiations[id].held = false;
  core_.preferences.FreeIfUnused(id);
}

// The working memory phase --------------------------------------------------------------------------------------------

void Elaboration::ApplyWorkingMemoryChanges() {
  const std::size_t retired = core_.preferences.retired();
  if (!core_.preferences.changed_slots().empty()) core_.slot_decision.DecideChangedSlots();
  if (!core_.preferences.changed_acceptables().empty()) core_.slot_decision.UpdateAcceptables();
  if (retired > 0) core_.preferences.ReleaseRetired(retired);
  ApplyBufferedChanges();
}

void Elaboration::ApplyBufferedChanges() {
  // Agents that do not reach quiescence retract something in each elaboration. So elements that were removed before
  // this elaboration are freed here.
  if (core_.changes.HasDead()) BuryDead();
  if (!core_.preferences.changed_acceptables().empty()) core_.slot_decision.UpdateAcceptables();
  while (core_.links.HasWork()) {
    garbage_.clear();
    core_.links.Settle(garbage_);
    for (const Symbol id : garbage_) core_.goal_changes.CollectGarbage(id);
  }
  if (!core_.changes.empty()) core_.changes.Flush();
  if (!core_.preferences.empty_slots().empty()) core_.preferences.FreeEmptySlots();
  if (!core_.excisions.empty()) {
    for (const ProductionId production : core_.excisions) core_.rete.ExciseProduction(production);
    core_.excisions.clear();
  }
  if (core_.changes.HasDead()) BuryDead();
}

void Elaboration::BuryDead() {
  // Elements of matches that wait for their retraction may still be shown, so they are not freed.
  const MatchSet& matches = core_.rete.matches();
  for (GoalLevel level = 0; level <= core_.goals.depth(); ++level) {
    if (matches.HasRetractions(level)) return;
  }
  core_.changes.Bury();
}

}  // namespace soarbox::kernel
