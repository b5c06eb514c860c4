// SPDX-License-Identifier: BSD-2-Clause
#include "cli/interpreter.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/command.h"
#include "cli/help.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class InterpreterTest : public testing::Test {
 protected:
  InterpreterTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("soarbox_cli_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    session_.stream().SetSink([this](std::string_view text) { printed_ += text; });
  }
  ~InterpreterTest() override { std::filesystem::remove_all(folder_); }

  CommandResult Do(const std::string& line) { return interpreter_.Execute(session_, line); }

  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::filesystem::path folder_;
  kernel::Agent agent_{"soar"};
  Session session_{agent_};
  Interpreter interpreter_;
  std::string printed_;
};

constexpr const char* kGo = "sp {go (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}";

TEST_F(InterpreterTest, AnElementMayLeadToAnIdentifierThatIsNotThereYet) {
  EXPECT_THAT(Do("wm add S1 ^link X7").text, StartsWith("Timetag: "));
  EXPECT_THAT(Do("print s1").text, HasSubstr("^link X7"));
  EXPECT_THAT(Do("wm add X7 ^size 3").text, StartsWith("Timetag: "));
  EXPECT_THAT(Do("wm add S1 ^other x7").text, StartsWith("Timetag: "));
  EXPECT_THAT(Do("print s1").text, HasSubstr("^other X7"));
  EXPECT_THAT(Do("wm add S1 ^next *").text, StartsWith("Timetag: "));
  EXPECT_FALSE(Do("wm add Q3 ^link X8").ok) << "the object must be there";
  EXPECT_FALSE(Do("wm add S1 ^X9 a").ok) << "so must an attribute";
  EXPECT_FALSE(Do("wm add S1 ^link X18446744073709551615").ok);
  EXPECT_EQ(agent_.CheckInvariants(), "");
}

TEST_F(InterpreterTest, NegativeNumbersAreArgumentsOfAllCommands) {
  EXPECT_TRUE(Do("decide set-random-seed -5").ok) << Do("decide set-random-seed -5").text;
  EXPECT_TRUE(Do("srand -5").ok);
  EXPECT_TRUE(Do("wm add S1 ^height -2.5").ok);
  EXPECT_THAT(Do("print s1").text, HasSubstr("^height -2.5"));
}

TEST_F(InterpreterTest, AFileIsFoundWhereBackslashesSeparateFolders) {
  std::filesystem::create_directories(folder_ / "deep");
  Write("deep/here.soar", std::string(kGo) + "\n");
  Do("cd " + folder_.string());
  EXPECT_TRUE(Do("source {deep\\here.soar}").ok) << Do("source {deep\\here.soar}").text;
  EXPECT_THAT(Do("print").text, HasSubstr("go"));
  EXPECT_THAT(Do("source {deep\\none.soar}").text, HasSubstr("deep\\none.soar"));
}

TEST_F(InterpreterTest, AnImageIsWrittenAndReadByTheCommandOfOlderScripts) {
  Do(kGo);
  Do("cd " + folder_.string());
  EXPECT_TRUE(Do("rete-net -s x.net").ok);
  EXPECT_THAT(Do("excise --all").text, HasSubstr("1 production excised."));
  EXPECT_TRUE(Do("rete-net -l x.net").ok);
  EXPECT_THAT(Do("print").text, HasSubstr("go"));
  EXPECT_TRUE(Do("save rete-network --load x.net").ok);
}

TEST_F(InterpreterTest, AQuestionMarkPrintsTheHelpOfACommand) {
  for (const char* const command :
       {"debug", "decide", "epmem", "load", "output", "production", "save", "visualize", "wm"}) {
    const std::string help = Do(std::string("help ") + command).text;
    EXPECT_THAT(help, HasSubstr("\n\n  ")) << command;
    for (const char* const word : {" ?", " help"})
      EXPECT_THAT(Do(std::string(command) + word).text, StartsWith(help)) << command;
  }
  EXPECT_THAT(Do("decide nothing").text, HasSubstr("Invalid decide command.  Use 'decide ?'"));
}

