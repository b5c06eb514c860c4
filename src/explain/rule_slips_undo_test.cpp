// SPDX-License-Identifier: BSD-2-Clause
// Tests each slip of undoing, and each slip about what is absent, with a rule that has it and with a similar correct
// rule.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "explain/rule_slips.h"

namespace soarbox::explain {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The messages about these rules, which have the form that a kernel prints.
std::vector<std::string> Undoing(const std::string& rules) {
  std::vector<std::string> messages;
  for (const Slip& slip : FindSlipsOfUndoing(ReadRules(rules))) messages.push_back(slip.message);
  return messages;
}
std::vector<std::string> Negation(const std::string& rules) {
  std::vector<std::string> messages;
  for (const Slip& slip : FindSlipsOfNegation(ReadRules(rules))) messages.push_back(slip.message);
  return messages;
}

/// One rule in the form that a kernel prints.
std::string Rule(const std::string& name, const std::string& conditions, const std::string& actions) {
  return "sp {" + name + "\n    " + conditions + "\n    -->\n    " + actions + "\n}\n";
}

TEST(SlipsOfUndoing, ARuleThatRemovesWhatItsOperatorAdds) {
  const std::string remember =
      Rule("remember", "(state <s> ^operator <o>)\n    (<o> ^name move ^direction <d>)", "(<s> ^last <d>)");
  EXPECT_THAT(Undoing(remember + Rule("forget", "(state <s> ^operator <o> ^last <old>)\n    (<o> ^name move)",
                                      "(<s> ^last <old> -)")),
              ElementsAre(HasSubstr("rule forget removes every ^last while its operator is selected, also the one that "
                                    "rule remember has just added")));
  // It removes another value, it waits for something, or it belongs to another operator.
  EXPECT_THAT(Undoing(remember + Rule("forget",
                                      "(state <s> ^operator <o> ^last { <> <d> <old> })\n"
                                      "    (<o> ^name move ^direction <d>)",
                                      "(<s> ^last <old> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(remember + Rule("forget", "(state <s> ^operator <o> ^last <old> ^done yes)\n    (<o> ^name move)",
                                      "(<s> ^last <old> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(remember + Rule("forget", "(state <s> ^operator <o> ^last <old>)\n    (<o> ^name rest)",
                                      "(<s> ^last <old> -)")),
              IsEmpty());
  // The rules belong to operators with different parameters.
  EXPECT_THAT(Undoing(Rule("on", "(state <s> ^operator <o>)\n    (<o> ^name radio ^switch on)", "(<s> ^playing yes)") +
                      Rule("off", "(state <s> ^operator <o> ^playing <old>)\n    (<o> ^name radio ^switch off)",
                           "(<s> ^playing <old> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(remember + Rule("replace", "(state <s> ^operator <o> ^last <old>)\n    (<o> ^name move)",
                                      "(<s> ^last <old> - ^last none)")),
              IsEmpty());
}

TEST(SlipsOfUndoing, ACommandThatIsRemovedAtOnce) {
  const std::string link = "(state <s> ^operator <o> ^io <i*1>)\n    (<i*1> ^output-link <out>)\n    (<o> ^name go)";
  const std::string give = Rule("give", link, "(<out> ^move <m*1>)\n    (<m*1> ^direction north)");
  EXPECT_THAT(Undoing(give + Rule("clear", link + "\n    (<out> ^move <done>)", "(<out> ^move <done> -)")),
              ElementsAre(HasSubstr("rule clear removes every ^move")));
  EXPECT_THAT(Undoing(give + Rule("clear", link + "\n    (<out> ^move <done>)\n    (<done> ^status complete)",
                                  "(<out> ^move <done> -)")),
              IsEmpty());
}

TEST(SlipsOfUndoing, AnyCommandThatIsRemovedAtOnce) {
  const std::string link = "(state <s> ^operator <o> ^io <i*1>)\n    (<i*1> ^output-link <out>)";
  const std::string give =
      Rule("give", link + "\n    (<o> ^name go)", "(<out> ^move <m*1>)\n    (<m*1> ^direction north)");
  EXPECT_THAT(Undoing(give + Rule("tidy", link + "\n    (<out> ^<name> <done>)", "(<out> ^<name> <done> -)")),
              ElementsAre(HasSubstr("rule tidy removes every command while its operator is selected, also the ^move "
                                    "that rule give has just added")));
  // It waits for an answer, it belongs to another operator, or something restricts the names of the commands.
  EXPECT_THAT(Undoing(give + Rule("tidy", link + "\n    (<out> ^<name> <done>)\n    (<done> ^status)",
                                  "(<out> ^<name> <done> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(give + Rule("tidy", link + "\n    (<o> ^name stop)\n    (<out> ^<name> <done>)",
                                  "(<out> ^<name> <done> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(give + Rule("tidy", link + "\n    (<o> ^name <> go)\n    (<out> ^<name> <done>)",
                                  "(<out> ^<name> <done> -)")),
              IsEmpty());
  EXPECT_THAT(Undoing(give + Rule("tidy", link + "\n    (<o> ^ends <name>)\n    (<out> ^<name> <done>)",
                                  "(<out> ^<name> <done> -)")),
              IsEmpty());
}

TEST(SlipsOfUndoing, ASumWithoutBrackets) {
  const std::string counts = "(state <s> ^operator <o> ^next <n>)\n    (<o> ^name count)";
  EXPECT_THAT(Undoing(Rule("r", counts, "(<s> ^next <n> - ^next <n> + ^next 1 +)")),
              ElementsAre(HasSubstr("removes ^next <n> and adds it again, with 1 as a second value")));
  EXPECT_THAT(Undoing(Rule("r", counts, "(<s> ^next <n> - ^next (+ <n> 1) +)")), IsEmpty());
  EXPECT_THAT(Undoing(Rule("r", counts, "(<s> ^next <n> - ^next 1 +)")), IsEmpty());
}

TEST(SlipsOfNegation, AnAttributeThatNoOperatorHas) {
  const std::string propose = Rule("propose", "(state <s> ^letter <l>)\n    (<l> ^urgent yes)",
                                   "(<s> ^operator <o> +)\n    (<o> ^name look ^letter <l>)");
  EXPECT_THAT(
      Negation(propose + Rule("r", "(state <s> ^operator <o>)\n    (<o> ^name look -^urgent yes)", "(<s> ^seen yes)")),
      ElementsAre(HasSubstr("tests -^urgent of its operator, and no rule gives an operator ^urgent")));
  EXPECT_THAT(Negation(propose +
                       Rule("r", "(state <s> ^operator <o>)\n    (<o> ^name look ^letter <l>)\n    (<l> -^urgent yes)",
                            "(<s> ^seen yes)")),
              IsEmpty());
  EXPECT_THAT(Negation(propose + Rule("more", "(state <s> ^operator <o> +)", "(<o> ^urgent yes)") +
                       Rule("r", "(state <s> ^operator <o>)\n    (<o> ^name look -^urgent yes)", "(<s> ^seen yes)")),
              IsEmpty());
}

TEST(SlipsOfNegation, YesForAName) {
  const std::string danger =
      Rule("danger", "(state <s> ^agent <a>)\n    (<a> ^name <name> ^range < 8)", "(<s> ^danger <name>)");
  EXPECT_THAT(Negation(danger + Rule("r", "(state <s> ^superstate nil -^danger yes)", "(<s> ^calm yes)")),
              ElementsAre(HasSubstr("tests -^danger yes, but rule danger makes ^danger a name, never yes: the "
                                    "condition always holds")));
  EXPECT_THAT(Negation(danger + Rule("r", "(state <s> ^superstate nil ^danger yes)", "(<s> ^calm no)")),
              ElementsAre(HasSubstr("the condition never holds")));
  EXPECT_THAT(Negation(danger + Rule("r", "(state <s> ^superstate nil -^danger)", "(<s> ^calm yes)")), IsEmpty());
  EXPECT_THAT(Negation(danger + Rule("also", "(state <s> ^alarm yes)", "(<s> ^danger yes)") +
                       Rule("r", "(state <s> ^superstate nil -^danger yes)", "(<s> ^calm yes)")),
              IsEmpty());
}

TEST(SlipsOfMemory, ATemplateWithoutValues) {
  const auto found = [](const std::string& conditions) {
    std::vector<std::string> messages;
    for (const Slip& slip : FindSlipsOfMemory(
             ReadRules("sp {t\n    :template\n    " + conditions + "\n    -->\n    (<s> ^operator <o> = 0.)\n}\n")))
      messages.push_back(slip.message);
    return messages;
  };
  EXPECT_THAT(found("(state <s> ^operator <o> +)\n    (<o> ^name go)"),
              ElementsAre(HasSubstr("template t has no variable for a value")));
  EXPECT_THAT(found("(state <s> ^operator <o> +)\n    (<o> ^name go ^to <to>)"), IsEmpty());
}

}  // namespace
}  // namespace soarbox::explain
