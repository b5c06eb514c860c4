// SPDX-License-Identifier: BSD-2-Clause
#include "wording/mind_words.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <type_traits>
#include <utility>
#include <variant>

#include "mind/decision_codec.h"

namespace soarbox::wording {
namespace {

using Lines = std::vector<std::string>;

/// One operator, proposed by a rule.
std::string OnlyOne() {
  mind::DecisionView decision;
  decision.operators = {{"O1", "seek"}};
  decision.preferences = {{mind::PreferenceKind::kAcceptable, 0, mind::Decision::kNoOperator, 0, "scout*propose"}};
  decision.left = {{0, 0, 1}};
  decision.selected = 0;
  std::string bytes;
  mind::Pack(decision, bytes);
  return bytes;
}

TEST(MindWords, PerceptsAreWordedWithPathKeyAndValue) {
  mind::EventLog log;
  log.Add(mind::PerceptChanged{"", "distance", 0, 12.5});
  log.Add(mind::PerceptChanged{"agent#3.", "visible", 0, std::string_view("yes")});
  log.Add(mind::PerceptChanged{"self.", "rounds", 0, std::int64_t{-7}});
  log.Add(mind::PerceptChanged{"", "sound", 2, std::string_view()});
  log.Add(mind::PerceptChanged{"", "bearing", 0, 1.0 / 3});
  log.Add(mind::PerceptGone{"agent#3.", "path", 4});
  EXPECT_EQ(Words(log).percepts, (Lines{"distance 12.5", "agent#3.visible yes", "self.rounds -7", "sound#2 ",
                                        "bearing 0.333333", "-agent#3.path#4"}));
}

TEST(MindWords, DecisionsAreIndentedByLevelAndHaveTheirReasons) {
  mind::EventLog log;
  const std::string decision = OnlyOne();
  log.Add(mind::OperatorSelected{1, "O1", "seek", decision});
  log.Add(mind::StateMade{2, "S2", mind::StateReason::kNoChange, true, {}});
  log.Add(mind::OperatorSelected{2, "O2", "", "damaged"});
  log.Add(mind::RuleLearned{2, "chunk*a", "a", "S2", mind::StateReason::kTie, true});
  log.Add(mind::StateGone{2, "S2"});
  log.Add(mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}});
  log.Add(mind::Recalled{1, false, 12, "^kind ammo", "^kind ammo ^at mill", "the only one that fits"});
  log.Add(mind::ValueUpdated{"rl*one", 0.25});
  log.Add(mind::RewardReceived{-1});
  log.Add(mind::EpisodeEnded{});
  log.Add(mind::OperatorSelected{1, "O3", "rest", {}});
  log.Add(mind::Remark{"the others are worse"});
  log.Add(mind::Halted{});
  const MindWords words = Words(log);
  EXPECT_EQ(words.decisions, (Lines{"O: O1 (seek)", "   ==>S: S2 (operator no-change)", "   O: O2", "   learn chunk*a",
                                    "   <==S: S2", "==>S: S1", "recall @12 {^kind ammo ^at mill} for {^kind ammo}",
                                    "value rl*one 0.25", "reward -1", "episode ends", "O: O3 (rest)", "halt"}));
  EXPECT_EQ(words.reasons,
            (Lines{"the only operator proposed, by rule scout*propose", "", "", "from a in S2 (operator tie)", "", "",
                   "the only one that fits", "", "", "", "as recorded: the others are worse", ""}));
}

TEST(MindWords, CommandsHaveTheirParametersAndTheRuleThatMadeThem) {
  using mind::Parameter;
  mind::EventLog log;
  log.Add(mind::CommandSaid{18, "shoot", "scout*shoot", {{0, false, "at", std::string_view("red-1")}}});
  log.Add(mind::CommandEnded{"move-to", mind::CommandStatus::kComplete, {}});
  log.Add(mind::CommandEnded{"aim", mind::CommandStatus::kError, "no-target"});
  log.Add(mind::CommandSaid{19,
                            "say",
                            {},
                            {{0, true, "at", {}},
                             {1, false, "x", 1.5},
                             {1, true, "none", {}},
                             {1, false, "z", std::int64_t{-2}},
                             {0, false, "text", std::string_view("go ^fast")},
                             {0, true, "empty", {}}}});
  log.Add(mind::CommandSaid{20, "wander", {}, {}});
  const MindWords words = Words(log);
  EXPECT_EQ(words.commands, (Lines{"shoot ^at red-1", "move-to: complete", "aim: error no-target",
                                   "say ^at (^x 1.5 ^none () ^z -2) ^text |go ^fast| ^empty ()", "wander"}));
  EXPECT_EQ(words.command_rules, (Lines{"scout*shoot", "", "", "", ""}));
}

TEST(MindWords, DetailsCountTheDecisionsBeforeThemAndCanBeLeftOut) {
  mind::EventLog log;
  log.Add(mind::RuleFired{"scout*propose", false});
  log.Add(mind::ElementChanged{true, 12, "S1", "operator", "O1", true, true});
  log.Add(mind::OperatorSelected{1, "O1", "seek", {}});
  log.Add(mind::ElementChanged{false, 9, "O1", "name", "seek", false, false});
  log.Add(mind::RuleFired{"scout*propose", true});
  EXPECT_EQ(Words(log).details, (Lines{"0 fire scout*propose", "0 + 12: S1 ^operator O1 +", "1 - 9: O1 ^name seek",
                                       "1 retract scout*propose"}));
  EXPECT_TRUE(Words(log, false).details.empty());
  EXPECT_EQ(Words(log, false).decisions.size(), 1u);
}

/// The names of an event's fields, as the page on recordings lists them.
struct Names {
  std::string text;
  template <typename Field>
  void operator()(const char* name, const Field&) {
    text += (text.empty() ? "" : ", ") + std::string(name);
  }
};

template <std::size_t... kinds>
std::vector<std::string> FieldsOfKinds(std::index_sequence<kinds...>) {
  std::vector<std::string> rows;
  const auto add = [&rows](const auto& event) {
    Names names;
    std::decay_t<decltype(event)>::Fields(event, names);
    rows.push_back(names.text);
  };
  (add(std::variant_alternative_t<kinds, mind::Event>()), ...);
  return rows;
}

TEST(MindEvents, ThePageOfRecordingsListsEachKindWithItsFields) {
  std::ifstream in(std::string(SOARBOX_SOURCE_DIR) + "/docs/dev/recording_format.md");
  std::ostringstream page;
  page << in.rdbuf();
  const std::size_t table = page.str().find("The mind events, by their number");
  ASSERT_NE(table, std::string::npos);
  const std::vector<std::string> rows = FieldsOfKinds(std::make_index_sequence<std::variant_size_v<mind::Event>>());
  for (std::size_t kind = 0; kind < rows.size(); ++kind) {
    const std::size_t row = page.str().find("\n| " + std::to_string(kind) + " | ", table);
    ASSERT_NE(row, std::string::npos) << kind;
    const std::string line = page.str().substr(row + 1, page.str().find('\n', row + 1) - row - 1);
    EXPECT_TRUE(line.ends_with("| " + rows[kind] + (rows[kind].empty() ? "|" : " |"))) << line;
  }
}

}  // namespace
}  // namespace soarbox::wording