TEST_F(InterpreterTest, AQuestionMarkSucceedsOnlyIfItDoesInSoar) {
  for (const char* const command : {"debug", "decide", "load", "production", "save", "wm"}) {
    const CommandResult asked = Do(std::string(command) + " ?");
    EXPECT_FALSE(asked.ok) << command;
    EXPECT_THAT(asked.text, EndsWith("command failed (see return string for details)\n")) << command;
    EXPECT_TRUE(Do(std::string("help ") + command).ok) << command;
  }
  for (const char* const command : {"epmem", "explain", "output", "soar", "visualize"})
    EXPECT_TRUE(Do(std::string(command) + " ?").ok) << command;
  const CommandResult sourced = Do("source " + Write("asks.soar", "echo before\ndecide ?\n"));
  EXPECT_FALSE(sourced.ok);
  EXPECT_THAT(sourced.text, AllOf(StartsWith("before\n"), HasSubstr("asks.soar:2")));
}

TEST_F(InterpreterTest, SettingsOfSoarAreShownAndChanged) {
  EXPECT_EQ(Do("soar max-gp").text, "max-gp is 20000\n");
  EXPECT_EQ(Do("soar max-gp 5").text, "The maximum number of rules gp can generate is now 5.\n");
  EXPECT_FALSE(Do("soar max-gp 0").ok);
  EXPECT_EQ(Do("soar max-memory-usage 1000").text.substr(0, 63),
            "Soar will now interrupt execution if more than 1000 bytes of me");
  EXPECT_EQ(Do("soar max-memory-usage").text, "max-memory-usage is 1000\n");
  EXPECT_THAT(Do("soar max-dc-time 0").text, HasSubstr("no longer interrupt"));
  EXPECT_EQ(Do("soar wait-snc on").text, "Soar will now wait instead of impassing when a state doesn't change.\n");
  EXPECT_EQ(Do("soar wait-snc").text, "wait-snc is on\n");
}

TEST_F(InterpreterTest, ExcisingChunksExcisesJustifications) {
  Do("sp {pp (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}");
  Do("sp {rr (state <s> ^superstate <ss>) (<ss> ^operator.name a) --> (<ss> ^res t)}");
  Do("run 3");
  EXPECT_THAT(Do("print -j").text, HasSubstr("justif"));
  EXPECT_THAT(Do("excise -c").text, HasSubstr("1 production excised."));
  EXPECT_EQ(Do("print -j").text, "");
}

TEST_F(InterpreterTest, AnAgentMayBehaveLikeAnotherVersion) {
  EXPECT_EQ(Do("soar like").text, "like is 9.6.5\n");
  EXPECT_FALSE(Do("sp {ff (state <s> ^superstate nil) --> (<s> ^x (unheard <s>))}").ok);
  EXPECT_TRUE(Do("soar like 9.6.3").ok);
  EXPECT_TRUE(Do("sp {ff (state <s> ^superstate nil) --> (<s> ^x (unheard <s>))}").ok);
  EXPECT_FALSE(Do("soar like 9.5").ok);
  EXPECT_EQ(Do("soar like").text, "like is 9.6.3\n");
}

TEST_F(InterpreterTest, TheVersionIsTheOneWhoseBehaviourTheAgentHas) {
  EXPECT_THAT(Do("soar version").text, StartsWith("9.6.5\nSoarbox "));
  EXPECT_THAT(Do("soar").text, HasSubstr("Soar 9.6.5 Summary"));
  EXPECT_THAT(Do("help").text, StartsWith("Soar 9.6.5 Command List"));
  Do("soar like 9.6.3");
  EXPECT_THAT(Do("version").text, StartsWith("9.6.3\n"));
  EXPECT_THAT(Do("stats --system").text, HasSubstr("Soar 9.6.3 (Soarbox "));
}

TEST_F(InterpreterTest, TheStarsOfGeneratedRulesBeginALineThatRulesAfterThemContinue) {
  Write("stars.soar",
        "sp {aa (state <s> ^superstate nil) --> (<s> ^a 1)}\n"
        "gp {bb (state <s> ^v [1 2]) --> (<s> ^b 1)}\n"
        "sp {cc (state <s> ^superstate nil) --> (<s> ^c 1)}\n"
        "gp {dd (state <s> ^v [1 2 3 4 5]) --> (<s> ^d 1)}\n");
  EXPECT_THAT(Do("source " + (folder_ / "stars.soar").string()).text, StartsWith("* \n*** \n*****\n"));
}

