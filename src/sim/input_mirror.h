// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <cstring>
#include <forward_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"
#include "sim/percept_link.h"
#include "vocabulary/percept.h"
#include "vocabulary/percept_sink.h"

namespace soarbox::sim {

/// Keeps an agent's input link equal to the percepts that the caller reports. It writes only the differences. An
/// unchanged percept costs one comparison, without allocations or look-ups.
///
/// Report all percepts in each update, except those of a queue: see Drop and KeepRest. Objects and words are found
/// again by row (or name) and key, and keep their identifiers. Reporting in the same order each time is cheapest.
///
/// Invariant: the slots contain the values that were last written to the link. Elements that others have added to the
/// input link (the thesis' ^distance) are not changed. Owned by the agent's mind, as the link is.
class InputMirror final : public vocabulary::PerceptSink<InputMirror> {
 public:
  explicit InputMirror(PerceptLink& link) : link_(&link) { link.Include(*top_); }
  InputMirror(InputMirror&&) noexcept = default;
  InputMirror& operator=(InputMirror&&) noexcept = default;

  /// Updates the input link with the percepts that `tell(mirror)` reports.
  template <std::invocable<InputMirror&> Tell>
  void Show(Tell&& tell) {
    Begin();
    tell(*this);
    End();
  }
  void Show(const vocabulary::PerceptList& wanted);
  /// The same in two calls, with the percepts reported between them.
  void Begin();
  void End();

  // The following functions are inline, because they are called for each object in view in each update.
  [[gnu::always_inline]] void Word(const vocabulary::PerceptRow& row, std::string_view value, std::uint32_t key = 0) {
    if (!StandsNext(row, key)) {
      TellText({&row, {}, key, Kind::kText}, value);
    } else if (Slot& slot = *next_++; !HoldsShort(slot, value)) {
      Change(slot, value);
    }
  }
  void Other(std::string_view attribute, const vocabulary::ConstantValue& value) { TellOther(attribute, 0, value); }
  void Open(const vocabulary::PerceptRow& row, std::uint32_t key = 0) {
    if (StandsNext(row, key)) {
      Enter(*next_++);
    } else {
      OpenNamed({&row, {}, key, Kind::kObject});
    }
  }
  void Close();

  // For a queue, in which elements are added at the end and removed at the beginning.
  /// The key of the next element of the previous update that was not yet reported; 0 if there is none.
  std::uint32_t NextKey() const;
  /// Removes that element. There must be one (NextKey).
  void Drop();
  /// Keeps that element and all later ones unchanged.
  void KeepRest();

  /// Records each change in `log` from now on; null: stops. Not owned.
  void SetLog(mind::EventLog* log) { log_ = log; }
  /// Number of elements that were added, changed or removed since the last Begin.
  std::size_t changes() const { return changes_; }

 private:
  friend class vocabulary::PerceptSink<InputMirror>;
  using Slot = PerceptSlot;
  using Slots = PerceptSlots;
  using Kind = PerceptSlot::Kind;
  /// Identifies an element. An element without a row is identified by its name.
  struct Name {
    const vocabulary::PerceptRow* row = nullptr;
    std::string_view other = {};
    std::uint32_t key = 0;
    Kind kind = Kind::kText;
  };
  /// Long texts and names of slots. Their addresses stay valid.
  class Texts {
   public:
    std::string* Take(std::string_view text);
    void GiveBack(const std::string* text);

   private:
    std::forward_list<std::string> texts_;
    std::vector<std::string*> spare_;
  };
  struct OpenObject {
    const Slot* slot = nullptr;
    std::uint32_t next = 0;       ///< Index of the first slot that was not reported yet. Used while an object below is
                                  ///< updated.
    std::uint32_t dropped = 0;    ///< Number of removed slots before the first that was not reported.
    std::size_t path_length = 0;  ///< Length of the path of its parent object, once the path is computed.

    Slots& slots() const { return *slot->object.below; }
  };

