// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/plain_vector.h"
#include "kernel/base/record_arena.h"
#include "kernel/base/symbol.h"
#include "kernel/base/symbol_table.h"
#include "kernel/match/goal_view.h"
#include "kernel/match/wme.h"
#include "kernel/memory/large_slots.h"
#include "kernel/memory/preference.h"
#include "kernel/memory/slot_index.h"

namespace soarbox::kernel {

/// Why an element is in working memory. Determines the list that it is on.
enum class WmeKind : std::uint8_t {
  kFree,
  kSlot,          ///< The value of a slot; of an operator slot: the selected operator.
  kAcceptable,    ///< (S1 ^operator O1 +)
  kArchitecture,  ///< Of a goal: type, superstate, impasse, item, ...
  kInput,         ///< Created by the input link, or by a user's command.
};

/// Marks an element that was in the goal dependency set of a removed goal.
constexpr GoalLevel kGoalOfGdsGone = 0xFFFF;

/// The data of an element that the match does not read.
class WmeRecord {
 public:
  static constexpr std::uint32_t kNoInput = 0xFFFFFFFFu;

  WmeKind kind = WmeKind::kFree;
  bool in_match : 1 = false;  ///< The match contains it.
  bool removing : 1 = false;  ///< Its removal was passed to the match: it is freed when nothing refers to it.
  bool renewed : 1 = false;   ///< In the buffers, it represents both a removed element and its replacement.

 private:
  bool is_input_ : 1 = false;  ///< The union holds input_element_, not slot_.

 public:
  GoalLevel gds = 0;             ///< Level of the goal whose dependency set contains it, kGoalOfGdsGone, or 0.
  std::uint32_t references = 0;  ///< From instantiations of substates, justifications and modules.
  WmeId next = WmeId::kNone, previous = WmeId::kNone;  ///< In the list of the slot or the identifier.
  PreferenceId preference = PreferenceId::kNone;       ///< The preference that caused it, if any.
  LinkId link = LinkId::kNone;  ///< The link to its value, if that is an identifier and no preference holds the link.

  /// For kSlot and kAcceptable.
  SlotId slot() const { return is_input_ ? SlotId::kNone : slot_; }
  void SetSlot(SlotId slot) {
    is_input_ = false;
    slot_ = slot;
  }
  /// For kInput: the input link's element; kNoInput if the input link did not create it.
  std::uint32_t input_element() const { return is_input_ ? input_element_ : kNoInput; }
  void SetInputElement(std::uint32_t element) {
    is_input_ = true;
    input_element_ = element;
  }

 private:
  union {
    SlotId slot_ = SlotId::kNone;
    std::uint32_t input_element_;
  };
};
static_assert(sizeof(WmeRecord) == (sizeof(void*) == 8 ? 40 : 28), "an agent has thousands");

/// The preferences and elements of one (identifier, attribute) pair.
struct Slot {
  Symbol id, attribute;
  bool live = false;
  bool is_operator = false;              ///< ^operator of a goal: decided only in the decide phase.
  bool changed = false;                  ///< It is in the list of changed slots.
  bool is_large : 1 = false;             ///< It has a LargeSlot (large_slots.h).
  bool acceptables_changed : 1 = false;  ///< It is in the list of slots whose acceptable preferences changed.
  bool changed_since_selected : 1 =
      false;                      ///< ^operator of a goal: preferences changed after its operator was selected.
  bool lost_by_hand : 1 = false;  ///< `wm remove` removed an element that still has preferences.
  std::uint32_t acceptable_count = 0;
  std::uint32_t substate_facts = 0;               ///< O-supported acceptable preferences of substates' rules.
  WmeId wmes = WmeId::kNone;                      ///< Newest first.
  WmeId acceptable_wmes = WmeId::kNone;           ///< kAcceptable elements of an operator slot, newest first.
  PreferenceId acceptable = PreferenceId::kNone;  ///< Acceptable preferences: higher goals first, then newest first.
  PreferenceId others = PreferenceId::kNone;      ///< All other types in one list, in the same order.
  SlotId next = SlotId::kNone, previous = SlotId::kNone;  ///< Slots of the identifier, newest first.
};

/// The data of an identifier in working memory. Its size is a power of two, so that indexing needs only a shift.
struct alignas(64) IdentifierRecord {
  bool live = false;
  bool is_goal = false;
  GoalLevel level = 0;           ///< The highest goal (smallest number) from which it is reachable.
  bool rooted = false;           ///< Following its parent links ends at a goal (links.h).
  bool queued = false;           ///< It is in a queue of LinkGraph (links.h).
  bool gone = false;             ///< It is a removed goal: remaining references to it do not keep it alive.
  bool names_itself = false;     ///< It is or was the value of one of its own elements.
  bool slots_indexed = false;    ///< It has had too many slots for a linear search: slot_index_ is used.
  std::uint16_t slot_count = 0;  ///< Number of slots, while not slots_indexed.
  std::uint32_t value_of = 0;    ///< Number of elements of other identifiers with it as their value.
  std::uint32_t item_of = 0;     ///< Those of them that the architecture created; they do not keep it alive.
  SlotId slots = SlotId::kNone;
  WmeId architecture_wmes = WmeId::kNone;  ///< Newest first.
  WmeId input_wmes = WmeId::kNone;         ///< Newest first.
  LinkId first_link = LinkId::kNone;       ///< Links to it (links.h).
  LinkId parent_link = LinkId::kNone;      ///< The link that determines its level.
  LinkId first_child = LinkId::kNone;      ///< Parent links whose source it is.
};

/// Working memory of one agent as a data structure: elements, slots, preferences and identifiers in arenas with free
/// lists. This class keeps lists and counts consistent; decide/ decides what changes, and when.
///
/// Invariants: an element is on exactly one list, that of its kind. A slot's preferences are ordered by level, then
/// newest first. An empty slot is freed at the end of a working memory phase. Time tags only grow. Single-threaded:
/// only the agent's cycle uses it.
class WorkingMemory {
 public:
  explicit WorkingMemory(SymbolTable& symbols);
  ~WorkingMemory();
  WorkingMemory(const WorkingMemory&) = delete;
  WorkingMemory& operator=(const WorkingMemory&) = delete;