TEST_F(InterpreterTest, AnElementOfARuleThatIsTakenAwayByHandComesBackWhenItsSlotIsDecidedAgain) {
  Do("sp {make (state <s> ^superstate nil) --> (<s> ^size 3)}");
  Do("sp {more (state <s> ^grow yes) --> (<s> ^size 4)}");
  Do("run 1");
  const kernel::Symbol state = agent_.goals().at(1).id;
  const auto tag = [&](std::int64_t size) {
    for (const kernel::WmeId wme : agent_.memory().WmesOf(state)) {
      if (agent_.memory().wme(wme).value == agent_.mutable_symbols().Integer(size))
        return agent_.memory().wme(wme).timetag;
    }
    return std::uint64_t{0};
  };
  ASSERT_NE(tag(3), 0u);
  EXPECT_TRUE(Do(fmt::format("wm remove {}", tag(3))).ok);
  EXPECT_EQ(tag(3), 0u);
  EXPECT_THAT(Do("preferences s1 size").text, HasSubstr("S1 ^size 3"));
  EXPECT_EQ(agent_.CheckInvariants(), "");
  Do("run 1");
  EXPECT_EQ(tag(3), 0u);
  Do("wm add s1 ^grow yes");
  Do("run 1");
  EXPECT_NE(tag(3), 0u);
  EXPECT_NE(tag(4), 0u);
  EXPECT_EQ(agent_.CheckInvariants(), "");
}

TEST_F(InterpreterTest, AGoalThatGoesTakesTheElementAlongThatWasTakenAwayByHand) {
  Do("sp {top (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}");
  Do("sp {local (state <s> ^impasse no-change -^done) --> (<s> ^operator <o> +) (<o> ^name b)}");
  Do("sp {apply (state <s> ^operator.name b ^superstate <ss> ^impasse <i>) --> (<s> ^done <i>)}");
  Do("run 4");
  const kernel::Symbol state = agent_.goals().at(2).id;
  for (const kernel::WmeId wme : agent_.memory().WmesOf(state)) {
    if (agent_.memory().wme(wme).attribute != agent_.mutable_symbols().String("impasse")) continue;
    EXPECT_TRUE(Do(fmt::format("wm remove {}", agent_.memory().wme(wme).timetag)).ok);
    break;
  }
  EXPECT_EQ(agent_.CheckInvariants(), "");
  Do("run 3");
  EXPECT_EQ(agent_.CheckInvariants(), "");
}

TEST_F(InterpreterTest, TheTraceShowsWhatResultsRestOn) {
  Do("chunk always");
  Do("trace --backtracing");
  Do("sp {pa (state <s> ^superstate nil) --> (<s> ^operator <o> + ^size 7) (<o> ^name a)}");
  Do("sp {pb (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}");
  Do("sp {copy (state <s> ^superstate.size <n>) --> (<s> ^n <n>)}");
  Do("sp {pick (state <s> ^impasse tie ^item <i> ^superstate <ss> ^n <n> -^blocked yes) (<i> ^name a)"
     " --> (<ss> ^operator <i> >)}");
  printed_.clear();
  Do("run 2");
  EXPECT_THAT(printed_,
              HasSubstr("For result preference (S1 ^operator O2 >) [level 2]\n ... BT through instantiation of "
                        "pick\n  -->Grounds:\n     ("));
  EXPECT_THAT(printed_, HasSubstr("^blocked yes"));
  EXPECT_THAT(printed_, HasSubstr(": S2 ^n 7)\n ... BT through instantiation of copy\n  -->Grounds:\n     ("));
  EXPECT_THAT(printed_, HasSubstr(": S2 ^item O2)\n ... BT through the proposal of the item\n"));
  EXPECT_THAT(printed_, HasSubstr(": S2 ^superstate S1)\n ...no trace, can't BT\n"));
  EXPECT_THAT(Do("print --chunks").text, HasSubstr("chunk*pick"));
  Do("trace --backtracing off");
  Do("init-soar");
  printed_.clear();
  Do("run 2");
  EXPECT_THAT(printed_, Not(HasSubstr("Grounds")));
}

