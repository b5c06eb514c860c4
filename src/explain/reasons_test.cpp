// SPDX-License-Identifier: BSD-2-Clause
// Tests each answer of MindReasons in its situation, and statements that it must not make in other situations. The
// tests use the client interface, like with any kernel; only the traces of decisions need our own kernel.
#include "explain/reasons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "sml_Client.h"

namespace soarbox::explain {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kProposeGo =
    "sp {propose*go (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}\n";

class Reasons : public ::testing::Test {
 protected:
  ~Reasons() override { kernel_->Shutdown(); }

  /// Loads rules into a new agent and runs some decisions.
  std::vector<std::string> Idle(const std::string& rules, int decisions = 3, const std::string& setting = "") {
    agent_ = kernel_->CreateAgent(("a" + std::to_string(++count_)).c_str());
    Load(rules);
    agent_->ExecuteCommandLine("watch 0");
    if (!setting.empty()) agent_->ExecuteCommandLine(setting.c_str());
    agent_->RunSelf(static_cast<unsigned long>(decisions));
    std::vector<std::string> texts;
    for (const Reason& reason : MindReasons(*agent_, failed_).WhyIdle(Known())) texts.push_back(reason.text);
    return texts;
  }

  void Load(const std::string& rules) {
    for (std::size_t at = rules.find("sp {"); at != std::string::npos;) {
      const std::size_t next = rules.find("sp {", at + 1);
      agent_->ExecuteCommandLine(rules.substr(at, next - at).c_str());
      at = next;
    }
  }

  /// The attributes that this agent's rules create, as a simulation collects them.
  std::set<std::string> Known() {
    std::set<std::string> known;
    MindReasons reasons(*agent_);
    for (const RuleText& rule : reasons.rules())
      for (const RuleAttribute& action : rule.actions) known.insert(action.attribute);
    return known;
  }

  std::string Why(const std::string& topic) {
    const Result<std::vector<WhyNode>> nodes = MindReasons(*agent_, failed_).WhyTopic(topic, Known());
    std::string text;
    if (!nodes) return nodes.error().message;
    for (const WhyNode& node : *nodes)
      for (const std::string& line : Lines(node, 1)) text += line + "\n";
    return text;
  }

  std::unique_ptr<sml::Kernel> kernel_{sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener)};
  sml::Agent* agent_ = nullptr;
  std::vector<FailedRule> failed_;
  int count_ = 0;
};

TEST_F(Reasons, ARuleIsSaidToMakeWhatItMakesAndNothingElse) {
  const std::string go = "sp {go (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n";
  EXPECT_THAT(Idle(go + "sp {alarm (state <s> ^superstate nil ^noise yes) --> (<s> ^danger yes)}"),
              Contains("rule go requires ^danger yes, but there is none now; rule alarm makes it"));
  EXPECT_THAT(Idle(go + "sp {calm (state <s> ^superstate nil ^noise yes) --> (<s> ^danger no)}"),
              Contains("rule go requires ^danger yes, but there is none now, and no rule makes it; rule calm makes "
                       "^danger no"));
  EXPECT_THAT(Idle(go + "sp {copy (state <s> ^superstate nil ^noise <n>) --> (<s> ^danger <n>)}"),
              Contains("rule go requires ^danger yes, but there is none now; rule copy may make it"));
  EXPECT_THAT(Idle(go + "sp {below (state <s> ^superstate <ss> ^noise yes) --> (<s> ^danger yes)}"),
              Contains("rule go requires ^danger yes, but there is none now, and no rule makes it"));
}

TEST_F(Reasons, WhatWaitsForItselfIsCalledACircle) {
  const std::vector<std::string> reasons = Idle(
      "sp {go (state <s> ^superstate nil ^plan yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
      "sp {make*plan (state <s> ^superstate nil ^ready yes) --> (<s> ^plan yes)}\n"
      "sp {make*ready (state <s> ^superstate nil ^plan yes) --> (<s> ^ready yes)}\n");
  EXPECT_THAT(reasons,
              Contains("rule go requires ^plan yes, but ^plan and ^ready wait for each other: only rule "
                       "make*plan creates ^plan, and it tests ^ready; only rule make*ready creates ^ready, and "
                       "it tests ^plan"));
  const std::string why = Why("go");
  EXPECT_THAT(why, Not(HasSubstr("makes it")));
  EXPECT_THAT(Idle("sp {go (state <s> ^superstate nil ^plan yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
                   "sp {keep (state <s> ^superstate nil ^plan <p>) --> (<s> ^plan <p>)}\n"),
              Contains(HasSubstr("^plan waits for itself: only rule keep creates ^plan, and it tests ^plan")));
  // It is no circle if another rule creates one of the elements without testing the other.
  EXPECT_THAT(Idle("sp {go (state <s> ^superstate nil ^plan yes) --> (<s> ^operator <o> +) (<o> ^name go)}\n"
                   "sp {make*plan (state <s> ^superstate nil ^ready yes) --> (<s> ^plan yes)}\n"
                   "sp {make*ready (state <s> ^superstate nil ^plan yes) --> (<s> ^ready yes)}\n"
                   "sp {other*ready (state <s> ^superstate nil ^late yes) --> (<s> ^ready yes)}\n"),
              Contains("rule go requires ^plan yes, but there is none now; rule make*plan makes it"));
}

