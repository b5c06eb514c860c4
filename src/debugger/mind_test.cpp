// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "debugger/agents.h"
#include "debugger/breakpoints.h"
#include "debugger/console.h"
#include "debugger/io_rows.h"
#include "debugger/memory.h"
#include "debugger/mind_fixture.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/rule_edit.h"
#include "debugger/rules.h"
#include "debugger/run_models.h"
#include "debugger/stack_rows.h"
#include "debugger/views.h"
#include "debugger/why.h"

namespace soarbox::debugger {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using Debugger = MindFixture;

constexpr const char* kTwoOperators = R"(
sp {hero*elaborate (state <s> ^superstate nil ^io.input-link.self.health <h>) --> (<s> ^vigour <h>)}
sp {hero*propose*walk (state <s> ^superstate nil ^vigour > 50) --> (<s> ^operator <o> +) (<o> ^name walk)}
sp {hero*propose*rest (state <s> ^superstate nil ^vigour <v>) --> (<s> ^operator <o> +) (<o> ^name rest)}
sp {hero*prefer*walk (state <s> ^operator <w> + ^operator <r> +) (<w> ^name walk) (<r> ^name rest)
 --> (<s> ^operator <w> > <r>)}
sp {hero*apply*walk (state <s> ^operator.name walk ^io.output-link <out>) --> (<out> ^move <m>) (<m> ^speed 1.5)}
sp {hero*never (state <s> ^superstate nil ^vigour < 10) --> (<s> ^afraid yes)}
)";

constexpr const char* kTie = R"(
sp {hero*one (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name one)}
sp {hero*two (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name two)}
)";

TEST_F(Debugger, TheWinnerIsToldWithTheRuleThatMadeItWin) {
  Start(kTwoOperators);
  Tick();
  const auto mind = Mind();
  ASSERT_NE(mind, nullptr);
  const OperatorsView view = LookAtOperators(*mind, "S1");
  ASSERT_EQ(view.rows.size(), 2u);
  const auto walk = std::ranges::find(view.rows, "walk", &OperatorRow::name);
  const auto rest = std::ranges::find(view.rows, "rest", &OperatorRow::name);
  EXPECT_TRUE(walk->selected);
  EXPECT_THAT(view.sentence,
              HasSubstr("walk (" + walk->id + ") was selected: rule hero*prefer*walk makes it better than rest (" +
                        rest->id + ")."));
  EXPECT_EQ(rest->verdict, "rule hero*prefer*walk makes it worse than walk (" + walk->id + ")");
}

TEST_F(Debugger, OperatorsOfOneNameAreToldApartByWhatDiffers) {
  Start(R"(
sp {hero*places (state <s> ^superstate nil) --> (<s> ^place <n> <e>) (<n> ^name north) (<e> ^name east)}
sp {hero*propose (state <s> ^superstate nil ^place <p>)
 --> (<s> ^operator <o> + =) (<o> ^name go ^to <p> ^pace 2)}
sp {hero*rest (state <s> ^superstate nil ^place.name north) --> (<s> ^operator <o> + <) (<o> ^name rest ^for 3)}
)");
  Tick();
  const auto mind = Mind();
  ASSERT_NE(mind, nullptr);
  const OperatorsView view = LookAtOperators(*mind, "S1");
  ASSERT_EQ(view.rows.size(), 3u);
  std::vector<std::string> about;
  for (const OperatorRow& row : view.rows) about.push_back(row.about);
  EXPECT_THAT(about, testing::UnorderedElementsAre(testing::MatchesRegex("\\^to [A-Z][0-9]+ \\(north\\)"),
                                                   testing::MatchesRegex("\\^to [A-Z][0-9]+ \\(east\\)"), ""));
  EXPECT_THAT(ToText(view), HasSubstr(") ^to "));
  EXPECT_THAT(ToText(view), Not(HasSubstr("^pace")));
  EXPECT_THAT(ToText(view), Not(HasSubstr("^for")));
}

