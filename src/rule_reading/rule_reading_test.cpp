// SPDX-License-Identifier: BSD-2-Clause
#include "rule_reading/rule_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/print_production.h"
#include "kernel/rules/production.h"

namespace soarbox::rule_reading {
namespace {

using kernel::Condition;
using kernel::ConditionKind;
using kernel::ParseProduction;
using kernel::Production;
using kernel::ProductionPtr;
using kernel::RhsValue;
using kernel::RhsValueKind;
using kernel::SymbolTable;
using kernel::Test;
using kernel::TestKind;

/// Draws rules as an author might write them, with every word that is legal and looks like something else.
class RuleWriter {
 public:
  explicit RuleWriter(std::uint32_t seed) : random_(seed) {}

  std::string Next(int number) {
    bound_ = {"<s>"};
    std::string text = "r*" + std::to_string(number);
    if (Below(8) == 0) text += "\n  \"about { and | and -->\"";
    if (Below(8) == 0) text += Below(2) == 0 ? " :o-support" : " :i-support";
    text += "\n  (state <s>" + Attributes() + ")";
    for (std::uint32_t i = Below(4); i > 0; --i) text += "\n  " + Clause();
    if (Below(3) == 0) text += "\n  -{" + Clause() + " " + Clause() + "}";
    text += "\n-->\n  (<s>" + Made() + ")";
    for (std::uint32_t i = Below(3); i > 0; --i) text += "\n  (" + Pick(bound_) + Made() + ")";
    if (Below(3) == 0) text += "\n  (<s> ^operator <o> + " + std::string(Below(2) == 0 ? "=" : "> <p>") + ")";
    if (Below(4) == 0) text += "\n  (write " + Word() + " (crlf) " + Call() + ")";
    return text;
  }

 private:
  std::uint32_t Below(std::uint32_t limit) { return random_() % limit; }
  std::string Pick(const std::vector<std::string>& from) {
    return from[Below(static_cast<std::uint32_t>(from.size()))];
  }
  std::string Word() {
    static const std::vector<std::string> kWords = {
        "a",   "name", "|a\\|b|", "|-->|", "|a b|",  "|\n} |", "|{|", "|(|",  "|^a|", "3", "-2.5",
        "|3|", "<<x",  "|<x>|",   "+x",    "|sp {|", "|\\\\|", "|#|", "|\"|", "nil",  "-", "|- |"};
    const std::string word = Pick(kWords);
    // What the reader takes for signs is left to bars.
    return word == "<<x" || word == "+x" || word == "-" ? "|" + word + "|" : word;
  }
  std::string Bound() {
    const std::string variable = "<v" + std::to_string(Below(9)) + ">";
    bound_.push_back(variable);
    return variable;
  }
  std::string Value() {
    switch (Below(7)) {
      case 0:
        return "";
      case 1:
        return " << " + Word() + " " + Word() + " >>";
      case 2:
        return " { " + Bound() + " <> " + Word() + " }";
      case 3:
        return " > " + std::to_string(Below(9));
      case 4:
        return " " + Word();
      default:
        return " " + Bound();
    }
  }
  std::string Attribute() {
    static const std::vector<std::string> kAttributes = {
        "a", "b.c", "operator", "|x y|", "|a\\|b|", "io.input-link", "<way>", "{ << a b >> <way> }", "<< a b >>"};
    std::string attribute = Pick(kAttributes);
    if (const std::size_t way = attribute.find("way"); way != std::string::npos)
      attribute.insert(way + 3, std::to_string(ways_++));
    return attribute;
  }
  std::string Attributes() {
    std::string text;
    for (std::uint32_t i = 1 + Below(3); i > 0; --i) {
      const std::string attribute = Attribute();
      text += std::string(Below(5) == 0 ? " -^" : " ^") + attribute;
      text += attribute == "operator" && Below(2) == 0 ? " " + Bound() + " +" : Value();
    }
    return text;
  }
  std::string Clause() { return std::string(Below(6) == 0 ? "-(" : "(") + Pick(bound_) + Attributes() + ")"; }
  std::string Call() { return "(+ " + std::to_string(Below(5)) + " (* 2 " + std::to_string(Below(5)) + "))"; }
  std::string Made() {
    static const std::vector<std::string> kAttributes = {"made", "b.c", "|x y|"};
    const std::string value = Below(3) == 0 ? Call() : Below(3) == 0 ? "<new" + std::to_string(Below(3)) + ">" : Word();
    return " ^" + Pick(kAttributes) + " " + value + (Below(6) == 0 ? " -" : "");
  }

