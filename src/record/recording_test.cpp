// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "record/reader.h"
#include "record/tick_codec.h"
#include "record/writer.h"

namespace soarbox::record {
namespace {

namespace fs = std::filesystem;

/// A file in a folder of its own that goes with the test.
class RecordingTest : public testing::Test {
 protected:
  RecordingTest() {
    std::string name = (fs::temp_directory_path() / "soarbox-recording-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~RecordingTest() override { fs::remove_all(folder_); }
  fs::path file() const { return folder_ / "run.soarrec"; }

  fs::path folder_;
};

Header SomeHeader() {
  Header header;
  header.build = BuildId();
  header.scenario = "thesis";
  header.folder = "/somewhere";
  header.extra_folders = {"/a", "/b"};
  header.scenario_digest = 0x123456789abcdef0;
  header.seed = 77;
  header.level = Level::kAll;
  return header;
}

/// Ticks of a made-up world in which bodies come, move and go, and things happen now and then.
std::vector<TickRecord> SomeTicks(std::size_t count, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const auto chance = [&](unsigned one_in) { return random() % one_in == 0; };
  const auto number = [&] { return static_cast<float>(random() % 1000) / 7.0f; };
  std::vector<TickRecord> ticks;
  TickRecord tick;
  std::uint32_t next_id = 1;
  for (std::size_t i = 0; i < count; ++i) {
    tick.tick = tick.scene.tick = i;
    tick.scene.time_s = static_cast<double>(i) / 30;
    tick.state_hash = (static_cast<std::uint64_t>(random()) << 32) | random();
    tick.inputs.clear();
    tick.events.clear();
    tick.minds.clear();
    if (i == 0 || chance(9)) {
      world::DrawableSnapshot& box = tick.scene.drawables.emplace_back();
      box.id = next_id;
      box.mesh = "models/box" + std::to_string(next_id) + ".mesh";
      world::AgentSnapshot& agent = tick.scene.agents.emplace_back();
      agent.id = next_id++;
      agent.name = "agent" + std::to_string(agent.id);
    }
    if (tick.scene.drawables.size() > 3 && chance(11))
      tick.scene.drawables.erase(tick.scene.drawables.begin() + static_cast<long>(random() % 3));
    for (world::DrawableSnapshot& box : tick.scene.drawables)
      if (chance(2)) box.position = {number(), number(), number()};
    for (world::AgentSnapshot& agent : tick.scene.agents)
      if (chance(2)) agent.velocity = {number(), 0, number()};
    if (chance(5))
      tick.scene.lines = {{{1, 2, 3}, {4, 5, 6}, {}}};
    else
      tick.scene.lines.clear();
    if (chance(7)) tick.inputs = {"key space_key down", "key space_key up"};
    if (chance(6)) {
      sim::Event event;
      event.kind = sim::EventKind::kCommand;
      event.tick = i;
      event.agent = "agent1";
      event.text = "seek";
      event.position = {1, 2, 3};
      tick.events.push_back(event);
      event.kind = sim::EventKind::kDiagnostic;
      event.diagnostic.file = "x.soar";
      event.diagnostic.line = 3;
      event.diagnostic.message = "something is wrong";
      tick.events.push_back(event);
    }
    if (chance(3)) tick.minds.push_back({"agent1", {"+ distance 3.5"}, {"O: O1 (seek)"}, {"Firing seek"}, {"seek"}});
    ticks.push_back(tick);
  }
  return ticks;
}

/// All that a record holds, as bytes that stand alone.
std::string Bytes(const TickRecord& tick) {
  std::string bytes;
  ByteWriter out(bytes);
  WriteTick(out, {}, tick);
  return bytes;
}

void Write(const fs::path& file, const std::vector<TickRecord>& ticks, const WriterSettings& settings = {}) {
  Result<std::unique_ptr<Writer>> writer = Writer::Create(file, SomeHeader(), settings);
  ASSERT_TRUE(writer) << Format(writer.error());
  for (const TickRecord& tick : ticks) ASSERT_TRUE((*writer)->Add(tick));
}

std::string Content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
}

void Put(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

TEST_F(RecordingTest, ReadsBackWhatWasWrittenInAnyOrder) {
  const std::vector<TickRecord> ticks = SomeTicks(200);
  Write(file(), ticks);
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  Reader& reader = *opened.value();
  EXPECT_EQ(EncodeHeader(reader.header()), EncodeHeader(SomeHeader()));
  EXPECT_EQ(reader.first_tick(), 0u);
  EXPECT_EQ(reader.last_tick(), 199u);
  EXPECT_TRUE(reader.ending().empty());
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const std::uint64_t tick = i < 200 ? static_cast<std::uint64_t>(199 - i) : random() % 200;
    const Result<const TickRecord*> read = reader.At(tick);
    ASSERT_TRUE(read) << Format(read.error());
    ASSERT_EQ(Bytes(*read.value()), Bytes(ticks[tick])) << "tick " << tick;
  }
  EXPECT_FALSE(reader.At(200));
}

TEST_F(RecordingTest, TheSameRunGivesTheSameBytes) {
  Write(file(), SomeTicks(100));
  const std::string first = Content(file());
  Write(file(), SomeTicks(100));
  EXPECT_EQ(Content(file()), first);
}

TEST_F(RecordingTest, AFileThatEndsAnywhereKeepsItsCompleteBlocks) {
  const std::vector<TickRecord> ticks = SomeTicks(120);
  Write(file(), ticks, {.ticks_per_block = 10});
  const std::string whole = Content(file());
  std::mt19937 random(3);
  std::uint64_t longest = 0;
  for (int i = 0; i < 100; ++i) {
    const std::size_t size = random() % whole.size();
    Put(file(), std::string_view(whole).substr(0, size));
    const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
    if (!opened) {
      EXPECT_FALSE(opened.error().message.empty());
      continue;
    }
    Reader& reader = *opened.value();
    longest = std::max(longest, reader.last_tick());
    EXPECT_EQ((reader.last_tick() + 1) % 10, 0u);
    for (std::uint64_t tick = 0; tick <= reader.last_tick(); ++tick)
      ASSERT_EQ(Bytes(*reader.At(tick).value()), Bytes(ticks[tick]));
  }
  EXPECT_GT(longest, 60u);
}

TEST_F(RecordingTest, ADamagedByteIsToldOrHarmless) {
  const std::vector<TickRecord> ticks = SomeTicks(60);
  Write(file(), ticks, {.ticks_per_block = 10});
  const std::string whole = Content(file());
  std::mt19937 random(4);
  int told = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
    Put(file(), damaged);
    const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
    if (!opened) {
      ++told;
      continue;
    }
    Reader& reader = *opened.value();
    bool complained = !reader.ending().empty() || reader.last_tick() != 59;
    for (std::uint64_t tick = reader.first_tick(); tick <= reader.last_tick(); ++tick) {
      const Result<const TickRecord*> read = reader.At(tick);
      if (!read) {
        complained = true;
      } else {
        ASSERT_EQ(Bytes(*read.value()), Bytes(ticks[tick])) << "wrong content passed for right";
      }
    }
    told += complained ? 1 : 0;
  }
  // A few bits of the compressed form mean nothing.
  EXPECT_GT(told, 290);
}

TEST_F(RecordingTest, ABoundedRecordingKeepsItsEndAndAllInputs) {
  const std::vector<TickRecord> ticks = SomeTicks(2000);
  constexpr std::uint64_t kLimit = 60000;
  Write(file(), ticks, {.ticks_per_block = 10, .limit_bytes = kLimit});
  EXPECT_LT(fs::file_size(file()), kLimit * 5 / 4);
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  Reader& reader = *opened.value();
  EXPECT_GT(reader.first_tick(), 0u);
  EXPECT_EQ(reader.last_tick(), 1999u);
  for (std::uint64_t tick = reader.first_tick(); tick <= reader.last_tick(); ++tick)
    ASSERT_EQ(Bytes(*reader.At(tick).value()), Bytes(ticks[tick]));
  const Result<std::vector<TickInputs>> inputs = reader.Inputs();
  ASSERT_TRUE(inputs);
  std::vector<std::uint64_t> expected;
  for (const TickRecord& tick : ticks)
    if (!tick.inputs.empty()) expected.push_back(tick.tick);
  std::vector<std::uint64_t> found;
  for (const TickInputs& entry : inputs.value()) found.push_back(entry.tick);
  EXPECT_EQ(found, expected);
}

TEST_F(RecordingTest, WhatIsNoRecordingIsRefusedByName) {
  EXPECT_NE(Reader::Open(folder_ / "absent").error().message.find("no such file"), std::string::npos);
  Put(file(), "sp {a (state <s> ^superstate nil) --> (halt)}");
  EXPECT_NE(Reader::Open(file()).error().message.find("no recording"), std::string::npos);
  EXPECT_FALSE(Reader::Open(folder_));
  EXPECT_FALSE(Writer::Create(folder_ / "no" / "such" / "folder", SomeHeader()));
}

TEST_F(RecordingTest, AFullDiskEndsTheRecordingAndIsTold) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const Result<std::unique_ptr<Writer>> writer = Writer::Create("/dev/full", SomeHeader());
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().message.find("No space left"), std::string::npos) << writer.error().message;
}

}  // namespace
}  // namespace soarbox::record