TEST_F(Debugger, ATieIsToldAndShownOnTheStack) {
  Start(kTie);
  Tick();
  const auto mind = Mind();
  EXPECT_THAT(LookAtOperators(*mind, "S1").sentence, HasSubstr("no preference decides among one (O"));
  const StackView stack = LookAtStack(*mind);
  ASSERT_GE(stack.levels.size(), 2u);
  EXPECT_EQ(stack.levels[1].impasse, "operator tie");
  EXPECT_THAT(Phases(), Contains(stack.phase));
  EXPECT_EQ(stack.rules, 2u);
}

TEST_F(Debugger, MemoryTellsWhoMadeAnElementAndWhoTestsIt) {
  Start(kTwoOperators);
  Tick();
  const auto mind = Mind();
  const MemoryObject state = LookAtObject(*mind, "S1");
  const auto vigour =
      std::ranges::find_if(state.rows, [](const MemoryRow& row) { return row.element.attribute == "vigour"; });
  ASSERT_NE(vigour, state.rows.end());
  const std::optional<ElementStory> story = LookAtElement(*mind, vigour->element.timetag);
  ASSERT_TRUE(story.has_value());
  ASSERT_EQ(story->makers.size(), 1u);
  EXPECT_EQ(story->makers[0].rule, "hero*elaborate");
  EXPECT_FALSE(story->makers[0].elements.empty());
  std::map<std::string, bool> testers;
  for (const explain::TesterFact& tester : story->testers) testers[tester.rule] = tester.matches;
  EXPECT_EQ(testers, (std::map<std::string, bool>{
                         {"hero*propose*walk", true}, {"hero*propose*rest", true}, {"hero*never", false}}));
  EXPECT_FALSE(LookAtElement(*mind, 999'999).has_value());
  EXPECT_FALSE(LookAtObject(*mind, "Z99").exists);
  EXPECT_FALSE(LookAtObject(*mind, "no id").exists);
}

TEST_F(Debugger, MemoryIsATreeThatCanBeSearchedAndMarksWhatIsNew) {
  Start(kTwoOperators);
  const record::TickRecord& tick = Tick();
  const auto mind = Mind();
  const MemoryChanges changes(record::FindMind(tick, "hero")->events);
  const MemoryObject state = LookAtObject(*mind, "S1", changes, 4);
  const auto vigour =
      std::ranges::find_if(state.rows, [](const MemoryRow& row) { return row.element.attribute == "vigour"; });
  ASSERT_NE(vigour, state.rows.end());
  EXPECT_EQ(vigour->change, Change::kAdded);
  EXPECT_THAT(ToText(state), HasSubstr("^health 100"));
  const std::vector<explain::ElementFact> found = SearchMemory(*mind, "vigour");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].value, "100");
}

TEST_F(Debugger, ARuleThatDoesNotMatchTellsWhereItStopsAndWhatItSaw) {
  Start(kTwoOperators);
  Tick(3);
  const auto mind = Mind();
  const std::optional<RuleView> rule = LookAtRule(*mind, "hero*never");
  ASSERT_TRUE(rule.has_value());
  EXPECT_THAT(rule->match.sentence, HasSubstr("stops at condition"));
  EXPECT_THAT(rule->match.sentence, HasSubstr("^vigour of S1 is 100"));
  EXPECT_THAT(rule->rule.file, HasSubstr("hero.soar"));
  EXPECT_EQ(rule->rule.line, 8);
  EXPECT_FALSE(LookAtRule(*mind, "hero*nevr").has_value());
  EXPECT_THAT(NearRules(*mind, "hero*nevr"), Contains("hero*never"));
  EXPECT_EQ(ListRules(*mind, "HERO propose").size(), 2u);
  EXPECT_THAT(LookAtRule(*mind, "hero*elaborate")->match.sentence, HasSubstr("matches"));
}

