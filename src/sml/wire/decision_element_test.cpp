// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/decision_element.h"

#include <gtest/gtest.h>

#include <random>

#include "mind/decision_codec.h"

namespace soarbox::wire {
namespace {

using mind::Decision;

Decision RandomDecision(std::mt19937& random) {
  const auto below = [&](std::uint32_t limit) { return static_cast<std::uint32_t>(random() % limit); };
  Decision decision;
  decision.impasse = static_cast<mind::Impasse>(below(4));
  decision.policy = static_cast<mind::Policy>(below(5));
  decision.is_forced = below(8) == 0;
  decision.has_changed = below(8) == 0;
  const std::uint32_t operators = 1 + below(4);
  for (std::uint32_t i = 0; i < operators; ++i)
    decision.operators.push_back({"O" + std::to_string(i), below(2) == 0 ? "" : "|go ^fast < \"x\" & y|"});
  if (below(2) == 0) decision.selected = below(operators);
  for (std::uint32_t i = 1 + below(6); i > 0; --i) {
    Decision::Preference& p = decision.preferences.emplace_back();
    p.kind = static_cast<mind::PreferenceKind>(below(11));
    p.op = below(operators);
    const bool is_binary = p.kind == mind::PreferenceKind::kBetter || p.kind == mind::PreferenceKind::kWorse ||
                           p.kind == mind::PreferenceKind::kEqual;
    if (is_binary) p.referent = below(operators);
    if (p.kind == mind::PreferenceKind::kNumeric) p.number = below(1000) / 7.0 - 50;
    if (below(5) > 0) p.rule = "rule*" + std::to_string(i);
  }
  for (std::uint32_t op = 0; op < operators; ++op) {
    if (below(2) == 0) {
      decision.left.push_back({op, below(100) / 3.0, below(100) / 99.0});
      continue;
    }
    const auto first = static_cast<std::uint32_t>(decision.by.size());
    for (std::uint32_t i = below(3); i > 0; --i)
      decision.by.push_back(below(static_cast<std::uint32_t>(decision.preferences.size())));
    decision.drops.push_back({op, static_cast<mind::Stage>(below(7)), static_cast<mind::Decisive>(below(3)), first,
                              static_cast<std::uint32_t>(decision.by.size()) - first});
  }
  return decision;
}

mind::DecisionView ViewOf(const Decision& from) {
  mind::DecisionView to;
  to.impasse = from.impasse;
  to.selected = from.selected;
  to.is_forced = from.is_forced;
  to.has_changed = from.has_changed;
  to.policy = from.policy;
  for (const Decision::Operator& op : from.operators) to.operators.push_back({op.id, op.name});
  for (const Decision::Preference& p : from.preferences)
    to.preferences.push_back({p.kind, p.op, p.referent, p.number, p.rule});
  for (const Decision::Drop& drop : from.drops)
    to.drops.push_back({drop.op, drop.stage, drop.decisive, drop.first, drop.count});
  to.by = from.by;
  for (const Decision::Chance& chance : from.left) to.left.push_back({chance.op, chance.value, chance.probability});
  return to;
}

std::string Packed(const Decision& decision) {
  std::string bytes;
  mind::Pack(decision, bytes);
  return bytes;
}

TEST(Decision, CrossesEveryBorderAsItIs) {
  std::mt19937 random(3);
  for (int n = 0; n < 500; ++n) {
    const Decision decision = RandomDecision(random);
    const std::string bytes = Packed(decision);
    EXPECT_EQ(Packed(mind::Owned(ViewOf(decision))), bytes);
    const std::optional<Decision> unpacked = mind::Unpack(bytes);
    ASSERT_TRUE(unpacked);
    EXPECT_EQ(Packed(*unpacked), bytes);
    EXPECT_EQ(unpacked->operators.front().id, decision.operators.front().id);
    EXPECT_EQ(unpacked->preferences.back().rule, decision.preferences.back().rule);
    Element parent("result");
    AddDecision(parent, decision);
    const std::optional<Decision> read = ReadDecision(parent);
    ASSERT_TRUE(read);
    EXPECT_EQ(Packed(*read), bytes);
  }
}

TEST(Decision, BytesThatAreNoneAreRefused) {
  std::mt19937 random(5);
  for (int n = 0; n < 200; ++n) {
    std::string bytes = Packed(RandomDecision(random));
    EXPECT_FALSE(mind::Unpack(std::string_view(bytes).substr(0, random() % bytes.size())));
    EXPECT_FALSE(mind::Unpack(bytes + "x"));
    bytes[random() % bytes.size()] = static_cast<char>(random());
    if (const std::optional<Decision> read = mind::Unpack(bytes)) {
      for (const Decision::Drop& drop : read->drops) ASSERT_LE(drop.first + drop.count, read->by.size());
      for (const std::uint32_t place : read->by) ASSERT_LT(place, read->preferences.size());
    }
  }
  EXPECT_FALSE(mind::Unpack(""));
}

TEST(Decision, WhatWouldTakeFarMoreMemoryOrTimeThanItsBytesIsRefused) {
  Decision decision;
  decision.operators = {{"O1", std::string(1000, 'a')}, {"O2", "b"}};
  decision.preferences.resize(10, {mind::PreferenceKind::kBetter, 1, 0, 0, "r"});
  decision.by = {0, 1};
  decision.drops = {{0, mind::Stage::kDominated, mind::Decisive::kYes, 0, 2}};
  EXPECT_TRUE(mind::Unpack(Packed(decision)));
  decision.drops.push_back({1, mind::Stage::kDominated, mind::Decisive::kYes, 0, 2});
  EXPECT_FALSE(mind::Unpack(Packed(decision))) << "each has its own";
  decision.drops.back().stage = mind::Stage::kBest;
  EXPECT_TRUE(mind::Unpack(Packed(decision)));
  decision.drops.resize(40'000, decision.drops.back());
  EXPECT_FALSE(mind::Unpack(Packed(decision)));
  decision.drops.clear();
  decision.left.resize(20'000, {0, 0, 0});
  EXPECT_FALSE(mind::Unpack(Packed(decision))) << "one long name, again and again";
  decision.operators[0].name = "a";
  EXPECT_TRUE(mind::Unpack(Packed(decision)));
  decision.left.resize(300'000, {0, 0, 0});
  EXPECT_FALSE(mind::Unpack(Packed(decision)));
}

TEST(Decision, AnAnswerOfAnotherKernelIsNone) {
  Element parent("result");
  EXPECT_FALSE(ReadDecision(parent));
  parent.Add("decision");
  EXPECT_FALSE(ReadDecision(parent));
  for (const char* text : {"0", "0g", "00", "-1"}) {
    parent.children.front().text = text;
    EXPECT_FALSE(ReadDecision(parent)) << text;
  }
}

}  // namespace
}  // namespace soarbox::wire
