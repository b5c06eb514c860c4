// SPDX-License-Identifier: BSD-2-Clause
#include "record/minds_codec.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

#include "mind/event_log.h"

namespace soarbox::record {
namespace {

using Minds = std::vector<MindRecord>;

/// Ticks of one block, as bytes.
std::vector<std::string> Encode(const std::vector<Minds>& ticks) {
  std::vector<std::string> encoded;
  MindsEncoder encoder;
  for (const Minds& minds : ticks) {
    BufferedWriter out(encoded.emplace_back());
    encoder.Write(out, minds);
    out.Flush();
  }
  return encoded;
}

std::size_t SizeOf(const std::vector<std::string>& encoded) {
  std::size_t size = 0;
  for (const std::string& tick : encoded) size += tick.size();
  return size;
}

void ExpectReadsBack(const std::vector<Minds>& ticks) {
  const std::vector<std::string> encoded = Encode(ticks);
  MindsDecoder decoder;
  Minds read;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ByteReader in(encoded[i]);
    decoder.Read(in, read);
    ASSERT_FALSE(in.failed()) << i;
    EXPECT_TRUE(in.AtEnd()) << i;
    ASSERT_EQ(read.size(), ticks[i].size()) << i;
    for (std::size_t j = 0; j < read.size(); ++j) {
      EXPECT_EQ(read[j].agent, ticks[i][j].agent);
      ASSERT_EQ(read[j].events.bytes(), ticks[i][j].events.bytes()) << "tick " << i << ", " << read[j].agent;
    }
  }
}

class Random {
 public:
  unsigned Below(unsigned most) { return static_cast<unsigned>(random_() % most); }

  /// What the mind of a soldier does in a tick.
  mind::EventLog Soldier() {
    mind::EventLog log;
    if (Below(3) == 0) log.Add(mind::CommandEnded{"fire", mind::CommandStatus::kError, "no-target"});
    for (unsigned other = 0; other < 12; ++other) {
      if (Below(4) == 0) continue;
      const std::string path = "agent#" + std::to_string(other) + ".";
      if (Below(3) != 0) log.Add(mind::PerceptChanged{path, "distance", 0, static_cast<double>(Below(1000)) / 10});
      if (Below(4) == 0) log.Add(mind::PerceptChanged{path, "name", 2, std::string_view(path)});
      if (Below(9) == 0) log.Add(mind::PerceptChanged{path, "count", 0, std::int64_t{Below(9)} - 4});
      if (Below(9) == 0) log.Add(mind::PerceptChanged{path, "count", 0, static_cast<double>(Below(9)) / 7});
      if (Below(5) == 0) log.Add(mind::PerceptGone{path, "seen", Below(3)});
      if (Below(9) == 0) log.Add(mind::PerceptGone{"", "agent", other});
    }
    const std::string id = "O" + std::to_string(Below(1200)), decision(40 + Below(2) * 200, 'd');
    if (Below(2) == 0) log.Add(mind::OperatorSelected{1, id, "engage", decision + id});
    if (Below(3) == 0) log.Add(mind::CommandSaid{Below(1u << 20), "fire", "fire*apply", {{0, false, "at", "red-1"}}});
    return log;
  }
  std::vector<Minds> Soldiers(std::size_t count) {
    std::vector<Minds> ticks(count);
    for (Minds& minds : ticks)
      for (const char* agent : {"red-1", "red-2", "blue-1", "blue-2"})
        if (Below(5) != 0) minds.push_back({agent, Soldier()});
    return ticks;
  }
  unsigned operator()() { return static_cast<unsigned>(random_()); }

