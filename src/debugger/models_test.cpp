// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "debugger/breakpoints.h"
#include "debugger/facts_text.h"
#include "debugger/file_place.h"
#include "debugger/memory.h"
#include "debugger/messages.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/run_trace.h"
#include "debugger/syntax.h"
#include "debugger/timeline.h"

namespace soarbox::debugger {
namespace {

using ::testing::HasSubstr;

// Syntax --------------------------------------------------------------------------------------------------------------

std::string Kinds(std::string_view text) {
  std::string kinds;
  for (const Token& token : Tokenize(text)) {
    if (!kinds.empty()) kinds += ' ';
    kinds += std::string(text.substr(token.begin, token.length)) + "/" + std::string(NameOf(token.kind));
  }
  return kinds;
}

TEST(Syntax, ARuleIsTakenApart) {
  EXPECT_EQ(Kinds("sp {a*b :i-support\n(state <s> -^x.y >= -1.5) # why\n-->\n(<s> ^|z z| <o> + > <p>)}"),
            "sp/command {/sign a*b/rule-name :i-support/keyword (/sign state/keyword <s>/variable -/sign "
            "^x.y/attribute >=/sign -1.5/number )/sign # why/comment -->/arrow (/sign <s>/variable ^|z z|/attribute "
            "<o>/variable +/sign >/sign <p>/variable )/sign }/sign");
}

TEST(Syntax, AnyTextEndsAndLeavesNothingOut) {
  for (const std::string text : {"", "sp {", "|open", "\"open", "<", "<s", "^", "-", "-->", "<=> << a b >>", "{{{}}}}}",
                                 "\xff\xfe sp", "sp {x\n#", "^a.|b", "\\"}) {
    std::size_t at = 0;
    for (const Token& token : Tokenize(text)) {
      EXPECT_GE(token.begin, at) << text;
      EXPECT_GT(token.length, 0u) << text;
      for (std::size_t i = at; i < token.begin; ++i) EXPECT_TRUE(std::isspace(static_cast<unsigned char>(text[i])));
      at = token.begin + token.length;
      EXPECT_LE(at, text.size());
    }
  }
}

// Operators -----------------------------------------------------------------------------------------------------------

explain::PreferenceFact Preference(std::string type, std::string value, std::string referent = {}) {
  explain::PreferenceFact fact;
  fact.maker.rule = type + "*" + value;
  fact.type = std::move(type);
  fact.value = std::move(value);
  fact.referent = std::move(referent);
  return fact;
}

explain::OperatorFacts Facts(std::string selected, std::vector<explain::PreferenceFact> preferences) {
  explain::OperatorFacts facts;
  facts.state = "S1";
  facts.selected = std::move(selected);
  facts.preferences = std::move(preferences);
  facts.impasse = "none";
  return facts;
}

TEST(Operators, WithoutTheProceduresAccountNoReasonIsMadeUp) {
  const auto ok = [](const char* value) { return Preference("acceptable", value); };
  const OperatorsView view = View(Facts("O1", {ok("O1"), ok("O2"), Preference("reject", "O2")}));
  EXPECT_EQ(view.sentence, "O1 is selected.");
  EXPECT_EQ(view.rows[1].verdict, "proposed");
  EXPECT_EQ(View(Facts("O1", {})).sentence, "O1 is selected.");
  EXPECT_EQ(View(Facts("", {})).sentence, "no operator is proposed in S1.");
}

TEST(Operators, TheDropsOfADecisionStandWithTheirRules) {
  explain::OperatorFacts facts = Facts("O1", {Preference("acceptable", "O1"), Preference("acceptable", "O2"),
                                              Preference("reject", "O2"), Preference("worst", "O3")});
  mind::Decision& decision = facts.decision.emplace();
  decision.operators = {{"O1", ""}, {"O2", ""}, {"O3", ""}};
  decision.preferences = {{mind::PreferenceKind::kAcceptable, 0, mind::Decision::kNoOperator, 0, "p1"},
                          {mind::PreferenceKind::kAcceptable, 1, mind::Decision::kNoOperator, 0, "p2"},
                          {mind::PreferenceKind::kReject, 1, mind::Decision::kNoOperator, 0, "tired*stay"},
                          {mind::PreferenceKind::kWorst, 2, mind::Decision::kNoOperator, 0, "w"}};
  decision.by = {2};
  decision.drops = {{1, mind::Stage::kReject, mind::Decisive::kYes, 0, 1}};
  decision.left = {{0, 0, 1}};
  decision.selected = 0;
  const OperatorsView view = View(facts);
  EXPECT_EQ(view.sentence, "O1 was selected: rule tired*stay rejects O2.");
  EXPECT_EQ(view.rows[0].verdict, "selected");
  EXPECT_EQ(view.rows[1].verdict, "rule tired*stay rejects it");
  EXPECT_EQ(view.rows[2].verdict, "not proposed");
  ASSERT_TRUE(view.rows[1].dropped);
  EXPECT_EQ(view.rows[1].dropped->stage, "reject");
  EXPECT_EQ(view.rows[1].dropped->is_decisive, true);
  EXPECT_EQ(view.rows[1].dropped->rules, std::vector<std::string>{"tired*stay"});

  decision.has_changed = true;
  EXPECT_EQ(View(facts).sentence,
            "O1 is selected, and preferences have changed since then. With the present preferences: rule tired*stay "
            "rejects O2.");
  decision.has_changed = false;
  facts.selected = "O2";
  decision.selected = 1;
  EXPECT_EQ(View(facts).sentence,
            "O2 is selected, but now rule tired*stay rejects it, so the next decision will drop it.");
  facts.selected.clear();
  decision.selected = mind::Decision::kNoOperator;
  EXPECT_EQ(View(facts).sentence, "O1 would be selected at the next decision: rule tired*stay rejects O2.");
}

TEST(Operators, AChoiceByChanceTellsItsProbability) {
  explain::OperatorFacts facts = Facts("O2", {Preference("acceptable", "O1"), Preference("acceptable", "O2"),
                                              Preference("numeric", "O1", "3"), Preference("numeric", "O2", "1")});
  facts.candidates = {{"O1", "", 3, 0.75}, {"O2", "", 1, 0.25}};
  const OperatorsView view = View(facts);
  EXPECT_EQ(view.rows[0].value, 3);
  EXPECT_EQ(view.rows[0].probability, 0.75);
}

// Memory --------------------------------------------------------------------------------------------------------------

TEST(Memory, WhatCameAndWentWithinATickIsNoChange) {
  mind::EventLog events;
  events.Add(mind::ElementChanged{true, 5, "S1", "a", "b", false, false});
  events.Add(mind::ElementChanged{false, 3, "S1", "|two words|", "O3", true, true});
  events.Add(mind::ElementChanged{false, 5, "S1", "a", "b", false, false});
  events.Add(mind::ElementChanged{true, 6, "S1", "e", "f", false, false});
  const MemoryChanges changes(events);
  EXPECT_FALSE(changes.WasAdded(5));
  EXPECT_TRUE(changes.WasAdded(6));
  ASSERT_EQ(changes.removed().size(), 1u);
  EXPECT_EQ(changes.removed().at(3), (explain::ElementFact{3, "S1", "|two words|", "O3", true, true}));
}

// Ticks ---------------------------------------------------------------------------------------------------------------

record::TickRecord TickOf(std::uint64_t number, const std::vector<mind::Event>& events) {
  record::TickRecord tick;
  tick.tick = number;
  tick.scene.time_s = static_cast<double>(number) / 30;
  record::MindRecord& mind = tick.minds.emplace_back();
  mind.agent = "a";
  mind.events.Add(mind::PerceptChanged{"self.", "health", 0, std::int64_t{100}});
  for (const mind::Event& event : events) std::visit([&](const auto& one) { mind.events.Add(one); }, event);
  return tick;
}

mind::Event Selected(std::string_view id, std::string_view name = {}, int level = 1) {
  return mind::OperatorSelected{level, id, name, {}};
}

mind::Event Top() {
  return mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}};
}