TEST_F(InterpreterTest, AnAttributeWithDotsIsRefused) {
  for (const char* attribute : {"foo.x", "^foo.y", "^a.b.c"}) {
    EXPECT_THAT(Do(fmt::format("wm add s1 {} 2", attribute)).text, HasSubstr("Unknown attribute type."));
  }
  EXPECT_TRUE(Do("wm add s1 ^|foo.z| 2").ok);
  EXPECT_TRUE(Do("wm add s1 ^3.5 2").ok);
  EXPECT_TRUE(Do("wm add s1 ^@1 2").ok);
  EXPECT_TRUE(Do("wm add s1 ^host www.example.org").ok);
}

TEST_F(InterpreterTest, ObjectsOfLongTermMemoryAreShownByTheirNames) {
  Do("smem --enable");
  Do("smem --add { (@test1 ^name test1 ^info @info1) (@info1 ^number 1) }");
  EXPECT_EQ(Do("print @").text, "(@test1 ^info @info1 ^name test1 [+0.000])\n(@info1 ^number 1 [+0.000])\n");
  EXPECT_THAT(Do("smem --query { (<x> ^info @info1) }").text, StartsWith("(@test1 "));
  EXPECT_THAT(Do("smem --remove { (@info1 ^number) }").text, HasSubstr("Removal complete"));
  Do("cd " + folder_.string());
  EXPECT_TRUE(Do("smem --export out.smem").ok);
  std::ifstream exported(folder_ / "out.smem");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(exported), {}),
            "smem --add {\n(@test1 ^name test1 ^info @info1)\n}\n");
  Do("soar like 9.6.3");
  EXPECT_THAT(Do("print @1").text, StartsWith("(@1 ^info @2 ^name test1"));
}

TEST_F(InterpreterTest, TheTraceOfSemanticMemoryHasASignForEachObject) {
  Do("trace --smem");
  printed_.clear();
  Do("smem --add { (@1 ^a b c d) (@2 ^e f) }");
  EXPECT_THAT(printed_, HasSubstr("@@"));
  EXPECT_THAT(printed_, Not(HasSubstr("=>SMEM")));
}

TEST_F(InterpreterTest, ACommandIsFoundByAnyUniqueBeginningAndByAlias) {
  EXPECT_TRUE(Do("pri s1").ok);
  EXPECT_TRUE(Do("p s1").ok);
  EXPECT_THAT(Do("so").text, StartsWith("=====")) << "soar is the only command that begins so";
  EXPECT_THAT(Do("ep").text, StartsWith("=====")) << "epmem";
  EXPECT_THAT(Do("pop").text, StartsWith("Directory stack is empty."));
  EXPECT_EQ(Do("po").text, Do("popd").text);
  EXPECT_THAT(Do("l").text, StartsWith("Ambiguous command, possibilities: 'learn' 'load' 'ls' "));
}

TEST_F(InterpreterTest, AMisspeltCommandGetsASuggestionBesideTheTextThatToolsRead) {
  const CommandResult result = Do("pirnt s1");
  EXPECT_FALSE(result.ok);
  EXPECT_EQ(result.text, "No such command: pirnt\n");
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.diagnostics[0].hint, "did you mean 'print'?");
}

TEST_F(InterpreterTest, ALineEndsWithItsFirstCommandThatFails) {
  const CommandResult result = Do("echo a; frob; echo b");
  EXPECT_FALSE(result.ok);
  EXPECT_EQ(result.text, "a\nNo such command: frob\n");
}

TEST_F(InterpreterTest, RunsPrintTheirTraceAndAnswerTheirReport) {
  EXPECT_EQ(Do(kGo).text, "*");
  const CommandResult result = Do("run 1");
  EXPECT_EQ(printed_, "\n     1:    O: O1 (go)");
  EXPECT_EQ(result.text, "\n\n--> 1 decision cycle executed. 1 rule fired. ");
}

TEST_F(InterpreterTest, RetractionsInDetailShowThePreferencesThatGo) {
  Do("sp {once*only (state <s> ^superstate nil -^done) --> (<s> ^operator <o> +) (<o> ^name finish)}");
  Do("sp {apply*finish (state <s> ^operator.name finish) --> (<s> ^done yes)}");
  Do("watch 0");
  Do("trace --user");
  Do("trace --timetags");
  printed_.clear();
  Do("run 4 -p");
  EXPECT_THAT(printed_, HasSubstr("Retracting once*only\n 2 -->\n (O1 ^name finish +)\n (S1 ^operator O1 +)\n"));
}

