// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/origin_element.h"

#include <gtest/gtest.h>

namespace soarbox::wire {
namespace {

using mind::OriginElementFact;

mind::OriginFacts Example() {
  mind::OriginFacts facts;
  facts.noted = true;
  facts.timetag = 42;
  mind::OriginFact& command = facts.origins.emplace_back();
  command.rule = "apply*go";
  command.decision = 7;
  command.o_supported = true;
  command.level = 2;
  command.state = "S3";
  command.op = "O1";
  command.op_name = "go";
  command.op_origin = 1;
  command.left_out = 5;
  command.matched.push_back({{11, "S3", "x", "|a \"b\" <c>|", true, false}, OriginElementFact::Source::kInput});
  command.matched.push_back({{12, "S3", "y", "Y1", false, true}, OriginElementFact::Source::kRule, 2});
  mind::OriginFact& op = facts.origins.emplace_back();
  op.is_operator = true;
  op.op = "O1";
  op.proposals = {2};
  op.decided.emplace();
  op.decided->operators.push_back({"O1", "go"});
  facts.origins.emplace_back().rule = "propose*go";
  return facts;
}

TEST(OriginElement, ReadsWhatWasWritten) {
  Element parent("result");
  AddOrigins(parent, Example());
  const mind::OriginFacts read = ReadOrigins(parent);
  EXPECT_TRUE(read.noted);
  EXPECT_EQ(read.timetag, 42u);
  ASSERT_EQ(read.origins.size(), 3u);
  const mind::OriginFact& command = read.origins[0];
  EXPECT_EQ(command.rule, "apply*go");
  EXPECT_EQ(command.decision, 7u);
  EXPECT_TRUE(command.o_supported);
  EXPECT_FALSE(command.is_operator);
  EXPECT_EQ(command.level, 2);
  EXPECT_EQ(command.state + command.op + command.op_name, "S3O1go");
  EXPECT_EQ(command.op_origin, 1u);
  EXPECT_EQ(command.left_out, 5u);
  ASSERT_EQ(command.matched.size(), 2u);
  EXPECT_EQ(command.matched[0].element, Example().origins[0].matched[0].element);
  EXPECT_EQ(command.matched[0].source, OriginElementFact::Source::kInput);
  EXPECT_EQ(command.matched[0].origin, mind::kNoOrigin);
  EXPECT_EQ(command.matched[1].element, Example().origins[0].matched[1].element);
  EXPECT_EQ(command.matched[1].origin, 2u);
  EXPECT_TRUE(read.origins[1].is_operator);
  EXPECT_EQ(read.origins[1].proposals, std::vector<std::uint32_t>{2});
  EXPECT_TRUE(read.origins[1].decided.has_value());
  EXPECT_FALSE(read.origins[2].decided.has_value());
}

TEST(OriginElement, DropsPlacesThatAreOutOfBounds) {
  mind::OriginFacts facts = Example();
  facts.origins[0].op_origin = 3;
  facts.origins[0].matched[1].origin = 77;
  facts.origins[1].proposals = {2, 3};
  Element parent("result");
  AddOrigins(parent, facts);
  const mind::OriginFacts read = ReadOrigins(parent);
  EXPECT_EQ(read.origins[0].op_origin, mind::kNoOrigin);
  EXPECT_EQ(read.origins[0].matched[1].origin, mind::kNoOrigin);
  EXPECT_EQ(read.origins[1].proposals, std::vector<std::uint32_t>{2});
}

TEST(OriginElement, NothingIsNotedByAnAnswerWithoutOrigins) {
  EXPECT_FALSE(ReadOrigins(Element("result")).noted);
}

}  // namespace
}  // namespace soarbox::wire
