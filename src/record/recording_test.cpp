// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "diagnostics/without_threads.h"
#include "mind/decision_codec.h"
#include "record/reader.h"
#include "record/recorder.h"
#include "record/ticks_test_support.h"
#include "record/writer.h"
#include "world/animation/pose.h"
#include "world/animation/rig.h"

namespace soarbox::record {
namespace {

namespace fs = std::filesystem;

/// A file in a folder that is removed with the test.
class RecordingTest : public testing::Test {
 protected:
  fs::path file() const { return folder() / "run.soarrec"; }
  const fs::path& folder() const { return scratch_.path(); }

 private:
  ScratchFolder scratch_;
};

void Write(const fs::path& file, const std::vector<TickRecord>& ticks, const WriterSettings& settings = {}) {
  Result<std::unique_ptr<Writer>> writer = Writer::Create(file, SomeHeader(), settings);
  ASSERT_TRUE(writer) << Format(writer.error());
  for (const TickRecord& tick : ticks) ASSERT_TRUE((*writer)->Add(tick));
}

std::string Content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
}

void PutBytes(const fs::path& file, std::string_view bytes) {
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

TEST_F(RecordingTest, WhereNoThreadCanBeStartedTheRunsThreadWritesTheSame) {
  const std::vector<TickRecord> ticks = SomeTicks(200);
  const auto record = [&](const fs::path& to) {
    Result<std::unique_ptr<Writer>> writer = Writer::Create(to, SomeHeader(), {});
    ASSERT_TRUE(writer) << Format(writer.error());
    // With fewer records, the run would wait, and the recording would say so.
    Recorder recorder(std::move(*writer), Level::kAll, ticks.size());
    for (const TickRecord& tick : ticks) ASSERT_TRUE(recorder.Take(tick));
    ASSERT_TRUE(recorder.Finish());
  };
  record(file());
  const WithoutThreads none;
  ASSERT_THROW(std::thread([] {}).join(), std::system_error);
  record(folder() / "one-thread.soarrec");
  EXPECT_GT(Content(file()).size(), 1'000u);
  EXPECT_EQ(Content(file()), Content(folder() / "one-thread.soarrec"));
}

TEST_F(RecordingTest, ARunWithoutFreeRecordsWaitsAndTheRecordingSaysSo) {
  const std::vector<TickRecord> ticks = SomeTicks(200);
  const auto waits = [&](std::size_t records) -> Waits {
    Result<std::unique_ptr<Writer>> writer = Writer::Create(file(), SomeHeader(), {});
    EXPECT_TRUE(writer) << Format(writer.error());
    Recorder recorder(std::move(*writer), Level::kAll, records);
    for (const TickRecord& tick : ticks) EXPECT_TRUE(recorder.Take(tick));
    EXPECT_TRUE(recorder.Finish());
    const Result<std::unique_ptr<Reader>> reader = Reader::Open(file());
    EXPECT_TRUE(reader) << Format(reader.error());
    for (const std::uint64_t tick : {0, 150, 199}) {
      const Result<const TickRecord*> read = (*reader)->At(tick);
      EXPECT_TRUE(read && Bytes(**read) == Bytes(ticks[tick])) << tick;
    }
    return (*reader)->waits();
  };
  const Waits few = waits(1);
  EXPECT_GT(few.ticks, 0u);
  EXPECT_LT(few.ticks, 200u);
  EXPECT_GT(few.seconds, 0);
  EXPECT_EQ(waits(ticks.size()).ticks, 0u);
}

TEST_F(RecordingTest, AFileThatEndsAnywhereKeepsItsCompleteBlocks) {
  const std::vector<TickRecord> ticks = SomeTicks(120);
  Write(file(), ticks, {.ticks_per_block = 10});
  const std::string whole = Content(file());
  std::mt19937 random(3);
  std::uint64_t longest = 0;
  for (int i = 0; i < 100; ++i) {
    const std::size_t size = random() % whole.size();
    PutBytes(file(), std::string_view(whole).substr(0, size));
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

TEST_F(RecordingTest, AChangedBitAnywhereIsTold) {
  const std::vector<TickRecord> ticks = SomeTicks(60);
  Write(file(), ticks, {.ticks_per_block = 10});
  const std::string whole = Content(file());
  std::mt19937 random(4);
  int told = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
    PutBytes(file(), damaged);
    const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
    if (!opened) {
      ++told;
      continue;
    }
    Reader& reader = *opened.value();
    bool complained = !reader.ending().empty() || reader.last_tick() != 59 || !reader.Inputs();
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
  EXPECT_EQ(told, 300);
}

TEST_F(RecordingTest, WhatCameInIsReadWithoutTheTicks) {
  const std::vector<TickRecord> ticks = SomeTicks(300);
  Write(file(), ticks, {.ticks_per_block = 10});
  // A block of ticks in the middle is damaged; all inputs are still readable.
  std::string content = Content(file());
  for (std::size_t at = kMagic.size(), blocks = 0; at < content.size(); ++blocks) {
    BlockFrame frame;
    ASSERT_TRUE(DecodeFrame(std::string_view(content).substr(at), frame));
    if (frame.kind == BlockKind::kTicks && frame.first_tick == 150) content[at + kFrameBytes + 20] ^= 1;
    at += kFrameBytes + frame.compressed_bytes;
  }
  PutBytes(file(), content);
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  EXPECT_FALSE(opened.value()->At(155));
  const Result<std::vector<TickInputs>> inputs = opened.value()->Inputs();
  ASSERT_TRUE(inputs) << Format(inputs.error());
  std::size_t next = 0;
  for (const TickRecord& tick : ticks) {
    if (tick.inputs.empty()) continue;
    ASSERT_LT(next, inputs->size());
    EXPECT_EQ((*inputs)[next].tick, tick.tick);
    EXPECT_EQ((*inputs)[next++].inputs, tick.inputs);
  }
  EXPECT_EQ(next, inputs->size());
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
  EXPECT_NE(Reader::Open(folder() / "absent").error().message.find("no such file"), std::string::npos);
  PutBytes(file(), "sp {a (state <s> ^superstate nil) --> (halt)}");
  EXPECT_NE(Reader::Open(file()).error().message.find("not a recording"), std::string::npos);
  EXPECT_FALSE(Reader::Open(folder()));
  EXPECT_FALSE(Writer::Create(folder() / "no" / "such" / "folder", SomeHeader()));
}

TEST_F(RecordingTest, OtherFormatsAreRefusedByNumber) {
  for (const int version : {1, kVersion - 1, kVersion + 1, 65535}) {
    BlockFrame frame;
    frame.kind = BlockKind::kHeader;
    frame.version = static_cast<std::uint16_t>(version);
    PutBytes(file(), std::string(kMagic) + EncodeBlock(frame, EncodeHeader(SomeHeader())));
    const Result<std::unique_ptr<Reader>> refused = Reader::Open(file());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("format " + std::to_string(version)), std::string::npos);
  }
}

/// Agents of all kinds, in any order: with bodies at their position or elsewhere, that are created, removed and
/// rotated.
TEST_F(RecordingTest, AgentsAreKeptWhereTheyStandWhateverTheirBodiesDo) {
  std::mt19937 random(9);
  std::vector<TickRecord> ticks = SomeTicks(200);
  const auto number = [&] { return static_cast<float>(random() % 4000) / 7 - 300; };
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    world::SceneSnapshot& scene = ticks[i].scene;
    scene.drawables = {};
    scene.agents.clear();
    for (std::uint32_t id = 1; id < 12; ++id) {
      if (random() % 8 == 0) continue;
      world::AgentSnapshot& agent = scene.agents.emplace_back();
      agent.id = id;
      agent.position = {number(), random() % 3 == 0 ? number() : 0.8f, number()};
      world::DrawableSnapshot body;
      body.id = id;
      body.owner_id = random() % 4 == 0 ? 12 - id : id;
      body.belongs_to_agent = random() % 6 != 0;
      body.position = random() % 4 == 0 ? world::Vec3{number(), 0, number()} : agent.position;
      body.orientation = {number() / 300, 0, number() / 300, 0};
      if (random() % 20 == 0) body.orientation.w = std::numeric_limits<float>::quiet_NaN();
      agent.forward = Rotate(body.orientation, {0, 0, random() % 4 == 0 ? -1.0f : 1.0f});
      scene.drawables.push_back(body);
    }
  }
  Write(file(), ticks, {.ticks_per_block = 30});
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  for (const TickRecord& tick : ticks) {
    const Result<const TickRecord*> read = (*opened)->At(tick.tick);
    ASSERT_TRUE(read) << Format(read.error());
    EXPECT_EQ(Bytes(**read), Bytes(tick));
  }
}

TEST_F(RecordingTest, MovementsOfBodiesAreKeptAndTheirBonesFollow) {
  std::mt19937 random(6);
  std::vector<TickRecord> ticks = SomeTicks(200);
  const auto number = [&] { return static_cast<float>(random() % 1000) / 999; };
  const world::Rig& rig = world::SoldierRig();
  world::Rig model;
  model.model = "model.glb#00000000000000bb";
  model.skeleton.AddToParent("bone", -1, {{0, 1, 0}, {}, {2, 1, 1}});
  world::BoneMovement movement;
  movement.scale = {{0, 1}, {{2, 1, 1}, {1, 2, 3}}, false};
  model.clips.emplace_back(world::Clip::Settings{.name = "stretch"}, std::vector{movement});
  world::KeepRig(model);
  world::Pose pose;
  for (TickRecord& tick : ticks) {
    if (random() % 10 == 0 || pose.rig == nullptr) {
      pose.rig = random() % 4 == 0 ? &world::RifleRig() : random() % 3 == 0 ? world::FindRig(model.model) : &rig;
      pose.parts.resize(random() % 5);
      for (world::Pose::Part& part : pose.parts)
        part = {static_cast<std::uint32_t>(random() % pose.rig->clips.size()), number(), number() + 0.01f};
      pose.played = pose.parts.empty() ? 0 : random() % (pose.parts.size() + 1);
    }
    if (random() % 3 == 0) pose.legs = number();
    for (world::Pose::Part& part : pose.parts)
      if (random() % 2 == 0) part.time_s += 1 / 30.0f;
    world::DrawableSnapshot& drawable = tick.scene.drawables.Edit(tick.scene.drawables.Find(0));
    drawable.bones = world::BodyBones(pose);
    // Without a pose.
    if (random() % 12 == 0 && pose.rig->model.empty()) drawable.bones = drawable.bones.value();
    if (random() % 12 == 0) drawable.bones = {};
  }
  Write(file(), ticks, {.ticks_per_block = 30});
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  int followed = 0;
  for (const TickRecord& tick : ticks) {
    const Result<const TickRecord*> read = (*opened)->At(tick.tick);
    ASSERT_TRUE(read) << Format(read.error());
    EXPECT_EQ(Bytes(**read), Bytes(tick));
    const world::BodyBones& was = tick.scene.drawables.front().bones;
    const world::BodyBones& is = (*read)->scene.drawables.front().bones;
    EXPECT_EQ(is.pose() == nullptr, was.pose() == nullptr);
    EXPECT_EQ(is.value(), was.value()) << tick.tick;
    followed += is.pose() != nullptr;
  }
  EXPECT_GT(followed, 100);
}

TEST_F(RecordingTest, ThingsThatHangOnBonesArePlacedWhereTheirBodiesHoldThem) {
  std::mt19937 random(9);
  const auto number = [&] { return static_cast<float>(random() % 1000) / 99; };
  std::vector<TickRecord> ticks = SomeTicks(120), placed;
  world::Pose pose;
  pose.rig = &world::SoldierRig();
  pose.parts = {{0, 0, 1}};
  world::DrawableSnapshot body, rifle;
  body.id = 100'000;
  rifle.id = 100'001;
  body.owner_id = rifle.owner_id = 1;
  body.belongs_to_agent = rifle.belongs_to_agent = true;
  for (TickRecord& tick : ticks) {
    pose.parts[0].time_s += 1 / 30.0f;
    body.bones = world::BodyBones(pose);
    body.position = {number(), 1, number()};
    if (random() % 9 == 0) rifle.hung.on = rifle.hung.on == 0 ? body.id : 0;
    rifle.hung.bone = 3;
    if (random() % 5 == 0) rifle.hung.position = {0, number() / 100, 0};
    if (rifle.hung.on == 0) rifle.position = {number(), number(), number()};
    tick.scene.drawables.push_back(body);
    if (random() % 7 != 0) tick.scene.drawables.push_back(rifle);
    placed.push_back(tick);
    world::PlaceHung(placed.back().scene.drawables);
  }
  Write(file(), ticks);
  const std::string unplaced = Content(file());
  Write(file(), placed);
  EXPECT_EQ(Content(file()), unplaced) << "positions that follow from bones are stored";
  const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
  ASSERT_TRUE(opened) << Format(opened.error());
  for (const std::uint64_t tick : {0, 3, 4, 5, 50, 51, 52, 53, 54, 55, 90, 119, 7, 8}) {
    const Result<const TickRecord*> read = (*opened)->At(tick);
    ASSERT_TRUE(read) << Format(read.error());
    EXPECT_EQ(Bytes(**read), Bytes(ticks[tick]));
    ASSERT_EQ((*read)->scene.drawables.size(), placed[tick].scene.drawables.size());
    auto expected = placed[tick].scene.drawables.begin();
    for (const world::DrawableSnapshot& drawable : (*read)->scene.drawables) {
      EXPECT_EQ(drawable.position, expected->position) << tick << " " << drawable.id;
      EXPECT_EQ(drawable.orientation, expected->orientation) << tick << " " << drawable.id;
      ++expected;
    }
  }
}

TEST_F(RecordingTest, AHundredProgramsThatAreKilledLeaveTheirCompleteBlocks) {
  const std::vector<TickRecord> ticks = SomeTicks(60);
  std::mt19937 random(8);
  std::size_t used = 0;
  for (int i = 0; i < 100; ++i) {
    fs::remove(file());
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      // Writes continuously until it is killed.
      Result<std::unique_ptr<Writer>> writer = Writer::Create(file(), SomeHeader(), {.ticks_per_block = 5});
      TickRecord tick;
      for (std::uint64_t number = 0; writer; ++number) {
        tick = ticks[number % ticks.size()];
        tick.tick = tick.scene.tick = number;
        if (!(*writer)->Add(tick)) _exit(1);
      }
      _exit(1);
    }
    // It is killed at a random moment after it has written a certain size, or after two seconds.
    const std::uintmax_t far = random() % 30'000;
    std::error_code error;
    for (int waits = 0; waits < 10'000; ++waits, usleep(200))
      if (const std::uintmax_t size = fs::file_size(file(), error); !error && size > far) break;
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    const Result<std::unique_ptr<Reader>> opened = Reader::Open(file());
    if (!opened) continue;  // Killed before its first block was complete.
    Reader& reader = **opened;
    ++used;
    EXPECT_EQ(reader.first_tick(), 0u);
    EXPECT_EQ((reader.last_tick() + 1) % 5, 0u);
    for (const std::uint64_t tick : {reader.first_tick(), reader.last_tick() / 2, reader.last_tick()}) {
      TickRecord expected = ticks[tick % ticks.size()];
      expected.tick = expected.scene.tick = tick;
      const Result<const TickRecord*> read = reader.At(tick);
      ASSERT_TRUE(read) << Format(read.error());
      ASSERT_EQ(Bytes(**read), Bytes(expected));
    }
  }
  EXPECT_GT(used, 30u);
}

TEST_F(RecordingTest, AFullDiskEndsTheRecordingAndIsTold) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const Result<std::unique_ptr<Writer>> writer = Writer::Create("/dev/full", SomeHeader());
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().message.find("No space left"), std::string::npos) << writer.error().message;
}

}  // namespace
}  // namespace soarbox::record