TEST_F(InterpreterTest, AFileGoesOnAfterARuleThatIsWrongAndNamesItsPlace) {
  const std::string file = Write("agent.soar", std::string(kGo) +
                                                   "\n"
                                                   "sp {wrong (state <s> ^a b) --> (<s> ^c)}\n"
                                                   "sp {last (state <s> ^a b) --> (<s> ^c d)}\n");
  const CommandResult result = Do("source " + file);
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("Illegal value for RHS value"));
  EXPECT_THAT(result.text, HasSubstr("agent.soar:2:"));
  EXPECT_THAT(result.text, HasSubstr("Total: 2 productions sourced."));
  EXPECT_NE(agent_.FindProduction("last"), kernel::ProductionId::kNone);
}

TEST_F(InterpreterTest, AFileThatSourcesItselfIsAnErrorAndNoCrash) {
  const std::string file = Write("loop.soar", "source " + (folder_ / "loop.soar").string() + "\n");
  const CommandResult result = Do("source " + file);
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("This file sources itself: " + file + " -> " + file));
}

TEST_F(InterpreterTest, FilesThatSourceEachOtherTwiceEnd) {
  const std::string a = (folder_ / "a.soar").string(), b = (folder_ / "b.soar").string();
  Write("a.soar", "source " + b + "\nsource " + b + "\n");
  Write("b.soar", "source " + a + "\nsource " + a + "\n");
  const CommandResult result = Do("source " + a);
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("This file sources itself: " + a + " -> " + b + " -> " + a));
  EXPECT_LT(result.text.size(), 10'000u);
}

TEST_F(InterpreterTest, FilesThatSourceEverMoreAreBounded) {
  // Each file sources the next one three times: a billion in all.
  constexpr int kFiles = 20;
  for (int i = 0; i < kFiles; ++i) {
    const std::string line = "source f" + std::to_string(i + 1) + ".soar\n";
    Write("f" + std::to_string(i) + ".soar", i + 1 < kFiles ? line + line + line : std::string("# the last\n"));
  }
  const CommandResult result = Do("source " + (folder_ / "f0.soar").string());
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("files are sourced at once"));
  EXPECT_THAT(result.text, HasSubstr("f0.soar -> "));
  EXPECT_LT(result.text.size(), 100'000u);
}

/// Every command with every option, with a file name in every place of a word, so that new commands are tested, too.
TEST_F(InterpreterTest, AFenceLetsNoCommandWriteAFile) {
  std::vector<std::string> lines;
  const auto with_options = [&](const std::string& start, std::span<const OptionSpec> options) {
    for (const char* words : {"", " leak", " leak print s1", " -a leak", " --set path leak", " --set database file"})
      lines.push_back(start + words);
    for (const OptionSpec& option : options) {
      lines.push_back(start + " --" + std::string(option.name) + " leak");
      lines.push_back(start + " -" + std::string(1, option.letter) + " leak print s1");
    }
  };
  for (const CommandInfo& command : Commands()) {
    if (command.name == "cd" || command.name == "popd" || command.name == "pushd") continue;
    with_options(std::string(command.name), command.options);
    for (const SubcommandInfo& word : command.subcommands)
      with_options(std::string(command.name) + " " + std::string(word.name), word.options);
  }
  ASSERT_GT(lines.size(), 300u);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  interpreter_.ChangeDirectory(folder_.string());
  for (const Fence::Source source : {Fence::Source::kFiles, Fence::Source::kRecording, Fence::Source::kRulesOnly}) {
    const Fence fence({folder_}, source);
    const Interpreter::Fenced fenced(interpreter_, &fence);
    for (const std::string& line : lines) {
      if (source == Fence::Source::kRecording && line.starts_with("run")) continue;
      Do(line);
      ASSERT_TRUE(std::filesystem::is_empty(folder_)) << line;
    }
  }
  std::filesystem::current_path(before);
}