mind::Event Substate(int level, std::string_view id, mind::StateReason reason = mind::StateReason::kNoChange) {
  return mind::StateMade{level, id, reason, true, {}};
}

TEST(Timeline, SpansGoFromSelectionToTheNext) {
  Timeline timeline;
  timeline.Add(TickOf(1, {Top(), Selected("O1", "walk")}));
  timeline.Add(TickOf(2, {Substate(2, "S2")}));
  timeline.Add(TickOf(3, {Substate(3, "S3", mind::StateReason::kTie)}));
  timeline.Add(TickOf(4, {mind::StateGone{3, "S3"}, Selected("O2", "rest")}));
  timeline.Add(TickOf(5, {}));
  const TimelineTrack* track = timeline.Find("a");
  ASSERT_NE(track, nullptr);
  EXPECT_EQ(timeline.At("a", 3).back().text, "operator tie");
  EXPECT_EQ(timeline.At("a", 5).back().text, "rest");
  EXPECT_EQ(timeline.At("a", 5).back().last_tick, 5u);
}

TEST(Timeline, AStateThatWaitsIsOneSpanAndEndsItsOperator) {
  Timeline timeline;
  timeline.Add(TickOf(1, {Top(), Selected("O1", "walk")}));
  timeline.Add(TickOf(2, {Top(), Top()}));
  timeline.Add(TickOf(3, {Top()}));
  ASSERT_EQ(timeline.Find("a")->open.size(), 1u);
  EXPECT_EQ(timeline.Find("a")->open[0].first_tick, 1u);
  ASSERT_EQ(timeline.Find("a")->spans.size(), 1u);
  EXPECT_EQ(timeline.Find("a")->spans[0].text, "walk");
  EXPECT_EQ(timeline.At("a", 3).size(), 1u);
}

