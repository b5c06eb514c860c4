// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/recorded_mind.h"

#include <gmock/gmock.h>

#include "debugger/io_rows.h"
#include "debugger/memory.h"
#include "debugger/mind_fixture.h"
#include "debugger/stack_rows.h"

namespace soarbox::debugger {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const char* const kRules = R"(
sp {hero*propose*go
   (state <s> ^superstate nil ^io.input-link.self.health > 50)
-->
   (<s> ^operator <o> +)
   (<o> ^name go)
}
sp {hero*apply*go
   (state <s> ^operator.name go ^io.output-link <out>)
-->
   (<out> ^say <c>)
   (<c> ^text hello ^loud yes)
}
)";

class RecordedMindTest : public MindFixture {
 protected:
  /// Runs some ticks and passes them on as a recording of this level would.
  RecordedMinds Record(int ticks, record::Level level) {
    Start(kRules);
    RecordedMinds minds(level);
    for (int i = 0; i <= ticks; ++i) {
      if (i > 0) simulation_->Tick();
      record::Observe(*simulation_, simulation_->TakeEvents(), level, record_);
      minds.Add(record_);
    }
    return minds;
  }
};

std::vector<std::string> Attributes(const std::vector<explain::ElementFact>& elements) {
  std::vector<std::string> names;
  for (const explain::ElementFact& element : elements)
    names.push_back(element.attribute + (element.acceptable ? " +" : ""));
  std::ranges::sort(names);
  return names;
}

TEST_F(RecordedMindTest, AtLevelAllItHasTheStackAndTheMemoryOfTheLivingMind) {
  const RecordedMinds minds = Record(4, record::Level::kAll);
  const std::unique_ptr<explain::Inspector> recorded = minds.Inspect("hero"), living = Mind();
  ASSERT_TRUE(recorded != nullptr && living != nullptr);
  ASSERT_EQ(recorded->Stack().size(), living->Stack().size());
  for (std::size_t i = 0; i < living->Stack().size(); ++i) {
    EXPECT_EQ(recorded->Stack()[i].id, living->Stack()[i].id);
    EXPECT_EQ(recorded->Stack()[i].impasse, living->Stack()[i].impasse);
    EXPECT_EQ(recorded->Stack()[i].operator_name, living->Stack()[i].operator_name);
    // Everything except the elements that Soar created with the state S1, before the first tick.
    const std::vector<std::string> there = Attributes(living->ElementsOf(living->Stack()[i].id)),
                                   known = Attributes(recorded->ElementsOf(recorded->Stack()[i].id));
    EXPECT_FALSE(known.empty());
    EXPECT_TRUE(std::ranges::includes(there, known)) << i;
  }
  EXPECT_EQ(recorded->Mind().input_link, living->Mind().input_link);
  const IoView io = LookAtIo(*recorded);
  EXPECT_EQ(io.input.rows.size(), LookAtIo(*living).input.rows.size());
  EXPECT_TRUE(MemoryAbsence(*recorded).empty());
  EXPECT_EQ(Absence(*recorded), "not recorded");
  const std::string operators = ToText(LookAtOperators(*recorded));
  EXPECT_THAT(operators, HasSubstr("was selected: the only operator proposed, by rule"));
  EXPECT_THAT(operators, HasSubstr("what the preferences rest on: not recorded"));
}

TEST_F(RecordedMindTest, AtLevelDecisionsItHasPerceptsAndCommandsAndSaysThatMemoryIsNotThere) {
  const RecordedMinds minds = Record(4, record::Level::kDecisions);
  const std::unique_ptr<explain::Inspector> recorded = minds.Inspect("hero");
  ASSERT_NE(recorded, nullptr);
  const std::string io = ToText(LookAtIo(*recorded));
  EXPECT_THAT(io, HasSubstr("^health 100"));
  EXPECT_THAT(io, HasSubstr("say ^loud yes ^text hello"));
  EXPECT_THAT(ToText(LookAtObject(*recorded, "S1")), HasSubstr("--record-level all"));
  EXPECT_THAT(ToText(LookAtOperators(*recorded)), HasSubstr("was selected"));
  const std::string why = ToText(WhyRecorded(*minds.Find("hero"), "hero"));
  EXPECT_THAT(why, HasSubstr("command say"));
}