TEST_F(InterpreterTest, WhatIsLookedOverIsNotCarriedOut) {
  const Fence fence({folder_}, Fence::Source::kRulesOnly);
  const Interpreter::Fenced fenced(interpreter_, &fence);
  const CommandResult result =
      Do("source " + Write("agent.soar", "output log leak\nrun 5\necho said\n" + std::string(kGo)));
  EXPECT_TRUE(result.ok) << result.text;
  EXPECT_THAT(result.text, HasSubstr("1 production sourced"));
  EXPECT_THAT(result.text, Not(HasSubstr("said")));
}

TEST_F(InterpreterTest, SettingsOfMissingPartsAreKeptSoThatAgentsLoad) {
  EXPECT_TRUE(
      Do("chunk never; learn --off; smem --set learning on; epmem --set trigger output; rl --set discount-rate 0.5")
          .ok);
  EXPECT_EQ(Do("rl --get discount-rate").text, "0.5");
  EXPECT_THAT(Do("smem --query {(<x> ^a b)}").text, HasSubstr("No results for query"));
}

TEST_F(InterpreterTest, DirectoriesAreTheInterpretersOwn) {
  const std::filesystem::path before = std::filesystem::current_path();
  EXPECT_TRUE(Do("pushd " + folder_.string()).ok);
  EXPECT_EQ(Do("pwd").text, std::filesystem::canonical(folder_).string());
  EXPECT_TRUE(Do("popd").ok);
  EXPECT_FALSE(Do("popd").ok);
  EXPECT_EQ(std::filesystem::current_path(), before);
}

TEST_F(InterpreterTest, ObjectsAreAnsweredInStructuredFormToo) {
  const CommandResult result = Do("print s1");
  ASSERT_FALSE(result.structured.children.empty());
  EXPECT_EQ(result.structured.children[0].tag, "id");
  EXPECT_EQ(result.structured.children[0].children[0].tag, "wme");
}

TEST_F(InterpreterTest, CompletesCommandsSubcommandsOptionsAndRules) {
  Do(kGo);
  EXPECT_THAT(interpreter_.Complete(session_, "prod"), Contains("production"));
  EXPECT_THAT(interpreter_.Complete(session_, "soar max-"), Contains("max-elaborations"));
  EXPECT_THAT(interpreter_.Complete(session_, "print --de"), Contains("--depth"));
  EXPECT_THAT(interpreter_.Complete(session_, "excise g"), Contains("go"));
}

TEST(CommandReference, NamesEveryCommand) {
  const std::string reference = CommandReference();
  for (const CommandInfo& command : Commands()) {
    EXPECT_THAT(reference, HasSubstr("\n## " + std::string(command.name) + "\n"));
  }
}

TEST_F(InterpreterTest, OptimisedAttributesAreTestedLaterByRulesLoadedFromThenOn) {
  constexpr const char* kRule = "{wide (state <s> ^superstate nil ^near <n> ^far <f>) --> (<s> ^done yes)}";
  const auto far_first = [this] {
    const std::string text = Do("print -i wide").text;
    return text.find("^far") < text.find("^near");
  };
  EXPECT_EQ(Do("production optimize-attribute").text, "No optimized attributes found.Value\tSymbol\n");
  Do(std::string("sp ") + kRule);
  EXPECT_TRUE(far_first());
  EXPECT_TRUE(Do("multi-attributes near").ok);
  EXPECT_TRUE(Do("multi-attributes far 20").ok);
  EXPECT_FALSE(Do("multi-attributes far 0").ok);
  EXPECT_EQ(Do("multi-attributes").text, "Value\tSymbol\n20\tfar\n10\tnear\n");
  EXPECT_TRUE(far_first()) << "rules that are there already stay as they are";
  Do(std::string("sp ") + kRule);
  EXPECT_FALSE(far_first());
}