  std::mt19937 random_;
  std::vector<std::string> bound_;
  int ways_ = 0;
};

// What a rule says, written down by walking through it once more, in another way than the code under test does.

std::string Text(const SymbolTable& symbols, const Test& test) {
  switch (test.kind) {
    case TestKind::kBlank:
    case TestKind::kState:
    case TestKind::kImpasse:
      return "";
    case TestKind::kDisjunction: {
      std::string text = "<<";
      for (const kernel::Symbol word : test.disjuncts()) text += " " + ToString(symbols, word);
      return text + " >>";
    }
    case TestKind::kConjunction: {
      std::vector<std::string> parts;
      for (const Test& part : test.parts())
        if (std::string one = Text(symbols, part); !one.empty()) parts.push_back(one);
      // The only test without a sign comes first.
      const auto equal =
          std::ranges::find_if(test.parts(), [](const Test& one) { return one.kind == TestKind::kEqual; });
      if (equal != test.parts().end()) {
        std::erase(parts, Text(symbols, *equal));
        parts.insert(parts.begin(), Text(symbols, *equal));
      }
      if (parts.size() == 1) return parts[0];
      std::string text = "{";
      for (const std::string& one : parts) text += " " + one;
      return text + " }";
    }
    default:
      return std::string(kernel::ComparisonSign(test.kind)) + ToString(symbols, test.referent());
  }
}

bool HasState(const Test& test) {
  return test.kind == TestKind::kState ||
         std::ranges::any_of(test.parts(), [](const Test& part) { return HasState(part); });
}

struct Expected {
  std::vector<mind::RuleConditionFact> conditions;
  std::set<std::string> states;
};
void Walk(const SymbolTable& symbols, std::span<const Condition> conditions, int outer, int& groups,
          Expected& expected) {
  for (const Condition& condition : conditions) {
    if (condition.kind == ConditionKind::kConjunctiveNegation) {
      Walk(symbols, condition.conditions(), outer != 0 ? outer : ++groups, groups, expected);
      continue;
    }
    const std::string id = Text(symbols, condition.id);
    if (HasState(condition.id)) expected.states.insert(id);
    expected.conditions.push_back({id, Text(symbols, condition.attribute), Text(symbols, condition.value),
                                   condition.tests_acceptable, condition.kind == ConditionKind::kNegative || outer != 0,
                                   false, outer});
  }
}

std::string Text(const SymbolTable& symbols, const RhsValue& value) {
  if (value.kind != RhsValueKind::kFunction) return ToString(symbols, value.symbol());
  std::string name(kernel::BuiltinFunctions()[value.function_index()].name);
  std::string text = "(" + name;
  for (const RhsValue& argument : value.arguments()) text += " " + Text(symbols, argument);
  return text + ")";
}

void ExpectWhatTheRuleSays(const SymbolTable& symbols, const Production& rule, const mind::RuleFacts& facts) {
  Expected expected;
  int groups = 0;
  Walk(symbols, rule.conditions, 0, groups, expected);
  for (mind::RuleConditionFact& one : expected.conditions) one.on_state = expected.states.contains(one.id);
  EXPECT_EQ(facts.name, rule.name);
  EXPECT_TRUE(facts.conditions == expected.conditions);
  std::vector<mind::RuleActionFact> actions;
  for (const kernel::Action& action : rule.actions) {
    if (action.is_function_call) continue;
    actions.push_back({Text(symbols, action.id), Text(symbols, action.attribute), Text(symbols, action.value),
                       std::string(kernel::PreferenceSign(action.preference)),
                       action.HasReferent() ? Text(symbols, action.referent) : ""});
  }
  EXPECT_TRUE(facts.actions == actions);
  EXPECT_EQ(facts.acts, !rule.actions.empty());
  using Support = mind::RuleFacts::Support;
  EXPECT_EQ(facts.support, rule.declared_support == kernel::DeclaredSupport::kOSupport   ? Support::kOSupport
                           : rule.declared_support == kernel::DeclaredSupport::kISupport ? Support::kISupport
                                                                                         : Support::kByConditions);
}

/// Conditions in an order of their own. When a rule is read again, a test of a variable that is there several times may
/// move to another condition of it: attributes and signs stay.
std::vector<std::string> Sorted(const std::vector<mind::RuleConditionFact>& facts) {
  std::vector<std::string> texts;
  for (const mind::RuleConditionFact& fact : facts)
    texts.push_back((fact.attribute.starts_with('{') ? "{}" : fact.attribute) + (fact.acceptable ? " +" : "") +
                    (fact.negated ? " not" : "") + (fact.on_state ? " state" : ""));
  std::ranges::sort(texts);
  return texts;
}
std::vector<std::string> Sorted(const std::vector<mind::RuleActionFact>& facts) {
  std::vector<std::string> texts;
  for (const mind::RuleActionFact& fact : facts)
    texts.push_back(fact.id + " ^" + fact.attribute + " " + fact.value + " " + fact.sign + " " + fact.referent);
  std::ranges::sort(texts);
  return texts;
}

TEST(RuleReading, Of10000RulesEveryFactIsWhatTheKernelsRuleSays) {
  constexpr int kRules = 10'000;
  RuleWriter writer(48);
  int read = 0, tried = 0;
  for (; read < kRules && tried < 3 * kRules; ++tried) {
    SymbolTable symbols;
    const std::string text = writer.Next(tried);
    const ProductionPtr rule = ParseProduction(text, {}, symbols).production;
    if (rule == nullptr) continue;  // A removal without a value, say.
    ++read;
    const mind::RuleFacts facts = FactsOf(*rule, symbols);
    ExpectWhatTheRuleSays(symbols, *rule, facts);
    // The same from what a kernel prints.
    const std::vector<mind::RuleFacts> again = ReadPrintedRules("\n" + PrintProduction(symbols, *rule) + "\n");
    ASSERT_EQ(again.size(), 1u) << text << "\n" << PrintProduction(symbols, *rule);
    EXPECT_EQ(Sorted(again[0].conditions), Sorted(facts.conditions)) << text;
    EXPECT_EQ(Sorted(again[0].actions), Sorted(facts.actions)) << text;
    EXPECT_EQ(again[0].support, facts.support) << text;
    EXPECT_EQ(again[0].calls.size(), facts.calls.size()) << text;
    if (HasFailure()) FAIL() << text << "\n" << PrintProduction(symbols, *rule);
  }
  EXPECT_EQ(read, kRules) << "of " << tried;
}

TEST(RuleReading, WordsThatLookLikeSyntaxAreWords) {
  const std::vector<mind::RuleFacts> rules = ReadPrintedRules(
      "sp {a\n    (state <s> ^x |a\\|b|)\n    -->\n    (<s> ^made |-->|)\n}\n\n"
      "sp {b\n    (state <s> ^x |\n}|)\n    -->\n    (write |sp {c|)\n    (<s> ^n (+ 1 (* 2 3)))\n}\n");
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_EQ(rules[0].conditions[0].value, "|a\\|b|");
  EXPECT_EQ(rules[0].actions[0].value, "|-->|");
  EXPECT_EQ(rules[1].name, "b");
  ASSERT_EQ(rules[1].calls.size(), 3u);
  EXPECT_EQ(rules[1].calls[0].function, "write");
  EXPECT_EQ(rules[1].calls[1].arguments, (std::vector<std::string>{"1", "(* 2 3)"}));
}

TEST(RuleReading, ConditionsAreReadAlone) {
  const std::vector<mind::RuleConditionFact> found = ReadPrintedConditions("(<in> -^agent { <a> <> |a b| })");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, "<in>");
  EXPECT_EQ(found[0].attribute, "agent");
  EXPECT_EQ(found[0].value, "{ <a> <> |a b| }");
  EXPECT_TRUE(found[0].negated);
  EXPECT_EQ(ReadPrintedConditions("(<o> ^name go) (<s> ^operator <o> +)").size(), 2u);
  // What they compare with is bound by conditions that are not there.
  const std::vector<mind::RuleConditionFact> compared = ReadPrintedConditions("(<me> ^reserve { <r> > <h*1> })");
  ASSERT_EQ(compared.size(), 1u);
  EXPECT_EQ(compared[0].value, "{ <r> > <h*1> }");
  EXPECT_TRUE(ReadPrintedConditions("no condition").empty());
}

}  // namespace
}  // namespace soarbox::rule_reading