  // Reading ---------------------------------------------------------------------------------------------------------

  /// The table that the matcher reads.
  const WmeTable& wmes() const { return wmes_; }
  const Wme& wme(WmeId id) const { return wmes_[Index(id)]; }
  const WmeRecord& record(WmeId id) const { return records_[Index(id)]; }
  const Preference& preference(PreferenceId id) const { return *id.record; }
  const Slot& slot(SlotId id) const { return *id.record; }
  /// The slot of an identifier and attribute, or kNone.
  SlotId FindSlot(Symbol id, Symbol attribute) const;
  /// For a symbol that is no identifier of working memory, the returned record has `live` false.
  const IdentifierRecord& identifier(Symbol id) const {
    if (!id.IsIdentifier() || id.index() >= identifier_limit_) return kUnknownIdentifier;
    return identifiers_[id.index()];
  }
  /// The identifier must be in working memory.
  const IdentifierRecord& known_identifier(Symbol id) const { return identifiers_[id.index()]; }
  GoalLevel level(Symbol id) const { return identifier(id).level; }
  /// The elements of an identifier in the order of `print`: slot by slot, the newest slot first (within a slot the
  /// values, newest first, then the acceptable ones, newest first); then those of the architecture; then input.
  std::vector<WmeId> WmesOf(Symbol id) const;
  /// Like WmesOf, one by one. `visit` must not change working memory.
  template <typename Visit>
  void ForEachWmeOf(Symbol id, Visit&& visit) const {
    const auto visit_list = [&](WmeId first) {
      for (WmeId wme = first; wme != WmeId::kNone; wme = record(wme).next) visit(wme);
    };
    const IdentifierRecord& identifier = this->identifier(id);
    for (SlotId slot = identifier.slots; slot != SlotId::kNone; slot = this->slot(slot).next) {
      visit_list(this->slot(slot).wmes);
      visit_list(this->slot(slot).acceptable_wmes);
    }
    visit_list(identifier.architecture_wmes);
    visit_list(identifier.input_wmes);
  }
  /// The first value of an attribute, of any kind, or the none symbol.
  Symbol ValueOf(Symbol id, Symbol attribute) const;
  /// The live element with a time tag, or kNone. Slow: walks all elements. For commands only.
  WmeId FindByTimetag(std::uint64_t timetag) const;
  std::uint32_t wme_count() const { return live_wmes_; }
  std::uint64_t last_timetag() const { return next_timetag_ - 1; }
  std::uint32_t identifier_limit() const { return identifier_limit_; }
  template <typename Visit>
  void ForEachPreference(Visit&& visit) const {
    preferences_.ForEach([&](PreferenceId id) {
      if (id.record->live) visit(*id.record);
    });
  }
  template <typename Visit>
  void ForEachSlot(Visit&& visit) const {
    slots_.ForEach([&](SlotId id) {
      if (id.record->live) visit(id);
    });
  }
  std::uint32_t identifier_count() const { return live_identifiers_; }
  /// The data on identifiers for the matcher. Valid until the next identifier is created.
  GoalView goal_view() const { return {goal_levels_, long_term_}; }
  /// By identifier index: the level of a goal, or 0; the long-term identifier that it is linked to, or 0.
  std::span<const GoalLevel> goal_levels() const { return goal_levels_; }
  std::span<const std::uint64_t> long_term_identifiers() const { return long_term_; }