TEST_F(InterpreterTest, ARuleThatHoldsManyPartialMatchesForNoneIsToldOfWithTheOrderThatHelps) {
  std::string make, holds, disks, names;
  for (const char* const n : {"1", "2", "3", "4", "5", "6"}) {
    const std::string number = n;
    make += "(<s> ^holds <h" + number + ">) (<h" + number + "> ^disk <d" + number + ">) (<d" + number + "> ^name " +
            number + ")";
    holds += " <h" + number + ">";
    disks += "(<h" + number + "> ^disk <d" + number + ">)";
    names += "(<d" + number + "> ^name " + (number == "6" ? "none" : number) + ")";
  }
  const std::string file =
      Write("tower.soar", "sp {make (state <s> ^superstate nil) --> " + make + "}\n" + "sp {done (state <s> ^holds" +
                              holds + ")" + disks + names + " --> (<s> ^done yes)}\n");
  const std::string advice =
      "test what distinguishes each ^holds directly after it, in this order: (state <s> ^holds <h6>) (<h6> ^disk <d6>) "
      "(<d6> ^name none), then the next ^holds; or declare `multi-attributes holds 6` in front of the rule";
  Do("multi-attributes disk 6");  // Therefore ^disk is tested late.
  const CommandResult loaded = Do("source " + file);
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(loaded.diagnostics[0].line, 2);
  EXPECT_EQ(loaded.diagnostics[0].hint, advice);
  Do("run 1");
  const std::string usage = Do("production memory-usage done").text;
  EXPECT_THAT(usage, HasSubstr("done has held "));
  EXPECT_THAT(usage, HasSubstr(" partial matches for 0 matches: " + advice + ".\n"));
  Do("multi-attributes holds 6");
  EXPECT_TRUE(Do("source " + file).diagnostics.empty()) << "the advice helps";
  EXPECT_THAT(Do("production memory-usage done").text, Not(HasSubstr("has held")));
}

TEST_F(InterpreterTest, AWarningThatASourceRepeatsIsToldOnceAndCounted) {
  const std::string file = Write("many.soar",
                                 "sp {first (state <s> ^x r2) --> (<s> ^y z)}\n"
                                 "sp {second (state <s> ^x r2 ^w r3) --> (<s> ^y r2)}\n");
  const CommandResult result = Do("source " + file);
  ASSERT_EQ(result.diagnostics.size(), 2u);
  EXPECT_THAT(result.diagnostics[0].message, StartsWith("r2 looks like an identifier"));
  EXPECT_EQ(result.diagnostics[0].line, 1);
  EXPECT_EQ(result.diagnostics[0].more, 2);
  EXPECT_THAT(result.diagnostics[1].message, StartsWith("r3 looks like an identifier"));
  EXPECT_EQ(result.diagnostics[1].line, 2);
  EXPECT_EQ(result.diagnostics[1].more, 0);
}

TEST_F(InterpreterTest, CountsOfRulesShowDefaultRulesApartAndBeginAgainWithTheAgent) {
  Do("sp {basic :default (state <s> ^superstate nil) --> (<s> ^x 1)}");
  Do("sp {two (state <s> ^superstate nil ^x <x>) --> (<s> ^y <x>)}");
  Do("run 1");
  EXPECT_EQ(Do("firing-counts").text, "     1:  two\n     1:  basic\n");
  EXPECT_EQ(Do("firing-counts --templates").text, Do("firing-counts").text);
  EXPECT_EQ(Do("production memory-usage").text, "     2:  two\n     1:  basic\n");
  Do("init-soar");
  EXPECT_EQ(Do("firing-counts two").text, "     0:  two\n");
}

TEST_F(InterpreterTest, ALevelOfTheTraceComesAfterTheOptionsThatStandBesideIt) {
  EXPECT_THAT(Do("trace 1 --phases -t").text, StartsWith("Trace level 1 enabled"));
  const std::string table = Do("trace").text;
  EXPECT_THAT(table, HasSubstr("Phases                                                   off"));
  EXPECT_THAT(table, HasSubstr("WME Detail Level                                     timetag"));
  EXPECT_THAT(Do("trace --level 2").text, StartsWith("Trace level 2 enabled"));
  EXPECT_THAT(Do("trace 2 3").text, StartsWith("Only non option argument allowed is watch level."));
}

TEST_F(InterpreterTest, PreferencesOfSubstatesNameTheirLevelAndShowWhatMatchedInFull) {
  Do("sp {sub (state <s> ^impasse no-change) --> (<s> ^name sub)}");
  Do("run 2");
  EXPECT_THAT(Do("preferences s2 name").text, HasSubstr("  (S2 ^name sub)  :I  [level 2] \n"));
  EXPECT_THAT(Do("preferences --wmes s2 name").text, HasSubstr(" ^impasse no-change)\n"));
  EXPECT_THAT(Do("preferences --object s2").text,
              HasSubstr("Preferences for S2 ^operator:Support for S2 ^smem:\nSupport for S2 ^epmem:\n"));
}

