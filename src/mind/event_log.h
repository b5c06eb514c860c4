// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "mind/event.h"
#include "mind/field_writer.h"

namespace soarbox::mind {

/// One event as bytes.
struct EventFrame {
  std::uint8_t kind = 0;
  std::string_view fields;
  std::string_view whole;  ///< Includes kind and size.
};

/// Removes the first event from the bytes of a log. Returns false if they do not begin with an event.
bool TakeFrame(std::string_view& log, EventFrame& frame);

/// What one mind did, in order, as bytes. Adding an event and copying the log are fast. Files store the same bytes.
///
/// An event consists of its kind (a byte), the number of bytes that follow, and its fields. That number is in at least
/// two groups of seven bits, the lowest first. A text is its size and its bytes. Readers skip kinds that they do not
/// support.
class EventLog {
 public:
  EventLog() = default;
  /// Copies the bytes of another log or of a file. Accepts any bytes (see IsSound).
  explicit EventLog(std::string_view bytes) : may_have_details_(!bytes.empty()) { Fill(bytes); }
  EventLog(const EventLog& other) : may_have_details_(other.may_have_details_) { Fill(other.bytes()); }
  EventLog& operator=(const EventLog& other) {
    Fill(other.bytes());
    may_have_details_ = other.may_have_details_;
    return *this;
  }
  EventLog(EventLog&& other) noexcept
      : bytes_(std::move(other.bytes_)),
        room_(std::exchange(other.room_, 0)),
        used_(std::exchange(other.used_, 0)),
        may_have_details_(other.may_have_details_) {}
  EventLog& operator=(EventLog&& other) noexcept {
    bytes_.swap(other.bytes_);
    std::swap(room_, other.room_);
    std::swap(used_, other.used_);
    std::swap(may_have_details_, other.may_have_details_);
    return *this;
  }
  ~EventLog() = default;

  /// Removes all events; keeps the allocated memory.
  void Clear() {
    used_ = 0;
    may_have_details_ = false;
  }
  bool empty() const { return used_ == 0; }
  std::string_view bytes() const { return {bytes_.get(), used_}; }
  friend bool operator==(const EventLog& a, const EventLog& b) { return a.bytes() == b.bytes(); }

  template <typename Kind>
  void Add(const Kind& event);

  /// Reads the event at offset `at` (0 for the first) and advances `at`. Returns false after the last event. Texts of
  /// the event belong to this log and are valid until the log changes. Skips invalid events.
  bool Next(std::size_t& at, Event& event) const;
  /// Calls `see` with each event, as its own type.
  template <typename See>
  void ForEach(See&& see) const {
    Event event;
    for (std::size_t at = 0; Next(at, event);) std::visit(see, event);
  }
  /// Calls `see` with each event of one kind.
  template <typename Kind, typename See>
  void ForEachOf(See&& see) const {
    Event event;
    for (std::size_t at = 0; Next(at, event);)
      if (const Kind* wanted = std::get_if<Kind>(&event)) see(*wanted);
  }
  template <typename Kind>
  bool HasAny() const {
    bool any = false;
    ForEachOf<Kind>([&](const Kind&) { any = true; });
    return any;
  }

  /// Whether all bytes are events, and all events of known kinds are valid.
  bool IsSound() const;
  /// Removes firings and elements.
  void DropDetails();

 private:
  /// The index of a type in Event.
  template <typename Kind, std::size_t at = 0>
  static constexpr std::size_t NumberOf() {
    if constexpr (std::is_same_v<std::variant_alternative_t<at, Event>, Kind>) {
      return at;
    } else {
      return NumberOf<Kind, at + 1>();
    }
  }

  struct Sizer;

  /// Replaces all bytes. `bytes` may belong to this log.
  void Fill(std::string_view bytes) {
    if (bytes.size() > room_) {
      // No zeros are written, and the log is not larger than the copied one, because many copies are made.
      bytes_ = std::make_unique_for_overwrite<char[]>(bytes.size());
      room_ = bytes.size();
    }
    if (!bytes.empty()) std::memmove(bytes_.get(), bytes.data(), bytes.size());
    used_ = bytes.size();
  }
  void Grow(std::size_t room);

  std::unique_ptr<char[]> bytes_;
  std::size_t room_ = 0;           ///< Size of bytes_.
  std::size_t used_ = 0;           ///< Number of bytes that are events.
  bool may_have_details_ = false;  ///< May contain firings or elements.
};

/// Computes the maximum number of bytes that fields use.
struct EventLog::Sizer {
  static constexpr std::size_t kNumber = FieldWriter::kMostOfNumber;
  std::size_t size = 0;

  void operator()(const char*, std::string_view text) { size += kNumber + text.size(); }
  void operator()(const char*, const Value& value) {
    size += kNumber + 1;
    if (const auto* word = std::get_if<std::string_view>(&value)) size += word->size();
  }
  void operator()(const char*, const std::vector<Parameter>& parameters) {
    size += kNumber;
    for (const Parameter& parameter : parameters) {
      size += 1 + kNumber;
      (*this)("", parameter.attribute);
      (*this)("", parameter.value);
    }
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(const char*, Number) { size += kNumber; }
};

template <typename Kind>
void EventLog::Add(const Kind& event) {
  if constexpr (std::is_same_v<Kind, RuleFired> || std::is_same_v<Kind, ElementChanged>) may_have_details_ = true;
  constexpr std::size_t kHead = 3, kMostHead = 11;  // Kind, and a size that takes two bytes nearly always.
  Sizer most;
  Kind::Fields(event, most);
  if (const std::size_t needed = used_ + kMostHead + most.size; needed > room_) Grow(2 * needed);
  char* const begin = bytes_.get() + used_;
  FieldWriter fields(begin + kHead);
  Kind::Fields(event, fields);
  auto size = static_cast<std::size_t>(fields.at() - begin) - kHead;
  FieldWriter head(begin);
  head.Byte(static_cast<std::uint8_t>(NumberOf<Kind>()));
  if (size < (1u << 14)) {
    head.Byte(static_cast<std::uint8_t>(size | 0x80));
    head.Byte(static_cast<std::uint8_t>(size >> 7));
    used_ += kHead + size;
    return;
  }
  FieldWriter longer(begin);
  std::size_t groups = 0;
  for (std::size_t rest = size; rest > 0; rest >>= 7) ++groups;
  std::memmove(begin + 1 + groups, begin + kHead, size);
  longer.Byte(static_cast<std::uint8_t>(NumberOf<Kind>()));
  longer.Number(size);
  used_ += 1 + groups + size;
}

}  // namespace soarbox::mind