  // Elements --------------------------------------------------------------------------------------------------------

  /// Creates an element with the next time tag at the head of its list. The caller informs match and observers.
  WmeId Make(WmeKind kind, Symbol id, Symbol attribute, Symbol value, bool acceptable, SlotId slot = SlotId::kNone);
  /// Gives an element a new constant as its value and a new time tag, in place: equivalent to Unlink and Make, but the
  /// index stays. Nothing may refer to the element.
  void Make(WmeId wme, Symbol value);
  /// Removes the element from its list. Its contents stay readable until Free.
  void Unlink(WmeId wme);
  /// Frees indices; nothing may refer to them any more.
  void Free(std::span<const WmeId> wmes);
  WmeRecord& mutable_record(WmeId id) { return records_[Index(id)]; }

  // Identifiers -----------------------------------------------------------------------------------------------------

  Symbol NewIdentifier(char letter, GoalLevel level);
  /// Adds an identifier that the symbol table has just created.
  Symbol NewIdentifier(Symbol id, GoalLevel level);
  void SetGoal(Symbol id, GoalLevel level);
  void ClearGoal(Symbol id);
  void SetLongTerm(Symbol id, std::uint64_t lti) { long_term_[id.index()] = lti; }
  IdentifierRecord& mutable_identifier(Symbol id) { return identifiers_[id.index()]; }
  void FreeIdentifier(Symbol id);

  // Slots and preferences -------------------------------------------------------------------------------------------

  SlotId FindOrMakeSlot(Symbol id, Symbol attribute, bool is_operator);
  Slot& mutable_slot(SlotId id) { return *id.record; }
  void FreeSlot(SlotId slot);
  bool SlotIsEmpty(SlotId slot) const;

  PreferenceId MakePreference();
  Preference& mutable_preference(PreferenceId id) { return *id.record; }
  /// Inserts a preference into its slot, in the order described at the class. The slot must exist.
  void InsertInSlot(PreferenceId preference, SlotId slot);
  void RemoveFromSlot(PreferenceId preference);
  /// The index of a slot with very many acceptable preferences; null if it has few. Not for operator slots.
  LargeSlot* Large(SlotId id) {
    Slot& slot = *id.record;
    return slot.is_large || slot.acceptable_count > kManyPreferences ? &LargeOf(slot) : nullptr;
  }
  /// Returns whether the slot has an o-supported acceptable preference for `value` on the level of the top state.
  /// Preferences that a substate's rule created do not count, because they are removed with the substate.
  bool HasTopFact(SlotId slot, Symbol value);
  /// True if the indexes of large slots agree with the slots.
  bool LargeSlotsAreRight() const;
  /// Frees a preference; nothing may refer to it.
  void FreePreference(PreferenceId preference);

  /// Removes everything (init-soar); keeps the allocated memory.
  void Clear();

  std::size_t MemoryBytes() const;

 private:
  static const IdentifierRecord kUnknownIdentifier;
  /// Up to this number of slots per identifier, slots are found by walking the list; beyond it, by slot_index_.
  static constexpr std::uint16_t kFewSlots = 4;
  /// A slot with more acceptable preferences has an index in large_slots_. Builds that check invariants use a smaller
  /// limit, so that tests reach it.
#ifdef SOARBOX_CHECK_INVARIANTS
  static constexpr std::uint32_t kManyPreferences = 1;
#else
  static constexpr std::uint32_t kManyPreferences = 256;
#endif

  void MakeRoomForIdentifiers(std::size_t count);
  void IndexSlots(Symbol id);
  [[gnu::noinline]] LargeSlot& LargeOf(Slot& slot);
  LargeSlot Describe(const Slot& slot) const;
  SlotId FindSlot(const IdentifierRecord& owner, Symbol id, Symbol attribute) const;

  WmeId& ListHead(const WmeRecord& record, const Wme& content);
  void PutFirst(WmeId wme, WmeRecord& record);
  void TakeOut(WmeId wme, WmeRecord& record);

  SymbolTable& symbols_;
  WmeTable wmes_;
  PlainVector<WmeRecord> records_;
  std::vector<WmeId> free_wmes_;
  RecordArena<Slot, &Slot::next> slots_;
  RecordArena<Preference, &Preference::next_of_goal> preferences_;
  std::vector<IdentifierRecord> identifiers_;
  SlotIndex slot_index_;
  LargeSlots large_slots_;
  std::vector<GoalLevel> goal_levels_;
  std::vector<std::uint64_t> long_term_;
  std::uint64_t next_timetag_ = 1;
  std::uint32_t identifier_limit_ = 0;  ///< The size of identifiers_.
  std::uint32_t live_wmes_ = 0;
  std::uint32_t live_identifiers_ = 0;
};

}  // namespace soarbox::kernel
