// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/preference_changes.h"

#include <algorithm>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {

PreferenceId PreferenceChanges::Make(InstantiationId instantiation, const Preference& content) {
  return Make(instantiation, content.id, content.attribute, content.value, content.referent, content.type,
              content.o_supported, content.action);
}

PreferenceId PreferenceChanges::Make(InstantiationId instantiation_id, Symbol id, Symbol attribute, Symbol value,
                                     Symbol referent, PreferenceType type, bool o_supported, std::uint16_t action) {
  const PreferenceId made = core_.memory.MakePreference();
  Preference& preference = core_.memory.mutable_preference(made);
  Instantiation& instantiation = core_.instantiations[instantiation_id];
  preference.id = id;
  preference.attribute = attribute;
  preference.value = value;
  preference.referent = referent;
  preference.type = type;
  preference.o_supported = o_supported;
  preference.action = action;
  if (o_supported && type == PreferenceType::kReject) o_reject_made_ = true;
  preference.instantiation = instantiation_id;
  preference.level = instantiation.level;
  preference.next_of_instantiation = instantiation.preferences;
  if (instantiation.preferences != PreferenceId::kNone) {
    core_.memory.mutable_preference(instantiation.preferences).previous_of_instantiation = made;
  }
  instantiation.preferences = made;
  return made;
}

bool PreferenceChanges::Assert(PreferenceId id) {
  WorkingMemory& memory = core_.memory;
  Preference& preference = memory.mutable_preference(id);
  const bool is_operator = preference.attribute == words::kOperator && memory.known_identifier(preference.id).is_goal;
  const SlotId slot = memory.FindOrMakeSlot(preference.id, preference.attribute, is_operator);
  if (preference.o_supported && preference.type == PreferenceType::kAcceptable && preference.level == 1 &&
      !is_operator && !core_.settings.keep_all_top_o_preferences) {
    if (memory.HasTopFact(slot, preference.value)) {
      core_.observers.Notify(Event::kPreference, [&](Observer& o) { o.OnPreferenceIgnored(core_.agent, id); });
      return false;
    }
  }
  memory.InsertInSlot(id, slot);
  if (preference.type == PreferenceType::kProhibit) ++prohibits_;
  preference.stamp = ++last_stamp_;
  if (preference.value.IsIdentifier()) preference.value_link = core_.links.Add(preference.id, preference.value);
  if (preference.referent.IsIdentifier()) {
    preference.referent_link = core_.links.Add(preference.id, preference.referent);
  }
  Slot& record = memory.mutable_slot(slot);
  if (!is_operator && !record.is_operator) {
    MarkOrdinary(slot, record);
  } else {
    MarkChanged(slot);
    if (is_operator &&
        (preference.type == PreferenceType::kAcceptable || preference.type == PreferenceType::kRequire)) {
      NoteAcceptablesChanged(slot);
    }
  }
  core_.observers.Notify(Event::kPreference, [&](Observer& o) { o.OnPreferenceAdded(core_.agent, id); });
  return true;
}

void PreferenceChanges::Retract(PreferenceId id) {
  WorkingMemory& memory = core_.memory;
  Preference& preference = memory.mutable_preference(id);
  if (!preference.in_slot) return;
  core_.observers.Notify(Event::kPreference, [&](Observer& o) { o.OnPreferenceRemoved(core_.agent, id); });
  const SlotId slot = preference.slot;
  if (preference.value_link != LinkId::kNone) core_.links.Remove(preference.value_link);
  if (preference.referent_link != LinkId::kNone) core_.links.Remove(preference.referent_link);
  preference.value_link = preference.referent_link = LinkId::kNone;
  if (memory.preference(id).type == PreferenceType::kProhibit) --prohibits_;
  memory.RemoveFromSlot(id);
  Slot& record = memory.mutable_slot(slot);
  if (!record.is_operator) {
    MarkOrdinary(slot, record);
    // This is the slot of a removed goal.
    if (record.acceptable_wmes != WmeId::kNone) NoteAcceptablesChanged(slot);
  } else {
    MarkChanged(slot);
    if (preference.type == PreferenceType::kAcceptable || preference.type == PreferenceType::kRequire) {
      NoteAcceptablesChanged(slot);
    }
  }
  if (core_.goals.depth() > 1) {
    AddReference(id);
    retired_.push_back(id);
  } else {
    FreeIfUnused(id);
  }
}

void PreferenceChanges::ReleaseRetired(std::size_t count) {
  for (std::size_t n = 0; n < count; ++n) DropReference(retired_[n]);
  retired_.erase(retired_.begin(), retired_.begin() + static_cast<std::ptrdiff_t>(count));
}

void PreferenceChanges::RemoveSelected(SlotId slot) {
  while (core_.memory.slot(slot).wmes != WmeId::kNone) {
    const WmeId wme = core_.memory.slot(slot).wmes;
    const PreferenceId maker = core_.memory.record(wme).preference;
    core_.changes.Remove(wme);
    DropReference(maker);
  }
}

