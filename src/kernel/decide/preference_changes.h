// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

struct Engine;

/// Preferences enter and leave slots here, and slots are marked for decision. Keeps the lists of preferences per
/// instantiation and per goal, the links that preferences make, and frees preferences and instantiations that nothing
/// refers to.
class PreferenceChanges {
 public:
  explicit PreferenceChanges(Engine& engine) : engine_(engine) {
    for (std::vector<SlotId>* list : {&changed_slots_, &changed_acceptables_, &empty_slots_}) list->reserve(16);
    for (std::vector<PreferenceId>* list : {&unused_, &rejected_, &retired_}) list->reserve(16);
  }

  /// A preference of an instantiation, at the head of its list; not in a slot yet. Of `content` only the symbols, the
  /// type, the support and the action count.
  PreferenceId Make(InstantiationId instantiation, const Preference& content);
  PreferenceId Make(InstantiationId instantiation, Symbol id, Symbol attribute, Symbol value, Symbol referent,
                    PreferenceType type, bool o_supported, std::uint16_t action = 0);
  /// Puts it in its slot, unless the top state has the same o-supported fact already. False if it was not added.
  bool Assert(PreferenceId preference);
  /// Takes it out of its slot and drops the slot's reference. While there are substates it lives on until its slot has
  /// been decided: until then the element that it made may be matched, and learning asks for the element's maker.
  void Retract(PreferenceId preference);
  /// How many preferences in slots prohibit something.
  std::uint32_t prohibits() const { return prohibits_; }
  /// How many retracted preferences wait for their slots to be decided.
  std::size_t retired() const { return retired_.size(); }
  /// Those, the longest waiting first.
  const std::vector<PreferenceId>& retired_preferences() const { return retired_; }
  /// Lets go of the `count` that have waited longest.
  void ReleaseRetired(std::size_t count);
  /// Removes the selected operator of a goal's slot, and the hold of its element on its preference.
  void RemoveSelected(SlotId slot);
  /// Removes every preference for the same value from the slot of an o-supported reject.
  void ApplyOReject(PreferenceId reject);
  /// Marks the clones of a reject as spent.
  void SpendClones(PreferenceId reject);
  /// Takes the preference from among those of the same result at other levels.
  void LeaveClones(PreferenceId preference);
  /// Puts the preferences of a new instantiation of a substate on its goal's list: they go when the goal goes.
  void LinkToGoal(InstantiationId instantiation);
  /// The goal is going: takes the preference out of its slot and off the goal's list.
  void LeaveGoal(PreferenceId preference);
  /// True if an o-supported reject was made since the last call.
  bool TakeORejectMade() { return std::exchange(o_reject_made_, false); }
  void AddReference(PreferenceId preference);
  void DropReference(PreferenceId preference);
  /// The same while others are being freed: it goes with the next one.
  void DropReferenceLater(PreferenceId preference);
  /// Frees the preference if nothing refers to it.
  void FreeIfUnused(PreferenceId preference);
  /// Frees the instantiation if it no longer matches and has no preferences.
  void FreeIfUnused(InstantiationId instantiation);

  /// Marks a slot for decision in this working memory phase, or its goal for the decide phase.
  void MarkChanged(SlotId slot);
  /// Slots to decide, in order of change; the newest is decided first.
  std::vector<SlotId>& changed_slots() { return changed_slots_; }
  /// Operator slots whose acceptable or require preferences changed.
  std::vector<SlotId>& changed_acceptables() { return changed_acceptables_; }
  /// Slots to free at the end of the phase if they are empty.
  std::vector<SlotId>& empty_slots() { return empty_slots_; }
  [[gnu::flatten]] void FreeEmptySlots();
  void Clear();

 private:
  void MarkOrdinary(SlotId id, Slot& slot) {
    if (slot.changed) return;
    slot.changed = true;
    changed_slots_.push_back(id);
  }
  void LinkToGoal(PreferenceId preference);
  void UnlinkFromGoal(PreferenceId preference);
  void UnlinkFromLists(PreferenceId preference);
  void FreeInstantiation(InstantiationId instantiation);
  void NoteAcceptablesChanged(SlotId slot);
  void NoteUnused(PreferenceId preference);
  void Free(PreferenceId preference);
  void Drain();

  Engine& engine_;
  std::vector<SlotId> changed_slots_, changed_acceptables_, empty_slots_;
  std::vector<PreferenceId> unused_, rejected_, retired_;
  std::uint32_t last_stamp_ = 0, prohibits_ = 0;
  bool draining_ = false;
  bool o_reject_made_ = false;
};

}  // namespace soarbox::kernel
