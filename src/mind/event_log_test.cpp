// SPDX-License-Identifier: BSD-2-Clause
#include "mind/event_log.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

namespace soarbox::mind {
namespace {

/// Fills the fields of an event with random values.
class Filler {
 public:
  explicit Filler(std::uint64_t seed) : random_(seed) {}

  void operator()(const char*, std::string_view& text) { text = Text(); }
  void operator()(const char*, Value& value) {
    switch (random_() % 4) {
      case 0:
        value = Text();
        break;
      case 1:
        value = static_cast<std::int64_t>(Number());
        break;
      case 2:
        value = static_cast<double>(static_cast<float>(random_()) / 7);
        break;
      default:
        value = static_cast<double>(random_()) / 7;
    }
  }
  void operator()(const char*, std::vector<Parameter>& parameters) {
    parameters.clear();
    std::uint32_t most_depth = 0;
    for (std::uint64_t left = random_() % 6; left > 0; --left) {
      Parameter& parameter = parameters.emplace_back();
      parameter.depth = static_cast<std::uint32_t>(random_() % (most_depth + 1));
      parameter.is_object = random_() % 3 == 0;
      most_depth = parameter.depth + (parameter.is_object ? 1 : 0);
      parameter.attribute = Text();
      if (!parameter.is_object) (*this)("", parameter.value);
    }
  }
  void operator()(const char*, bool& flag) { flag = random_() % 2 == 0; }
  void operator()(const char*, int& level) { level = 1 + static_cast<int>(random_() % 1000); }
  void operator()(const char*, std::uint32_t& number) { number = static_cast<std::uint32_t>(Number()); }
  void operator()(const char*, std::uint64_t& number) { number = Number(); }
  void operator()(const char*, double& number) { number = static_cast<double>(random_()) / 3; }
  void operator()(const char*, StateReason& reason) { reason = static_cast<StateReason>(random_() % 5); }
  void operator()(const char*, CommandStatus& status) { status = static_cast<CommandStatus>(random_() % 3); }

 private:
  std::uint64_t Number() { return random_() >> (random_() % 64); }
  std::string_view Text() {
    // Occasionally a long text, so that the size of the event needs three bytes.
    const std::size_t size = random_() % 50 == 0 ? 20'000 : random_() % 12;
    return std::string_view(texts_).substr(random_() % 100, size);
  }

  std::mt19937_64 random_;
  std::string texts_ = [] {
    std::string texts;
    for (int i = 0; i < 30'000; ++i) texts += static_cast<char>(i % 251);
    return texts;
  }();
};

/// The fields of an event, for comparison.
struct Listed {
  std::vector<std::string> fields;
  void operator()(const char*, std::string_view text) { fields.emplace_back(text); }
  void operator()(const char*, const Value& value) {
    std::visit(Cases{[&](std::string_view word) { fields.push_back("word " + std::string(word)); },
                     [&](std::int64_t number) { fields.push_back("integer " + std::to_string(number)); },
                     [&](double number) { Bits(number); }},
               value);
  }
  void operator()(const char*, const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters) {
      fields.push_back(std::to_string(parameter.depth) + (parameter.is_object ? "object" : "constant"));
      fields.emplace_back(parameter.attribute);
      if (!parameter.is_object) (*this)("", parameter.value);
    }
  }
  void operator()(const char*, double number) { Bits(number); }
  template <typename Number>
  requires std::is_integral_v<Number> || std::is_enum_v<Number>
  void operator()(const char*, Number number) { fields.push_back(std::to_string(static_cast<std::uint64_t>(number))); }

