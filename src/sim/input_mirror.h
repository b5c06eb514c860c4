// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <forward_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"
#include "vocabulary/percept.h"
#include "vocabulary/percept_sink.h"

namespace sml {
class Agent;
class Identifier;
class WMElement;
}  // namespace sml

namespace soarbox::sim {

/// Keeps an agent's input link equal to the percepts that the caller reports. It writes only the differences. An
/// unchanged percept costs one comparison, without allocations or look-ups.
///
/// Report all percepts in each update, except those of a queue: see Drop and KeepRest. Objects and words are found
/// again by row (or name) and key, and keep their identifiers. Reporting in the same order each time is cheapest.
/// Callers that use InputMirror directly, not through PerceptSink&, avoid a virtual call for each element that has kept
/// its position.
///
/// Invariant: the slots contain the values that were last sent to the client library. Elements that others have added
/// to the input link (the thesis' ^distance) are not changed. Owned by the agent's mind.
class InputMirror final : public vocabulary::PerceptSink {
 public:
  explicit InputMirror(sml::Agent& agent);
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
  /// As PerceptSink::Number.
  [[gnu::always_inline]] void Number(const vocabulary::PerceptRow& row, double value) {
    if (!std::isfinite(value)) return;
    const double perceived = vocabulary::AsPerceived(row, value);
    if (row.type != vocabulary::ValueType::kInteger) {
      Float(row, perceived);
    } else if (row.steps_per_unit == 1 && row.min != row.max) {
      Integer(row, static_cast<std::int64_t>(perceived));  // It is an integer and in range.
    } else {
      Integer(row, static_cast<std::int64_t>(std::llround(perceived)));
    }
  }
  [[gnu::always_inline]] void Word(const vocabulary::PerceptRow& row, std::string_view value,
                                   std::uint32_t key = 0) override {
    if (!StandsNext(row, key, Kind::kText)) {
      TellText({&row, {}, key, Kind::kText}, value);
    } else if (Slot& slot = *next_++; !slot.HoldsShort(value)) {
      Change(slot, value);
    }
  }
  void Other(std::string_view attribute, const vocabulary::ConstantValue& value) override {
    TellOther(attribute, 0, value);
  }
  void Open(const vocabulary::PerceptRow& row, std::uint32_t key = 0) override {
    if (StandsNext(row, key, Kind::kObject)) {
      Enter(*next_++);
    } else {
      OpenNamed({&row, {}, key, Kind::kObject});
    }
  }
  void Close() override;

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
  enum class Kind : std::uint8_t { kInteger, kFloat, kText, kObject };
  /// Identifies an element. An element without a row is identified by its name.
  struct Name {
    const vocabulary::PerceptRow* row = nullptr;
    std::string_view other = {};
    std::uint32_t key = 0;
    Kind kind = Kind::kText;

    std::string attribute() const { return std::string(row != nullptr ? row->Attribute() : other); }
  };
  /// One element. It is small, so that the elements of an object are close together in memory; most of them are only
  /// compared.
  struct Slot {
    static constexpr std::size_t kShort = 16;
    static constexpr std::uint8_t kLong = 0xFF;
    union {
      std::int64_t integer = 0;
      double number;
      char text[kShort];         ///< Padded with zeros.
      std::vector<Slot>* below;  ///< For an object; points into slots_.
    };
    sml::WMElement* element = nullptr;  ///< Has the attribute, and a text that is too long for this slot.
    const vocabulary::PerceptRow* row = nullptr;
    std::uint32_t key = 0;
    Kind kind = Kind::kText;
    std::uint8_t size = 0;  ///< Size of a text, or kLong.

    /// False for texts that are too long for the slot.
    bool HoldsShort(std::string_view value) const {
      return size == value.size() && size != kLong && AreEqual(text, value.data(), size);
    }
    bool Holds(std::string_view value) const;
    void Hold(std::string_view value);
  };
  using Slots = std::vector<Slot>;
  struct OpenObject {
    Slots* slots = nullptr;
    std::size_t next = 0;  ///< The first slot that was not reported yet. Used while an object below is updated.
    sml::Identifier* object = nullptr;
    std::uint32_t key = 0;
    std::size_t path_length = 0;  ///< Length of the path of its parent object, once the path is computed.
    std::size_t dropped = 0;      ///< Number of removed slots before the first that was not reported.
  };

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
  /// Whether the next slot is this element.
  bool StandsNext(const vocabulary::PerceptRow& row, std::uint32_t key, Kind kind) const {
    return next_ != end_ && next_->row == &row && next_->key == key && next_->kind == kind && refused_ == 0;
  }

  [[gnu::always_inline]] void Integer(const vocabulary::PerceptRow& row, std::int64_t value) override {
    if (StandsNext(row, 0, Kind::kInteger)) {
      if (Slot& slot = *next_++; slot.integer != value) Change(slot, value);
    } else {
      TellInteger({&row, {}, 0, Kind::kInteger}, value);
    }
  }
  [[gnu::always_inline]] void Float(const vocabulary::PerceptRow& row, double value) override {
    if (StandsNext(row, 0, Kind::kFloat)) {
      if (Slot& slot = *next_++; slot.number != value) Change(slot, value);
    } else {
      TellFloat({&row, {}, 0, Kind::kFloat}, value);
    }
  }
  void Change(Slot& slot, std::int64_t value);
  void Change(Slot& slot, double value);
  /// Changes a text. A long text is compared here first, because it may be unchanged.
  void Change(Slot& slot, std::string_view value);
  void TellInteger(const Name& name, std::int64_t value);
  void TellFloat(const Name& name, double value);
  void TellText(const Name& name, std::string_view value);
  void TellOther(std::string_view attribute, std::uint32_t key, const vocabulary::ConstantValue& value);
  void OpenNamed(const Name& name);
  void Enter(const Slot& object);
  void ShowList(const vocabulary::PerceptList& list);

  /// Continues with the slots of an object, of which the first `next` have been reported.
  void GoOn(Slots& slots, std::size_t next) {
    next_ = slots.data() + next;
    end_ = slots.data() + slots.size();
  }
  Slot* Find(const Name& name);
  Slot* Insert(const Name& name, sml::WMElement* element);
  void Destroy(const Slot& slot);
  void DropRest();
  void Recycle(Slots& slots);
  void Note(const Slot& slot);
  std::string_view Path();

  sml::Agent* agent_;
  std::forward_list<Slots> slots_;
  std::vector<Slots*> spare_;
  std::unique_ptr<Slots> top_ = std::make_unique<Slots>();  ///< Elements directly on the input link.
  std::vector<OpenObject> open_;                            ///< The objects from the input link to the current one.
  Slot* next_ = nullptr;                                    ///< The first slot of the current object that was not
                                                            ///< reported yet.
  Slot* end_ = nullptr;                                     ///< One past its last slot.
  std::size_t refused_ = 0;                                 ///< Number of open objects that the client library refused
                                                            ///< to create.
  std::size_t changes_ = 0;
  mind::EventLog* log_ = nullptr;
  std::string path_;       ///< Path of the current object, with a dot at its end.
  std::size_t named_ = 0;  ///< path_ is computed for this many of open_.
};

}  // namespace soarbox::sim
