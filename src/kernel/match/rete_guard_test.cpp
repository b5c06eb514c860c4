// SPDX-License-Identifier: BSD-2-Clause
// Justifications with negated conditions: the matcher has nodes only for the negated conditions. Compared with rules of
// another type with the same conditions, which are matched condition by condition.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kernel/match/match_test_support.h"

namespace soarbox::kernel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class GuardFixture : public MatchFixture {
 public:
  explicit GuardFixture(ProductionType type) : type_(type) {
    SetGoal("S1", 1);
    SetGoal("S2", 2);
  }
  TestDraft Is(std::string_view word) { return Equal(Word(word)); }

  /// Adds a rule whose positive conditions are these elements. `number` is the number of its instantiation.
  Rete::Added AddLiteral(std::size_t number, const std::vector<WmeId>& grounds,
                         const std::vector<ConditionDraft>& negations) {
    RuleDraft draft;
    const std::string name = "literal" + std::to_string(number);
    draft.name = name;
    draft.type = type_;
    std::vector<ConditionDraft> conditions;
    for (const WmeId ground : grounds) {
      const Wme& wme = wmes[Index(ground)];
      conditions.push_back(Positive(Equal(wme.id), Equal(wme.attribute), Equal(wme.value)));
    }
    conditions.insert(conditions.end(), negations.begin(), negations.end());
    for (ConditionDraft& condition : conditions) draft.conditions.Add(&condition);
    ActionDraft action;  // It must be unique, so that no rule duplicates another.
    action.id.symbol = Word("S1");
    action.attribute.symbol = Word(name);
    action.value.symbol = Word("1");
    draft.actions.Add(&action);
    Rete::AddOptions options;
    options.refracted = grounds;
    options.instantiation = SomeInstantiation(number);
    return rete.AddProduction(Production::Make(draft), Goals(), options);
  }

  /// Takes all retractions. Returns the numbers of the retracted instantiations, by level.
  std::vector<std::size_t> Retract(std::size_t numbers) {
    std::vector<std::size_t> found;
    for (GoalLevel level = 0; level <= 2; ++level) {
      while (rete.matches().HasRetractions(level)) {
        const MatchId match = rete.matches().TakeRetraction(level);
        for (std::size_t n = 0; n < numbers; ++n) {
          if (rete.matches().InstantiationOf(match) == SomeInstantiation(n)) found.push_back(n);
        }
        rete.matches().Release(match);
      }
    }
    return found;
  }

 private:
  ProductionType type_;
};

class GuardTest : public testing::Test, public GuardFixture {
 protected:
  GuardTest() : GuardFixture(ProductionType::kJustification) {}
};

TEST_F(GuardTest, AMatchIsRetractedWhenANegatedConditionEndsAndComesBackIfThatIsTakenBack) {
  const WmeId ground = Add("S1", "x", "1");
  const Rete::Added added = AddLiteral(0, {ground}, {Negative(Is("S1"), Is("no"), Is("<v>"))});
  ASSERT_NE(added.refracted, MatchId::kNone);
  const WmeId no = Add("S1", "no", "1");
  EXPECT_TRUE(rete.matches().HasRetractions(1));
  Remove(no);
  EXPECT_FALSE(rete.matches().HasRetractions(1)) << "nothing has been retracted yet";
  Add("S1", "no", "2");
  EXPECT_THAT(Retract(1), ElementsAre(0u));
  EXPECT_EQ(rete.CheckInvariants(), "");
  rete.ExciseProduction(added.production);
  while (!live.empty()) Remove(live.back());
  EXPECT_EQ(rete.statistics().nodes, 1u) << "only the root is left";
  EXPECT_EQ(rete.statistics().tokens, 0u);
  EXPECT_EQ(rete.statistics().alpha_memories, 0u);
}

TEST_F(GuardTest, AMatchIsRetractedWhenOneOfItsElementsGoesAndNeverComesBack) {
  const WmeId ground = Add("S1", "x", "1");
  const WmeId other = Add("S2", "y", "1");
  const ConditionDraft inside = Negative(Is("<v>"), Is("good"), Is("yes"));
  const Rete::Added added =
      AddLiteral(0, {ground, other}, {Conjunction({Positive(Is("S1"), Is("no"), Is("<v>")), inside})});
  ASSERT_NE(added.refracted, MatchId::kNone);
  const WmeId good = Add("V1", "good", "yes");
  const WmeId no = Add("S1", "no", "V1");
  EXPECT_THAT(Retract(1), IsEmpty());
  Remove(ground);
  EXPECT_EQ(rete.CheckInvariants(), "");
  EXPECT_EQ(rete.statistics().tokens, 0u) << "elements do not reach its negated conditions any more";
  Remove(good);
  Remove(no);
  EXPECT_THAT(Retract(1), ElementsAre(0u));
  const WmeId again = Add("S1", "no", "V1");
  EXPECT_EQ(rete.statistics().tokens, 0u);
  Remove(again);
  Add("S1", "x", "1");
  EXPECT_FALSE(rete.matches().HasAssertions(2, false));
  EXPECT_EQ(rete.CheckInvariants(), "");
  rete.ExciseProduction(added.production);
  EXPECT_EQ(rete.CheckInvariants(), "");
}

TEST_F(GuardTest, ExcisingRetractsAMatch) {
  const WmeId ground = Add("S1", "x", "1");
  const Rete::Added added = AddLiteral(0, {ground}, {Negative(Is("S1"), Is("no"), Is("<v>"))});
  rete.ExciseProduction(added.production);
  EXPECT_THAT(Retract(1), ElementsAre(0u));
  Remove(ground);
  EXPECT_EQ(rete.statistics().tokens, 0u);
}

