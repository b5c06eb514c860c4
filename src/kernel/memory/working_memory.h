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

/// Why an element is in working memory, and on which list of its identifier it stands.
enum class WmeKind : std::uint8_t {
  kFree,
  kSlot,          ///< The value of a slot; of an operator slot: the selected operator.
  kAcceptable,    ///< (S1 ^operator O1 +)
  kArchitecture,  ///< Of a goal: type, superstate, impasse, item, ...
  kInput,         ///< Made by the input link, or by a user's command.
};

/// Mark of an element that was in the dependency set of a goal that has been removed.
constexpr GoalLevel kGoalOfGdsGone = 0xFFFF;

/// What stands beside a Wme: everything that the match does not read.
class WmeRecord {
 public:
  static constexpr std::uint32_t kNoInput = 0xFFFFFFFFu;

  WmeKind kind = WmeKind::kFree;
  bool in_match : 1 = false;  ///< The matcher knows it.
  bool removing : 1 = false;  ///< Waits in the removal buffer.
  bool renewed : 1 = false;   ///< Waits in the buffers as one that left and one that came in its place.

 private:
  bool is_input_ : 1 = false;  ///< It has an input element in the place of a slot.

 public:
  GoalLevel gds = 0;             ///< Level of the goal whose dependency set holds it, kGoalOfGdsGone, or 0.
  std::uint32_t references = 0;  ///< Instantiations of substates that matched it.
  WmeId next = WmeId::kNone, previous = WmeId::kNone;  ///< The list of the slot or of the identifier.
  PreferenceId preference = PreferenceId::kNone;       ///< The preference that put it here, if any.
  LinkId link = LinkId::kNone;                         ///< An identifier as value, if no preference holds it.

  /// kSlot, kAcceptable.
  SlotId slot() const { return is_input_ ? SlotId::kNone : slot_; }
  void SetSlot(SlotId slot) {
    is_input_ = false;
    slot_ = slot;
  }
  /// kInput: the input link's element, kNoInput if it did not make this one.
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

/// The preferences and elements of one (identifier, attribute).
struct Slot {
  Symbol id, attribute;
  bool live = false;
  bool is_operator = false;              ///< ^operator of a goal: decided in the decide phase only.
  bool changed = false;                  ///< Is on the list of changed slots.
  bool is_large : 1 = false;             ///< See large_slots.h.
  bool acceptables_changed : 1 = false;  ///< Is on the list of slots whose acceptable preferences changed.
  bool changed_since_selected : 1 =
      false;                      ///< ^operator of a goal: preferences changed after its operator was selected.
  bool lost_by_hand : 1 = false;  ///< An element was taken away although there are preferences for its value.
  std::uint32_t acceptable_count = 0;
  std::uint32_t substate_facts = 0;               ///< Of these the o-supported ones that a substate's rule made.
  WmeId wmes = WmeId::kNone;                      ///< Newest first.
  WmeId acceptable_wmes = WmeId::kNone;           ///< kAcceptable elements of an operator slot, newest first.
  PreferenceId acceptable = PreferenceId::kNone;  ///< Acceptable preferences: higher goals first, then newest first.
  PreferenceId others = PreferenceId::kNone;      ///< All other types in one list, in the same order.
  SlotId next = SlotId::kNone, previous = SlotId::kNone;  ///< Slots of the identifier, newest first.
};

/// What working memory knows of an identifier. Of a size that is addressed by a shift.
struct alignas(64) IdentifierRecord {
  bool live = false;
  bool is_goal = false;
  GoalLevel level = 0;           ///< The highest goal (smallest number) that reaches it.
  bool rooted = false;           ///< Following parents ends at a goal (see links.h).
  bool queued = false;           ///< Waits for its level to be worked out.
  bool gone = false;             ///< A goal that has gone: what may still name it does not hold it.
  bool names_itself = false;     ///< It is or was a value of its own.
  bool slots_indexed = false;    ///< It has had more slots than are searched one by one.
  std::uint16_t slot_count = 0;  ///< While not slots_indexed.
  std::uint32_t value_of = 0;    ///< Elements that have it as their value.
  std::uint32_t item_of = 0;     ///< Of these the ones that the architecture made: they hold nothing.
  SlotId slots = SlotId::kNone;
  WmeId architecture_wmes = WmeId::kNone;  ///< Newest first.
  WmeId input_wmes = WmeId::kNone;         ///< Newest first.
  LinkId first_link = LinkId::kNone;       ///< Links that lead here (see links.h).
  LinkId parent_link = LinkId::kNone;      ///< The link that gives it its level.
  LinkId first_child = LinkId::kNone;      ///< Links of which this is the source and that are parent links.
};

/// Working memory of one agent as a data structure: elements, slots, preferences and identifiers in arenas with free
/// lists. What to change and when is decided in decide/; this class keeps lists and counts right.
///
/// Invariants: an element stands on exactly one list, that of its kind; a slot's preferences are ordered by level, then
/// newest first; a slot with nothing in it is freed at the end of a working memory phase; time tags only grow.
/// Single-threaded: owned and touched by the agent's cycle only.
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
  /// Identifiers that working memory does not know have a record that is not live.
  const IdentifierRecord& identifier(Symbol id) const {
    if (!id.IsIdentifier() || id.index() >= identifier_limit_) return kUnknownIdentifier;
    return identifiers_[id.index()];
  }
  /// Of an identifier that working memory made.
  const IdentifierRecord& known_identifier(Symbol id) const { return identifiers_[id.index()]; }
  GoalLevel level(Symbol id) const { return identifier(id).level; }
  /// Elements of an identifier as `print` lists them: slot by slot (newest slot first; within a slot the values newest
  /// first, then the acceptable ones newest first), then those of the architecture, then input.
  std::vector<WmeId> WmesOf(Symbol id) const;
  /// The same, one by one. `visit` changes nothing here.
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
  /// The first value of an attribute, whatever its kind, or the none symbol.
  Symbol ValueOf(Symbol id, Symbol attribute) const;
  /// The live element with a time tag, or kNone. Walks all elements: for commands only.
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
  /// What the matcher is told of identifiers. Valid until the next identifier is made.
  GoalView goal_view() const { return {goal_levels_, long_term_}; }
  /// By identifier index: the level of an identifier that is a goal, else 0; the long-term identifier that it is linked
  /// to, else 0.
  std::span<const GoalLevel> goal_levels() const { return goal_levels_; }
  std::span<const std::uint64_t> long_term_identifiers() const { return long_term_; }

