// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/parser.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class ParserTest : public testing::Test {
 protected:
  ParseOutcome Parse(std::string_view body) { return ParseProduction(body, {"scout.soar", 10, 5}, symbols_); }

  /// All texts that Soar would print for the rule, without the star.
  std::string Messages(std::string_view body) {
    const ParseOutcome outcome = Parse(body);
    std::string text;
    for (const RuleMessage& message : outcome.messages) text += message.text;
    for (const RuleMessage& message : outcome.late_messages) text += message.text;
    EXPECT_EQ(outcome.production == nullptr, text.find("(Ignoring") != std::string::npos || outcome.name.empty());
    return text;
  }

  std::string Printed(std::string_view body, bool internal = false) {
    const ParseOutcome outcome = Parse(body);
    return outcome.production ? PrintProduction(symbols_, *outcome.production, {internal})
                              : "refused: " + Messages(body);
  }

  SymbolTable symbols_;
};

TEST_F(ParserTest, AnUnknownFunctionIsAnErrorWithItsPlaceUnlessAClientHasIt) {
  constexpr std::string_view kRule = "go (state <s> ^a <a>)\n-->\n(<s> ^b (conact <a> x))";
  const ParseOutcome refused = Parse(kRule);
  EXPECT_EQ(refused.production, nullptr);
  ASSERT_EQ(refused.diagnostics.size(), 1u);
  EXPECT_EQ(refused.diagnostics[0].line, 12);
  EXPECT_EQ(refused.diagnostics[0].column, 10);
  EXPECT_THAT(refused.diagnostics[0].message, HasSubstr("calls the function conact, which does not exist"));
  EXPECT_THAT(refused.diagnostics[0].hint, HasSubstr("did you mean concat? (exec conact ...) calls a function"));

  RuleLanguage language;
  language.is_client_function = [](std::string_view name) { return name == "conact"; };
  EXPECT_NE(ParseProduction(kRule, {}, symbols_, {}, language).production, nullptr);
  language = {SoarVersion::k963, {}};
  EXPECT_NE(ParseProduction(kRule, {}, symbols_, {}, language).production, nullptr);
  EXPECT_NE(Parse("go (state <s> ^a <a>) --> (<s> ^b (exec conact <a> x))").production, nullptr);
}

TEST_F(ParserTest, ADollarMarksAVariableThatLearningKeepsLiteral) {
  EXPECT_THAT(Printed("lit (state <s> ^a $ <x> ^b { <y> $$ <y> }) --> (<s> ^c <x>)"),
              AllOf(HasSubstr("^a $ <x>"), HasSubstr("^b $ <y>")));
  EXPECT_THAT(Printed("lit (state <s> ^a { <x> $$ <x> < 5 }) --> (<s> ^c <x>)"), HasSubstr("$$ <x>"));
  // The printed text is read as the same rule.
  const std::string printed = Printed("lit (state <s> ^a { $ <x> < 5 > 2 }) --> (<s> ^c <x>)");
  const std::size_t open = printed.find('{');
  EXPECT_EQ(Printed(printed.substr(open + 1, printed.rfind('}') - open - 1)), printed);
  EXPECT_THAT(Printed("lit (state <s> ^a { <x> $$ <y> } ^b <y>) --> (<s> ^c <x>)"),
              HasSubstr("$$ needs the variable of its own test"));
  // Before a constant, which stays in any case, `$` has no effect; alone or between bars it is a word.
  EXPECT_THAT(Printed("lit (state <s> ^a $ 5 ^b $ ^c |$|) --> (<s> ^d $)"),
              AllOf(HasSubstr("^a 5"), HasSubstr("^b |$|"), HasSubstr("^c |$|"), HasSubstr("^d |$|")));
  RuleLanguage older;
  older.version = SoarVersion::k963;
  const ParseOutcome two = ParseProduction("lit (state <s> ^a $ <x>) --> (<s> ^c <x>)", {}, symbols_, {}, older);
  EXPECT_THAT(PrintProduction(symbols_, *two.production, {}), HasSubstr("^a |$| ^a <x>"));
}

