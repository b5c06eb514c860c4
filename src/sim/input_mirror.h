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

/// Keeps an agent's input link equal to what you tell it and writes only the differences. Telling it what has not
/// changed costs a comparison: it makes, copies and looks up nothing.
///
/// Each time, tell it again everything that is to stay, except for a queue: see Drop and KeepRest. It finds objects and
/// words again by row (or name) and key, and they keep their identifiers; it is cheapest to tell them in the same order
/// each time. Who tells it as what it is, and not as a sink, is spared the calls for what stands where it stood.
///
/// Invariant: what it keeps is what it last told the client library. Other elements on the input link (the thesis'
/// ^distance) are not its own and stay. Owned by the agent's mind.
class InputMirror final : public vocabulary::PerceptSink {
 public:
  explicit InputMirror(sml::Agent& agent);
  InputMirror(InputMirror&&) noexcept = default;
  InputMirror& operator=(InputMirror&&) noexcept = default;

  /// Makes the input link show what `tell(mirror)` tells it.
  template <std::invocable<InputMirror&> Tell>
  void Show(Tell&& tell) {
    Begin();
    tell(*this);
    End();
  }
  void Show(const vocabulary::PerceptList& wanted);
  /// The same by hand.
  void Begin();
  void End();

  // (What is told for each of those in view, each time, is compared where it is told.)
  /// As PerceptSink::Number.
  [[gnu::always_inline]] void Number(const vocabulary::PerceptRow& row, double value) {
    if (!std::isfinite(value)) return;
    const double perceived = vocabulary::AsPerceived(row, value);
    if (row.type != vocabulary::ValueType::kInteger) {
      Float(row, perceived);
    } else if (row.steps_per_unit == 1 && row.min != row.max) {
      Integer(row, static_cast<std::int64_t>(perceived));  // It is whole, and small enough.
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

  // For a queue, in which things come at the end and go at the beginning.
  /// The key of what was there the last time and has not been told yet; 0 if there is nothing.
  std::uint32_t NextKey() const;
  /// Removes that one.
  void Drop();
  /// Keeps that one and all after it, as they are.
  void KeepRest();

  /// Notes each change from now on; null: stops. Not owned.
  void SetLog(mind::EventLog* log) { log_ = log; }
  /// How many elements were written, changed or removed since the last Begin.
  std::size_t changes() const { return changes_; }

 private:
  enum class Kind : std::uint8_t { kInteger, kFloat, kText, kObject };
  /// What an element is found by. One without a row goes by its name.
  struct Name {
    const vocabulary::PerceptRow* row = nullptr;
    std::string_view other = {};
    std::uint32_t key = 0;
    Kind kind = Kind::kText;

    std::string attribute() const { return std::string(row != nullptr ? row->Attribute() : other); }
  };
  /// One element, small enough that those of an object lie close together: most of them are only compared.
  struct Slot {
    static constexpr std::size_t kShort = 16;
    static constexpr std::uint8_t kLong = 0xFF;
    union {
      std::int64_t integer = 0;
      double number;
      char text[kShort];         ///< With zeros at its end.
      std::vector<Slot>* below;  ///< Of an object; from slots_.
    };
    sml::WMElement* element = nullptr;  ///< Knows its attribute, and a text that is too long for this.
    const vocabulary::PerceptRow* row = nullptr;
    std::uint32_t key = 0;
    Kind kind = Kind::kText;
    std::uint8_t size = 0;  ///< Of a text, or kLong.

    /// False for a text that is too long for this, too.
    bool HoldsShort(std::string_view value) const { return size == value.size() && AreEqual(text, value.data(), size); }
    bool Holds(std::string_view value) const;
    void Hold(std::string_view value);
  };
  using Slots = std::vector<Slot>;
  struct OpenObject {
    Slots* slots = nullptr;
    std::size_t next = 0;  ///< The first that has not been told yet, while one below it is told.
    sml::Identifier* object = nullptr;
    std::uint32_t key = 0;
    std::size_t path_length = 0;  ///< Of the path of what it hangs on, once it is named.
    std::size_t dropped = 0;      ///< How many in front of the first that has not been told are gone.
  };

  /// Whether up to sixteen bytes are the same: texts are short and mostly equal, so without a call.
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
  /// Whether the next one that stood there is that.
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
  /// A text that may be another one, if it is long.
  void Change(Slot& slot, std::string_view value);
  void TellInteger(const Name& name, std::int64_t value);
  void TellFloat(const Name& name, double value);
  void TellText(const Name& name, std::string_view value);
  void TellOther(std::string_view attribute, std::uint32_t key, const vocabulary::ConstantValue& value);
  void OpenNamed(const Name& name);
  void Enter(const Slot& object);
  void ShowList(const vocabulary::PerceptList& list);

  /// From here on the slots of that object are told, the first `next` of which have been.
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
  std::unique_ptr<Slots> top_ = std::make_unique<Slots>();  ///< What is directly on the input link.
  std::vector<OpenObject> open_;                            ///< From the input link to the object that is told now.
  Slot* next_ = nullptr;                                    ///< Of that object, the first that has not been told yet;
  Slot* end_ = nullptr;                                     ///< ... behind its last.
  std::size_t refused_ = 0;                                 ///< Open objects that the client library would not make.
  std::size_t changes_ = 0;
  mind::EventLog* log_ = nullptr;
  std::string path_;       ///< Of the object that you are telling now, with a dot at its end, ...
  std::size_t named_ = 0;  ///< ... as far as somebody has asked for it: this many of open_.
};

}  // namespace soarbox::sim
