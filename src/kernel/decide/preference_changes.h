// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

struct AgentCore;

/// Asserts and retracts preferences, and marks slots for decision. Maintains the lists of preferences per instantiation
/// and per goal, and the links of preferences. Frees preferences and instantiations that are no longer referred to.
class PreferenceChanges {
 public:
  explicit PreferenceChanges(AgentCore& core) : core_(core) {
    for (std::vector<SlotId>* list : {&changed_slots_, &changed_acceptables_, &empty_slots_}) list->reserve(16);
    for (std::vector<PreferenceId>* list : {&unused_, &rejected_, &retired_}) list->reserve(16);
  }

  /// Creates a preference at the head of its instantiation's list, not yet in a slot. Of `content`, only the symbols,
  /// the type, the support and the action are used.
  PreferenceId Make(InstantiationId instantiation, const Preference& content);
  PreferenceId Make(InstantiationId instantiation, Symbol id, Symbol attribute, Symbol value, Symbol referent,
                    PreferenceType type, bool o_supported, std::uint16_t action = 0);
  /// Adds it to its slot. But an acceptable, o-supported preference of the top state is not added if the slot already
  /// has one for the same value: then returns false. Exceptions: operator slots, and keep-all-top-oprefs.
  bool Assert(PreferenceId preference);
  /// Removes it from its slot and drops the slot's reference. If there are substates, it stays alive until its slot has
  /// been decided. Until then rules may match its element, and learning needs the element's creator.
  void Retract(PreferenceId preference);
  /// Number of prohibit preferences in slots.
  std::uint32_t prohibits() const { return prohibits_; }
  /// Number of retracted preferences that wait for the decision of their slots.
  std::size_t retired() const { return retired_.size(); }
  /// The retracted preferences that wait, the longest waiting first.
  const std::vector<PreferenceId>& retired_preferences() const { return retired_; }
  /// Releases the `count` preferences that have waited longest.
  void ReleaseRetired(std::size_t count);
  /// Removes the selected operator of a goal's slot, and the reference of its element to the preference.
  void RemoveSelected(SlotId slot);
  /// Removes every preference for the same value from the slot of an o-supported reject.
  void ApplyOReject(PreferenceId reject);
  /// Marks the clones of a reject as spent.
  void SpendClones(PreferenceId reject);
  /// Removes the preference from its list of clones.
  void LeaveClones(PreferenceId preference);
  /// Adds the preferences of a new instantiation of a substate to its goal's list, so that they are removed with the
  /// goal.
  void LinkToGoal(InstantiationId instantiation);
  /// The goal is being removed: removes the preference from its slot and from the goal's list.
  void LeaveGoal(PreferenceId preference);
  /// True if an o-supported reject was created since the last call.
  bool TakeORejectMade() { return std::exchange(o_reject_made_, false); }
  void AddReference(PreferenceId preference);
  void DropReference(PreferenceId preference);
  /// Like DropReference, for calls while other objects are being freed: the preference is freed together with the next
  /// one.
  void DropReferenceLater(PreferenceId preference);
  /// Frees the preference if it has no references.
  void FreeIfUnused(PreferenceId preference);
  /// Frees the instantiation if it no longer matches and has no preferences.
  void FreeIfUnused(InstantiationId instantiation);

  /// Marks a slot for decision in this working memory phase; for an operator slot, marks its goal for the decide phase.
  void MarkChanged(SlotId slot);
  /// The slots to decide, in the order of their changes. The newest is decided first.
  std::vector<SlotId>& changed_slots() { return changed_slots_; }
  /// Operator slots whose acceptable or require preferences changed.
  std::vector<SlotId>& changed_acceptables() { return changed_acceptables_; }
  /// Slots that are freed at the end of the phase if they are empty.
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

  AgentCore& core_;
  std::vector<SlotId> changed_slots_, changed_acceptables_, empty_slots_;
  std::vector<PreferenceId> unused_, rejected_, retired_;
  std::uint32_t last_stamp_ = 0, prohibits_ = 0;
  bool draining_ = false;
  bool o_reject_made_ = false;
};

}  // namespace soarbox::kernel
