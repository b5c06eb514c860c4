// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/goal_dependency_set.h"

#include <algorithm>

#include "kernel/decide/engine.h"

namespace soarbox::kernel {

void GoalDependencySets::NoteNewFact(WmeId wme) {
  const WorkingMemory& memory = engine_.memory;
  const SlotId slot = memory.record(wme).slot;
  if (memory.slot(slot).substate_facts == 0) return;
  // A result belongs to the state above: it rests on its justification.
  const PreferenceId maker = memory.record(wme).preference;
  if (maker == PreferenceId::kNone) return;
  if (!memory.preference(maker).o_supported || memory.preference(maker).level < 2) return;
  const Symbol value = memory.wme(wme).value;
  ++collection_;
  for (PreferenceId p = memory.slot(slot).acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    const Preference& preference = memory.preference(p);
    if (!preference.o_supported || preference.value != value || preference.level < 2) continue;
    const GoalLevel level = preference.level;
    // As in Soar 9.6.3 only the first such fact counts: what later ones rest on is never added.
    if (level > engine_.goals.depth() || engine_.goals.at(level).has_gds) continue;
    engine_.goals.at(level).has_gds = true;
    Queue(preference.instantiation);
    while (!queue_.empty()) {
      const InstantiationId next = queue_.back();
      queue_.pop_back();
      Collect(next, level);
    }
  }
}

void GoalDependencySets::Queue(InstantiationId id) {
  Instantiation& instantiation = engine_.instantiations[id];
  if (instantiation.gds_visit == collection_) return;
  instantiation.gds_visit = collection_;
  queue_.push_back(id);
}

void GoalDependencySets::Collect(InstantiationId id, GoalLevel level) {
  const WorkingMemory& memory = engine_.memory;
  for (const ConditionTrace& trace : engine_.instantiations.Trace(id)) {
    const WmeRecord& record = memory.record(trace.wme);
    if (record.removing || !memory.wme(trace.wme).live) continue;
    const PreferenceId preference = record.preference;
    const bool given = preference == PreferenceId::kNone;  // By the architecture, by input, or by a memory.
    if (given || memory.level(memory.wme(trace.wme).id) < level) {
      AddMember(trace.wme, level);
      continue;
    }
    // A fact of this goal that is not held by o-support passes its own dependencies on.
    const SlotId slot = record.slot;
    for (PreferenceId p = memory.slot(slot).acceptable; p != PreferenceId::kNone;
         p = memory.preference(p).next_in_slot) {
      const Preference& supporter = memory.preference(p);
      if (supporter.value == memory.wme(trace.wme).value && supporter.level == level && !supporter.o_supported) {
        Queue(supporter.instantiation);
      }
    }
  }
}

void GoalDependencySets::AddMember(WmeId wme, GoalLevel level) {
  WmeRecord& record = engine_.memory.mutable_record(wme);
  if (record.gds != 0 && record.gds <= level) return;
  if (record.gds != 0 && record.gds != kGoalOfGdsGone) std::erase(engine_.goals.at(record.gds).gds, wme);
  record.gds = level;
  engine_.goals.at(level).gds.push_back(wme);
  if (engine_.observers.Wants(Event::kGds)) {
    const GoalInfo goal = engine_.Describe(engine_.goals.at(level));
    const WmeInfo info = engine_.Describe(wme);
    engine_.observers.Notify(Event::kGds, [&](Observer& o) { o.OnGdsAdded(engine_.agent, goal, info); });
  }
}

void GoalDependencySets::MemberLeaves(WmeId wme) {
  const GoalLevel level = engine_.memory.record(wme).gds;
  if (level == 0 || level > engine_.goals.depth()) return;
  if (engine_.observers.Wants(Event::kGds)) {
    const GoalInfo info = engine_.Describe(engine_.goals.at(level));
    const WmeInfo member = engine_.Describe(wme);
    engine_.observers.Notify(Event::kGds, [&](Observer& o) { o.OnGdsViolation(engine_.agent, info, member); });
  }
  engine_.goal_changes.RemoveFrom(level, GoalRemoval::kGdsChange);
}

void GoalDependencySets::Forget(WmeId wme) {
  WmeRecord& record = engine_.memory.mutable_record(wme);
  if (record.gds != 0 && record.gds <= engine_.goals.depth()) std::erase(engine_.goals.at(record.gds).gds, wme);
  record.gds = 0;
}

void GoalDependencySets::GoalRemoved(GoalLevel level) {
  Goal& goal = engine_.goals.at(level);
  for (const WmeId wme : goal.gds) engine_.memory.mutable_record(wme).gds = kGoalOfGdsGone;
  goal.gds.clear();
  goal.has_gds = false;
}

}  // namespace soarbox::kernel
