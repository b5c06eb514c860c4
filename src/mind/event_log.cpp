// SPDX-License-Identifier: BSD-2-Clause
#include "mind/event_log.h"

#include <algorithm>
#include <array>

#include "bytes/byte_stream.h"

namespace soarbox::mind {
namespace {

/// Reads the output of EventLog::Add.
class FieldReader : public ByteReader {
 public:
  using ByteReader::ByteReader;

  void operator()(const char*, std::string_view& text) { text = Text(); }
  void operator()(const char*, Value& value) {
    switch (Byte()) {
      case 0:
        (*this)("", value.emplace<std::string_view>());
        break;
      case 1: {
        const std::uint64_t number = Number();
        value = static_cast<std::int64_t>((number >> 1) ^ ((number & 1) != 0 ? ~std::uint64_t{0} : 0));
        break;
      }
      case 2:
        value = static_cast<double>(Float());
        break;
      case 3:
        value = Double();
        break;
      default:
        Fail();
    }
  }
  void operator()(const char*, std::vector<Parameter>& parameters) {
    parameters.clear();
    const std::size_t count = Count(2);
    if (count > kMostParameters) return Fail();  // Each uses much more memory than bytes.
    std::uint32_t most_depth = 0;
    for (std::size_t i = 0; i < count && !failed(); ++i) {
      Parameter& parameter = parameters.emplace_back();
      const std::uint64_t head = Number();
      if (head >> 1 > most_depth) return Fail();
      parameter.depth = static_cast<std::uint32_t>(head >> 1);
      parameter.is_object = (head & 1) != 0;
      most_depth = parameter.depth + (parameter.is_object ? 1 : 0);
      (*this)("", parameter.attribute);
      if (!parameter.is_object) (*this)("", parameter.value);
    }
  }
  void operator()(const char*, bool& flag) {
    const std::uint8_t value = Byte();
    if (value > 1) Fail();
    flag = value == 1;
  }
  /// Reads a level of the goal stack.
  void operator()(const char*, int& number) {
    number = static_cast<int>(std::clamp<std::uint64_t>(Number(), 1, kDeepestLevel));
  }
  void operator()(const char*, std::uint32_t& number) {
    const std::uint64_t value = Number();
    if (value > 0xFFFFFFFFu) return Fail();
    number = static_cast<std::uint32_t>(value);
  }
  void operator()(const char*, std::uint64_t& number) { number = Number(); }
  void operator()(const char*, double& number) { number = Double(); }
  void operator()(const char*, StateReason& reason) { reason = Kind(StateReason::kNoChange); }
  void operator()(const char*, CommandStatus& status) { status = Kind(CommandStatus::kError); }
};

template <std::size_t number>
bool ReadKind(std::string_view bytes, Event& event) {
  using Kind = std::variant_alternative_t<number, Event>;
  FieldReader in(bytes);
  // Reuses the memory of the previous event.
  Kind& read = std::holds_alternative<Kind>(event) ? std::get<Kind>(event) : event.emplace<Kind>();
  Kind::Fields(read, in);
  return !in.failed();  // Ignores fields that a later version adds at the end.
}

constexpr std::size_t kKinds = std::variant_size_v<Event>;

template <std::size_t... numbers>
constexpr auto Readers(std::index_sequence<numbers...>) {
  return std::array<bool (*)(std::string_view, Event&), sizeof...(numbers)>{&ReadKind<numbers>...};
}
constexpr auto kReaders = Readers(std::make_index_sequence<kKinds>());

}  // namespace

bool TakeFrame(std::string_view& log, EventFrame& frame) {
  ByteReader in(log);
  frame.kind = in.Byte();
  frame.fields = in.Text();
  if (in.failed()) return false;
  frame.whole = log.substr(0, log.size() - in.left());
  log.remove_prefix(frame.whole.size());
  return true;
}

bool EventLog::Next(std::size_t& at, Event& event) const {
  std::string_view left = bytes().substr(std::min(at, used_));
  for (EventFrame frame; TakeFrame(left, frame);) {
    at = used_ - left.size();
    if (frame.kind < kKinds && kReaders[frame.kind](frame.fields, event)) return true;
  }
  return false;
}

bool EventLog::IsSound() const {
  Event event;
  for (std::string_view left = bytes(); !left.empty();) {
    EventFrame frame;
    if (!TakeFrame(left, frame)) return false;
    if (frame.kind < kKinds && !kReaders[frame.kind](frame.fields, event)) return false;
  }
  return true;
}

void EventLog::Grow(std::size_t room) {
  auto larger = std::make_unique_for_overwrite<char[]>(room);
  if (used_ > 0) std::memcpy(larger.get(), bytes_.get(), used_);
  bytes_ = std::move(larger);
  room_ = room;
}

void EventLog::DropDetails() {
  if (!std::exchange(may_have_details_, false)) return;
  std::size_t kept = 0;
  std::string_view left = bytes();
  for (EventFrame frame; TakeFrame(left, frame);) {
    if (frame.kind == NumberOf<RuleFired>() || frame.kind == NumberOf<ElementChanged>()) continue;
    if (char* const place = bytes_.get() + kept; place != frame.whole.data())
      std::memmove(place, frame.whole.data(), frame.whole.size());
    kept += frame.whole.size();
  }
  used_ = kept;
}

}  // namespace soarbox::mind