 private:
  void Bits(double number) { fields.push_back("float " + std::to_string(std::bit_cast<std::uint64_t>(number))); }
};

std::vector<std::string> Of(const Event& event) {
  Listed listed;
  listed.fields.push_back(std::to_string(event.index()));
  std::visit([&](const auto& kind) { std::decay_t<decltype(kind)>::Fields(kind, listed); }, event);
  return listed.fields;
}

template <std::size_t... kinds>
Event AnyEvent(std::uint64_t kind, Filler& filler, std::index_sequence<kinds...>) {
  Event event;
  ((kind == kinds ? (void)event.emplace<kinds>() : (void)0), ...);
  std::visit([&](auto& made) { std::decay_t<decltype(made)>::Fields(made, filler); }, event);
  return event;
}

constexpr std::size_t kKinds = std::variant_size_v<Event>;

TEST(EventLog, EachKindOfEventIsReadAsItWasWritten) {
  Filler filler(1);
  std::mt19937_64 random(2);
  for (int round = 0; round < 500; ++round) {
    EventLog log;
    std::vector<std::vector<std::string>> written;
    for (int n = 0; n < 40; ++n) {
      const Event event = AnyEvent(random() % kKinds, filler, std::make_index_sequence<kKinds>());
      written.push_back(Of(event));
      std::visit([&](const auto& kind) { log.Add(kind); }, event);
    }
    EXPECT_TRUE(log.IsSound());
    std::vector<std::vector<std::string>> read;
    Event event;
    for (std::size_t at = 0; log.Next(at, event);) read.push_back(Of(event));
    ASSERT_EQ(read, written);
    EXPECT_EQ(EventLog(log.bytes()), log);
  }
}

TEST(EventLog, DamageIsPassedOverOrFoundAndNeverReadBeyond) {
  Filler filler(3);
  std::mt19937_64 random(4);
  int unsound = 0;
  for (int round = 0; round < 20'000; ++round) {
    EventLog log;
    for (int n = 0; n < 4; ++n)
      std::visit([&](const auto& kind) { log.Add(kind); },
                 AnyEvent(random() % kKinds, filler, std::make_index_sequence<kKinds>()));
    std::string bytes(log.bytes());
    if (bytes.size() > 2000) continue;
    for (std::uint64_t n = 1 + random() % 3; n > 0; --n) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 4 == 0) bytes.resize(random() % (bytes.size() + 1));
    EventLog damaged{std::string_view(bytes)};
    unsound += damaged.IsSound() ? 0 : 1;
    Event event;
    std::size_t read = 0;
    for (std::size_t at = 0; damaged.Next(at, event);) read += Of(event).size();
    EXPECT_LT(read, 10'000u);
    damaged.DropDetails();
  }
  EXPECT_GT(unsound, 1000);
}

TEST(EventLog, KindsThatAreNotKnownAndFieldsThatWereAddedArePassedOver) {
  EventLog log;
  log.Add(Halted{});
  std::string bytes(log.bytes());
  bytes += std::string(
      "\xF0\x83\x00"
      "abc",
      6);                                                              // A kind of a later version.
  bytes += std::string("\x06\x88\x00\x02\x02S2\x05later", 3 + 8 + 2);  // A removed state with additional fields.
  const EventLog read{std::string_view(bytes).substr(0, bytes.size() - 2)};
  EXPECT_TRUE(read.IsSound());
  std::vector<std::size_t> kinds;
  Event event;
  for (std::size_t at = 0; read.Next(at, event);) kinds.push_back(event.index());
  EXPECT_EQ(kinds, (std::vector<std::size_t>{7, 6}));
  EXPECT_EQ(std::get<StateGone>(event).id, "S2");
}

TEST(EventLog, FiringsAndElementsCanBeLeftOut) {
  EventLog log, without;
  log.Add(RuleFired{"a", false});
  log.Add(OperatorSelected{1, "O1", "seek", {}});
  log.Add(ElementChanged{true, 3, "S1", "a", "b", false, false});
  log.Add(Halted{});
  without.Add(OperatorSelected{1, "O1", "seek", {}});
  without.Add(Halted{});
  log.DropDetails();
  EXPECT_EQ(log, without);
}

TEST(EventLog, ACopyKeepsWhatItWasMadeFrom) {
  EventLog log;
  log.Add(OperatorSelected{1, "O1", "seek", {}});
  const EventLog copy = log;
  log.Clear();
  EXPECT_TRUE(log.empty());
  EXPECT_TRUE(copy.HasAny<OperatorSelected>());
  EventLog moved = std::move(log);
  EXPECT_TRUE(moved.empty());
}

}  // namespace
}  // namespace soarbox::mind
