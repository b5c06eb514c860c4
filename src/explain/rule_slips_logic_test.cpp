// SPDX-License-Identifier: BSD-2-Clause
// Tests each slip with a rule that has it, and with a similar correct rule.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explain/rule_slips.h"

namespace soarbox::explain {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The messages about these rules, which have the form that a kernel prints.
std::vector<std::string> Found(const std::string& rules, const KnownWords& known = {}) {
  std::vector<std::string> messages;
  for (const Slip& slip : FindSlipsOfLogic(ReadRules(rules), known)) messages.push_back(slip.message);
  return messages;
}

/// One rule in the form that a kernel prints.
std::string Rule(const std::string& name, const std::string& conditions, const std::string& actions) {
  return "sp {" + name + "\n    " + conditions + "\n    -->\n    " + actions + "\n}\n";
}

TEST(SlipsOfLogic, ARuleThatMakesWhatItTestsAsAbsent) {
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate nil -^danger)", "(<s> ^danger no)")),
              ElementsAre(HasSubstr("makes the ^danger that it tests as absent")));
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate nil -^danger no)", "(<s> ^danger no)")),
              ElementsAre(HasSubstr("makes the ^danger that it tests as absent")));
  // Not a contradiction: an element with o-support, another value, another object, a group of conditions.
  EXPECT_THAT(Found(Rule("r", "(state <s> ^operator <o> -^danger)\n    (<o> ^name look)", "(<s> ^danger no)")),
              IsEmpty());
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate nil -^danger yes)", "(<s> ^danger no)")), IsEmpty());
  EXPECT_THAT(Found(Rule("r", "(state <s> ^part <p> -^danger)", "(<p> ^danger no)")), IsEmpty());
  EXPECT_THAT(
      Found(Rule("r", "(state <s> ^superstate nil)\n    -{\n      (<s> ^danger <d>)\n      (<d> ^near yes)\n    }",
                 "(<s> ^danger no)")),
      IsEmpty());
}

TEST(SlipsOfLogic, ARuleThatCountsWithoutAnOperator) {
  const std::string actions = "(<s> ^next <n> - ^next (+ <n> 1))";
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate nil ^next <n>)", actions)),
              ElementsAre(HasSubstr("removes the ^next that it tests, and tests no selected operator")));
  EXPECT_THAT(Found(Rule("r", "(state <s> ^operator <o> ^next <n>)\n    (<o> ^name count)", actions)), IsEmpty());
  EXPECT_THAT(
      Found("sp {r\n    :o-support\n    (state <s> ^superstate nil ^next <n>)\n    -->\n    " + actions + "\n}\n"),
      IsEmpty());
  // A rule may reject a proposal that it tests.
  EXPECT_THAT(Found(Rule("r", "(state <s> ^operator <o> +)", "(<s> ^operator <o> -)")), IsEmpty());
}

TEST(SlipsOfLogic, TwoPathsThroughOneOfSeveral) {
  const std::string two = Rule("make", "(state <s> ^operator <o>)",
                               "(<s> ^plan <one> ^plan <two>)\n    (<one> ^cart ada)\n    (<two> ^cart bo)");
  const std::string one = Rule("make", "(state <s> ^operator <o>)", "(<s> ^plan <one>)\n    (<one> ^cart ada)");
  const std::string apart =
      Rule("r", "(state <s> ^superstate nil ^plan <p*1> ^plan <p*2>)\n    (<p*1> ^cart <c>)\n    (<p*2> ^place <b>)",
           "(<s> ^told <c> ^at <b>)");
  const std::string together =
      Rule("r", "(state <s> ^superstate nil ^plan <p>)\n    (<p> ^cart <c> ^place <b>)", "(<s> ^told <c> ^at <b>)");
  EXPECT_THAT(Found(two + apart), ElementsAre(HasSubstr("of ^plan on two paths")));
  EXPECT_THAT(Found(two + together), IsEmpty());
  EXPECT_THAT(Found(one + apart), IsEmpty());
}