 private:
  std::mt19937 random_{3};
};

TEST(MindsCodec, ReadsBackWhatItWrote) {
  Random random;
  const std::vector<Minds> ticks = random.Soldiers(300);
  ExpectReadsBack(ticks);
  std::size_t whole = 0;
  for (const Minds& minds : ticks)
    for (const MindRecord& mind : minds) whole += mind.events.bytes().size();
  EXPECT_LT(SizeOf(Encode(ticks)), whole / 3);
}

TEST(MindsCodec, APerceptThatChangesAgainTakesTwoBytes) {
  std::vector<Minds> ticks(3);
  for (int tick = 0; tick < 3; ++tick) {
    mind::EventLog log;
    for (int other = 0; other < 50; ++other)
      log.Add(mind::PerceptChanged{"agent#" + std::to_string(other) + ".", "distance", 0, 12.3 + tick / 10.0});
    ticks[static_cast<std::size_t>(tick)].push_back({"scout", log});
  }
  ticks[1][0].events = {};
  for (int other = 0; other < 50; ++other)
    ticks[1][0].events.Add(mind::PerceptChanged{"agent#" + std::to_string(other) + ".", "distance", 0, 12.7});
  const std::vector<std::string> encoded = Encode(ticks);
  EXPECT_LE(encoded[1].size(), 2u * 50 + 4);
  ExpectReadsBack(ticks);
}

TEST(MindsCodec, APathThatAnotherMindHasIsNotStoredAgain) {
  std::vector<Minds> ticks(1);
  for (const char* agent : {"a", "b"}) {
    mind::EventLog log;
    log.Add(mind::PerceptChanged{"a-rather-long-path.", "with-a-long-attribute", 0, std::int64_t{3}});
    log.Add(mind::PerceptChanged{"another-long-path.", "with-a-long-attribute", 0, std::int64_t{4}});
    ticks[0].push_back({agent, log});
    if (*agent == 'a') ExpectReadsBack(ticks);
  }
  const std::size_t both = SizeOf(Encode(ticks));
  ticks[0].pop_back();
  EXPECT_LT(both, SizeOf(Encode(ticks)) + 20);
}

TEST(MindsCodec, SaysLittleOfWhatIsTheSame) {
  std::vector<Minds> ticks(3);
  const std::string decision(200, 'd');
  for (const char* id : {"O41", "O42"}) {
    mind::EventLog log;
    log.Add(mind::OperatorSelected{1, id, "engage", decision + id});
    ticks[*(id + 2) == '1' ? 0 : 2].push_back({"scout", log});  // In between it does nothing.
  }
  EXPECT_LT(Encode(ticks)[2].size(), 20u);
  ExpectReadsBack(ticks);
}

TEST(MindsCodec, StoresEveryBitOfValues) {
  std::vector<Minds> ticks(1);
  mind::EventLog log;
  for (const double value : {0.0, -0.0, 0.1, 12.34, -12.345, 1e300, 1.0 / 3, 4503599627370496.0, 9007199254740993.0,
                             std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(),
                             static_cast<double>(0.1f), 5e-324, -1000.5})
    log.Add(mind::PerceptChanged{"self.", "x", 0, value});
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1} << 52, -(std::int64_t{1} << 52),
                                   (std::int64_t{1} << 52) + 1, INT64_MAX, INT64_MIN})
    log.Add(mind::PerceptChanged{"self.", "x", 0, value});
  log.Add(mind::PerceptChanged{"self.", "x", 7, ""});
  log.Add(mind::PerceptChanged{"self.", std::string(300, 'x'), 7, std::string_view("long name")});
  const std::string word(20'000, 'w');
  log.Add(mind::PerceptChanged{"self.", "x", 7, std::string_view(word)});
  ticks[0].push_back({"scout", log});
  ExpectReadsBack(ticks);
}

TEST(MindsCodec, TakesAnyBytesForLogs) {
  Random random;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::string> logs(3);
    for (std::string& log : logs)
      for (unsigned size = random.Below(40); size > 0; --size)
        log += static_cast<char>(random.Below(5) == 0   ? random()
                                 : random.Below(4) == 0 ? 0x80 + random.Below(9)
                                                        : random.Below(3));
    MindsEncoder encoder;
    std::string bytes;
    BufferedWriter out(bytes);
    std::vector<Minds> ticks;
    for (const std::string& log : logs) {
      ticks.push_back({{"scout", mind::EventLog(log)}});
      encoder.Write(out, ticks.back());
    }
    out.Flush();
    MindsDecoder decoder;
    ByteReader in(bytes);
    for (const Minds& minds : ticks) {
      Minds read;
      decoder.Read(in, read);
      // The decoder accepts only logs that consist of events.
      if (!minds[0].events.IsSound()) break;
      ASSERT_FALSE(in.failed()) << i;
      ASSERT_EQ(read[0].events.bytes(), minds[0].events.bytes()) << i;
    }
  }
}

TEST(MindsCodec, NeverReadsBeyondWhatThereIs) {
  Random random;
  const std::vector<std::string> encoded = Encode(random.Soldiers(6));
  int failed = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = encoded[0] + encoded[1] + encoded[2];
    for (unsigned changes = 1 + random.Below(2); changes > 0; --changes)
      damaged[random.Below(static_cast<unsigned>(damaged.size()))] = static_cast<char>(random());
    if (random.Below(3) == 0) damaged.resize(random.Below(static_cast<unsigned>(damaged.size())));
    MindsDecoder decoder;
    ByteReader in(damaged);
    in.SetBudget(100'000);
    for (int tick = 0; tick < 3 && !in.failed(); ++tick) {
      Minds read;
      decoder.Read(in, read);
      std::size_t size = 0;
      for (const MindRecord& mind : read) size += mind.events.bytes().size();
      EXPECT_LE(size, 200'000u);
    }
    failed += in.failed();
  }
  EXPECT_GT(failed, 100);
}

}  // namespace
}  // namespace soarbox::record
