// SPDX-License-Identifier: BSD-2-Clause
// Tests slips about operators, their attributes, commands and settings, each with a file that has it, and with a
// similar correct one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explain/rule_slips.h"

namespace soarbox::explain {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> Texts(const std::vector<Slip>& slips) {
  std::vector<std::string> texts;
  for (const Slip& slip : slips) texts.push_back(slip.message + "; " + slip.hint);
  return texts;
}

/// One rule in the form that a kernel prints.
std::string Rule(const std::string& name, const std::string& conditions, const std::string& actions) {
  return "sp {" + name + "\n    " + conditions + "\n    -->\n    " + actions + "\n}\n";
}

TEST(SlipsOfUse, TheNameOfAnOperatorOnItsState) {
  const auto found = [](const std::string& rules) { return Texts(FindSlipsOfUse(ReadRules(rules))); };
  const std::string conditions = "(state <s> ^superstate nil ^bell yes)";
  const std::string wrong = Rule("propose", conditions, "(<s> ^operator <o> + ^name ring)");
  const std::string right = Rule("propose", conditions, "(<s> ^operator <o> +)\n    (<o> ^name ring)");
  const std::string apply = Rule("apply", "(state <s> ^operator <o>)\n    (<o> ^name ring)", "(<s> ^rung yes)");
  const std::string note = Rule("note", "(state <s> ^operator <o>)", "(<s> ^busy <o>)");
  EXPECT_THAT(
      found(wrong + apply + note),
      ElementsAre(AllOf(HasSubstr("rule propose gives the ^name ring to its state"), HasSubstr("(<o> ^name ring)"))));
  EXPECT_THAT(found(right + apply + note), IsEmpty());
  // States have names here, which other rules test.
  const std::string below = Rule("below", "(state <s> ^name ring)", "(<s> ^ready yes)");
  EXPECT_THAT(found(wrong + note + below), IsEmpty());
}

TEST(SlipsOfUse, AnOperatorWithoutAName) {
  const auto found = [](const std::string& rules) { return Texts(FindSlipsOfUse(ReadRules(rules))); };
  const std::string nameless =
      Rule("mower*propose*mow", "(state <s> ^superstate nil ^grass high)", "(<s> ^operator <o> +)\n    (<o> ^to <s>)");
  const std::string apply = Rule("apply", "(state <s> ^operator <o>)\n    (<o> ^name mow)", "(<s> ^mown yes)");
  const std::string link = "(state <s> ^operator <o> ^io <i*1>)\n    (<i*1> ^output-link <out>)";
  const std::string tidy = Rule("tidy", link + "\n    (<out> ^<name> <c>)\n    (<c> ^status)", "(<out> ^<name> <c> -)");
  // A rule that removes answered commands for any operator applies none.
  EXPECT_THAT(found(nameless + apply + tidy),
              ElementsAre(AllOf(HasSubstr("proposes an operator without a ^name"), HasSubstr("(<o> ^name mow)"))));
  const std::string give = Rule("give", link + "\n    (<o> ^to <to>)", "(<out> ^move <to>)");
  EXPECT_THAT(found(nameless + apply + give), IsEmpty());
}

TEST(SlipsOfUse, APreferenceInTheSubstateForACandidateAbove) {
  const auto found = [](const std::string& rules) { return Texts(FindSlipsOfUse(ReadRules(rules))); };
  const std::string conditions = "(state <s> ^impasse conflict ^superstate <above> ^item <o>)\n    (<o> ^depth < 3)";
  EXPECT_THAT(found(Rule("reject", conditions, "(<s> ^operator <o> -)")),
              ElementsAre(AllOf(HasSubstr("rule reject gives <o> a preference in the substate <s>"),
                                HasSubstr("(<above> ^operator <o> -)"))));
  EXPECT_THAT(found(Rule("reject", conditions, "(<above> ^operator <o> -)")), IsEmpty());
  // Here the candidates are proposed again below.
  EXPECT_THAT(found(Rule("again", "(state <s> ^impasse tie ^item <o>)", "(<s> ^operator <o> +)") +
                    Rule("best", "(state <s> ^impasse tie ^item <o>)\n    (<o> ^depth > 9)", "(<s> ^operator <o> >)")),
              IsEmpty());
}

TEST(SlipsOfLogic, ANameInsteadOfTheObject) {
  const auto found = [](const std::string& rules) { return Texts(FindSlipsOfLogic(ReadRules(rules), {})); };
  const std::string conditions = "(state <s> ^thing <t>)\n    (<t> ^name <name> ^away no)";
  const std::string wrong = Rule("put", conditions, "(<s> ^operator <o> +)\n    (<o> ^name put ^thing <name>)");
  const std::string right = Rule("put", conditions, "(<s> ^operator <o> +)\n    (<o> ^name put ^thing <t>)");
  const std::string walk = Rule("walk",
                                "(state <s> ^superstate <a>)\n    (<a> ^operator <o>)\n    (<o> ^name put ^thing <t>)\n"
                                "    (<t> ^lies-at <place>)",
                                "(<s> ^operator <w> +)\n    (<w> ^name walk ^to <place>)");
  EXPECT_THAT(found(wrong + walk),
              ElementsAre(AllOf(HasSubstr("rule put gives its operator ^thing <name>, a name, and rule walk tests "
                                          "^lies-at below it"),
                                HasSubstr("(<o> ^thing <t>)"))));
  EXPECT_THAT(found(right + walk), IsEmpty());
  // Another operator has an object as its ^thing, and the state bears the name of the operator above.
  const std::string take =
      Rule("take", "(state <s> ^thing <t>)", "(<s> ^operator <o> +)\n    (<o> ^name take ^thing <t>)");
  const std::string below = Rule("below",
                                 "(state <s> ^name put ^superstate <a>)\n    (<a> ^operator <o>)\n"
                                 "    (<o> ^thing <t>)\n    (<t> ^lies-at <place>)",
                                 "(<s> ^operator <w> +)\n    (<w> ^name walk ^to <place>)");
  EXPECT_THAT(found(wrong + take + below), ElementsAre(HasSubstr("rule put gives its operator ^thing <name>, a name")));
  EXPECT_THAT(found(right + take + below), IsEmpty());
  // Nothing is tested below the name.
  EXPECT_THAT(
      found(wrong + Rule("say", "(state <s> ^operator <o>)\n    (<o> ^name put ^thing <t>)", "(<s> ^said <t>)")),
      IsEmpty());
}

TEST(SlipsOfMeaning, TwoCommandsForOnePartOfTheBody) {
  const auto found = [](const std::string& actions) {
    const std::string conditions =
        "(state <s> ^operator <o> ^io <i*1>)\n    (<i*1> ^output-link <out>)\n"
        "    (<o> ^name go ^waypoint <place>)";
    const std::string propose =
        Rule("propose", "(state <s> ^place <place>)", "(<s> ^operator <o> +)\n    (<o> ^name go ^waypoint <place>)");
    return Texts(FindSlipsOfMeaning(ReadRules(propose + Rule("r", conditions, actions)), {{"place"}, {}}));
  };
  EXPECT_THAT(found("(<out> ^move-to <m> ^wander <w>)\n    (<m> ^waypoint <place>)"),
              ElementsAre(HasSubstr("gives move-to and wander at once, and both need the legs")));
  EXPECT_THAT(found("(<out> ^move-to <m> ^say <w>)\n    (<m> ^waypoint <place>)\n    (<w> ^about go)"), IsEmpty());
}

TEST(SlipsOfMeaning, ANameInsteadOfACommand) {
  const auto found = [](const std::string& bound, const std::string& actions) {
    const std::string conditions =
        "(state <s> ^operator <o> ^io <i*1>)\n    (<i*1> ^output-link <out>)\n"
        "    (<o> ^name go ^waypoint <name>)";
    const std::string propose = Rule("propose", "(state <s> ^place <p>)\n    (<p> ^" + bound + " <w>)",
                                     "(<s> ^operator <o> +)\n    (<o> ^name go ^waypoint <w>)");
    return Texts(FindSlipsOfMeaning(ReadRules(propose + Rule("r", conditions, actions)), {{"place", "plan"}, {}}));
  };
  EXPECT_THAT(found("name", "(<out> ^move-to <name>)"),
              ElementsAre(AllOf(HasSubstr("gives ^move-to the value <name>, a name"),
                                HasSubstr("(<out> ^move-to <command>) (<command> ^waypoint <name>)"))));
  EXPECT_THAT(found("name", "(<out> ^move-to <m>)\n    (<m> ^waypoint <name>)"), IsEmpty());
}

TEST(FindDuplicates, ASettingThatALaterLineChanges) {
  const auto found = [](const std::string& text) {
    std::vector<std::string> messages;
    for (const Diagnostic& warning : FindDuplicates({{"hare.soar", text}}))
      messages.push_back(std::to_string(warning.line) + ": " + warning.message);
    return messages;
  };
  EXPECT_THAT(found("rl --set learning on\nrl --set discount-rate 0.9\n\nrl --set discount-rate 0\n"),
              ElementsAre("2: this sets discount-rate to 0.9, and line 4 sets it to 0: only the last one counts"));
  EXPECT_THAT(found("rl --set discount-rate 0.9\nrl --set learning on\nrl --set discount-rate 0.9\n"), IsEmpty());
}

}  // namespace
}  // namespace soarbox::explain
