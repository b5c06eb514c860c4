// SPDX-License-Identifier: BSD-2-Clause
#include "cli/rule_crowds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/rules/parser.h"

namespace soarbox::cli {
namespace {

using kernel::ExpectedValues;
using kernel::ParseProduction;
using kernel::Production;
using kernel::ProductionPtr;
using kernel::SymbolTable;
using testing::HasSubstr;

class RuleCrowdsTest : public testing::Test {
 protected:
  ProductionPtr Read(const std::string& body) {
    const ProductionPtr rule = ParseProduction(body, {"tower.soar", 12, 5}, symbols_, expected_).production;
    EXPECT_NE(rule, nullptr) << body;
    return rule;
  }
  /// A rule that tests all disks of a tower. The disks are distinguished by their names, which are tested last.
  static std::string Tower(int disks) {
    std::string body = "done (state <s> ^holds", disk_tests, name_tests;
    for (int n = 1; n <= disks; ++n) {
      const std::string number = std::to_string(n);
      body += " <h" + number + ">";
      disk_tests += "(<h" + number + "> ^disk <d" + number + ">)";
      name_tests += "(<d" + number + "> ^name " + number + ")";
    }
    return body + ")" + disk_tests + name_tests + " --> (<s> ^done yes)";
  }
  SymbolTable symbols_;
  ExpectedValues expected_;
};

TEST_F(RuleCrowdsTest, ValuesThatAreToldApartTooLateAreToldOf) {
  EXPECT_FALSE(FindCrowd(*Read(Tower(7)))) << "each is told apart at once";
  expected_.Set(symbols_.String("disk"), 7);
  const ProductionPtr rule = Read(Tower(7));
  const Production* const rules[] = {rule.get()};
  const std::vector<Diagnostic> found = FindRuleCrowds(rules, 1, symbols_);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].severity, Severity::kWarning);
  EXPECT_EQ(found[0].file, "tower.soar");
  EXPECT_EQ(found[0].line, 12);
  EXPECT_EQ(
      found[0].message,
      "done tests ^holds 7 times before it distinguishes the values: with 7 values it holds 823543 partial matches");
  EXPECT_THAT(found[0].hint,
              HasSubstr("(state <s> ^holds <h7>) (<h7> ^disk <d7>) (<d7> ^name 7), then the next ^holds"));
  EXPECT_THAT(found[0].hint, HasSubstr("`multi-attributes holds 7`"));
  EXPECT_TRUE(FindRuleCrowds(rules, 0, symbols_).empty()) << "rules of before are told already";
}

TEST_F(RuleCrowdsTest, WhatTheAdviceSaysHelps) {
  expected_.Set(symbols_.String("disk"), 7);
  ASSERT_TRUE(FindCrowd(*Read(Tower(7))));
  expected_.Set(symbols_.String("holds"), 7);
  EXPECT_FALSE(FindCrowd(*Read(Tower(7))));
}

TEST_F(RuleCrowdsTest, FewConditionsAndValuesThatAreNeverToldApartAreNoCrowd) {
  EXPECT_FALSE(FindCrowd(*Read(Tower(5))));
  EXPECT_FALSE(FindCrowd(*Read("all (state <s> ^v <a> <b> <c> <d> <e> <f> <g> <h>) --> (<s> ^n <a>)")));
  EXPECT_FALSE(
      FindCrowd(*Read("own (state <s> ^a <a> ^b <b> ^c <c> ^d <d> ^e <e> ^f <f>) (<a> ^name 1) (<b> ^name 2) "
                      "(<c> ^name 3) (<d> ^name 4) (<e> ^name 5) (<f> ^name 6) --> (<s> ^n <a>)")))
      << "attributes of their own";
}

}  // namespace
}  // namespace soarbox::cli