TEST(SlipsOfLogic, AVariableThatIsThereOnceWhereAnotherOneIsMeant) {
  const auto rule = [](const std::string& kind) {
    return Rule("r",
                "(state <s> ^letter <l> ^page <p>)\n    (<l> ^kind <k>)\n    (<p> ^kind " + kind + " ^shelf <place>)",
                "(<l> ^shelf <place>)");
  };
  EXPECT_THAT(Found(rule("<kind>")), ElementsAre(HasSubstr("uses <k> once, as ^kind, and <kind> beside it")));
  EXPECT_THAT(Found(rule("<k>")), IsEmpty());
  EXPECT_THAT(Found(Rule("r", "(state <s> ^at <plac>)\n    (<s> ^wish <place>)", "(<s> ^go <place>)")),
              ElementsAre(HasSubstr("uses <plac> once, as ^at, and <place> beside it")));
  EXPECT_THAT(Found(Rule("r", "(state <s> ^at <x1> ^was <x2>)", "(<s> ^go <x2> ^from <x2>)")), IsEmpty());
}

TEST(SlipsOfLogic, ANumberInBars) {
  const std::string make = Rule("make", "(state <s> ^operator <o>)", "(<s> ^next 1)");
  EXPECT_THAT(Found(make + Rule("r", "(state <s> ^operator <o> ^next |3|)", "(<s> ^done yes)")),
              ElementsAre(HasSubstr("^next is |3|, which is a word")));
  EXPECT_THAT(Found(make + Rule("r", "(state <s> ^operator <o> ^other |3|)", "(<s> ^done yes)")), IsEmpty());
  EXPECT_THAT(Found(Rule("make", "(state <s> ^operator <o>)", "(<s> ^next |1|)") +
                    Rule("make2", "(state <s> ^operator <o>)", "(<s> ^next 1 ^next |3|)") +
                    Rule("r", "(state <s> ^operator <o> ^next |3|)", "(<s> ^done yes)")),
              IsEmpty());
}

TEST(SlipsOfLogic, AParameterThatNothingBinds) {
  const auto rule = [](const std::string& conditions) {
    return Rule(
        "r",
        "(state <s> ^operator <o> ^io <i*1>)\n    (<o> ^name go" + conditions + ")\n    (<i*1> ^output-link <out>)",
        "(<out> ^move-to <c>)\n    (<c> ^waypoint <place>)");
  };
  EXPECT_THAT(Found(rule("")),
              ElementsAre(HasSubstr("binds <place>: ^waypoint of its command becomes a new, empty object")));
  EXPECT_THAT(Found(rule(" ^where <place>")), IsEmpty());
  const std::string propose =
      Rule("p", "(state <s> ^superstate nil)", "(<s> ^operator <o> +)\n    (<o> ^name go ^where <place>)");
  EXPECT_THAT(Found(propose), ElementsAre(HasSubstr("binds <place>: ^where of its operator")));
  // Another rule adds elements to the value.
  EXPECT_THAT(Found(propose + Rule("q", "(state <s> ^operator <o>)\n    (<o> ^where <w>)", "(<w> ^name gate)")),
              IsEmpty());
}

TEST(SlipsOfLogic, AValueOfAStateThatNoRuleMakes) {
  const auto rules = [](const std::string& name) {
    return Rule("make", "(state <s> ^operator <o>)\n    (<o> ^name start)", "(<s> ^name " + name + ")") +
           Rule("r", "(state <s> ^name ferry ^bank <b>)", "(<s> ^operator <o> +)\n    (<o> ^name cross ^from <b>)");
  };
  EXPECT_THAT(Found(rules("ferri")), ElementsAre(HasSubstr("tests ^name ferry of a state, which no rule makes")));
  EXPECT_THAT(Found(rules("ferry")), IsEmpty());
  EXPECT_THAT(Found(rules("<o>")), IsEmpty());
  KnownWords known;
  known.made_values = {"name ferry"};  // In another file of the folder.
  EXPECT_THAT(Found(rules("ferri"), known), IsEmpty());
  known = {};
  known.complete = false;
  EXPECT_THAT(Found(rules("ferri"), known), IsEmpty());
}