TEST_F(Reasons, AnOperatorHasBeenAppliedOnlyIfARuleFiredForIt) {
  const std::string applied = "operator go has been applied (rule apply*go), which gave no command, and stays";
  EXPECT_THAT(Idle(std::string(kProposeGo) + "sp {apply*go (state <s> ^operator.name go) --> (<s> ^gone yes)}"),
              Contains(HasSubstr(applied)));
  // A rule that only adds to the operator does not apply it, nor does a rule that only prints for every operator.
  for (const char* rule : {"sp {note (state <s> ^operator <o>) (<o> ^name go) --> (<o> ^speed 3)}",
                           "sp {note (state <s> ^operator <o>) --> (write |an operator|)}"}) {
    const std::vector<std::string> reasons = Idle(std::string(kProposeGo) + rule);
    EXPECT_THAT(reasons, Contains(HasSubstr("operator go is selected in S1 and no rule applies it"))) << rule;
    EXPECT_THAT(reasons, Not(Contains(HasSubstr("has been applied")))) << rule;
  }
  // A rule that names the operator counts as fired for it even if it only prints.
  EXPECT_THAT(Idle(std::string(kProposeGo) + "sp {note (state <s> ^operator.name go) --> (write |going|)}"),
              Contains("operator go stays selected in S1: rule note has fired for it, but neither changes what its "
                       "proposal tests nor gives a command"));
  // A rule that names no operator applies this one, too.
  EXPECT_THAT(Idle(std::string(kProposeGo) + "sp {any (state <s> ^operator <o>) --> (<s> ^gone yes)}"),
              Contains(HasSubstr("operator go has been applied (rule any)")));
  // The rules loop, and the elaboration limit ends the phase before the pending instantiation fires.
  const std::vector<std::string> loop =
      Idle(std::string(kProposeGo) +
               "sp {count (state <s> ^operator.name go ^n <n>) --> (<s> ^n <n> - ^n (+ <n> 1))}\n"
               "sp {begin (state <s> ^operator.name go -^n) --> (<s> ^n 0)}\n",
           1, "soar max-elaborations 5");
  EXPECT_THAT(loop, Contains(HasSubstr(", which applies it, matches but has not fired")));
  EXPECT_THAT(loop, Not(Contains(HasSubstr("has been applied"))));
}

TEST_F(Reasons, ARuleThatFailedToParseIsNamedInsteadOfAdvice) {
  failed_ = {{"propose*go", "hero.soar:7", "expected -->"}};
  EXPECT_THAT(
      Idle("sp {x (state <s> ^superstate nil) --> (<s> ^y 1)}"),
      ElementsAre("no rule proposes an operator: rule propose*go in hero.soar:7 failed to parse: expected -->"));
  EXPECT_THAT(Why("propose*go"), HasSubstr("rule propose*go in hero.soar:7 failed to parse: expected -->"));
  EXPECT_THAT(Why("dance"), HasSubstr("no rule that loaded gives or proposes 'dance'"));
  // The elements that the failed rule would create are unknown, so no answer says that no rule makes ^danger.
  const std::vector<std::string> waits =
      Idle("sp {go (state <s> ^superstate nil ^danger yes) --> (<s> ^operator <o> +) (<o> ^name go)}");
  EXPECT_THAT(waits, Contains("rule go requires ^danger yes, but there is none now; rule propose*go in hero.soar:7 "
                              "failed to parse: expected -->"));
  // The rule has been loaded by an edit.
  Load(kProposeGo);
  agent_->RunSelf(1);
  for (const Reason& reason : MindReasons(*agent_, failed_).WhyIdle(Known()))
    EXPECT_THAT(reason.text, Not(HasSubstr("failed to parse")));
  failed_ = {{"", "hero.soar:9", "expected sp { here"}};
  EXPECT_THAT(Idle("sp {x (state <s> ^superstate nil) --> (<s> ^y 1)}"),
              ElementsAre("no rule proposes an operator: error in hero.soar:9: expected sp { here"));
  failed_.clear();
  EXPECT_THAT(Idle("sp {x (state <s> ^superstate nil) --> (<s> ^y 1)}"),
              ElementsAre("no rule proposes an operator: write one with (<s> ^operator <o> +)"));
}