TEST(Timeline, GoingBackTakesBackWhatCameLater) {
  Timeline timeline;
  timeline.Add(TickOf(1, {Top(), Selected("O1", "walk")}));
  timeline.Add(TickOf(2, {Selected("O2", "rest")}));
  timeline.Add(TickOf(3, {Selected("O3", "flee")}));
  timeline.Add(TickOf(2, {}));
  EXPECT_EQ(timeline.last_tick(), 2u);
  EXPECT_EQ(timeline.At("a", 2).back().text, "walk");
  EXPECT_EQ(timeline.Find("a")->open.size(), 2u);
  EXPECT_TRUE(timeline.Find("a")->spans.empty());
}

TEST(Trace, DetailsStandBetweenTheirDecisionsAndLevelsFilter) {
  Trace trace;
  trace.Add(TickOf(1, {mind::RuleFired{"propose"}, Selected("O1", "walk"), mind::RuleFired{"apply"},
                       mind::ElementChanged{true, 7, "S1", "a", "b"}, Selected("O2", "step", 2)}));
  std::string all;
  for (const TraceLine* line : trace.Find({TraceKind::kElement, "", ""})) all += line->text + "|";
  EXPECT_EQ(all, "self.health 100|fire propose|O: O1 (walk)|fire apply|+ 7: S1 ^a b|O: O2 (step)|");
  EXPECT_EQ(trace.Find({TraceKind::kDecision, "", ""}).size(), 2u);
  EXPECT_EQ(trace.Find({TraceKind::kDecision, "", "STEP"}).front()->level, 2);
  EXPECT_TRUE(trace.Find({TraceKind::kElement, "b", ""}).empty());
}

TEST(FilePlaces, AreFoundInMessages) {
  const std::string text = "walker: /tmp/a b/scout.soar:14:23: error: no such <t> (see init.lua:7)";
  const std::optional<FilePlace> place = FindFilePlace(text);
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->file, "b/scout.soar");
  EXPECT_EQ(place->line, 14);
  EXPECT_EQ(text.substr(place->begin, place->length), "b/scout.soar:14:23");
  EXPECT_EQ(FindFilePlace("stopped (init.lua:7)")->file, "init.lua");
  EXPECT_EQ(FindFilePlace("scenario.toml:3")->line, 3);
  for (const char* none : {"", "12:30", "a:b", "scout.soar", "scout.soar:", "rule a*b:1", "x.soar:99999999999999"})
    EXPECT_FALSE(FindFilePlace(none).has_value()) << none;
  EXPECT_TRUE(IsEditable("a.soar"));
  EXPECT_FALSE(IsEditable("scenario.toml"));
}

TEST(Timeline, SpansWithinTicksAreThoseThatCanBeSeenThere) {
  Timeline timeline;
  for (std::uint64_t tick = 1; tick <= 40; ++tick) {
    const std::string id = (tick % 4 == 1 ? "O" : "S") + std::to_string(tick);
    std::vector<mind::Event> decisions;
    if (tick == 1) decisions.push_back(Top());
    if (tick % 4 == 1) decisions.push_back(Selected(id));
    if (tick % 4 == 2) decisions.push_back(Substate(2, id));
    timeline.Add(TickOf(tick, decisions));
  }
  const TimelineTrack& track = *timeline.Find("a");
  for (std::uint64_t first = 1; first <= 40; first += 3) {
    for (std::uint64_t last = first; last <= 40; last += 5) {
      std::vector<std::string> wanted, seen;
      const auto note = [&](const TimelineSpan& span) {
        if (span.last_tick >= first && span.first_tick <= last) wanted.push_back(span.id);
      };
      std::ranges::for_each(track.spans, note);
      std::ranges::for_each(track.open, note);
      ForSpansWithin(track, first, last, [&](const TimelineSpan& span) { seen.push_back(span.id); });
      EXPECT_EQ(seen, wanted) << first << " to " << last;
    }
  }
}