TEST_F(GuardTest, WhatDoesNotHoldWhenItIsAddedIsMatchedAsARule) {
  const WmeId ground = Add("S1", "x", "1");
  const WmeId no = Add("S1", "no", "1");
  EXPECT_EQ(AddLiteral(0, {ground}, {Negative(Is("S1"), Is("no"), Is("<v>"))}).refracted, MatchId::kNone);
  Remove(no);
  EXPECT_TRUE(rete.matches().HasAssertions(1, false));
  EXPECT_EQ(rete.CheckInvariants(), "");
}

/// Executes each step of the random test in both ways.
class BothWays {
 public:
  explicit BothWays(std::uint32_t seed) : random_(seed) {}

  void Step() {
    const std::uint32_t kind = Below(10);
    if (kind < 5 || guarded_.live.size() < 6) {
      const std::string id = Identifier(), attribute = Attribute(), value = Value();
      for (GuardFixture* way : {&guarded_, &rules_}) {
        if (!Has(*way, id, attribute, value)) way->Add(id, attribute, value);
      }
    } else if (kind < 8) {
      const std::uint32_t place = Below(static_cast<std::uint32_t>(guarded_.live.size()));
      for (GuardFixture* way : {&guarded_, &rules_}) way->Remove(way->live[place]);
    } else {
      AddLiteral();
    }
    if (Below(3) != 0) Compare();
  }
  void Compare() {
    const std::vector<std::size_t> guarded = guarded_.Retract(made_), rules = rules_.Retract(made_);
    EXPECT_EQ(std::multiset(guarded.begin(), guarded.end()), std::multiset(rules.begin(), rules.end()));
    for (const std::size_t number : guarded) {
      guarded_.rete.ExciseProduction(numbers_[number].first);
      rules_.rete.ExciseProduction(numbers_[number].second);
      ++retracted;
    }
    EXPECT_EQ(guarded_.rete.CheckInvariants(), "");
  }
  int held = 0, retracted = 0;

 private:
  std::uint32_t Below(std::uint32_t limit) { return random_() % limit; }
  std::string Identifier() { return std::vector<std::string>{"S1", "S2", "V1", "V2", "V3"}[Below(5)]; }
  std::string Attribute() { return std::vector<std::string>{"a", "b", "c"}[Below(3)]; }
  std::string Value() { return std::vector<std::string>{"V1", "V2", "V3", "1", "2"}[Below(5)]; }
  static bool Has(GuardFixture& way, const std::string& id, const std::string& attribute, const std::string& value) {
    for (const WmeId wme : way.live) {
      const Wme& element = way.wmes[Index(wme)];
      if (element.id == way.Word(id) && element.attribute == way.Word(attribute) && element.value == way.Word(value)) {
        return true;
      }
    }
    return false;
  }

  void AddLiteral() {
    std::set<std::uint32_t> places;
    while (places.size() < 1 + made_ % 3) places.insert(Below(static_cast<std::uint32_t>(guarded_.live.size())));
    struct Negated {
      std::string id, attribute, value, inner_attribute, inner_value;
      std::uint32_t kind;
    };
    std::vector<Negated> negated;
    for (std::uint32_t n = 0; n <= Below(2); ++n) {
      negated.push_back({Identifier(), Attribute(), Value(), Attribute(), Value(), Below(4)});
    }
    Rete::Added added[2];
    std::size_t way_number = 0;
    for (GuardFixture* way : {&guarded_, &rules_}) {
      std::vector<WmeId> grounds;
      for (const std::uint32_t place : places) grounds.push_back(way->live[place]);
      std::vector<ConditionDraft> negations;
      for (const Negated& n : negated) {
        const TestDraft id = way->Is(n.id), attribute = way->Is(n.attribute);
        const std::vector<ConditionDraft> path = {
            Positive(id, attribute, way->Is("<v>")),
            n.kind == 2 ? Positive(way->Is("<v>"), way->Is(n.inner_attribute), way->Is("<w>"))
                        : Negative(way->Is("<v>"), way->Is(n.inner_attribute), way->Is(n.inner_value))};
        negations.push_back(n.kind == 0   ? Negative(id, attribute, way->Is("<v>"))
                            : n.kind == 1 ? Negative(id, attribute, way->Is(n.value))
                                          : Conjunction(path));
      }
      added[way_number++] = way->AddLiteral(made_, grounds, negations);
    }
    EXPECT_EQ(added[0].refracted == MatchId::kNone, added[1].refracted == MatchId::kNone);
    if (added[0].refracted == MatchId::kNone) {
      guarded_.rete.ExciseProduction(added[0].production);
      rules_.rete.ExciseProduction(added[1].production);
      return;
    }
    numbers_.emplace_back(added[0].production, added[1].production);
    ++made_;
    ++held;
  }

  std::mt19937 random_;
  GuardFixture guarded_{ProductionType::kJustification}, rules_{ProductionType::kUser};
  std::vector<std::pair<ProductionId, ProductionId>> numbers_;
  std::size_t made_ = 0;
};

TEST(GuardedRules, HoldAsLongAsRulesOfTheSameConditionsDo) {
  int held = 0, retracted = 0;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    BothWays ways(seed);
    for (int step = 0; step < 120 && !testing::Test::HasFailure(); ++step) ways.Step();
    held += ways.held;
    retracted += ways.retracted;
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(held, 200);
  EXPECT_GT(retracted, 150);
}

}  // namespace
}  // namespace soarbox::kernel
