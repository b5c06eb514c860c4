// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/goal_dependency_set.h"

#include <algorithm>

#include "kernel/decide/descriptions.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_changes.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/observers.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

void GoalDependencySets::NoteNewFact(WmeId wme) {
  const WorkingMemory& memory = uses_.memory;
  // A result belongs to a higher state: it depends on its justification.
  const PreferenceId maker = memory.record(wme).preference;
  if (maker == PreferenceId::kNone) return;
  const GoalLevel level = memory.preference(maker).level;
  if (!memory.preference(maker).o_supported || level < 2 || level > uses_.goals.depth()) return;
  // As in Soar 9.6.3, only the first such element counts: elements on which later ones depend are never added. If the
  // state's rules created other elements in the same slot before, with any value, these count together with the first
  // one.
  if (uses_.goals.at(level).has_gds) return;
  uses_.goals.at(level).has_gds = true;
  for (PreferenceId p = maker; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).level == level) Queue(memory.preference(p).instantiation);
  }
  // Breadth-first search. Within one level of the search, the newest entry is first.
  while (!queue_.empty()) {
    exploring_.swap(queue_);
    while (!exploring_.empty()) {
      const InstantiationId next = exploring_.back();
      exploring_.pop_back();
      Collect(next);
    }
  }
}

void GoalDependencySets::Queue(InstantiationId id) {
  Instantiation& instantiation = uses_.instantiations[id];
  if (instantiation.in_gds) return;
  instantiation.in_gds = true;
  queue_.push_back(id);
}

void GoalDependencySets::Collect(InstantiationId id) {
  const WorkingMemory& memory = uses_.memory;
  const GoalLevel level = uses_.instantiations[id].level;
  if (level > uses_.goals.depth() || !uses_.goals.at(level).has_gds) return;
  for (const ConditionTrace& trace : uses_.instantiations.Trace(id)) {
    const WmeRecord& record = memory.record(trace.wme);
    if (record.removing || !memory.wme(trace.wme).live) continue;
    PreferenceId maker = record.preference;
    if (maker == PreferenceId::kNone && trace.level >= level) {
      const WmeId proposal = uses_.goal_changes.ProposalOfItem(trace.wme);
      AddMember(proposal != WmeId::kNone ? proposal : trace.wme, level);
      continue;
    }
    if (maker == PreferenceId::kNone || trace.level < level) {
      AddMember(trace.wme, level);
      continue;
    }
    // An element of this goal that is not o-supported passes on its own dependencies.
    const PreferenceId local = uses_.firing.CloneAtLevel(maker, level);
    if (local != PreferenceId::kNone) maker = local;
    if (memory.preference(maker).o_supported) continue;
    const Symbol value = memory.wme(trace.wme).value;
    for (PreferenceId p = memory.slot(record.slot()).acceptable; p != PreferenceId::kNone;
         p = memory.preference(p).next_in_slot) {
      const Preference& supporter = memory.preference(p);
      if (supporter.value == value && supporter.level <= level) Queue(supporter.instantiation);
    }
  }
}

void GoalDependencySets::AddMember(WmeId wme, GoalLevel level) {
  WmeRecord& record = uses_.memory.mutable_record(wme);
  if (record.gds != 0 && record.gds <= level) return;
  if (record.gds != 0 && record.gds != kGoalOfGdsGone) std::erase(uses_.goals.at(record.gds).gds, wme);
  record.gds = level;
  uses_.goals.at(level).gds.push_back(wme);
  if (uses_.observers.Wants(Event::kGds)) {
    const GoalInfo goal = uses_.descriptions.Describe(uses_.goals.at(level));
    const WmeInfo info = uses_.descriptions.Describe(wme);
    uses_.observers.Notify(Event::kGds, [&](Observer& o) { o.OnGdsAdded(uses_.agent, goal, info); });
  }
}

void GoalDependencySets::MemberLeaves(WmeId wme) {
  const GoalLevel level = uses_.memory.record(wme).gds;
  if (level == 0 || level > uses_.goals.depth()) return;
  if (uses_.observers.Wants(Event::kGds)) {
    const GoalInfo info = uses_.descriptions.Describe(uses_.goals.at(level));
    const WmeInfo member = uses_.descriptions.Describe(wme);
    uses_.observers.Notify(Event::kGds, [&](Observer& o) { o.OnGdsViolation(uses_.agent, info, member); });
  }
  uses_.goal_changes.RemoveFrom(level, GoalRemoval::kGdsChange);
}

void GoalDependencySets::Forget(WmeId wme) {
  WmeRecord& record = uses_.memory.mutable_record(wme);
  if (record.gds != 0 && record.gds <= uses_.goals.depth()) std::erase(uses_.goals.at(record.gds).gds, wme);
  record.gds = 0;
}

void GoalDependencySets::GoalRemoved(GoalLevel level) {
  Goal& goal = uses_.goals.at(level);
  for (const WmeId wme : goal.gds) uses_.memory.mutable_record(wme).gds = kGoalOfGdsGone;
  goal.gds.clear();
  goal.has_gds = false;
}

}  // namespace soarbox::kernel