TEST_F(Debugger, CoverageTellsRulesThatFiredAndWhereOthersStop) {
  Start(kTwoOperators);
  Coverage coverage;
  for (std::uint64_t tick = 1; tick <= 3; ++tick)
    if (const record::MindRecord* mind = record::FindMind(Tick(), "hero")) coverage.Add(tick, *mind);
  coverage.Look(*Mind());
  const std::vector<Coverage::Row> rows = coverage.rows();
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0].rule, "hero*elaborate");
  EXPECT_GE(rows[0].firings, 1u);
  EXPECT_EQ(rows[0].first, 1u);
  EXPECT_EQ(rows[5].rule, "hero*never");
  EXPECT_EQ(rows[5].firings, 0u);
  EXPECT_FALSE(rows[5].matched);
  EXPECT_THAT(rows[5].stops_at, HasSubstr("^vigour"));
}

TEST_F(Debugger, WhyLeadsFromTheAgentToThePercept) {
  Start(kTwoOperators);
  Tick();
  const std::string text = ToText(WhyAgent(*simulation_, "hero"));
  EXPECT_THAT(text, HasSubstr("command move ^speed 1.5"));
  EXPECT_THAT(text, HasSubstr("was selected: rule hero*prefer*walk makes it better than rest"));
  EXPECT_THAT(text, HasSubstr("rule hero*elaborate"));
  EXPECT_THAT(text, HasSubstr("^health 100 (perceived)"));
  EXPECT_THAT(ToText(*WhyCommand(*Mind(), "move")), HasSubstr("rule hero*apply*walk"));
  EXPECT_THAT(ToText(WhyNameOrError(*simulation_, "hero", "rest")), HasSubstr("makes it worse than walk"));
  EXPECT_THAT(ToText(WhyNameOrError(*simulation_, "hero", "rst")), HasSubstr("did you mean rest?"));
  EXPECT_THAT(ToText(WhyAgent(*simulation_, "nobody")), HasSubstr("there is no agent nobody"));
}

TEST_F(Debugger, LinksAreTreesAndCommandsHaveAStatus) {
  Start(kTwoOperators);
  Tick();
  const IoView view = LookAtIo(*Mind());
  EXPECT_TRUE(view.input.exists);
  ASSERT_EQ(view.commands.size(), 1u);
  EXPECT_EQ(view.commands[0].name, "move");
  ASSERT_EQ(view.commands[0].parameters.size(), 1u);
  EXPECT_EQ(view.commands[0].parameters[0].element.value, "1.500000");
  EXPECT_FALSE(view.commands[0].status.empty());
}

TEST_F(Debugger, TheConsoleAnswersAtOnceAndTheRunKeepsWhatWasTyped) {
  Start(kTwoOperators);
  Tick();
  Console console("hero");
  console.Run(*simulation_, "print s1");
  EXPECT_THAT(ToText(console.lines()), HasSubstr("^vigour 100"));
  console.Run(*simulation_, "pirnt s1");
  EXPECT_THAT(ToText(console.lines()), HasSubstr("error: "));
  EXPECT_THAT(ToText(console.lines()), HasSubstr("print"));
  console.Run(*simulation_, "  ");
  const std::size_t lines = console.lines().size();
  const record::TickRecord& tick = Tick();
  EXPECT_EQ(tick.inputs.size(), 2u);
  EXPECT_THAT(tick.inputs[0], HasSubstr("command \"hero\""));
  console.Add(tick.events);
  EXPECT_EQ(console.lines().size(), lines) << "its own lines come once";
  const Completion completion = Complete(*Mind(), "matches hero*pro");
  EXPECT_EQ(completion.common, "hero*propose*");
  EXPECT_EQ(completion.words.size(), 2u);
}