  // Elements --------------------------------------------------------------------------------------------------------

  /// Makes an element with the next time tag and puts it at the head of its list. The caller tells match and observers.
  WmeId Make(WmeKind kind, Symbol id, Symbol attribute, Symbol value, bool acceptable, SlotId slot = SlotId::kNone);
  /// The same in the place of one that goes, that nothing refers to and that differs in its value only, a constant:
  /// what Unlink and Make would do, but the index stays.
  void Make(WmeId wme, Symbol value);
  /// Takes the element off its list; its contents stay readable until Free.
  void Unlink(WmeId wme);
  /// Gives indices back once nothing refers to them.
  void Free(std::span<const WmeId> wmes);
  WmeRecord& mutable_record(WmeId id) { return records_[Index(id)]; }

  // Identifiers -----------------------------------------------------------------------------------------------------

  Symbol NewIdentifier(char letter, GoalLevel level);
  /// The same for an identifier that the symbol table has just made.
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
  /// Links into its slot in the order of the class comment. The slot exists.
  void InsertInSlot(PreferenceId preference, SlotId slot);
  void RemoveFromSlot(PreferenceId preference);
  /// What is known about a slot with very many acceptable preferences; null if it has few. Not for operator slots.
  LargeSlot* Large(SlotId id) {
    Slot& slot = *id.record;
    return slot.is_large || slot.acceptable_count > kManyPreferences ? &LargeOf(slot) : nullptr;
  }
  /// Whether the slot has an o-supported acceptable preference of the top state's level for a value. (One that a
  /// substate's rule made is no reason to leave such a fact out: it goes with the substate.)
  bool HasTopFact(SlotId slot, Symbol value);
  /// True if the records of large slots agree with the slots.
  bool LargeSlotsAreRight() const;
  /// Returns a preference that nothing refers to.
  void FreePreference(PreferenceId preference);

  /// Forgets everything (init-soar); keeps capacity.
  void Clear();

  std::size_t MemoryBytes() const;

 private:
  static const IdentifierRecord kUnknownIdentifier;
  /// Slots of an identifier that has no more than this are found along its list, those of others by slot_index_.
  static constexpr std::uint16_t kFewSlots = 4;
  /// What a slot with more acceptable preferences has is in large_slots_. (Builds that check themselves try it early.)
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
  std::uint32_t identifier_limit_ = 0;  ///< Size of identifiers_.
  std::uint32_t live_wmes_ = 0;
  std::uint32_t live_identifiers_ = 0;
};

}  // namespace soarbox::kernel