TEST(Timeline, TracksOfManyAgentsShareWhatIsKept) {
  Timeline timeline;
  constexpr std::size_t kAgents = 100;
  record::TickRecord tick = TickOf(1, {});
  tick.minds[0].events.Add(mind::CommandSaid{0, "seek", {}, {}});
  for (std::size_t i = 0; i < kAgents; ++i) tick.minds.push_back(tick.minds[0]);
  for (std::size_t i = 0; i < tick.minds.size(); ++i) tick.minds[i].agent = "a" + std::to_string(i);
  for (tick.tick = 1; tick.tick <= 5'000; ++tick.tick) timeline.Add(tick);
  std::size_t marks = 0;
  for (const TimelineTrack* track : timeline.tracks()) marks += track->marks.size();
  EXPECT_LE(marks, Timeline::kMostOfAll);
  EXPECT_GT(marks, Timeline::kMostOfAll / 2);
}

TEST(Trace, ASearchThatIsKeptFindsWhatOneFromTheBeginningDoes) {
  Trace trace(40);
  TraceSearch search;
  TraceFilter filter{TraceKind::kDecision, "", ""};
  const auto is_same = [&] {
    const std::vector<const TraceLine*> wanted = trace.Find(filter);
    const auto& found = search.Find(trace, filter);
    return std::ranges::equal(found, wanted);
  };
  for (std::uint64_t tick = 1; tick <= 30; ++tick) {
    const std::string id = "O" + std::to_string(tick % 3);
    trace.Add(TickOf(tick, {mind::RuleFired{"a"}, Selected(id)}));
    EXPECT_TRUE(is_same()) << tick;
  }
  filter.text = "O1";
  EXPECT_TRUE(is_same());
  EXPECT_FALSE(search.Find(trace, filter).empty());
  trace.Add(TickOf(25, {Selected("O1")}));  // The run went back.
  EXPECT_TRUE(is_same());
  trace.Clear();
  EXPECT_TRUE(is_same());
}

TEST(Plots, KeepTheirBeginningHoweverLongTheyAre) {
  Plots plots;
  plots.Plot("a", "health");
  constexpr std::uint64_t kTicks = 110'000;  // An hour.
  record::TickRecord tick;
  tick.scene.agents.resize(1);
  tick.scene.agents[0].name = "a";
  for (tick.tick = 1; tick.tick <= kTicks; ++tick.tick) {
    tick.scene.agents[0].health = tick.tick == 500 ? 7.0f : tick.tick % 2 == 0 ? 50.0f : 60.0f;
    plots.Add(tick);
  }
  const PlotSeries& series = plots.series()[0];
  EXPECT_LE(series.points.size(), Plots::kMostPoints);
  EXPECT_LE(series.points.front().tick, kTicks / 100);
  EXPECT_EQ(series.points.back().tick, kTicks);
  EXPECT_TRUE(std::ranges::is_sorted(series.points, {}, &PlotPoint::tick));
  EXPECT_TRUE(std::ranges::any_of(series.points, [](const PlotPoint& point) { return point.value == 7; }));
}

TEST(Trace, IsBounded) {
  Trace trace(3);
  for (std::uint64_t tick = 1; tick <= 5; ++tick) trace.Add(TickOf(tick, {Selected("O1")}));
  EXPECT_EQ(trace.lines().size(), 3u);
  EXPECT_EQ(trace.forgotten(), 7u);
  EXPECT_EQ(trace.lines().back().tick, 5u);
}

TEST(Messages, AreReadFromEventsAndOrders) {
  record::TickRecord tick = TickOf(4, {});
  sim::RunEvent said;
  said.kind = sim::EventKind::kNews;
  said.tick = 4;
  said.agent = "a";
  said.news = "says";
  said.text = "to team red: ^about contact ^range 12";
  said.values = sim::Speech{"team red", "contact", "^about contact ^range 12"};
  tick.events.push_back(said);
  tick.inputs = {"4 order b go home"};
  MessageLog log;
  log.Add(tick);
  log.Add(tick);
  ASSERT_EQ(log.rows().size(), 2u);
  EXPECT_EQ(log.rows()[0].to, "b");
  EXPECT_EQ(log.rows()[0].text, "go home");
  EXPECT_EQ(log.rows()[1].to, "team red");
  EXPECT_EQ(log.rows()[1].about, "contact");
  EXPECT_EQ(log.Find("red", "RANGE").size(), 1u);
}

TEST(Breakpoints, PatternsOfElements) {
  const explain::ElementFact element{7, "S1", "operator", "O12", true, true};
  for (const char* yes : {"^operator *", "S1 ^operator", "S* ^op* O1*", "* ^operator * +", "^operator O12 +"})
    EXPECT_TRUE(IsLike(element, yes)) << yes;
  for (const char* no : {"^op", "S2 ^operator", "^operator O1", "^operator O12x"})
    EXPECT_FALSE(IsLike(element, no)) << no;
}

TEST(Text, TablesHaveColumnsAndFiltersWords) {
  EXPECT_EQ(Table({{"a", "b"}, {"long", "x"}, {"\xc3\xa4", ""}}), "a     b\nlong  x\n\xc3\xa4\n");
  EXPECT_TRUE(Passes("Red  SCOUT", "scout of team red"));
  EXPECT_FALSE(Passes("blue", "scout of team red"));
}

}  // namespace
}  // namespace soarbox::debugger
