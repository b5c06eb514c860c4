// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/elaboration.h"

#include "kernel/decide/engine.h"

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
  for (GoalLevel level = 1; level <= engine_.goals.depth(); ++level) engine_.goals.at(level).has_saved_firing = false;
}

// The active level ----------------------------------------------------------------------------------------------------

bool Elaboration::HasIeWork(GoalLevel level) const {
  const MatchSet& matches = engine_.rete.matches();
  return matches.HasAssertions(level, false) || matches.HasRetractions(level);
}

bool Elaboration::HasWork(GoalLevel level, bool apply) const {
  return HasIeWork(level) || (apply && engine_.rete.matches().HasAssertions(level, true));
}

GoalLevel Elaboration::HighestActive(GoalLevel from, bool apply) const {
  for (GoalLevel level = from; level <= engine_.goals.depth(); ++level) {
    if (HasWork(level, apply)) return level;
  }
  return 0;
}

FiringType Elaboration::TypeAt(GoalLevel level) const {
  return level == 0 || HasIeWork(level) ? FiringType::kIe : FiringType::kPe;
}

Elaboration::Next Elaboration::Determine(bool apply) {
  const GoalLevel active = HighestActive(1, apply);
  if (active == 0 && !engine_.rete.matches().HasNoGoalRetractions()) {
    if (firing_ == FiringType::kIe &&
        !engine_.decision.CheckConsistency(static_cast<GoalLevel>(engine_.goals.depth()))) {
      return Next::kInconsistent;
    }
    return Next::kPhaseEnds;
  }
  const AgentSettings& settings = engine_.settings;
  if (count_ >= static_cast<std::uint32_t>(settings.max_elaborations) ||
      engine_.counters.firings >= settings.most_firings) {
    engine_.observers.Warn(apply ? WarningKind::kMaxElaborationsApply : WarningKind::kMaxElaborationsPropose,
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
  return engine_.decision.CheckConsistency(through) ? Next::kElaborate : Next::kInconsistent;
}

Elaboration::Next Elaboration::DetermineApply(GoalLevel previous) {
  if (previous == 0) {
    firing_ = TypeAt(active_);
    return Next::kElaborate;
  }
  if (active_ < previous) {
    if (previous <= engine_.goals.depth()) {
      engine_.goals.at(previous).saved_firing = firing_;
      engine_.goals.at(previous).has_saved_firing = true;
    }
    if (!engine_.decision.CheckConsistency(active_)) return Next::kInconsistent;
    firing_ = TypeAt(active_);
    return Next::kElaborate;
  }
  if (active_ > previous) {
    if (firing_ == FiringType::kIe && !HasIeWork(previous) && !engine_.decision.CheckConsistency(previous)) {
      return Next::kInconsistent;
    }
    Goal& goal = engine_.goals.at(active_);
    if (!goal.has_saved_firing) {
      firing_ = TypeAt(active_);
      return Next::kElaborate;
    }
    firing_ = goal.saved_firing;
    goal.has_saved_firing = false;
  }
  // The level has not changed.
  if (firing_ == FiringType::kIe && !HasIeWork(active_) && !engine_.decision.CheckConsistency(active_)) {
    return Next::kInconsistent;
  }
  firing_ = TypeAt(active_);
  return Next::kElaborate;
}

// One elaboration -----------------------------------------------------------------------------------------------------

void Elaboration::Run(bool apply) {
  engine_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnElaborationBegin(engine_.agent); });
  ++count_;
  engine_.observers.Notify(Event::kElaboration,
                           [&](Observer& o) { o.OnPreferencePhase(engine_.agent, firing_, active_); });
  PreferencePhase(apply);
  engine_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnWorkingMemoryPhase(engine_.agent, firing_); });
  ApplyWorkingMemoryChanges();
  // Elaborations are counted at their end: a rule that reads the statistics does not see the current one.
  ++engine_.counters.elaborations;
  if (firing_ == FiringType::kPe) ++engine_.counters.pe_elaborations;
  // Within one decision, rules may add elements in more than a hundred elaborations before the host checks the agent
  // again.
  constexpr std::uint32_t kElaborationsUntilMeasured = 4;
  if (count_ % kElaborationsUntilMeasured == 0) engine_.StopIfOutgrown();
  engine_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnElaborationEnd(engine_.agent); });
}