TEST_F(Debugger, BreakpointsAreHitAndSayWhy) {
  Start(kTwoOperators);
  Breakpoints points;
  ASSERT_TRUE(points.Set(BreakKind::kFire, "", "hero*apply*walk").ok());
  ASSERT_TRUE(points.Set(BreakKind::kElement, "hero", "S1 ^vigour *").ok());
  ASSERT_TRUE(points.Set(BreakKind::kCommand, "", "move").ok());
  ASSERT_TRUE(points.Set(BreakKind::kMatch, "", "hero*elaborate").ok());
  ASSERT_TRUE(points.Set(BreakKind::kImpasse, "", "tie").ok());
  EXPECT_FALSE(points.Set(BreakKind::kFire, "", " ").ok());
  EXPECT_FALSE(points.Set(BreakKind::kElement, "", "vigour").ok());
  points.Prepare(*simulation_);
  Tick();
  const std::vector<BreakHit> hits = points.Check(*simulation_, record_.events);
  ASSERT_EQ(hits.size(), 4u);
  EXPECT_EQ(hits[0].why, "breakpoint 1: hero: rule hero*apply*walk fired");
  EXPECT_EQ(hits[1].why, "breakpoint 2: hero: S1 ^vigour 100 came");
  EXPECT_EQ(hits[2].why, "breakpoint 3: hero: command move ^speed 1.5");
  EXPECT_EQ(hits[3].why, "breakpoint 4: hero: rule hero*elaborate matches");
  EXPECT_TRUE(points.Enable(2, false));
  EXPECT_TRUE(points.Clear(1));
  EXPECT_FALSE(points.Clear(1));
  points.Prepare(*simulation_);
  Tick();
  EXPECT_TRUE(points.Check(*simulation_, record_.events).empty()) << "what was there a tick ago is no news";
}

TEST_F(Debugger, BreakpointsOnOperatorsNumbersAndWhatGoes) {
  Start(R"(
sp {hero*count (state <s> ^superstate nil ^io.input-link.time <t>) --> (<s> ^seconds <t>)}
sp {hero*propose*wave (state <s> ^superstate nil ^seconds < 0.1) --> (<s> ^operator <o> + =) (<o> ^name wave)}
sp {hero*propose*fly (state <s> ^superstate nil ^seconds >= 0.1) --> (<s> ^operator <o> + =) (<o> ^name fly)}
sp {hero*apply*fly (state <s> ^operator.name fly ^io.output-link <out>) --> (<out> ^move-to <m>) (<m> ^target nobody)}
)");
  Breakpoints points;
  const auto set = [&](BreakKind kind, const std::string& what) { return points.Set(kind, "", what).ok(); };
  ASSERT_TRUE(set(BreakKind::kOperator, "fly"));
  ASSERT_TRUE(set(BreakKind::kNumber, "S1 ^seconds >= 0.1"));
  ASSERT_TRUE(set(BreakKind::kRemoved, "* ^name wave"));
  ASSERT_TRUE(set(BreakKind::kFailed, ""));
  ASSERT_TRUE(set(BreakKind::kTime, " 0.2 "));
  for (const char* wrong : {"health < 20", "^health 20", "^health < much", "^health < 20 30", ""})
    EXPECT_FALSE(set(BreakKind::kNumber, wrong)) << wrong;
  EXPECT_FALSE(set(BreakKind::kTime, "soon"));
  EXPECT_FALSE(set(BreakKind::kRemoved, "name"));
  std::map<int, std::vector<std::string>> told;
  for (int i = 0; i < 12; ++i) {
    points.Prepare(*simulation_);
    Tick();
    for (const BreakHit& hit : points.Check(*simulation_, record_.events)) told[hit.number].push_back(hit.why);
  }
  ASSERT_FALSE(told[1].empty());
  EXPECT_THAT(told[1][0], HasSubstr("hero: operator fly (O"));
  ASSERT_EQ(told[2].size(), 1u) << "a number that stays beyond its limit is no news";
  EXPECT_THAT(told[2][0], HasSubstr("hero: S1 ^seconds is 0.1"));
  ASSERT_FALSE(told[3].empty());
  EXPECT_THAT(told[3][0], HasSubstr("^name wave went"));
  ASSERT_FALSE(told[4].empty());
  EXPECT_THAT(told[4][0], HasSubstr("hero: command move-to failed"));
  EXPECT_EQ(told[5], std::vector<std::string>{"breakpoint 5: it is 0.2 s"});
}