TEST_F(ParserTest, ATemplateWithoutOneNumericPreferenceIsRefused) {
  for (const char* actions : {"(<s> ^x 1)", "(<s> ^operator <o> = 1) (<s> ^x 2)", "(<s> ^operator <o> >)",
                              "(write |x|)", "(<s> ^operator <o> + = 0.5)"}) {
    const ParseOutcome outcome = Parse("bad :template (state <s> ^operator <o> +) --> " + std::string(actions));
    EXPECT_EQ(outcome.production, nullptr) << actions;
    ASSERT_FALSE(outcome.late_messages.empty());
    EXPECT_EQ(outcome.late_messages.back().text, "Invalid Soar-RL template (bad)\n\n");
  }
  EXPECT_NE(Parse("good :template (state <s> ^operator <o> +) --> (<s> ^operator <o> = <x>)").production, nullptr);
  EXPECT_NE(Parse("good :template (state <s> ^operator <o> +) --> (<s> ^operator <o> = 0.5)").production, nullptr);
}

TEST_F(ParserTest, ErrorsOfSyntaxHaveSoarsTexts) {
  const std::pair<const char*, const char*> kCases[] = {
      {"", "Expected symbol for production name\n"},
      {"12 (state <s> ^a b) --> (<s> ^c d)", "Expected symbol for production name\n"},
      {"s1 (state <s> ^a b) --> (<s> ^c d)", "Expected symbol for production name\n"},
      {"ab", "Expected ( to begin condition element\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b)", "Expected --> in production\n(Ignoring production ab)\n\n"},
      {"ab (state <s> a b) --> (<s> ^c d)", "Expected ^ followed by attribute\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a >) --> (<s> ^c d)", "Expected variable or constant for test\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a << <x> >>) --> (<s> ^c d)",
       "Expected constant or >> while reading disjunction test\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) -{} --> (<s> ^c d)", "Expected ( to begin condition element\n(Ignoring production ab)\n\n"},
      {"ab (state <s>) --> (<s> ^c d)",
       "Error: Expected attribute-value test after state/impasse test. Did you forget to add \"^type state\" or "
       "\"^superstate nil\"?\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) (b ^c 3) --> (<s> ^c d)",
       "Warning: Constant b in id field test.\n         This will never match.\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s> ^c)", "Illegal value for RHS value\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s>)", "(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s> c d)", "Expected ^ in RHS make action\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> junk", "Expected ( to begin RHS action\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (s ^c d)", "There is no function named s\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s> ^x (abs 1 2))",
       "Wrong number of arguments to function abs (expected 1)\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (abs 3)",
       "Function abs cannot be used as a stand-alone action\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s> ^x (write hello))",
       "Function write can only be used as a stand-alone action\n(Ignoring production ab)\n\n"},
      {"ab (state <s> ^a b) --> (<s> ^colour <i> > <s>)",
       "\nERROR: Binary preference illegal for non-operator.id = <s>\t attr = colour\t value = <i>\n"
       "(Ignoring production ab)\n\n"},
  };
  for (const auto& [body, expected] : kCases) {
    EXPECT_EQ(Messages(body), expected) << body;
  }
}

TEST_F(ParserTest, RulesThatHangOnNothingAreRefusedOrWarnedOf) {
  EXPECT_EQ(Messages("ab (state <s> ^a b) --> (<x> ^c <y>) (<y> ^d e)"),
            "Attempted to add rule with ungrounded action(s).\n"
            "The following RHS actions contain variables that are not tested\n"
            "in a positive condition on the LHS: \n\n"
            "        (<x> ^c <y> +)\n        (<y> ^d e +)\n\n(Ignoring production ab)\n\n");
  EXPECT_EQ(Messages("ab (state <s> ^a b) (<x> ^c <y>) (<y> ^e f) --> (<s> ^e <y>)"),
            "\nWarning: On the LHS of production ab, identifier <x> is not connected to any goal or impasse.\n");
  // (Unlike elsewhere, the name is printed without bars here.)
  EXPECT_EQ(Messages("ab*1 (state <s> ^a b) (<x> ^c <y>) (<y> ^e f) --> (<s> ^e <y>)"),
            "\nWarning: On the LHS of production ab*1, identifier <x> is not connected to any goal or impasse.\n");
  EXPECT_EQ(Messages("ab*1 (state <s> ^a b -^c > <limit>) --> (<s> ^e f)")
                .find("Error: production ab*1 has an unbound referent in negated relational test > <limit>.\n"),
            0u);
  EXPECT_EQ(Messages("ab -(state <s> ^a b) --> (write x)"),
            "Error: production ab has no positive conditions that reference a goal state.\n"
            "Did you forget to add \"^type state\" or \"^superstate nil\"?\n(Ignoring production ab)\n\n");
  EXPECT_EQ(Messages("ab (state <s> ^a b -^c > <limit>) --> (<s> ^e f)"),
            "Error: production ab has an unbound referent in negated relational test > <limit>.\n\n"
            "Attempted to add an invalid rule:\n"
            "      Unbound relational test in negative condition of rule \n(Ignoring production ab)\n\n");
}