  /// False for texts that are too long for the slot.
  [[gnu::always_inline]] static bool HoldsShort(const Slot& slot, std::string_view value) {
    return slot.size == value.size() && slot.size != Slot::kLong && AreEqual(slot.text, value.data(), slot.size);
  }
  /// Whether up to sixteen bytes are equal. Texts are short and mostly equal, so this avoids a call of memcmp.
  [[gnu::always_inline]] static bool AreEqual(const char* a, const char* b, std::size_t size) {
    const auto same = [&](std::size_t at, auto word) {
      auto other = word;
      std::memcpy(&word, a + at, sizeof(word));
      std::memcpy(&other, b + at, sizeof(other));
      return word == other;
    };
    if (size >= 8) return same(0, std::uint64_t{0}) && same(size - 8, std::uint64_t{0});
    if (size >= 4) return same(0, std::uint32_t{0}) && same(size - 4, std::uint32_t{0});
    return size == 0 || (a[0] == b[0] && a[size / 2] == b[size / 2] && a[size - 1] == b[size - 1]);
  }
  /// Whether the next slot is this element. All slots with one row are of one kind.
  bool StandsNext(const vocabulary::PerceptRow& row, std::uint32_t key) const {
    return next_ != end_ && next_->row == &row && next_->key == key;
  }

  [[gnu::always_inline]] void Integer(const vocabulary::PerceptRow& row, std::int64_t value) {
    if (StandsNext(row, 0)) {
      if (Slot& slot = *next_++; slot.integer != value) Change(slot, value);
    } else {
      TellInteger({&row, {}, 0, Kind::kInteger}, value);
    }
  }
  [[gnu::always_inline]] void Float(const vocabulary::PerceptRow& row, double value) {
    if (StandsNext(row, 0)) {
      if (Slot& slot = *next_++; slot.number != value) Change(slot, value);
    } else {
      TellFloat({&row, {}, 0, Kind::kFloat}, value);
    }
  }
  // These are called only for values that differ.
  void Change(Slot& slot, std::int64_t value);
  void Change(Slot& slot, double value);
  /// A long text is compared here first, because it may be unchanged.
  void Change(Slot& slot, std::string_view value);
  void TellInteger(const Name& name, std::int64_t value);
  void TellFloat(const Name& name, double value);
  void TellText(const Name& name, std::string_view value);
  void TellOther(std::string_view attribute, std::uint32_t key, const vocabulary::ConstantValue& value);
  void OpenNamed(const Name& name);
  void Enter(const Slot& object);
  void ShowList(const vocabulary::PerceptList& list);

  /// Continues with the slots of the current object, of which the first `next` have been reported.
  void GoOn(std::size_t next) {
    Slots& slots = open_.back().slots();
    next_ = slots.data() + next;
    end_ = slots.data() + slots.size();
  }
  std::uint32_t Reported() const { return static_cast<std::uint32_t>(next_ - open_.back().slots().data()); }
  Slot* Find(const Name& name);
  Slot NewSlot(const Name& name);
  void Hold(Slot& slot, std::string_view value);
  Slot* Insert(Slot slot);
  void Destroy(const Slot& slot);
  void Free(const Slot& slot);
  void DropRest();
  void Send(const Slot& slot);
  void Note(const Slot& slot);
  std::string_view Path();

  PerceptLink* link_;
  Texts texts_;
  std::forward_list<Slots> slots_;
  std::vector<Slots*> spare_;
  std::unique_ptr<Slots> top_ = std::make_unique<Slots>();  ///< Elements directly on the input link.
  Slot input_link_;
  std::vector<OpenObject> open_;  ///< The objects from the input link to the current one.
  Slot* next_ = nullptr;          ///< The first slot of the current object that was not
                                  ///< reported yet.
  Slot* end_ = nullptr;           ///< One past its last slot.
  std::size_t refused_ = 0;       ///< Number of open objects that the kernel refused to
                                  ///< create.
  std::size_t changes_ = 0;
  mind::EventLog* log_ = nullptr;
  std::string path_;       ///< Path of the current object, with a dot at its end.
  std::size_t named_ = 0;  ///< path_ is computed for this many of open_.
};

}  // namespace soarbox::sim