void Elaboration::PreferencePhase(bool apply) {
  if (engine_.modules.Wants(ModuleHook::kRulesFire)) engine_.modules.RulesFire();
  GoalLevel change_level = active_;
  bool first_pass = true;
  if (active_ == 0) {
    // Only matches of removed goals are left.
    ++engine_.counters.inner_elaborations;
    engine_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnInnerElaboration(engine_.agent, 0, {}); });
  }
  for (GoalLevel level = active_; level != 0; level = HighestActive(static_cast<GoalLevel>(level + 1), apply)) {
    if (engine_.observers.Wants(Event::kElaboration)) {
      const Symbol goal = engine_.goals.at(level).id;
      engine_.observers.Notify(Event::kElaboration,
                               [&](Observer& o) { o.OnInnerElaboration(engine_.agent, level, goal); });
    }
    FireLevel(level, first_pass, change_level);
    AssertNew();
    ++engine_.counters.inner_elaborations;
    first_pass = false;
  }
  if (active_ != 0) RetractLevel(active_);
  RetractLevel(0);
}

void Elaboration::FireLevel(GoalLevel level, bool first_pass, GoalLevel& change_level) {
  MatchSet& matches = engine_.rete.matches();
  put_back_.clear();
  const bool o_support = firing_ == FiringType::kPe;
  const bool has_any = matches.HasAssertions(level, o_support);
  while (matches.HasAssertions(level, o_support)) {
    const PendingMatch match = matches.TakeAssertion(level, o_support);
    const Production& rule = *engine_.rete.production(match.production);
    if (rule.type == ProductionType::kJustification) {
      matches.Release(match.match);  // A justification that matches again does not fire.
      continue;
    }
    const Symbol touched = first_pass ? Symbol() : engine_.firing.TouchedAbove(match, change_level);
    if (touched) {
      put_back_.push_back(match.match);
      if (engine_.observers.Wants(Event::kFiring)) {
        FiringInfo info;
        info.production = match.production;
        info.rule = &rule;
        info.name = info.rule->name;
        info.goal = match.goal;
        info.level = match.level;
        info.wmes = matches.Wmes(match.match);
        info.touched = touched;
        info.change_level = change_level;
        engine_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnInhibited(engine_.agent, info); });
      }
      continue;
    }
    engine_.firing.Fire(match, rule);
  }
  matches.PutBack(put_back_);
  if (has_any) change_level = level;  // Even if all of them are inhibited.
}

void Elaboration::AssertNew() {
  std::vector<InstantiationId>& made = engine_.firing.made();
  if (made.empty()) return;
  WorkingMemory& memory = engine_.memory;
  const auto is_o_reject = [](const Preference& preference) {
    return preference.o_supported && preference.type == PreferenceType::kReject;
  };
  const std::size_t to_search = engine_.preferences.TakeORejectMade() ? made.size() : 0;
  for (std::size_t n = to_search; n-- > 0;) {
    for (PreferenceId p = engine_.instantiations[made[n]].preferences; p != PreferenceId::kNone;
         p = memory.preference(p).next_of_instantiation) {
      if (is_o_reject(memory.preference(p))) o_rejects_.push_back(p);
    }
  }
  // Rejects are applied in the order of firing, the first action first.
  for (std::size_t n = o_rejects_.size(); n-- > 0;) engine_.preferences.ApplyOReject(o_rejects_[n]);
  // The clones of the reject at other levels are spent, too: they are never asserted.
  for (std::size_t n = o_rejects_.size(); n-- > 0;) engine_.preferences.SpendClones(o_rejects_[n]);
  o_rejects_.clear();
  for (std::size_t n = made.size(); n-- > 0;) {
    const InstantiationId id = made[n];
    if (engine_.observers.Wants(Event::kAssertion)) {
      const FiringInfo info = engine_.descriptions.DescribeInstantiation(id);
      engine_.observers.Notify(Event::kAssertion, [&](Observer& o) { o.OnInstantiationAsserted(engine_.agent, info); });
    }
    PreferenceId next;
    for (PreferenceId p = engine_.instantiations[id].preferences; p != PreferenceId::kNone; p = next) {
      next = memory.preference(p).next_of_instantiation;
      const Preference& preference = memory.preference(p);
      bool never = preference.is_spent || is_o_reject(preference);
      if (engine_.instantiations[id].match == MatchId::kNone && !preference.o_supported) {
        never = true;  // A justification that does not match.
        engine_.preferences.LeaveClones(p);
      }
      const bool asserted = !never && engine_.preferences.Assert(p);
      if (asserted) {
        if (engine_.modules.Wants(ModuleHook::kAsserted)) engine_.modules.Asserted(p);
      } else {
#ifdef SOARBOX_CHECK_INVARIANTS
        if (!never) engine_.CheckSupported(preference);
#endif
        engine_.preferences.FreeIfUnused(p);
      }
    }
    engine_.instantiations[id].held = false;
    engine_.preferences.FreeIfUnused(id);
  }
  made.clear();
}