TEST_F(ParserTest, AnOlderRuleIsToGoOnceTheNameIsReadEvenIfTheNewOneIsRefused) {
  const ParseOutcome broken = Parse("ab (state <s> ^a");
  EXPECT_EQ(broken.name, "ab");
  EXPECT_TRUE(broken.messages.empty());
  EXPECT_FALSE(broken.late_messages.empty());
  EXPECT_EQ(Parse("ab 99999999999999999999 (state <s> ^a b) --> (write x)").messages.size(), 1u);
  const ParseOutcome outcome = Parse("ab (state <s> ^a b) --> (<x> ^c d)");
  EXPECT_EQ(outcome.production, nullptr);
  EXPECT_TRUE(outcome.messages.empty());
  EXPECT_EQ(outcome.late_messages.size(), 2u);
}

TEST_F(ParserTest, DiagnosticsNameThePlaceTheTokenAndWhatToDo) {
  const ParseOutcome outcome = Parse("ab (state <s> ^a b)\n   --> (<s> ^c << d >>)");
  ASSERT_EQ(outcome.diagnostics.size(), 1u);
  const Diagnostic& diagnostic = outcome.diagnostics[0];
  EXPECT_EQ(diagnostic.file, "scout.soar");
  EXPECT_EQ(diagnostic.line, 11);
  EXPECT_EQ(diagnostic.column, 16);
  EXPECT_EQ(diagnostic.message,
            "rule ab: expected a value: a constant, a variable, or a function call in parentheses, found '<<'");
  EXPECT_EQ(diagnostic.hint, "the ( of line 11, column 8 is still open here");
  EXPECT_EQ(diagnostic.excerpt, "   --> (<s> ^c << d >>)");
}

TEST_F(ParserTest, ARuleThatEndsTooEarlySaysWhichBracketIsOpen) {
  const auto complaint = [&](std::string_view body) {
    const ParseOutcome outcome = Parse(body);
    return outcome.diagnostics.empty() ? std::string()
                                       : outcome.diagnostics[0].message + "\n" + outcome.diagnostics[0].hint;
  };
  EXPECT_EQ(complaint("ab (state <s> ^a b)\n   -->\n   (<s> ^c |)| ^d\n"),
            "rule ab: expected a value: a constant, a variable, or a function call in parentheses, but the rule ends "
            "here\nthe ( of line 12, column 4 is never closed");
  EXPECT_EQ(complaint("ab (state <s> ^a b)\n  -{(<s> ^c d) --> (<s> ^e f)"),
            "rule ab: expected } to end the conditions that -{ began, found '-->'\nthe { of line 11, column 4 is still "
            "open here");
  EXPECT_EQ(complaint("ab (state <s> ^a b)"),
            "rule ab: expected another condition, or --> before the actions, but the rule ends here\n");
}

TEST_F(ParserTest, TrapsAreToldOfBesideSoarsOwnTexts) {
  const auto traps = [&](std::string_view body) {
    std::string text;
    for (const Diagnostic& diagnostic : Parse(body).diagnostics) text += diagnostic.message + "\n";
    return text;
  };
  EXPECT_THAT(traps("ab (state <s> ^x <o1> <o2>) --> (<s> ^operator <o1> + = <o2> + =)"),
              HasSubstr("takes <o2> as its referent"));
  EXPECT_THAT(traps("ab (state <s> ^x r2) --> (<s> ^y z)"), HasSubstr("r2 looks like an identifier"));
  EXPECT_THAT(traps("ab (state <s> ^x y) --> (<s> ^superstate z)"), HasSubstr("^superstate on a state"));
  EXPECT_THAT(traps("ab (state <s> ^x y) (<q> ^z 1) --> (<s> ^y z)"), HasSubstr("<q> is not connected to a state"));
  EXPECT_EQ(traps("ab (state <s> ^x <o1>) --> (<s> ^operator <o1> + =)"), "");
}