void PreferenceChanges::ApplyOReject(PreferenceId reject) {
  WorkingMemory& memory = core_.memory;
  const Symbol value = memory.preference(reject).value;
  const SlotId slot = memory.FindSlot(memory.preference(reject).id, memory.preference(reject).attribute);
  if (slot == SlotId::kNone) return;
  const PreferenceId newest = memory.slot(slot).acceptable;
  const PreferenceId others = memory.slot(slot).others;
  if (others == PreferenceId::kNone && newest != PreferenceId::kNone &&
      memory.preference(newest).next_in_slot == PreferenceId::kNone) {
    if (memory.preference(newest).value == value) Retract(newest);
    return;
  }
  if (others == PreferenceId::kNone && !memory.slot(slot).is_operator) {
    if (const LargeSlot* const large = memory.Large(slot)) {
      const LargeSlot::Value* const known = large->Find(value);
      if (known == nullptr || known->acceptable == 0) return;
      if (known->only != PreferenceId::kNone) {
        Retract(known->only);
        return;
      }
    }
  }
  rejected_.clear();
  const auto collect = [&](PreferenceId first) {
    for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
      if (memory.preference(p).value == value) rejected_.push_back(p);
    }
  };
  collect(newest);
  collect(others);
  // The newest is removed first.
  std::sort(rejected_.begin(), rejected_.end(),
            [&](PreferenceId a, PreferenceId b) { return memory.preference(a).stamp > memory.preference(b).stamp; });
  for (const PreferenceId p : rejected_) Retract(p);
}

void PreferenceChanges::SpendClones(PreferenceId reject) {
  WorkingMemory& memory = core_.memory;
  for (PreferenceId p = memory.preference(reject).next_clone; p != PreferenceId::kNone;
       p = memory.preference(p).next_clone) {
    memory.mutable_preference(p).is_spent = true;
  }
  for (PreferenceId p = memory.preference(reject).previous_clone; p != PreferenceId::kNone;
       p = memory.preference(p).previous_clone) {
    memory.mutable_preference(p).is_spent = true;
  }
}

void PreferenceChanges::AddReference(PreferenceId id) {
  ++core_.memory.mutable_preference(id).references;
}

void PreferenceChanges::DropReference(PreferenceId id) {
  --core_.memory.mutable_preference(id).references;
  FreeIfUnused(id);
}

void PreferenceChanges::DropReferenceLater(PreferenceId id) {
  if (--core_.memory.mutable_preference(id).references == 0) NoteUnused(id);
}

void PreferenceChanges::FreeIfUnused(PreferenceId id) {
  const Preference& preference = core_.memory.preference(id);
  if (preference.references != 0) return;
  if (draining_ || preference.next_clone != PreferenceId::kNone || preference.previous_clone != PreferenceId::kNone) {
    NoteUnused(id);
  } else {
    Free(id);
  }
  if (!unused_.empty()) Drain();
}

/// The preferences of one result at several levels are freed together. As long as one of them is in use, learning may
/// need the others.
void PreferenceChanges::NoteUnused(PreferenceId id) {
  const WorkingMemory& memory = core_.memory;
  PreferenceId first = id;
  while (memory.preference(first).previous_clone != PreferenceId::kNone)
    first = memory.preference(first).previous_clone;
  for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_clone) {
    if (memory.preference(p).references != 0) return;
  }
  for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_clone) unused_.push_back(p);
}

void PreferenceChanges::FreeIfUnused(InstantiationId id) {
  FreeInstantiation(id);
  if (!unused_.empty()) Drain();
}

void PreferenceChanges::Free(PreferenceId id) {
  const InstantiationId instantiation = core_.memory.preference(id).instantiation;
  if (core_.memory.preference(id).on_goal_list) UnlinkFromGoal(id);
  UnlinkFromLists(id);
  core_.memory.FreePreference(id);
  FreeInstantiation(instantiation);
}

/// Freeing a preference may free its instantiation, whose conditions refer to other preferences, and so on. Such a
/// chain may be as long as the reasoning in a substate, so this is a loop and not a recursion.
void PreferenceChanges::Drain() {
  if (unused_.empty() || draining_) return;
  draining_ = true;
  while (!unused_.empty()) {
    const PreferenceId id = unused_.back();
    unused_.pop_back();
    Free(id);
  }
  draining_ = false;
}

void PreferenceChanges::UnlinkFromLists(PreferenceId id) {
  WorkingMemory& memory = core_.memory;
  Preference& preference = memory.mutable_preference(id);
  if (preference.previous_of_instantiation != PreferenceId::kNone) {
    memory.mutable_preference(preference.previous_of_instantiation).next_of_instantiation =
        preference.next_of_instantiation;
  } else {
    core_.instantiations[preference.instantiation].preferences = preference.next_of_instantiation;
  }
  if (preference.next_of_instantiation != PreferenceId::kNone) {
    memory.mutable_preference(preference.next_of_instantiation).previous_of_instantiation =
        preference.previous_of_instantiation;
  }
  LeaveClones(id);
}

