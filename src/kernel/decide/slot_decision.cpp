// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/slot_decision.h"

#include <algorithm>

#include "kernel/decide/decision.h"
#include "kernel/decide/goal_dependency_set.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/memory/large_slots.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {
namespace {

std::uint32_t HashValue(Symbol value) {
  return static_cast<std::uint32_t>((value.bits() * 0x9E3779B97F4A7C15ull) >> 32);
}

}  // namespace

// Values of the current slot ------------------------------------------------------------------------------------------

void SlotDecision::ResetValues() {
  if (indexed_ > 0) std::fill(table_.begin(), table_.end(), kNowhere);
  indexed_ = 0;
  values_.clear();
  excluded_.clear();
}

std::uint32_t SlotDecision::FindValue(Symbol value) const {
  if (values_.size() <= kLinearLimit) {
    for (std::uint32_t place = 0; place < values_.size(); ++place) {
      if (values_[place].value == value) return place;
    }
    return kNowhere;
  }
  const std::uint32_t mask = static_cast<std::uint32_t>(table_.size()) - 1;
  for (std::uint32_t slot = HashValue(value) & mask;; slot = (slot + 1) & mask) {
    if (table_[slot] == kNowhere) return kNowhere;
    if (values_[table_[slot]].value == value) return table_[slot];
  }
}

void SlotDecision::IndexValue(std::uint32_t place) {
  const std::uint32_t mask = static_cast<std::uint32_t>(table_.size()) - 1;
  std::uint32_t slot = HashValue(values_[place].value) & mask;
  while (table_[slot] != kNowhere) slot = (slot + 1) & mask;
  table_[slot] = place;
}

void SlotDecision::AddValue(Symbol value, PreferenceId preference) {
  if (FindValue(value) != kNowhere) return;
  if (!excluded_.empty() && std::find(excluded_.begin(), excluded_.end(), value) != excluded_.end()) return;
  values_.push_back({value, preference, false});
  if (values_.size() <= kLinearLimit) return;
  if (values_.size() * 2 > table_.size()) {
    table_.assign(std::max<std::size_t>(32, table_.size() * 2), kNowhere);
    indexed_ = 0;
  }
  for (; indexed_ < values_.size(); ++indexed_) IndexValue(static_cast<std::uint32_t>(indexed_));
}

// Ordinary slots ------------------------------------------------------------------------------------------------------

void SlotDecision::DecideChangedSlots() {
  std::vector<SlotId>& changed = uses_.preferences.changed_slots();
  while (!changed.empty()) {
    const SlotId id = changed.back();
    changed.pop_back();
    Slot& slot = uses_.memory.mutable_slot(id);
    if (!slot.live || !slot.changed) continue;
    slot.changed = false;
    const PreferenceId only = slot.acceptable;
    if (slot.others == PreferenceId::kNone &&
        (only == PreferenceId::kNone || uses_.memory.preference(only).next_in_slot == PreferenceId::kNone)) {
      DecideSingle(id, only);
    } else if (LargeSlot* const large = uses_.memory.Large(id); large != nullptr && !large->all_changed) {
      DecideLarge(id, *large);
    } else {
      Decide(id);
    }
    if (slot.is_large) [[unlikely]]
      uses_.memory.Large(id)->Settle(slot.others != PreferenceId::kNone);
  }
}

void SlotDecision::Decide(SlotId slot_id) {
  WorkingMemory& memory = uses_.memory;
  const Slot& slot = memory.slot(slot_id);
  ResetValues();
  for (PreferenceId p = slot.others; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    const PreferenceType type = memory.preference(p).type;
    if (type == PreferenceType::kReject || type == PreferenceType::kProhibit) {
      excluded_.push_back(memory.preference(p).value);
    }
  }
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    AddValue(memory.preference(p).value, p);
  }
  // Keeps the elements that still have a value and removes the others.
  WmeId next;
  for (WmeId wme = slot.wmes; wme != WmeId::kNone; wme = next) {
    next = memory.record(wme).next;
    const std::uint32_t place = FindValue(memory.wme(wme).value);
    if (place == kNowhere) {
      uses_.changes.Lose(wme);
    } else {
      values_[place].present = true;
      memory.mutable_record(wme).preference = values_[place].preference;
    }
  }
  // New elements are created in candidate order, the reverse of the list of preferences.
  for (std::size_t n = values_.size(); n-- > 0;) {
    if (!values_[n].present) MakeElement(slot_id, values_[n]);
  }
  if (memory.SlotIsEmpty(slot_id)) uses_.preferences.empty_slots().push_back(slot_id);
}