TEST_F(InterpreterTest, PreferencesAreListedKindByKind) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <a> +, <, = ^operator <b> +, >) (<a> ^name a)"
     " (<b> ^name b)}");
  Do("sp {better (state <s> ^operator <a> + ^operator <b> +) (<a> ^name a) (<b> ^name b) --> (<s> ^operator <b> > "
     "<a>)}");
  Do("run 1");
  const std::string text = Do("preferences s1 operator").text;
  EXPECT_LT(text.find("unary indifferents:"), text.find("bests:"));
  EXPECT_LT(text.find("bests:"), text.find("worsts:"));
  EXPECT_LT(text.find("worsts:"), text.find("betters:"));
}

TEST_F(InterpreterTest, WatchedRulesAndBreaksAreListedNewestFirst) {
  Do(kGo);
  Do("sp {second (state <s> ^nothing <n>) --> (<s> ^x 1)}");
  for (const char* line : {"production watch go", "production watch second", "pbreak go", "pbreak --set second"})
    Do(line);
  EXPECT_EQ(Do("production watch").text, "\nsecond\ngo");
  EXPECT_EQ(Do("production break").text, "second\ngo\n");
  EXPECT_THAT(Do("pbreak --clear").text, StartsWith("pbreak --set/--clear takes exactly one argument."));
  EXPECT_EQ(Do("excise -x").text.find("Use 'production ?'"), std::string::npos);
  EXPECT_THAT(Do("excise --nonsense").text, HasSubstr("Use 'production ?'"));
}

TEST_F(InterpreterTest, ARunThatARuleInterruptsInItsLastCycleIsNotCalledStopped) {
  Do("sp {begin (state <s> ^superstate nil) --> (<s> ^n 1)}");
  Do("sp {stop :interrupt (state <s> ^n 1) --> (<s> ^m 2)}");
  EXPECT_EQ(Do("run 1").text.find("Run stopped"), std::string::npos);
  EXPECT_THAT(printed_, HasSubstr("probably from stop\n    [Phase] (Interrupt, Stop) is [1] (2,1)\n"));
  Do("init-soar");
  EXPECT_THAT(Do("run 2").text, HasSubstr("Run stopped (interrupted)."));
  EXPECT_THAT(printed_, HasSubstr("[Phase] (Interrupt, Stop) is [1] (3,1)\n"));
}

TEST_F(InterpreterTest, SettingsOfSoarTakeOneValue) {
  EXPECT_THAT(Do("soar wait-snc on off").text, HasSubstr("Soar 9.6.5 Summary"));
  EXPECT_THAT(Do("soar init now").text, StartsWith("Invalid argument."));
  EXPECT_THAT(Do("decide indifferent-selection first").text, StartsWith("Too many args."));
  EXPECT_THAT(Do("decide indifferent-selection -f -l").text, HasSubstr("only one option at a time"));
  Do("run 6");
  EXPECT_THAT(Do("soar").text, HasSubstr(" S1, S2 ... S6, S7\n"));
}

TEST_F(InterpreterTest, PartialMatchesAreLimitedByASetting) {
  EXPECT_EQ(Do("soar max-partial-matches").text, "max-partial-matches is 8000000\n");
  for (const char* wrong : {"soar max-partial-matches 0", "soar max-partial-matches many",
                            "soar max-partial-matches -5", "soar max-partial-matches 99999999999"}) {
    EXPECT_FALSE(Do(wrong).ok) << wrong;
  }
  EXPECT_TRUE(Do("soar max-partial-matches 1000").ok);
  EXPECT_EQ(Do("soar max-partial-matches").text, "max-partial-matches is 1000\n");
  Do("sp {values (state <s> ^superstate nil) --> (<s> ^value 1 2 3 4 5 6 7 8 9 10 11 12)}");
  Do("sp {explode (state <s> ^value <a> ^value <b> ^value <c> ^value <d>) --> (<s> ^all yes)}");
  const CommandResult result = Do("run 3");
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("The agent ran out of memory: rule explode had "));
  EXPECT_THAT(result.text, HasSubstr("'soar max-partial-matches' allows 1000 in all"));
}

}  // namespace
}  // namespace soarbox::cli