void PreferenceChanges::LeaveClones(PreferenceId id) {
  WorkingMemory& memory = core_.memory;
  Preference& preference = memory.mutable_preference(id);
  if (preference.previous_clone != PreferenceId::kNone) {
    memory.mutable_preference(preference.previous_clone).next_clone = preference.next_clone;
  }
  if (preference.next_clone != PreferenceId::kNone) {
    memory.mutable_preference(preference.next_clone).previous_clone = preference.previous_clone;
  }
  preference.previous_clone = preference.next_clone = PreferenceId::kNone;
}

void PreferenceChanges::FreeInstantiation(InstantiationId id) {
  const Instantiation& instantiation = core_.instantiations[id];
  if (instantiation.preferences != PreferenceId::kNone || instantiation.held || instantiation.match != MatchId::kNone ||
      !instantiation.live) {
    return;
  }
  if (instantiation.justification != 0xFFFFFFFFu) core_.justifier.InstantiationFreed(id);
  if (instantiation.copied) core_.chunker.ForgetCopied(id);
  if (instantiation.turned) core_.chunker.ForgetTurned(id);
  for (const ConditionTrace& trace : core_.instantiations.Trace(id)) {
    core_.changes.DropReference(trace.wme);
    if (trace.preference != PreferenceId::kNone) DropReferenceLater(trace.preference);
  }
  if (instantiation.selection != SelectionKnowledge::kNone) {
    core_.selections.DropReference(instantiation.selection, true);
  }
  if (instantiation.production != ProductionId::kNone) core_.rete.matches().LetGoOfRule(instantiation.production);
  core_.instantiations.Free(id);
}

void PreferenceChanges::LinkToGoal(InstantiationId id) {
  if (core_.instantiations[id].level < 2) return;
  for (PreferenceId p = core_.instantiations[id].preferences; p != PreferenceId::kNone;
       p = core_.memory.preference(p).next_of_instantiation) {
    LinkToGoal(p);
  }
}

void PreferenceChanges::LeaveGoal(PreferenceId id) {
  UnlinkFromGoal(id);
  // From now on, preferences that depend on the result at another level do not keep this one alive. This one does not
  // keep the others alive either.
  const Preference& preference = core_.memory.preference(id);
  const PreferenceId other =
      preference.next_clone != PreferenceId::kNone ? preference.next_clone : preference.previous_clone;
  AddReference(id);
  LeaveClones(id);
  if (other != PreferenceId::kNone) FreeIfUnused(other);
  Retract(id);
  DropReference(id);
}

void PreferenceChanges::LinkToGoal(PreferenceId id) {
  Preference& preference = core_.memory.mutable_preference(id);
  Goal& goal = core_.goals.at(preference.level);
  preference.on_goal_list = true;
  preference.previous_of_goal = PreferenceId::kNone;
  preference.next_of_goal = goal.preferences;
  if (goal.preferences != PreferenceId::kNone) {
    core_.memory.mutable_preference(goal.preferences).previous_of_goal = id;
  } else {
    goal.oldest_preference = id;
  }
  goal.preferences = id;
}

void PreferenceChanges::UnlinkFromGoal(PreferenceId id) {
  WorkingMemory& memory = core_.memory;
  Preference& preference = memory.mutable_preference(id);
  Goal& goal = core_.goals.at(preference.level);
  preference.on_goal_list = false;
  if (preference.previous_of_goal != PreferenceId::kNone) {
    memory.mutable_preference(preference.previous_of_goal).next_of_goal = preference.next_of_goal;
  } else {
    goal.preferences = preference.next_of_goal;
  }
  if (preference.next_of_goal != PreferenceId::kNone) {
    memory.mutable_preference(preference.next_of_goal).previous_of_goal = preference.previous_of_goal;
  } else {
    goal.oldest_preference = preference.previous_of_goal;
  }
}

/// A slot keeps its place in the list from its first change.
void PreferenceChanges::NoteAcceptablesChanged(SlotId id) {
  Slot& slot = core_.memory.mutable_slot(id);
  if (slot.acceptables_changed) return;
  slot.acceptables_changed = true;
  changed_acceptables_.push_back(id);
}

void PreferenceChanges::MarkChanged(SlotId id) {
  Slot& slot = core_.memory.mutable_slot(id);
  if (slot.is_operator) {
    if (!core_.memory.known_identifier(slot.id).is_goal) {
      NoteAcceptablesChanged(id);
      return;
    }
    core_.decision.NoteContextChanged(core_.memory.level(slot.id));
    slot.changed = true;
    slot.changed_since_selected = true;
    return;
  }
  MarkOrdinary(id, slot);
}

void PreferenceChanges::FreeEmptySlots() {
  for (const SlotId slot : empty_slots_) {
    const Slot& record = core_.memory.slot(slot);
    if (record.live && !record.changed && !record.is_operator && core_.memory.SlotIsEmpty(slot)) {
      core_.memory.FreeSlot(slot);
    }
  }
  empty_slots_.clear();
}

void PreferenceChanges::Clear() {
  changed_slots_.clear();
  changed_acceptables_.clear();
  empty_slots_.clear();
  unused_.clear();
  retired_.clear();
  prohibits_ = 0;
}

}  // namespace soarbox::kernel