TEST_F(ParserTest, BracketsWithoutEndAreRefusedNotFollowed) {
  std::string nested = "ab (state <s> ^a b) ";
  for (int i = 0; i < 100000; ++i) nested += "-{";
  EXPECT_THAT(Messages(nested), HasSubstr("nested too deeply"));
  std::string calls = "ab (state <s> ^a b) --> (<s> ^c ";
  for (int i = 0; i < 100000; ++i) calls += "(+ ";
  EXPECT_THAT(Messages(calls), HasSubstr("nested too deeply"));
  EXPECT_EQ(Parse("ab (state <s> ^a b) --> (").production, nullptr);
}

TEST_F(ParserTest, ConditionsAreOrderedAndPrintedAsSoarDoes) {
  EXPECT_EQ(Printed("rule*alpha \"First rule.\" (state <s> ^superstate nil ^a.b <x>) (<x> ^c { <y> > 3 })"
                    "-{(<x> ^f <z>) (<z> ^g yes)} --> (<s> ^result <new> ^flag yes)"
                    "(<new> ^sum (+ 1 (* 2 <y>)) ^text |a b|) (write |hello | <y> (crlf))"),
            "sp {rule*alpha\n"
            "    \"First rule.\"\n"
            "    (state <s> ^superstate nil ^a <a*1>)\n"
            "    (<a*1> ^b <x>)\n"
            "   -{ (<x> ^f <z>)\n"
            "      (<z> ^g yes)}\n"
            "    (<x> ^c { > 3 <y> })\n"
            "    -->\n"
            "    (<s> ^result <new> ^flag yes)\n"
            "    (<new> ^sum (+ 1 (* 2 <y>)) ^text |a b|)\n"
            "    (write |hello | <y> (crlf))\n"
            "}\n");
}

TEST_F(ParserTest, RelationalTestsMoveToWhereBothSidesAreBoundAndTurnRound) {
  EXPECT_EQ(
      Printed("ab (state <s> ^a b) (<s> ^b {<x> > 3} ^c { <y> > <x> } ^d {<z> < <y> > <x> <> 3}) --> (<s> ^y 1)", true),
      "sp {ab\n"
      "    (state <s> ^a b)\n"
      "    (<s> ^d { <> 3 <z> })\n"
      "    (<s> ^c { > <z> <y> })\n"
      "    (<s> ^b { > 3 < <y> < <z> <x> })\n"
      "    -->\n"
      "    (<s> ^y 1)\n"
      "}\n");
}

TEST_F(ParserTest, TiesGoToTheMostRecentConstant) {
  EXPECT_EQ(Printed("ab (state <s> ^superstate nil ^type state ^zz <z> ^aa <a> -^qq 1) --> (<s> ^y 1)", true),
            "sp {ab\n"
            "    (state <s> ^type state)\n"
            "    (<s> -^qq 1)\n"
            "    (<s> ^superstate nil)\n"
            "    (<s> ^aa <a>)\n"
            "    (<s> ^zz <z>)\n"
            "    -->\n"
            "    (<s> ^y 1)\n"
            "}\n");
}

TEST_F(ParserTest, PathsStructuredValuesAndNegatedPathsExpand) {
  EXPECT_EQ(Printed("ab (state <s> ^a (<b> ^n <n> ^from (^h <p>)) -^x.y 1) --> (<s> ^q.r 2 ^operator.name go)"),
            "sp {ab\n"
            "    (state <s> ^a <b>)\n"
            "   -{ (<s> ^x <x*1>)\n"
            "      (<x*1> ^y 1)}\n"
            "    (<b> ^from <f*1> ^n <n>)\n"
            "    (<f*1> ^h <p>)\n"
            "    -->\n"
            "    (<s> ^q <q*1> ^operator <o*1> +)\n"
            "    (<q*1> ^r 2)\n"
            "    (<o*1> ^name go)\n"
            "}\n");
}

TEST_F(ParserTest, ChunksGetTheVariableNamesOfTheNetwork) {
  EXPECT_EQ(Printed("ab :chunk (state <abc> ^foo <q>) (<q> ^n <m>) --> (<abc> ^operator <new> + ^sum (+ <m> 1))"),
            "sp {ab\n"
            "    :chunk\n"
            "    (state <s1> ^foo <f1>)\n"
            "    (<f1> ^n <n1>)\n"
            "    -->\n"
            "    (<s1> ^operator <o1> + ^sum (+ <n1> 1))\n"
            "}\n");
}