// Like Decide, for the values that changed.
void SlotDecision::DecideLarge(SlotId slot_id, const LargeSlot& large) {
  WorkingMemory& memory = uses_.memory;
  const Slot& slot = memory.slot(slot_id);
  changed_ = large.changed;
  std::sort(changed_.begin(), changed_.end(), [](Symbol a, Symbol b) { return a.bits() < b.bits(); });
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  values_.clear();
  lost_.clear();
  for (const Symbol symbol : changed_) {
    const LargeSlot::Value* const known = large.Find(symbol);
    if (known == nullptr) continue;
    if (known->acceptable == 0) {
      lost_.push_back(known->wme);
      continue;
    }
    PreferenceId first = known->only;
    if (first == PreferenceId::kNone) {
      first = slot.acceptable;
      while (memory.preference(first).value != symbol) first = memory.preference(first).next_in_slot;
    }
    if (known->wme == WmeId::kNone) {
      values_.push_back({symbol, first, false});
    } else {
      memory.mutable_record(known->wme).preference = first;
    }
  }
  std::sort(lost_.begin(), lost_.end(),
            [&](WmeId a, WmeId b) { return memory.wme(a).timetag > memory.wme(b).timetag; });
  for (const WmeId wme : lost_) uses_.changes.Lose(wme);
  std::sort(values_.begin(), values_.end(), [&](const Value& a, const Value& b) {
    const Preference& p = memory.preference(a.preference);
    const Preference& q = memory.preference(b.preference);
    return p.level != q.level ? p.level > q.level : p.stamp < q.stamp;
  });
  for (const Value& value : values_) MakeElement(slot_id, value);
  if (memory.SlotIsEmpty(slot_id)) uses_.preferences.empty_slots().push_back(slot_id);
}

void SlotDecision::MakeElement(SlotId slot_id, const Value& value) {
  const Slot& slot = uses_.memory.slot(slot_id);
  const WmeId wme = uses_.changes.Add(WmeKind::kSlot, slot.id, slot.attribute, value.value, slot_id, value.preference);
  if (slot.substate_facts != 0) uses_.gds.NoteNewFact(wme);
}

void SlotDecision::DecideSingle(SlotId slot_id, PreferenceId only) {
  WorkingMemory& memory = uses_.memory;
  const Symbol value = only == PreferenceId::kNone ? Symbol() : memory.preference(only).value;
  const Slot& slot = memory.slot(slot_id);
  bool present = false;
  WmeId next;
  for (WmeId wme = slot.wmes; wme != WmeId::kNone; wme = next) {
    WmeRecord& record = memory.mutable_record(wme);
    next = record.next;
    if (memory.wme(wme).value == value) {
      present = true;
      record.preference = only;
    } else {
      uses_.changes.Lose(wme);
    }
  }
  if (value) {
    if (!present) MakeElement(slot_id, {value, only, false});
  } else if (slot.wmes == WmeId::kNone && slot.acceptable_wmes == WmeId::kNone) {
    uses_.preferences.empty_slots().push_back(slot_id);
  }
}

// Operator slots ------------------------------------------------------------------------------------------------------

void SlotDecision::UpdateAcceptables() {
  std::vector<SlotId>& changed = uses_.preferences.changed_acceptables();
  // The slot that was added to the list last is first. Removing an operator may add slots of the states below.
  while (!changed.empty()) {
    const SlotId slot = changed.back();
    changed.pop_back();
    const Slot& record = uses_.memory.slot(slot);
    if (record.live && (record.is_operator || record.acceptable_wmes != WmeId::kNone)) UpdateAcceptables(slot);
    uses_.memory.mutable_slot(slot).acceptables_changed = false;
  }
}

void SlotDecision::UpdateAcceptables(SlotId slot_id) {
  WorkingMemory& memory = uses_.memory;
  ResetValues();
  const Slot& slot = memory.slot(slot_id);
  // Required values are added first.
  for (PreferenceId p = slot.others; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).type == PreferenceType::kRequire) AddValue(memory.preference(p).value, p);
  }
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    AddValue(memory.preference(p).value, p);
  }
  WmeId next;
  for (WmeId wme = slot.acceptable_wmes; wme != WmeId::kNone; wme = next) {
    next = memory.record(wme).next;
    const std::uint32_t place = FindValue(memory.wme(wme).value);
    if (place != kNowhere) {
      values_[place].present = true;
      memory.mutable_record(wme).preference = values_[place].preference;
      continue;
    }
    if (slot.wmes != WmeId::kNone && memory.wme(slot.wmes).value == memory.wme(wme).value) {
      uses_.decision.RemoveOperator(memory.level(slot.id), OperatorRemoval::kProposalGone, wme);
    }
    uses_.changes.Lose(wme);
  }
  if (!memory.identifier(slot.id).is_goal) {
    // The goal was removed: the slot is now an ordinary empty slot.
    memory.mutable_slot(slot_id).is_operator = false;
    memory.mutable_slot(slot_id).changed = false;
    uses_.preferences.empty_slots().push_back(slot_id);
    return;
  }
  const std::size_t count = values_.size();
  for (std::size_t n = 0; n < count; ++n) {
    if (values_[n].present) continue;
    const Value value = values_[n];
    const WmeId wme = uses_.changes.AddAcceptable(slot_id, value.value, value.preference);
    if (slot.substate_facts != 0) uses_.gds.NoteNewFact(wme);
  }
}

}  // namespace soarbox::kernel