TEST_F(RecordedMindTest, AtLevelWorldNothingIsKnownOfMinds) {
  EXPECT_EQ(Record(2, record::Level::kWorld).Inspect("hero"), nullptr);
}

TEST(RecordedMinds, DecisionsBuildTheStackAndTakeItDown) {
  record::TickRecord tick;
  record::MindRecord& mind = tick.minds.emplace_back();
  mind.agent = "hero";
  mind.events.Add(mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}});
  mind.events.Add(mind::OperatorSelected{1, "O1", "go", {}});
  mind.events.Add(mind::StateMade{2, "S2", mind::StateReason::kNoChange, true, {}});
  mind.events.Add(mind::OperatorSelected{2, "O2", "look", {}});
  mind.events.Add(mind::CommandSaid{0, "move-to", "hero*say", {{0, false, "waypoint", std::string_view("gate")}}});
  mind.events.Add(mind::CommandEnded{"move-to", mind::CommandStatus::kError, "no-way"});
  RecordedMinds minds;
  minds.Add(tick);
  const std::string text = ToText(LookAtStack(*minds.Inspect("hero")));
  EXPECT_THAT(text, HasSubstr("==>S: S2 (operator no-change)"));
  EXPECT_THAT(text, HasSubstr("O: O2 (look)"));
  const std::string why = ToText(WhyRecorded(*minds.Find("hero"), "hero"));
  EXPECT_THAT(why, HasSubstr("command move-to ^waypoint gate: error no-way"));
  EXPECT_THAT(why, HasSubstr("rule hero*say"));

  tick.tick = 1;
  mind.events.Clear();
  mind.events.Add(mind::StateGone{2, "S2"});
  mind.events.Add(mind::OperatorSelected{1, "O3", "rest", {}});
  minds.Add(tick);
  const std::string later = ToText(LookAtStack(*minds.Inspect("hero")));
  EXPECT_THAT(later, HasSubstr("O: O3 (rest)"));
  EXPECT_THAT(later, Not(HasSubstr("S2")));
  EXPECT_EQ(minds.Inspect("hero")->Mind().decisions, 3u);
}

TEST(RecordedMinds, AValueIsOneValueWhateverStandsInIt) {
  record::TickRecord tick;
  record::MindRecord& mind = tick.minds.emplace_back();
  mind.agent = "hero";
  mind.events.Add(mind::CommandSaid{
      0, "say", {}, {{0, false, "text", std::string_view("go ^fast")}, {0, false, "loud", std::string_view("yes")}}});
  RecordedMinds minds;
  minds.Add(tick);
  const std::unique_ptr<explain::Inspector> recorded = minds.Inspect("hero");
  const std::vector<explain::ElementFact> commands = recorded->ElementsOf("output-link");
  ASSERT_EQ(commands.size(), 1u);
  const std::vector<explain::ElementFact> parameters = recorded->ElementsOf(commands.front().value);
  ASSERT_EQ(parameters.size(), 2u);
  EXPECT_EQ(parameters[0].attribute, "text");
  EXPECT_EQ(parameters[0].value, "go ^fast");
  EXPECT_EQ(parameters[1].attribute, "loud");
}

TEST(RecordedMinds, ARecordingThatBeginsInTheMiddleOfARunSaysSo) {
  record::TickRecord tick;
  tick.tick = 300;
  record::MindRecord& mind = tick.minds.emplace_back();
  mind.agent = "hero";
  mind.events.Add(mind::OperatorSelected{3, "O9", "aim", {}});
  RecordedMinds minds(record::Level::kAll);
  minds.Add(tick);
  const std::unique_ptr<explain::Inspector> recorded = minds.Inspect("hero");
  ASSERT_NE(recorded, nullptr);
  EXPECT_EQ(recorded->Stack().size(), 3u);
  EXPECT_THAT(MemoryAbsence(*recorded), HasSubstr("middle of the run"));
}

}  // namespace
}  // namespace soarbox::debugger