TEST_F(Debugger, BreakpointsOnImpassesTakePartsOfNamesAndPatterns) {
  Start(kTie);
  Breakpoints points;
  for (const char* what : {"", "*", "tie", "t*e", "conflict"})
    ASSERT_TRUE(points.Set(BreakKind::kImpasse, "", what).ok());
  std::set<int> hit;
  for (int i = 0; i < 3; ++i) {
    points.Prepare(*simulation_);
    Tick();
    for (const BreakHit& each : points.Check(*simulation_, record_.events)) hit.insert(each.number);
  }
  EXPECT_EQ(hit, (std::set<int>{1, 2, 3, 4}));
}

TEST_F(Debugger, ARunIsTheSameWhetherSomebodyLooksOrNot) {
  Start(kTie);
  for (int i = 0; i < 5; ++i) Tick();
  const std::uint64_t unseen = simulation_->StateHash();
  Start(kTie);
  for (int i = 0; i < 5; ++i) {
    Tick();
    RunModels models;
    models.Add(record_);
    for (const ViewInfo& view : Views()) {
      if (view.name == "console") continue;
      const Result<ViewText> shown =
          ShowView({simulation_.get(), &models, &record_},
                   {std::string(view.name), "hero", view.of == "RULE" ? "hero*one" : "", 0, 9});
      EXPECT_TRUE(shown.ok()) << view.name << ": " << Format(shown.error());
    }
  }
  EXPECT_EQ(simulation_->StateHash(), unseen);
}

TEST_F(Debugger, AnEditIsCheckedWithItsLinesAndTakesEffectInTheNextTick) {
  Start(kTwoOperators);
  Tick();
  const std::vector<sim::WatchedFile> files = FilesOf(*simulation_, "hero");
  const auto rules = std::ranges::find_if(files, [](const sim::WatchedFile& file) { return file.is_rules; });
  ASSERT_NE(rules, files.end());
  Result<Edit> edit = Edit::Open(*rules);
  ASSERT_TRUE(edit.ok());
  EXPECT_EQ(edit->LineOf("hero*never"), 8);
  const std::string good = edit->text();
  edit->text() = good + "sp {hero*bad (state <s> ^superstate nil) --> (<s> ^x }\n";
  const std::vector<Diagnostic> problems = edit->Apply(*simulation_);
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0].line, 9);
  EXPECT_EQ(problems[0].file, rules->file.string());
  edit->text() = good + "sp {hero*new (state <s> ^superstate nil) --> (<s> ^edited yes)}\n";
  EXPECT_TRUE(edit->is_changed());
  EXPECT_TRUE(edit->Apply(*simulation_).empty());
  EXPECT_FALSE(edit->is_changed());
  EXPECT_TRUE(edit->is_unsaved());
  Tick();
  EXPECT_EQ(SearchMemory(*Mind(), "edited").size(), 1u);
  ASSERT_TRUE(edit->Save().ok());
  EXPECT_FALSE(edit->is_unsaved());
}

TEST_F(Debugger, AScenarioFileIsCheckedAsOneAndTakesEffectWhenTheWorldBeginsAgain) {
  Start(kTwoOperators);
  const std::vector<sim::WatchedFile> files = FilesOf(*simulation_, "hero");
  ASSERT_FALSE(files.empty());
  EXPECT_EQ(files.back().file, folder_ / "scenario.toml");
  Result<Edit> edit = Edit::Open(files.back());
  ASSERT_TRUE(edit.ok());
  EXPECT_TRUE(edit->Check().empty());
  const std::string good = edit->text();
  edit->text() = good + "colour = 3\n";
  const std::vector<Diagnostic> problems = edit->Apply(*simulation_);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].line, 6);
  EXPECT_NE(problems[0].message.find("colour"), std::string::npos);
  edit->text() = good + "# A comment.\n";
  EXPECT_TRUE(edit->Apply(*simulation_).empty());
  EXPECT_EQ(simulation_->waiting_inputs(), 0u);
  ASSERT_TRUE(edit->Save().ok());
  EXPECT_TRUE(edit->is_changed()) << "the world runs as it was built";
  edit->BeginAgain();
  EXPECT_FALSE(edit->is_changed());
}

