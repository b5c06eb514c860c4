// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Every kind of test, action and flag that a rule can have.
constexpr const char* kImageRules = R"(
sp {propose*count "counts up" (state <s> ^superstate nil -^done yes) --> (<s> ^operator <o> + = 0.25) (<o> ^name count)}
sp {propose*wait :i-support (state <s> ^superstate nil ^io.input-link <i>) --> (<s> ^operator <o> +, =) (<o> ^name wait)}
sp {prefer :default (state <s> ^operator <a> + ^operator { <> <a> <b> } +) (<a> ^name count) (<b> ^name wait)
    --> (<s> ^operator <a> > <b>)}
sp {apply*first (state <s> ^operator.name count -^n) --> (<s> ^n 1 ^list.item |two words| <new> ^ratio -2.5) (<new> ^x -7)}
sp {apply*next (state <s> ^operator.name count ^n { <n> < 20 }) --> (<s> ^n (+ <n> 1) <n> -) (write |n | (+ <n> 1) (crlf))}
sp {apply*end :o-support (state <s> ^operator <o> ^n { <n> >= 20 <> red }) (<o> ^name << count wait >>) --> (<s> ^done yes)}
sp {elaborate*none (state <s> ^n <n>) -{(<s> ^list.item <it>) (<it> ^x > <n>) -(<it> ^y)} --> (<s> ^big (* <n> 2))}
sp {elaborate*kinds (state <s> ^n <n> ^ratio { <r> <=> <n> } ^<a> { <v> << 1 red 2.5 >> }) --> (<s> ^kinds.<a> <v>)}
sp {sub*one (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^n <n>) --> (<s> ^copy <n>) (<ss> ^seen <n>)}
sp {never :interrupt (state <s> ^n 1000) --> (halt) (<s> ^x (concat a (int |5|) <s>))}
)";

class RuleImageTest : public testing::Test {
 protected:
  struct Shell {
    Shell() {
      session.stream().SetSink([this](std::string_view text) { printed += text; });
    }
    CommandResult Do(const std::string& line) { return interpreter.Execute(session, line); }
    /// All output of a run of the rules.
    std::string Life() {
      std::string text = Do("print --internal --all").text;
      printed.clear();
      Do("watch 5; run 30");
      text += printed + Do("print --internal --depth 9 s1; matches; preferences s1 operator").text;
      return text;
    }

    kernel::Agent agent{"soar"};
    Session session{agent};
    Interpreter interpreter;
    std::string printed;
  };

  RuleImageTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("soarbox_image_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    const CommandResult loaded = source_.Do(kImageRules);
    EXPECT_TRUE(loaded.ok) << loaded.text;
  }
  ~RuleImageTest() override { std::filesystem::remove_all(folder_); }

  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::string Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return Path(name);
  }

  std::string Image() {
    EXPECT_TRUE(source_.Do("save rete-network --save " + Path("all.soarx")).ok);
    std::ostringstream text;
    text << std::ifstream(Path("all.soarx"), std::ios::binary).rdbuf();
    return text.str();
  }
  /// The answer to loading this file. Checks that it is refused and changes nothing.
  std::string Refused(const std::string& bytes) const {
    Shell shell;
    shell.Do("sp {kept (state <s> ^a b) --> (<s> ^c d)}");
    const std::uint64_t before = shell.agent.symbols().Digest();
    const CommandResult result = shell.Do("load rete-network --load " + Write("file", bytes));
    EXPECT_FALSE(result.ok);
    EXPECT_NE(shell.agent.FindProduction("kept"), kernel::ProductionId::kNone) << "nothing changes";
    EXPECT_EQ(shell.agent.symbols().Digest(), before);
    return result.text;
  }

  std::filesystem::path folder_;
  Shell source_;
};

TEST_F(RuleImageTest, RulesFromAnImageLiveTheSameLife) {
  EXPECT_EQ(source_.Do("save rete-network --save " + Path("all.soarx")).text,
            "10 productions written to file " + Path("all.soarx") + ".\n");
  Shell target;
  EXPECT_TRUE(target.Do("load rete-network --load " + Path("all.soarx")).ok);
  EXPECT_EQ(target.Do("print --internal --all").text, source_.Do("print --internal --all").text);
  EXPECT_EQ(target.Life(), source_.Life());
  EXPECT_EQ(target.agent.CheckInvariants(), "");
}