TEST(SlipsOfLogic, AnApplicationOnAnotherStateThanTheProposal) {
  const std::string top = Rule("p", "(state <s> ^superstate nil)", "(<s> ^operator <o> +)\n    (<o> ^name go)");
  const std::string below =
      Rule("p", "(state <s> ^superstate <t>)\n    (<t> ^flag yes)", "(<s> ^operator <o> +)\n    (<o> ^name go)");
  const std::string at_top =
      Rule("a", "(state <s> ^superstate nil ^operator <o>)\n    (<o> ^name go)", "(<s> ^done yes)");
  const std::string at_below =
      Rule("a", "(state <s> ^superstate <t> ^operator <o>)\n    (<o> ^name go)", "(<t> ^done yes)");
  EXPECT_THAT(Found(below + at_top), ElementsAre(HasSubstr("go is proposed in substates alone")));
  EXPECT_THAT(Found(top + at_below), ElementsAre(HasSubstr("go is proposed at the top state alone")));
  EXPECT_THAT(Found(top + at_top), IsEmpty());
  EXPECT_THAT(Found(below + at_below), IsEmpty());
  EXPECT_THAT(Found(top + below + at_below), IsEmpty());
}

TEST(SlipsOfLogic, ACommandOfAProposal) {
  const auto apply = [](const std::string& name, const std::string& sign) {
    return Rule(name,
                "(state <s> ^operator <o>" + sign + " ^io <i*1>)\n    (<o> ^name go)\n    (<i*1> ^output-link <out>)",
                "(<out> ^stop <c>)");
  };
  EXPECT_THAT(Found(apply("a", "") + apply("b", " +")), ElementsAre(HasSubstr("rule b gives a command for go while")));
  EXPECT_THAT(Found(apply("a", "") + apply("b", "")), IsEmpty());
}

TEST(SlipsOfLogic, APathInAnAction) {
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate <above> ^operator <o>)",
                         "(<s> ^superstate <s*1>)\n    (<s*1> ^holds soup)")),
              ElementsAre(HasSubstr("makes another ^superstate: a path in an action makes a new object")));
  EXPECT_THAT(Found(Rule("r", "(state <s> ^superstate <above> ^operator <o>)", "(<above> ^holds soup)")), IsEmpty());
  EXPECT_THAT(Found(Rule("r", "(state <s> ^operator <o>)", "(<s> ^part <p*1>)\n    (<p*1> ^holds soup)")), IsEmpty());
}

TEST(SlipsOfLogic, RemovalOfWhatAnElaborationConcludes) {
  const std::string remove = Rule("a", "(state <s> ^operator <o> ^fire <p>)", "(<s> ^fire <p> -)");
  EXPECT_THAT(Found(Rule("e", "(state <s> ^seen <p>)", "(<s> ^fire <p>)") + remove),
              ElementsAre(HasSubstr("removes ^fire, which rule e concludes")));
  EXPECT_THAT(Found(Rule("e", "(state <s> ^seen <p> ^operator <o>)", "(<s> ^fire <p>)") + remove), IsEmpty());
}

TEST(SlipsOfLogic, AConclusionThatExcludesARule) {
  const std::string message =
      "(state <s> ^superstate nil%s ^io <i*1>)\n    (<i*1> ^input-link <i*2>)\n    (<i*2> ^message <m>)\n    (<m> "
      "^about fire ^place <p>)";
  const auto with = [&](const std::string& test) { return std::string(message).replace(message.find("%s"), 2, test); };
  const std::string propose = "(<s> ^operator <o> +)\n    (<o> ^name remember ^place <p>)";
  EXPECT_THAT(Found(Rule("e", with(""), "(<s> ^fire <p>)") + Rule("r", with(" -^fire"), propose)),
              ElementsAre(HasSubstr("tests -^fire, but whenever its other conditions match, rule e concludes ^fire")));
  EXPECT_THAT(Found(Rule("e", with(" ^asked yes"), "(<s> ^fire <p>)") + Rule("r", with(" -^fire"), propose)),
              IsEmpty());
}

}  // namespace
}  // namespace soarbox::explain