TEST_F(Debugger, FilesThatRulesSourceAreEditedByThemselves) {
  Start(kTwoOperators);
  Write(rules_file_, "source more.soar\n" + std::string(kTwoOperators));
  Write(folder_ / "more.soar", "sp {hero*more (state <s> ^superstate nil) --> (<s> ^other no)}\n");
  const std::vector<sim::WatchedFile> files = FilesOf(*simulation_, "hero");
  const auto named = [&](const char* name) {
    return std::ranges::find_if(files, [&](const sim::WatchedFile& file) { return file.file.filename() == name; });
  };
  ASSERT_NE(named("hero.soar"), files.end());
  ASSERT_NE(named("more.soar"), files.end());
  Result<Edit> edit = Edit::Open(*named("hero.soar"));
  ASSERT_TRUE(edit.ok());
  EXPECT_TRUE(edit->Check().empty()) << Format(edit->Check()[0]);
  edit->text() = "source nowhere.soar\n";
  EXPECT_FALSE(edit->Check().empty());
  edit = Edit::Open(*named("more.soar"));
  ASSERT_TRUE(edit.ok());
  edit->text() = "sp {hero*more (state <s> ^superstate nil) --> (<s> ^edited yes)}\n";
  EXPECT_TRUE(edit->Apply(*simulation_).empty());
  Tick();
  EXPECT_EQ(SearchMemory(*Mind(), "edited").size(), 1u);
}

TEST_F(Debugger, AgentsAreListedAndFiltered) {
  Start(kTie,
        "[[agent]]\nname = \"hero\"\nrules = \"hero.soar\"\nbody = \"soldier\"\nposition = [0, 0]\nteam = \"red\"\n"
        "[[agent]]\nname = \"ally\"\nrules = \"hero.soar\"\nbody = \"soldier\"\nposition = [9, 0]\nteam = \"blue\"\n");
  AgentTroubles troubles;
  troubles.Add(Tick().events);
  std::vector<AgentRow> rows = ListAgents(*simulation_, troubles);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name, "hero");
  EXPECT_EQ(StateText(rows[0]), rows[0].state + " (operator tie)");
  EXPECT_GT(rows[0].decisions, 0u);
  EXPECT_GT(rows[0].decide_us, 0);
  RunModels models;
  const auto shown = [&](const std::string& filter) {
    return ShowView({simulation_.get(), &models, &record_}, {"agents", "", filter, 0, 9})->text;
  };
  EXPECT_THAT(shown("BLUE al"), testing::AllOf(HasSubstr("blue"), testing::Not(HasSubstr("red"))));
  EXPECT_THAT(shown(""), testing::AllOf(HasSubstr("blue"), HasSubstr("red")));
}

TEST_F(Debugger, NumbersOfBodyMindAndMemoryCanBePlotted) {
  Start(kTwoOperators);
  Plots plots;
  for (const char* what : {"health", "self.health", "S1.vigour", "decide_us", "fired", "no.such"})
    EXPECT_TRUE(plots.Plot("hero", what));
  EXPECT_FALSE(plots.Plot("hero", "health"));
  for (int i = 0; i < 3; ++i) {
    plots.Add(Tick());
    plots.Sample(*simulation_);
  }
  ASSERT_EQ(plots.series().size(), 6u);
  EXPECT_EQ(plots.series()[0].points.size(), 3u);
  EXPECT_EQ(plots.series()[0].points[0].value, 100);
  EXPECT_EQ(plots.series()[1].points.back().value, 100);
  EXPECT_EQ(plots.series()[2].points.back().value, 100);
  EXPECT_GT(plots.series()[3].maximum, 0);
  EXPECT_GT(plots.series()[4].points[0].value, 3);
  EXPECT_TRUE(plots.series()[5].points.empty());
  EXPECT_THAT(Plottable(*Mind()), Contains("S1.vigour"));
}

}  // namespace
}  // namespace soarbox::debugger