TEST_F(ParserTest, VariablesOfActionsAreBoundToFieldsOrNewIdentifiers) {
  const ParseOutcome outcome =
      Parse("ab (state <s> ^a <x>) -{(<s> ^b <y>)} (<x> ^<k> 3) --> (<n> ^<k> <x>) (<s> ^new <n> <y>)");
  ASSERT_NE(outcome.production, nullptr);
  const Production& rule = *outcome.production;
  ASSERT_EQ(rule.actions.size(), 3u);
  EXPECT_EQ(rule.actions[0].value.kind, RhsValueKind::kNew) << "the action that makes <n> comes first";
  EXPECT_EQ(rule.actions[0].value.new_index(), 0);
  EXPECT_EQ(rule.actions[1].attribute.site(), (BindingSite{1, Field::kAttribute}));
  EXPECT_EQ(rule.actions[1].value.site(), (BindingSite{0, Field::kValue}));
  EXPECT_EQ(rule.actions[2].value.kind, RhsValueKind::kNew) << "<y> is bound in the negation only";
  EXPECT_EQ(rule.new_identifiers.size(), 2u);
}

TEST_F(ParserTest, OnlyASingleNumericPreferenceMakesALearningRule) {
  EXPECT_TRUE(Parse("ab (state <s> ^operator <o> +) --> (<s> ^operator <o> = 2)").production->is_rl);
  EXPECT_FALSE(Parse("ab (state <s> ^operator <o> +) --> (<s> ^operator <o> = 2 >)").production->is_rl);
  EXPECT_FALSE(Parse("ab (state <s> ^operator <o> + ^v <v>) --> (<s> ^operator <o> = <v>)").production->is_rl);
  EXPECT_FALSE(Parse("ab :template (state <s> ^operator <o> +) --> (<s> ^operator <o> = 2)").production->is_rl);
}

TEST_F(ParserTest, OnlyAWrittenAttributeNamesTheVariableForItsValue) {
  EXPECT_THAT(Printed("ab (state <s> ^<< a b >> > 3 ^{ <t> <> foo } > 3 ^<> zoo.x > 3 ^c > 3) --> (<s> ^d e)"),
              AllOf(HasSubstr("^{ << a b >> <a*1> } { > 3 <v*1> }"), HasSubstr("{ > 3 <t*1> }"),
                    HasSubstr("^{ <> zoo <a*2> } <v*2>"), HasSubstr("^c { > 3 <c*1> }")));
}

TEST_F(ParserTest, ACommaIsAnAcceptablePreferenceWhereOneMayStand) {
  EXPECT_THAT(Printed("ab (state <s> ^c <c>) --> (<s> ^operator <o> <c> (* 1 2) , + , = 5)"),
              HasSubstr("(<s> ^operator <o> + ^operator <c> + ^operator (* 1 2) +\n"
                        "           ^operator (* 1 2) + ^operator (* 1 2) = 5)\n"));
}

TEST_F(ParserTest, ConditionsOnAttributesOfManyValuesComeLater) {
  constexpr std::string_view kRule =
      "wide (state <s> ^superstate nil ^near <n> ^far <f> ^seen <f>) --> (<s> ^done yes)";
  const auto attributes = [this](const Production& rule) {
    std::string text;
    for (const Condition& condition : rule.conditions) text += ToString(symbols_, condition.attribute.referent()) + ' ';
    return text;
  };
  EXPECT_EQ(attributes(*Parse(kRule).production), "superstate seen far near ");
  ExpectedValues expected;
  expected.Set(symbols_.String("seen"), 5);
  expected.Set(symbols_.String("far"), 4);
  expected.Set(symbols_.String("far"), 2);
  EXPECT_EQ(attributes(*ParseProduction(kRule, {}, symbols_, expected).production), "superstate near far seen ");
  expected.Set(symbols_.String("near"), 1000000000);
  const ParseOutcome outcome = ParseProduction(kRule, {}, symbols_, expected);
  EXPECT_EQ(attributes(*outcome.production), "superstate far seen near ");
  EXPECT_TRUE(outcome.late_messages.empty()) << "dear, but connected";
}

}  // namespace
}  // namespace soarbox::kernel
