// SPDX-License-Identifier: BSD-2-Clause
#include "record/legacy_minds.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "record/format.h"
#include "record/header.h"
#include "record/reader.h"
#include "record/test_ticks.h"

namespace soarbox::record {
namespace {

tell::MindWords Example() {
  return {
      {"distance 12.5", "agent#3.visible yes", "self.rounds -7", "name 007", "sound#2 two words", "-agent#3.path#4",
       "far 1e+20"},
      {"==>S: S1", "O: O1 (seek)", "   ==>S: S2 (operator tie)", "   O: O2", "   <==S: S2", "O: O3 (go (far))",
       "   ==>S: S3 (state no-change)", "recall @12 {^kind ammo ^at {x}} for {^kind ammo}",
       "recall no episode {} for {^here gate}", "recall episode 7 {} for {^here gate}", "value rl*a -0.25", "reward 2",
       "episode ends", "halt"},
      {"0 fire scout*propose", "0 + 12: S1 ^operator O1 +", "1 - 9: O1 ^|two words| seek", "3 retract scout*propose",
       "14 + 15: S1 ^text |a +|"},
      {"shoot ^at red-1", "move-to: complete", "aim: error no-target", "fetch: interrupted",
       "say ^text |go ^fast| ^loud yes", "put ^at (^x 1.5 ^inner (^z -2) ^none ()) ^within 2", "say ^text two words"},
      {"", "the only one proposed", "", "", "", "", "", "the only one that fits", "", "", "", "", "", ""},
      {"scout*shoot", "", "", "", "scout*say", "", ""}};
}

TEST(LegacyMinds, WordsAreFactsAgain) {
  const tell::MindWords before = Example();
  const mind::EventLog log = ReadWords(before);
  ASSERT_TRUE(log.IsSound());
  const tell::MindWords after = tell::Words(log);
  EXPECT_EQ(after.percepts, before.percepts);
  EXPECT_EQ(after.decisions, before.decisions);
  EXPECT_EQ(after.details, before.details);
  EXPECT_EQ(after.commands, before.commands);
  EXPECT_EQ(after.command_rules, before.command_rules);
  EXPECT_EQ(after.reasons[1], "as recorded: the only one proposed");
  EXPECT_EQ(after.reasons[7], "the only one that fits");
}

TEST(LegacyMinds, ValuesHaveTheirTypesAndBarsAreRespected) {
  std::vector<mind::Value> values;
  std::vector<mind::Parameter> parameters;
  ReadWords(Example()).ForEach(mind::Cases{[&](const mind::PerceptChanged& percept) {
                                             // Its texts go with the log.
                                             if (!std::holds_alternative<std::string_view>(percept.value))
                                               values.push_back(percept.value);
                                           },
                                           [&](const mind::CommandSaid& said) {
                                             if (said.name != "say" || said.parameters.size() != 2) return;
                                             EXPECT_EQ(std::get<std::string_view>(said.parameters[0].value),
                                                       "go ^fast");
                                             EXPECT_EQ(std::get<std::string_view>(said.parameters[1].value), "yes");
                                           },
                                           [](const auto&) {}});
  EXPECT_EQ(values, (std::vector<mind::Value>{12.5, std::int64_t{-7}, 1e20}));
}

TEST(LegacyMinds, AnythingElseIsTakenWithoutHarm) {
  std::mt19937 random(1);
  const tell::MindWords example = Example();
  for (int round = 0; round < 5000; ++round) {
    tell::MindWords words = example;
    for (auto* lines : {&words.percepts, &words.decisions, &words.details, &words.commands, &words.reasons}) {
      for (std::string& line : *lines) {
        if (line.empty() || random() % 2 == 0) continue;
        if (random() % 3 == 0) line.resize(random() % line.size());
        constexpr std::string_view kSigns = " ^(){}|:.#-+0O";
        if (!line.empty()) line[random() % line.size()] = kSigns[random() % kSigns.size()];
      }
    }
    if (random() % 3 == 0) words.reasons.clear();
    const mind::EventLog log = ReadWords(words);
    EXPECT_TRUE(log.IsSound());
    EXPECT_EQ(ReadWords(tell::Words(log)).IsSound(), true);
  }
}

/// Made by the release that wrote format 4, of a mind that learns, recalls, is rewarded and gives commands whose
/// parameters hold words with blanks, numbers and objects.
std::filesystem::path Kept() {
  return std::filesystem::path(SOARBOX_SOURCE_DIR) / "tests" / "app" / "recordings" / "words.soarrec";
}

std::string ContentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Format 3 differs in the header alone, which ends before the memory of the world.
std::string AsVersion3(std::string_view file) {
  std::string older(kMagic);
  for (std::size_t at = kMagic.size(); at < file.size();) {
    BlockFrame frame;
    std::string payload;
    EXPECT_TRUE(DecodeFrame(file.substr(at, kFrameBytes), frame));
    EXPECT_TRUE(DecodePayload(frame, file.substr(at + kFrameBytes, frame.compressed_bytes), payload));
    at += kFrameBytes + frame.compressed_bytes;
    if (frame.kind == BlockKind::kHeader) {
      Header header = DecodeHeader(payload, frame.version).value();
      header.memory_mb = 0;
      payload = EncodeHeader(header);
      payload.pop_back();
    }
    frame.version = 3;
    older += EncodeBlock(frame, payload);
  }
  return older;
}

struct Tally {
  int operators = 0, states = 0, learned = 0, recalled = 0, values = 0, rewards = 0, fired = 0, elements = 0, ended = 0,
      remarks = 0;
  std::vector<std::string> said;
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// What the kept mind did, and that it means what it meant when it was recorded.
Tally TallyOf(const std::filesystem::path& file) {
  Tally tally;
  const Result<std::unique_ptr<Reader>> reader = Reader::Open(file);
  EXPECT_TRUE(reader) << Format(reader.error());
  if (!reader) return tally;
  for (std::uint64_t tick = (*reader)->first_tick(); tick <= (*reader)->last_tick(); ++tick) {
    for (const MindRecord& mind : (*(*reader)->At(tick))->minds) {
      EXPECT_TRUE(mind.from_words);
      mind.events.ForEach(mind::Cases{[&](const mind::OperatorSelected& selected) {
                                        ++tally.operators;
                                        EXPECT_TRUE(selected.decision.empty()) << "words hold no decision";
                                      },
                                      [&](const mind::StateMade& made) {
                                        ++tally.states;
                                        if (made.level == 2) {
                                          EXPECT_EQ(made.reason, mind::StateReason::kNoChange);
                                        }
                                      },
                                      [&](const mind::RuleLearned& learned) {
                                        ++tally.learned;
                                        EXPECT_EQ(learned.rule, "chunk*hero*price*look*t2-1");
                                      },
                                      [&](const mind::Recalled& recalled) {
                                        ++tally.recalled;
                                        EXPECT_EQ(recalled.number, 1u);
                                        EXPECT_EQ(recalled.question, "^kind ammo");
                                        EXPECT_EQ(recalled.answer, "^kind ammo ^at gate");
                                        EXPECT_EQ(recalled.reason, "the only one that fits");
                                      },
                                      [&](const mind::ValueUpdated& update) {
                                        ++tally.values;
                                        EXPECT_EQ(update.rule, "hero*value");
                                        EXPECT_EQ(update.value, 0.45);
                                      },
                                      [&](const mind::RewardReceived&) { ++tally.rewards; },
                                      [&](const mind::RuleFired& fired) { tally.fired += fired.retracts ? 0 : 1; },
                                      [&](const mind::ElementChanged&) { ++tally.elements; },
                                      [&](const mind::CommandEnded& ended) {
                                        ++tally.ended;
                                        EXPECT_EQ(ended.status, mind::CommandStatus::kError);
                                      },
                                      [&](const mind::Remark&) { ++tally.remarks; },
                                      [&](const mind::CommandSaid& said) {
                                        tally.said.push_back(tell::CommandText(said) + " by " + std::string(said.rule));
                                        if (said.name == "say") {
                                          EXPECT_EQ(said.parameters.at(0).value, mind::Value("go ^fast"));
                                        }
                                        if (said.name == "move-to" && said.parameters.size() == 3) {
                                          EXPECT_TRUE(said.parameters[0].is_object);
                                          EXPECT_EQ(said.parameters[1].depth, 1u);
                                          EXPECT_EQ(said.parameters[1].value, mind::Value(1.5));
                                          EXPECT_EQ(said.parameters[2].value, mind::Value(std::int64_t{-2}));
                                        }
                                      },
                                      [](const auto&) {}});
    }
  }
  return tally;
}

TEST(LegacyMinds, ARecordingThatHoldsWordsIsReadAsFacts) {
  const Tally tally = TallyOf(Kept());
  EXPECT_EQ(tally.operators, 5);
  EXPECT_EQ(tally.learned, 1);
  EXPECT_EQ(tally.recalled, 1);
  EXPECT_EQ(tally.values, 1);
  EXPECT_EQ(tally.rewards, 2);
  EXPECT_GT(tally.fired, 10);
  EXPECT_GT(tally.elements, 50);
  EXPECT_EQ(tally.ended, 5);
  EXPECT_GE(tally.remarks, 5);
  const std::string go = "say ^text |go ^fast| by hero*apply*go",
                    move = "move-to ^position (^x 1.5 ^z -2) by hero*apply*go";
  EXPECT_EQ(tally.said, (std::vector<std::string>{go, move, go, move, "move-to ^waypoint nowhere by hero*apply*home"}));
}

TEST(LegacyMinds, Format3HoldsTheSameWords) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "older";
  std::ofstream(file, std::ios::binary) << AsVersion3(ContentOf(Kept()));
  EXPECT_EQ(TallyOf(file), TallyOf(Kept()));
}

}  // namespace
}  // namespace soarbox::record