TEST_F(RuleImageTest, AnImageTakesThePlaceOfWhatTheAgentKnew) {
  source_.Do("save rete-network --save " + Path("all.soarx"));
  Shell target;
  target.Do("sp {one (state <s> ^a b) --> (<s> ^c d)}\nsp {two (state <s> ^a c) --> (<s> ^c d)}");
  target.Do("sp {two (state <s> ^a c) --> (<s> ^c d)}");
  target.Do("run 2");
  EXPECT_EQ(target.Do("rete-net -l " + Path("all.soarx")).text, "##\n     0: ==>S: S1 ");
  EXPECT_EQ(target.agent.FindProduction("one"), kernel::ProductionId::kNone);
  EXPECT_EQ(target.agent.Productions().size(), 10u);
}

TEST_F(RuleImageTest, SourceLoadsAFileNamedSoarx) {
  source_.Do("save rete-network --save " + Path("all.soarx"));
  Shell target;
  EXPECT_EQ(target.Do("source " + Path("all.soarx")).text, "\n     0: ==>S: S1 \nTotal: 10 productions sourced.\n");
}

TEST_F(RuleImageTest, AnImageIsNotWrittenWhileThereAreJustifications) {
  Shell shell;
  shell.Do("sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}");
  shell.Do("sp {q (state <s> ^superstate <ss>) (<ss> ^operator.name go) --> (<ss> ^seen yes)}");
  shell.Do("run 3");
  ASSERT_GT(shell.agent.CountProductions(kernel::ProductionType::kJustification), 0u);
  const CommandResult refused = shell.Do("save rete-network --save " + Path("no.soarx"));
  EXPECT_FALSE(refused.ok);
  EXPECT_THAT(refused.text, HasSubstr("justifications"));
  EXPECT_FALSE(std::filesystem::exists(Path("no.soarx")));
}

TEST_F(RuleImageTest, AnImageKeepsWhatPrintLeavesOut) {
  Shell shell;
  shell.Do(
      "sp {fine :explain (state <s> ^superstate nil) --> (<s> ^far 3.0e20 ^near 1.25e-9 ^third 0.3333333333333333)}");
  shell.Do("save rete-network --save " + Path("fine.soarx"));
  Shell target;
  EXPECT_TRUE(target.Do("load rete-network --load " + Path("fine.soarx")).ok);
  const auto rule_of = [](const Shell& of) { return of.agent.production_ptr(of.agent.FindProduction("fine")); };
  EXPECT_TRUE(rule_of(target)->explain);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(target.agent.symbols().FloatValue(rule_of(target)->actions[i].value.symbol()),
              shell.agent.symbols().FloatValue(rule_of(shell)->actions[i].value.symbol()));
}

TEST_F(RuleImageTest, AnImageKeepsRulesThatBeginWithANegatedCondition) {
  Shell shell;
  shell.Do("sp {one (state <s> ^superstate nil) -{(state <t> ^a zz)} --> (<s> ^one yes)}");
  shell.Do("sp {both (state <s> ^superstate nil) -{(state <t> ^a zz) (<t> ^b <x>)} --> (<s> ^both yes)}");
  const std::string rules = shell.Do("print --internal --full --all").text;
  ASSERT_THAT(rules,
              AllOf(HasSubstr("sp {one\n    (state <t> -^a zz)"), HasSubstr("sp {both\n   -{ (state <t> ^a zz)")));
  shell.Do("save rete-network --save " + Path("negated.soarx"));
  Shell target;
  EXPECT_TRUE(target.Do("load rete-network --load " + Path("negated.soarx")).ok);
  EXPECT_EQ(target.Do("print --internal --full --all").text, rules);
  EXPECT_EQ(target.Life(), shell.Life());
  EXPECT_EQ(target.agent.CheckInvariants(), "");
}

TEST_F(RuleImageTest, AFileThatIsNoImageIsRefusedWithAWayOn) {
  EXPECT_THAT(Refused(""), HasSubstr("the file is empty"));
  EXPECT_THAT(Refused("SoarCompactReteNet\n\4rest"), HasSubstr("another program or version"));
  EXPECT_THAT(Refused("Soarbox rules\r\n\x1a\1"), HasSubstr("another program or version"));
  EXPECT_THAT(Refused("sp {x (state <s> ^a b) --> (<s> ^c d)}"), HasSubstr("use 'source'"));
}

TEST_F(RuleImageTest, AnErrorInAnImageIsReportedWithItsPlace) {
  const std::string image = Image();
  std::string changed = image;
  changed.replace(changed.find("-->"), 3, "->>");
  EXPECT_THAT(Refused(changed), HasSubstr("file:"));
  EXPECT_THAT(Refused(image.substr(0, image.size() - 4)), HasSubstr("file:"));
  EXPECT_THAT(Refused(image + "watch 5\n"), HasSubstr("an image contains only rules"));
}

}  // namespace
}  // namespace soarbox::cli
