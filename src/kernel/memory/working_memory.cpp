// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/memory/working_memory.h"

#include <cassert>

namespace soarbox::kernel {

const IdentifierRecord WorkingMemory::kUnknownIdentifier{};

WorkingMemory::WorkingMemory(SymbolTable& symbols) : symbols_(symbols) {
  // Enough for a small agent, so that its first decisions do not allocate more than later ones.
  constexpr std::size_t kUsual = 64;
  wmes_.reserve(kUsual);
  records_.reserve(kUsual);
  free_wmes_.reserve(kUsual);
}
WorkingMemory::~WorkingMemory() = default;

// Reading -------------------------------------------------------------------------------------------------------------

SlotId WorkingMemory::FindSlot(Symbol id, Symbol attribute) const {
  return FindSlot(identifier(id), id, attribute);
}

inline SlotId WorkingMemory::FindSlot(const IdentifierRecord& owner, Symbol id, Symbol attribute) const {
  if (owner.slots_indexed) return slot_index_.Find(id, attribute);
  for (SlotId slot = owner.slots; slot != SlotId::kNone;) {
    const Slot& record = *slot.record;
    if (record.attribute == attribute) return slot;
    slot = record.next;
  }
  return SlotId::kNone;
}

std::vector<WmeId> WorkingMemory::WmesOf(Symbol id) const {
  std::vector<WmeId> found;
  found.reserve(8);  // Most objects have fewer elements.
  ForEachWmeOf(id, [&](WmeId wme) { found.push_back(wme); });
  return found;
}

Symbol WorkingMemory::ValueOf(Symbol id, Symbol attribute) const {
  const SlotId slot = FindSlot(id, attribute);
  if (slot != SlotId::kNone && this->slot(slot).wmes != WmeId::kNone) return wme(this->slot(slot).wmes).value;
  const IdentifierRecord& identifier = this->identifier(id);
  for (const WmeId first : {identifier.architecture_wmes, identifier.input_wmes}) {
    for (WmeId wme = first; wme != WmeId::kNone; wme = record(wme).next) {
      if (this->wme(wme).attribute == attribute) return this->wme(wme).value;
    }
  }
  return {};
}

WmeId WorkingMemory::FindByTimetag(std::uint64_t timetag) const {
  for (std::uint32_t index = 0; index < wmes_.size(); ++index) {
    if (wmes_[index].live && wmes_[index].timetag == timetag) return static_cast<WmeId>(index);
  }
  return WmeId::kNone;
}

// Elements ------------------------------------------------------------------------------------------------------------

WmeId WorkingMemory::Make(WmeKind kind, Symbol id, Symbol attribute, Symbol value, bool acceptable, SlotId slot) {
  WmeId wme;
  if (!free_wmes_.empty()) {
    wme = free_wmes_.back();
    free_wmes_.pop_back();
    records_[Index(wme)] = WmeRecord{};
  } else {
    wme = static_cast<WmeId>(wmes_.size());
    wmes_.emplace_back();
    records_.emplace_back();
  }
  Wme& content = wmes_[Index(wme)];
  content.id = id;
  content.attribute = attribute;
  content.value = value;
  content.acceptable = acceptable;
  content.live = true;
  content.timetag = next_timetag_++;
  ++live_wmes_;

  WmeRecord& record = records_[Index(wme)];
  record.kind = kind;
  record.SetSlot(slot);
  PutFirst(wme, record);
  if (kind == WmeKind::kSlot && slot.record->is_large) [[unlikely]]
    LargeOf(*slot.record).SetWme(value, wme);
  return wme;
}

WmeId& WorkingMemory::ListHead(const WmeRecord& record, const Wme& content) {
  switch (record.kind) {
    case WmeKind::kSlot:
      return record.slot().record->wmes;
    case WmeKind::kAcceptable:
      return record.slot().record->acceptable_wmes;
    case WmeKind::kArchitecture:
      return identifiers_[content.id.index()].architecture_wmes;
    case WmeKind::kInput:
    case WmeKind::kFree:
      break;
  }
  return identifiers_[content.id.index()].input_wmes;
}

inline void WorkingMemory::PutFirst(WmeId wme, WmeRecord& record) {
  WmeId& head = ListHead(record, wmes_[Index(wme)]);
  record.next = head;
  if (head != WmeId::kNone) records_[Index(head)].previous = wme;
  head = wme;
}

inline void WorkingMemory::TakeOut(WmeId wme, WmeRecord& record) {
  if (record.previous != WmeId::kNone) {
    records_[Index(record.previous)].next = record.next;
  } else {
    ListHead(record, wmes_[Index(wme)]) = record.next;
  }
  if (record.next != WmeId::kNone) records_[Index(record.next)].previous = record.previous;
  record.next = record.previous = WmeId::kNone;
}

void WorkingMemory::Unlink(WmeId wme) {
  WmeRecord& record = records_[Index(wme)];
  TakeOut(wme, record);
  if (record.kind == WmeKind::kSlot && record.slot().record->is_large) [[unlikely]] {
    LargeOf(*record.slot().record).SetWme(wmes_[Index(wme)].value, WmeId::kNone);
  }
  record.kind = WmeKind::kFree;
  wmes_[Index(wme)].live = false;
  --live_wmes_;
}

void WorkingMemory::Make(WmeId wme, Symbol value) {
  Wme& content = wmes_[Index(wme)];
  content.value = value;
  content.timetag = next_timetag_++;
  WmeRecord& record = records_[Index(wme)];
  if (record.previous == WmeId::kNone) return;  // It is at the head of its list already.
  TakeOut(wme, record);
  PutFirst(wme, record);
}

void WorkingMemory::Free(std::span<const WmeId> wmes) {
  for ([[maybe_unused]] const WmeId wme : wmes) {
    assert(!wmes_[Index(wme)].live && records_[Index(wme)].references == 0);
  }
  free_wmes_.insert(free_wmes_.end(), wmes.begin(), wmes.end());
}

// Identifiers ---------------------------------------------------------------------------------------------------------

/// Grows by a quarter each time, because there are many agents with few identifiers.
void WorkingMemory::MakeRoomForIdentifiers(std::size_t count) {
  const std::size_t room = count + count / 4 + 8;
  identifiers_.reserve(room);
  goal_levels_.reserve(room);
  long_term_.reserve(room);
}

Symbol WorkingMemory::NewIdentifier(char letter, GoalLevel level) {
  return NewIdentifier(symbols_.NewIdentifier(letter), level);
}

Symbol WorkingMemory::NewIdentifier(Symbol id, GoalLevel level) {
  if (id.index() >= identifier_limit_) {
    if (id.index() >= identifiers_.capacity()) MakeRoomForIdentifiers(id.index() + std::size_t{1});
    identifier_limit_ = id.index() + 1;
    identifiers_.resize(id.index() + 1);
    goal_levels_.resize(id.index() + 1, 0);
    long_term_.resize(id.index() + 1, 0);
  }
  IdentifierRecord& record = identifiers_[id.index()];
  record = IdentifierRecord{};
  record.live = true;
  record.level = level;
  ++live_identifiers_;
  return id;
}

void WorkingMemory::SetGoal(Symbol id, GoalLevel level) {
  identifiers_[id.index()].is_goal = true;
  goal_levels_[id.index()] = level;
}

void WorkingMemory::ClearGoal(Symbol id) {
  identifiers_[id.index()].is_goal = false;
  goal_levels_[id.index()] = 0;
}

void WorkingMemory::FreeIdentifier(Symbol id) {
  identifiers_[id.index()] = IdentifierRecord{};
  goal_levels_[id.index()] = 0;
  long_term_[id.index()] = 0;
  symbols_.FreeIdentifier(id);
  --live_identifiers_;
}

// Slots ---------------------------------------------------------------------------------------------------------------

SlotId WorkingMemory::FindOrMakeSlot(Symbol id, Symbol attribute, bool is_operator) {
  const SlotId found = FindSlot(known_identifier(id), id, attribute);
  if (found != SlotId::kNone) return found;
  const SlotId made = slots_.Take();
  Slot& slot = *made.record;
  slot.id = id;
  slot.attribute = attribute;
  slot.live = true;
  slot.is_operator = is_operator;
  IdentifierRecord& owner = identifiers_[id.index()];
  slot.next = owner.slots;
  if (owner.slots != SlotId::kNone) owner.slots.record->previous = made;
  owner.slots = made;
  if (owner.slots_indexed) {
    slot_index_.Insert(id, attribute, made);
  } else if (++owner.slot_count > kFewSlots) {
    IndexSlots(id);
  }
  return made;
}

void WorkingMemory::IndexSlots(Symbol id) {
  IdentifierRecord& owner = identifiers_[id.index()];
  owner.slots_indexed = true;
  for (SlotId slot = owner.slots; slot != SlotId::kNone; slot = slot.record->next) {
    slot_index_.Insert(id, slot.record->attribute, slot);
  }
}

void WorkingMemory::FreeSlot(SlotId id) {
  Slot& slot = *id.record;
  assert(slot.live && SlotIsEmpty(id));
  IdentifierRecord& owner = identifiers_[slot.id.index()];
  if (slot.previous != SlotId::kNone) {
    slot.previous.record->next = slot.next;
  } else {
    owner.slots = slot.next;
  }
  if (slot.next != SlotId::kNone) slot.next.record->previous = slot.previous;
  if (owner.slots_indexed) {
    slot_index_.Erase(slot.id, slot.attribute);
  } else {
    --owner.slot_count;
  }
  slot.live = false;
  slots_.Give(id);
}

bool WorkingMemory::SlotIsEmpty(SlotId id) const {
  const Slot& slot = *id.record;
  return slot.wmes == WmeId::kNone && slot.acceptable_wmes == WmeId::kNone && slot.acceptable == PreferenceId::kNone &&
         slot.others == PreferenceId::kNone;
}

// Preferences ---------------------------------------------------------------------------------------------------------

PreferenceId WorkingMemory::MakePreference() {
  const PreferenceId made = preferences_.Take();
  made.record->live = true;
  return made;
}

void WorkingMemory::InsertInSlot(PreferenceId id, SlotId slot_id) {
  Preference& preference = *id.record;
  Slot& slot = *slot_id.record;
  preference.slot = slot_id;
  preference.in_slot = true;
  ++preference.references;
  PreferenceId& head = preference.type == PreferenceType::kAcceptable ? slot.acceptable : slot.others;
  if (preference.type == PreferenceType::kAcceptable) {
    ++slot.acceptable_count;
    if (preference.o_supported && preference.level > 1) ++slot.substate_facts;
  }
  if (slot.is_large) [[unlikely]]
    LargeOf(slot).Insert(id);
  // Inserts before the first preference that does not belong to a higher goal.
  PreferenceId before = head, after = PreferenceId::kNone;
  while (before != PreferenceId::kNone && before.record->level < preference.level) {
    after = before;
    before = before.record->next_in_slot;
  }
  preference.next_in_slot = before;
  preference.previous_in_slot = after;
  if (before != PreferenceId::kNone) before.record->previous_in_slot = id;
  if (after != PreferenceId::kNone) {
    after.record->next_in_slot = id;
  } else {
    head = id;
  }
}

void WorkingMemory::RemoveFromSlot(PreferenceId id) {
  Preference& preference = *id.record;
  Slot& slot = *preference.slot.record;
  if (preference.previous_in_slot != PreferenceId::kNone) {
    preference.previous_in_slot.record->next_in_slot = preference.next_in_slot;
  } else if (preference.type == PreferenceType::kAcceptable) {
    slot.acceptable = preference.next_in_slot;
  } else {
    slot.others = preference.next_in_slot;
  }
  if (preference.next_in_slot != PreferenceId::kNone) {
    preference.next_in_slot.record->previous_in_slot = preference.previous_in_slot;
  }
  if (preference.type == PreferenceType::kAcceptable) {
    --slot.acceptable_count;
    if (preference.o_supported && preference.level > 1) --slot.substate_facts;
  }
  if (slot.is_large) [[unlikely]] {
    LargeOf(slot).Remove(id);
    if (slot.acceptable_count == 0) {
      large_slots_.erase(&slot);
      slot.is_large = false;
    }
  }
  preference.next_in_slot = preference.previous_in_slot = PreferenceId::kNone;
  preference.slot = SlotId::kNone;
  preference.in_slot = false;
  --preference.references;
}

// Large slots ---------------------------------------------------------------------------------------------------------

bool WorkingMemory::HasTopFact(SlotId slot, Symbol value) {
  if (const LargeSlot* const large = Large(slot)) {
    const LargeSlot::Value* const known = large->Find(value);
    return known != nullptr && known->top_facts != 0;
  }
  for (PreferenceId p = slot.record->acceptable; p != PreferenceId::kNone; p = p.record->next_in_slot) {
    if (p.record->level > 1) break;  // Those of the top state are first.
    if (p.record->o_supported && p.record->value == value) return true;
  }
  return false;
}

LargeSlot& WorkingMemory::LargeOf(Slot& slot) {
  if (!slot.is_large) {
    large_slots_[&slot] = Describe(slot);
    slot.is_large = true;
  }
  return large_slots_.find(&slot)->second;
}

LargeSlot WorkingMemory::Describe(const Slot& slot) const {
  LargeSlot large;
  for (PreferenceId p = slot.acceptable; p != PreferenceId::kNone; p = p.record->next_in_slot) large.Insert(p);
  for (WmeId wme = slot.wmes; wme != WmeId::kNone; wme = record(wme).next) large.SetWme(this->wme(wme).value, wme);
  large.changed.clear();
  return large;
}

bool WorkingMemory::LargeSlotsAreRight() const {
  std::size_t count = 0;
  bool right = true;
  ForEachSlot([&](SlotId slot) {
    if (!slot.record->is_large) return;
    ++count;
    const auto at = large_slots_.find(slot.record);
    right = right && at != large_slots_.end() && at->second.values == Describe(*slot.record).values;
  });
  return right && count == large_slots_.size();
}

void WorkingMemory::FreePreference(PreferenceId id) {
  assert(id.record->references == 0 && !id.record->in_slot);
  id.record->live = false;
  preferences_.Give(id);
}

void WorkingMemory::Clear() {
  for (std::uint32_t index = 0; index < identifiers_.size(); ++index) {
    if (identifiers_[index].live) symbols_.FreeIdentifier(Symbol(Symbol::Tag::kIdentifier, index));
  }
  wmes_.clear();
  records_.clear();
  free_wmes_.clear();
  slots_.Clear();
  preferences_.Clear();
  identifiers_.clear();
  identifier_limit_ = 0;
  goal_levels_.clear();
  long_term_.clear();
  slot_index_.Clear();
  large_slots_.clear();
  next_timetag_ = 1;
  live_wmes_ = 0;
  live_identifiers_ = 0;
}

std::size_t WorkingMemory::MemoryBytes() const {
  std::size_t large = 0;
  for (const auto& [slot, known] : large_slots_) {
    using Known = decltype(known.values)::value_type;
    large += sizeof(known) + known.values.size() * (sizeof(Known) + 2 * sizeof(void*));
  }
  return wmes_.capacity() * sizeof(Wme) + records_.capacity() * sizeof(WmeRecord) +
         free_wmes_.capacity() * sizeof(WmeId) + slots_.MemoryBytes() + preferences_.MemoryBytes() +
         identifiers_.capacity() * sizeof(IdentifierRecord) + goal_levels_.capacity() * sizeof(GoalLevel) +
         long_term_.capacity() * sizeof(std::uint64_t) + slot_index_.MemoryBytes() + large;
}

}  // namespace soarbox::kernel
