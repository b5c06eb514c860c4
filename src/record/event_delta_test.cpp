// SPDX-License-Identifier: BSD-2-Clause
#include "record/event_delta.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "mind/event_log.h"

namespace soarbox::record {
namespace {

std::string Delta(std::string_view before, std::string_view now) {
  std::string bytes;
  ByteWriter out(bytes);
  WriteEventDelta(out, before, now);
  return bytes;
}

void ExpectReadsBack(std::string_view before, std::string_view now) {
  const std::string bytes = Delta(before, now);
  ByteReader in(bytes);
  EXPECT_EQ(ReadEventDelta(in, before), now);
  EXPECT_FALSE(in.failed());
  EXPECT_TRUE(in.AtEnd());
}

/// What the mind of a soldier does in a tick.
mind::EventLog SomeTick(std::mt19937& random) {
  const auto below = [&](unsigned most) { return static_cast<unsigned>(random() % most); };
  mind::EventLog log;
  for (const char* other : {"red-1", "red-2", "blue-1"}) {
    const std::string path = "agent#" + std::string(other) + ".";
    if (below(3) != 0) log.Add(mind::PerceptChanged{path, "distance", 0, static_cast<double>(below(1000)) / 7});
    if (below(4) == 0) log.Add(mind::PerceptChanged{path, "name", 2, std::string_view(other)});
    if (below(5) == 0) log.Add(mind::PerceptGone{path, "seen", below(3)});
  }
  const std::string id = "O" + std::to_string(below(1200)), decision(40 + below(2) * 200, 'd');
  if (below(2) == 0) log.Add(mind::OperatorSelected{1, id, "engage", decision + id});
  if (below(3) == 0) log.Add(mind::CommandSaid{below(1u << 20), "fire", "fire*apply", {{0, false, "at", "red-1"}}});
  if (below(3) == 0) log.Add(mind::CommandEnded{"fire", mind::CommandStatus::kError, "no-target"});
  return log;
}

TEST(EventDelta, ReadsBackWhatItWrote) {
  std::mt19937 random(3);
  mind::EventLog before;
  std::size_t whole = 0, written = 0;
  for (int i = 0; i < 2000; ++i) {
    const mind::EventLog now = SomeTick(random);
    ExpectReadsBack(before.bytes(), now.bytes());
    whole += now.bytes().size();
    written += Delta(before.bytes(), now.bytes()).size();
    if (HasFailure()) FAIL() << i;
    before = now;
  }
  EXPECT_LT(written, whole);
}

TEST(EventDelta, SaysLittleOfWhatIsTheSame) {
  mind::EventLog before, now;
  before.Add(mind::OperatorSelected{1, "O41", "engage", std::string(200, 'd') + "O41"});
  now.Add(mind::OperatorSelected{1, "O42", "engage", std::string(200, 'd') + "O42"});
  EXPECT_LT(Delta(before.bytes(), now.bytes()).size(), 16u);
  EXPECT_LT(Delta(now.bytes(), now.bytes()).size(), 8u);
}

TEST(EventDelta, TakesAnyBytesForLogs) {
  std::mt19937 random(4);
  for (int i = 0; i < 3000; ++i) {
    std::string logs[2];
    for (std::string& log : logs)
      for (unsigned size = random() % 40; size > 0; --size)
        log += static_cast<char>(random() % 5 == 0 ? random() : random() % 3);
    ExpectReadsBack(logs[0], logs[1]);
    if (HasFailure()) FAIL() << i;
  }
}

TEST(EventDelta, NeverReadsBeyondWhatThereIs) {
  std::mt19937 random(5);
  const mind::EventLog before = SomeTick(random);
  const mind::EventLog now = SomeTick(random);
  const std::string bytes = Delta(before.bytes(), now.bytes());
  int failed = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = bytes;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    if (random() % 3 == 0) damaged.resize(random() % damaged.size());
    ByteReader in(damaged);
    in.SetBudget(100'000);
    EXPECT_LE(ReadEventDelta(in, before.bytes()).size(), 200'000u);
    failed += in.failed();
  }
  EXPECT_GT(failed, 100);
  // Copies as much as possible of the existing data, repeatedly.
  std::string bomb;
  ByteWriter out(bomb);
  for (const std::uint64_t number : {std::uint64_t{2}, ~std::uint64_t{0}, std::uint64_t{3}}) out.Number(number);
  ByteReader in(bomb);
  in.SetBudget(1000);
  (void)ReadEventDelta(in, before.bytes());
  EXPECT_TRUE(in.failed());
}

}  // namespace
}  // namespace soarbox::record
