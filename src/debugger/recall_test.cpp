// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/recall.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "debugger/mind_fixture.h"
#include "debugger/recorded_mind.h"
#include "debugger/run_models.h"
#include "debugger/views.h"

namespace soarbox::debugger {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using Recalling = MindFixture;

/// Has two crates, and asks for ammunition, then for something unknown, and for an episode.
constexpr const char* kRecallRules = R"(
smem --enable
epmem --enable
smem --add { (@1 ^kind ammo ^at barn) (@2 ^kind ammo ^at mill) (@3 ^kind rope) }
sp {hero*start (state <s> ^superstate nil -^step) --> (<s> ^operator <o> +) (<o> ^name start)}
sp {hero*start*apply (state <s> ^operator.name start ^smem.command <c>) --> (<s> ^step 1) (<c> ^query <q>) (<q> ^kind ammo)}
sp {hero*next (state <s> ^superstate nil ^step 1 ^smem.result.retrieved) --> (<s> ^operator <o> +) (<o> ^name next)}
sp {hero*next*apply (state <s> ^operator.name next ^smem.command <c> ^epmem.command <e>) (<c> ^query <q>)
   --> (<s> ^step 1 - 2) (<c> ^query <q> - ^query <n>) (<n> ^kind mortar) (<e> ^query <m>) (<m> ^step 1)}
sp {hero*wait (state <s> ^superstate nil ^step 2) --> (<s> ^operator <o> +) (<o> ^name wait)}
)";

TEST_F(Recalling, TellsWhatWasAskedWhatCameAndWhy) {
  Start(kRecallRules);
  RunModels models;
  for (int tick = 0; tick < 8; ++tick) models.Add(Tick());
  const std::deque<Recall>& recalls = models.recalls["hero"].recalls();
  ASSERT_EQ(recalls.size(), 3u);
  EXPECT_EQ(recalls[0].number, 2u) << "of equally active ones the youngest";
  EXPECT_EQ(recalls[0].question, "^kind ammo");
  EXPECT_THAT(recalls[0].answer, HasSubstr("^at mill"));
  EXPECT_THAT(recalls[0].reason, HasSubstr("@1"));
  EXPECT_EQ(recalls[1].number, 0u);
  EXPECT_THAT(recalls[1].reason, HasSubstr("no known object has ^kind mortar"));
  EXPECT_TRUE(recalls[2].is_episode);
  EXPECT_GT(recalls[2].number, 0u);
  EXPECT_THAT(recalls[2].reason, HasSubstr("the latest episode that matches the entire cue"));
  // After going back, later recalls are removed.
  RecallLog log = models.recalls["hero"];
  log.CutFrom(recalls[1].tick);
  EXPECT_LT(log.recalls().size(), 3u);
}

TEST_F(Recalling, ShowsWhatIsKnownAndRemembered) {
  Start(kRecallRules);
  RunModels models;
  for (int tick = 0; tick < 8; ++tick) models.Add(Tick());
  const auto mind = Mind();
  const LongTermView view = LookAtLongTerm(*mind);
  EXPECT_TRUE(view.facts.semantic);
  EXPECT_TRUE(view.facts.episodic);
  EXPECT_EQ(view.facts.objects, 3u);
  ASSERT_EQ(view.facts.known.size(), 3u);
  EXPECT_EQ(view.facts.known[0].number, 2u) << "the most active first";
  EXPECT_EQ(view.facts.known[0].uses, 1u);
  EXPECT_EQ(LookAtLongTerm(*mind, "Rope").facts.known.size(), 1u) << "large and small letters are the same";
  EXPECT_EQ(LookAtLongTerm(*mind, "@3").facts.known.size(), 1u);
  EXPECT_EQ(LookAtLongTerm(*mind, "nothing of the kind").facts.known.size(), 0u);
  EXPECT_GT(view.facts.episodes, 2u);
  EXPECT_EQ(view.facts.decisions.size(), view.facts.episodes);
  const EpisodeView episode = LookAtEpisode(*mind, view.facts.episodes);
  EXPECT_THAT(episode.lines, Contains("step 2"));
  ASSERT_FALSE(episode.things.empty());
  EXPECT_EQ(episode.things[0].name, "self");
  EXPECT_EQ(LookAtEpisode(*mind, 100000).number, 0u);
  ASSERT_TRUE(episode.time_s.has_value());
  EXPECT_NEAR(*episode.time_s, simulation_->time_s(), 0.05);
  // The episodes that may differ from the previous one; the others are equal to it.
  const std::vector<std::size_t>& changed = view.facts.changed;
  ASSERT_FALSE(changed.empty());
  EXPECT_EQ(changed.front(), 1u);
  EXPECT_LT(changed.size(), view.facts.episodes);
  for (std::size_t n = 2; n <= view.facts.episodes; ++n) {
    if (std::ranges::binary_search(changed, n)) continue;
    EXPECT_EQ(LookAtEpisode(*mind, n).lines, LookAtEpisode(*mind, n - 1).lines) << n;
  }

  const record::TickRecord& last = record_;
  ViewSource source;
  source.simulation = simulation_.get();
  source.models = &models;
  source.last = &last;
  ViewRequest request;
  request.view = "longterm";
  const auto shown = ShowView(source, request);
  ASSERT_TRUE(shown.ok());
  EXPECT_THAT(shown->text, HasSubstr("^kind mortar"));
  request.of = "#1";
  EXPECT_THAT(ShowView(source, request)->text, HasSubstr("episode 1"));
  request.of = "#99999";
  EXPECT_FALSE(ShowView(source, request).ok());
  request.view = "why";
  request.of.clear();
  EXPECT_THAT(ShowView(source, request)->text, HasSubstr("recalled last: "));
}

TEST_F(Recalling, SaysWhyThereIsNothing) {
  Start("sp {hero*nothing (state <s> ^superstate nil) --> (<s> ^a b)}");
  Tick();
  EXPECT_THAT(LookAtLongTerm(*Mind()).note, HasSubstr("smem --enable"));
}

}  // namespace
}  // namespace soarbox::debugger