TEST_F(Reasons, WhatWasProposedAndDroppedIsNotCalledUnproposed) {
  const std::vector<std::string> reasons = Idle(
      std::string(kProposeGo) + "sp {never (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> ~)}\n");
  ASSERT_FALSE(reasons.empty());
  EXPECT_THAT(reasons.front(), HasSubstr("no operator is selected in S1: the only operator proposed was dropped: rule "
                                         "never prohibits go (O"));
  for (const std::string& reason : reasons) EXPECT_THAT(reason, Not(HasSubstr("no operator is proposed")));
}

TEST_F(Reasons, ATieIsAmongThoseThatAreLeft) {
  const std::vector<std::string> reasons = Idle(
      "sp {a (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}\n"
      "sp {b (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}\n"
      "sp {c (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name c)}\n"
      "sp {no (state <s> ^operator <o> +) (<o> ^name c) --> (<s> ^operator <o> -)}\n");
  EXPECT_THAT(reasons.front(), AnyOf("operator tie in S1: no preference decides among a and b",
                                     "operator tie in S1: no preference decides among b and a"));
  EXPECT_THAT(reasons, Contains("a is proposed by rule a"));
  EXPECT_THAT(reasons, Not(Contains(HasSubstr("by rule c"))));
}

TEST_F(Reasons, AConflictNamesThePreferencesThatMakeIt) {
  const std::string two =
      "sp {a (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}\n"
      "sp {b (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}\n";
  const std::string both = " (state <s> ^operator <a> + ^operator <b> +) (<a> ^name a) (<b> ^name b) --> ";
  const std::vector<std::string> reasons =
      Idle(two + "sp {ab" + both + "(<s> ^operator <a> > <b>)}\nsp {ba" + both +
           "(<s> ^operator <b> > <a>)}\nsp {even" + both + "(<s> ^operator <a> = <b>)}\n");
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_THAT(reasons.front(), AllOf(HasSubstr("operator conflict in S1: each of "), HasSubstr("rule ab makes "),
                                     HasSubstr("rule ba makes "), Not(HasSubstr("even"))));
  EXPECT_THAT(Idle(two + "sp {ra (state <s> ^operator <o> +) (<o> ^name a) --> (<s> ^operator <o> !)}\n"
                         "sp {rb (state <s> ^operator <o> +) (<o> ^name b) --> (<s> ^operator <o> !)}\n"),
              Contains(AllOf(HasSubstr("constraint failure in S1: "), HasSubstr("rule ra requires a (O"),
                             HasSubstr("rule rb requires b (O"))));
}

TEST_F(Reasons, ARuleThatWaitsForAnotherOperatorIsToldWhichOneIsSelected) {
  Idle(
      "sp {propose*rest (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name rest)}\n"
      "sp {apply*fetch (state <s> ^operator.name fetch) --> (<s> ^has yes)}\n");
  EXPECT_THAT(Why("apply*fetch"),
              AllOf(HasSubstr("requires ^operator.name fetch, but the operator selected in S1 is rest (O"),
                    HasSubstr("; no rule proposes fetch")));
  Idle(
      "sp {apply*fetch (state <s> ^operator.name fetch) --> (<s> ^has yes)}\n"
      "sp {propose*fetch (state <s> ^superstate nil ^x 1) --> (<s> ^operator <o> +) (<o> ^name fetch)}\n");
  EXPECT_THAT(Why("apply*fetch"), HasSubstr("but no operator is selected in S1"));
}

TEST_F(Reasons, AStackThatGrowsIsToldWithItsStates) {
  EXPECT_THAT(Idle("sp {go (state <s> ^superstate nil ^x 1) --> (<s> ^operator <o> +) (<o> ^name go)}", 4),
              Contains(HasSubstr("no operator is proposed in S1; the goal stack grows without progress: S2 to S")));
}

TEST_F(Reasons, OnlyWhoCalledHaltIsSaidToHaveHaltedIt) {
  const std::string rules = std::string(kProposeGo) +
                            "sp {stop (state <s> ^operator.name go) --> (halt)}\n"
                            "sp {other (state <s> ^operator.name dance) --> (halt)}\n";
  Idle(rules);
  EXPECT_EQ(MindReasons(*agent_).WhyHalted(), "rule stop calls (halt)");
  Idle("sp {other (state <s> ^operator.name dance) --> (halt)}\n", 1);
  EXPECT_EQ(MindReasons(*agent_).WhyHalted(), "");
}

}  // namespace
}  // namespace soarbox::explain
