// SPDX-License-Identifier: BSD-2-Clause
#include "cli/rule_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

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

  /// An image with this payload and a valid header.
  static std::string Wrap(const std::string& payload) {
    std::string image(rule_image::kMagic);
    const auto fixed = [&](std::uint64_t number, int size) {
      for (int i = 0; i < size; ++i) image += static_cast<char>(number >> (8 * i));
    };
    fixed(rule_image::kVersion, 4);
    fixed(payload.size(), 8);
    fixed(rule_image::Checksum(payload), 8);
    return image + payload;
  }

  std::filesystem::path folder_;
  Shell source_;
};

TEST_F(RuleImageTest, RulesFromAnImageLiveTheSameLife) {
  EXPECT_EQ(source_.Do("save rete-network --save " + Path("all.soarx")).text,
            "10 productions written to file " + Path("all.soarx") + ".\n");
  Shell target;
  EXPECT_TRUE(target.Do("load rete-network --load " + Path("all.soarx")).ok);
  EXPECT_EQ(WriteRuleImage(target.agent), WriteRuleImage(source_.agent));
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

TEST_F(RuleImageTest, AFileThatIsNoImageIsRefusedWithAWayOn) {
  const std::string image = WriteRuleImage(source_.agent);
  const auto answer = [&](const std::string& bytes) {
    Shell shell;
    shell.Do("sp {kept (state <s> ^a b) --> (<s> ^c d)}");
    const CommandResult result = shell.Do("load rete-network --load " + Write("file", bytes));
    EXPECT_FALSE(result.ok);
    EXPECT_NE(shell.agent.FindProduction("kept"), kernel::ProductionId::kNone) << "nothing changes";
    return result.text;
  };
  EXPECT_THAT(answer(""), HasSubstr("the file is empty"));
  EXPECT_THAT(answer("SoarCompactReteNet\n\4rest"), HasSubstr("another Soar wrote"));
  EXPECT_THAT(answer("sp {x (state <s> ^a b) --> (<s> ^c d)}"), HasSubstr("use 'source'"));
  EXPECT_THAT(answer(image.substr(0, 30)), HasSubstr("ends within its header, at byte 30"));
  EXPECT_THAT(answer(image.substr(0, image.size() - 1)), HasSubstr("it was cut or added to"));
  std::string changed = image;
  changed.back() = static_cast<char>(changed.back() ^ 1);
  EXPECT_THAT(answer(changed), HasSubstr("checksum"));
  changed = image;
  changed[16] = 9;
  EXPECT_THAT(answer(changed), HasSubstr("format 9"));
  changed = image;
  changed.erase(13, 1);
  EXPECT_THAT(answer(changed), HasSubstr("copied as if it were text"));
}

TEST_F(RuleImageTest, ErrorsInThePayloadNameTheRuleAndTheByte) {
  std::string payload = WriteRuleImage(source_.agent).substr(rule_image::kHeaderSize);
  const std::size_t place = payload.find("crlf");
  ASSERT_NE(place, std::string::npos);
  payload.replace(place, 4, "nope");
  kernel::SymbolTable symbols;
  const auto rules = ReadRuleImage(Wrap(payload), "f.soarx", symbols);
  ASSERT_FALSE(rules.ok());
  EXPECT_EQ(rules.error().file, "f.soarx");
  EXPECT_THAT(rules.error().message, StartsWith("byte "));
  EXPECT_THAT(rules.error().message, HasSubstr("rule "));
}

TEST_F(RuleImageTest, ANumericPreferenceNeedsItsNumberAtOnce) {
  Shell shell;
  shell.Do("sp {p (state <s> ^operator <o> + ^name <n>) --> (<s> ^operator <o> = <n>)}");
  std::string payload = WriteRuleImage(shell.agent).substr(rule_image::kHeaderSize);
  // The only action is the last: its code, then object, attribute, value and referent with two bytes each.
  char& code = payload[payload.size() - 9];
  ASSERT_EQ(code, static_cast<char>(kernel::PreferenceType::kBinaryIndifferent));
  code = static_cast<char>(kernel::PreferenceType::kNumericIndifferent);
  kernel::SymbolTable symbols;
  const auto rules = ReadRuleImage(Wrap(payload), "f", symbols);
  ASSERT_FALSE(rules.ok());
  EXPECT_THAT(rules.error().message, HasSubstr("rule 'p': a numeric preference has no number"));
}

TEST_F(RuleImageTest, EveryCutIsAnErrorAndLeavesNoSymbols) {
  const std::string payload = WriteRuleImage(source_.agent).substr(rule_image::kHeaderSize);
  for (std::size_t length = 0; length < payload.size(); ++length) {
    kernel::SymbolTable symbols;
    const std::uint64_t before = symbols.Digest();
    EXPECT_FALSE(ReadRuleImage(Wrap(payload.substr(0, length)), "f", symbols).ok()) << length;
    EXPECT_EQ(symbols.Digest(), before);
  }
}

TEST_F(RuleImageTest, ImagesWithWrongBytesEitherFailOrGiveRulesThatRun) {
  const std::string payload = WriteRuleImage(source_.agent).substr(rule_image::kHeaderSize);
  std::mt19937 random(2026);
  int good = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string changed = payload;
    for (std::uint32_t n = random() % 3 + 1; n > 0; --n) {
      changed[random() % changed.size()] = static_cast<char>(random() % 4 == 0 ? random() % 256 : random() % 12);
    }
    kernel::Agent agent("soar");
    auto rules = ReadRuleImage(Wrap(changed), "f", agent.mutable_symbols());
    if (!rules) continue;
    ++good;
    for (kernel::ProductionPtr& rule : *rules) agent.AddProduction(std::move(rule));
    agent.Run(kernel::RunUnit::kDecision, 4);
    EXPECT_EQ(agent.CheckInvariants(), "");
  }
  EXPECT_GT(good, 50) << "some changes do no harm";
}

TEST_F(RuleImageTest, NestingIsBounded) {
  // The first condition of this rule consists of 100,000 nested negations.
  std::string payload("\0\1\0\1\1x\0\0\0\0\0", 11);
  for (int i = 0; i < 100000; ++i) payload += std::string("\1\2", 2);
  kernel::SymbolTable symbols;
  const auto rules = ReadRuleImage(Wrap(payload), "f", symbols);
  ASSERT_FALSE(rules.ok());
  EXPECT_THAT(rules.error().message, HasSubstr("nested too deeply"));
}

}  // namespace
}  // namespace soarbox::cli