void Elaboration::RetractLevel(GoalLevel level) {
  MatchSet& matches = engine_.rete.matches();
  while (matches.HasRetractions(level)) Retract(matches.TakeRetraction(level));
}

void Elaboration::Retract(MatchId match) {
  const InstantiationId id = engine_.rete.matches().InstantiationOf(match);
  WorkingMemory& memory = engine_.memory;
  bool told = false;
  engine_.instantiations[id].held = true;
  PreferenceId next;
  for (PreferenceId p = engine_.instantiations[id].preferences; p != PreferenceId::kNone; p = next) {
    next = memory.preference(p).next_of_instantiation;
    if (memory.preference(p).o_supported || !memory.preference(p).in_slot) continue;
    if (!told && engine_.observers.Wants(Event::kFiring)) {
      told = true;
      const FiringInfo info = engine_.descriptions.DescribeInstantiation(id);
      engine_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnRetracting(engine_.agent, info); });
    }
    engine_.preferences.Retract(p);
  }
  if (engine_.observers.Wants(Event::kFiring)) {
    const FiringInfo info = engine_.descriptions.DescribeInstantiation(id);
    engine_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnRetracted(engine_.agent, info); });
  }
  engine_.rete.matches().Release(match);
  engine_.instantiations[id].match = MatchId::kNone;
  if (engine_.modules.Wants(ModuleHook::kMatches)) engine_.modules.MatchEnded(engine_.instantiations[id].production);
  engine_.instantiations[id].held = false;
  engine_.preferences.FreeIfUnused(id);
}

// The working memory phase --------------------------------------------------------------------------------------------

void Elaboration::ApplyWorkingMemoryChanges() {
  const std::size_t retired = engine_.preferences.retired();
  if (!engine_.preferences.changed_slots().empty()) engine_.slot_decision.DecideChangedSlots();
  if (!engine_.preferences.changed_acceptables().empty()) engine_.slot_decision.UpdateAcceptables();
  if (retired > 0) engine_.preferences.ReleaseRetired(retired);
  ApplyBufferedChanges();
}

void Elaboration::ApplyBufferedChanges() {
  // Agents that do not reach quiescence retract something in each elaboration: free the elements removed before this
  // one.
  if (engine_.changes.HasDead()) BuryDead();
  if (!engine_.preferences.changed_acceptables().empty()) engine_.slot_decision.UpdateAcceptables();
  while (engine_.links.HasWork()) {
    garbage_.clear();
    engine_.links.Settle(garbage_);
    for (const Symbol id : garbage_) engine_.goal_changes.CollectGarbage(id);
  }
  if (!engine_.changes.empty()) engine_.changes.Flush();
  if (!engine_.preferences.empty_slots().empty()) engine_.preferences.FreeEmptySlots();
  if (!engine_.excisions.empty()) {
    for (const ProductionId production : engine_.excisions) engine_.rete.ExciseProduction(production);
    engine_.excisions.clear();
  }
  if (engine_.changes.HasDead()) BuryDead();
}

void Elaboration::BuryDead() {
  // Elements of matches that wait for their retraction may still be shown.
  const MatchSet& matches = engine_.rete.matches();
  for (GoalLevel level = 0; level <= engine_.goals.depth(); ++level) {
    if (matches.HasRetractions(level)) return;
  }
  engine_.changes.Bury();
}

}  // namespace soarbox::kernel
