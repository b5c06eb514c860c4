// SPDX-License-Identifier: BSD-2-Clause
// One row per situation: the facts and the resulting text.
#include "wording/decision_text.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace soarbox::wording {
namespace {

using mind::Decision;
using mind::Decisive;
using mind::Stage;
using enum mind::PreferenceKind;

constexpr std::uint32_t kA = 0, kB = 1, kC = 2;

/// Facts built by hand. Operators are a (O1), b (O2) and c (O3); the rule of the n-th preference is "rn".
class Facts {
 public:
  explicit Facts(std::uint32_t operators = 3) {
    constexpr const char* kNames[] = {"a", "b", "c"};
    for (std::uint32_t i = 0; i < operators; ++i) {
      decision.operators.push_back({"O" + std::to_string(i + 1), kNames[i]});
      Prefer(kAcceptable, i);
    }
  }
  Facts& Prefer(mind::PreferenceKind kind, std::uint32_t op, std::uint32_t referent = Decision::kNoOperator,
                double number = 0) {
    decision.preferences.push_back({kind, op, referent, number, "r" + std::to_string(decision.preferences.size())});
    return *this;
  }
  Facts& Drop(std::uint32_t op, Stage stage, std::initializer_list<std::uint32_t> by,
              Decisive decisive = Decisive::kYes) {
    const auto first = static_cast<std::uint32_t>(decision.by.size());
    decision.by.insert(decision.by.end(), by);
    decision.drops.push_back({op, stage, decisive, first, static_cast<std::uint32_t>(by.size())});
    return *this;
  }
  Facts& Left(std::uint32_t op, double probability = 1, double value = 0) {
    decision.left.push_back({op, value, probability});
    return *this;
  }
  Facts& Select(std::uint32_t op) {
    decision.selected = op;
    return *this;
  }
  Facts& Impasse(mind::Impasse impasse) {
    decision.impasse = impasse;
    return *this;
  }
  Decision decision;
};

TEST(DecisionText, ASoleCandidate) {
  const Facts facts = Facts(1).Left(kA).Select(kA);
  EXPECT_EQ(WhySelected(facts.decision), "the only operator proposed, by rule r0");
  EXPECT_EQ(WhyDecided(facts.decision), "the only operator proposed, by rule r0");
}

TEST(DecisionText, EachStageInTheWordsOfTheOneThatWon) {
  const auto won = [](Facts facts) { return WhySelected(facts.Left(kA).Select(kA).decision); };
  EXPECT_EQ(won(Facts(2).Prefer(kBetter, kA, kB).Drop(kB, Stage::kDominated, {2})),
            "rule r2 makes it better than b (O2)");
  EXPECT_EQ(won(Facts(2).Prefer(kWorse, kB, kA).Drop(kB, Stage::kDominated, {2})),
            "rule r2 makes it better than b (O2)");
  EXPECT_EQ(won(Facts(2).Prefer(kReject, kB).Drop(kB, Stage::kReject, {2})), "rule r2 rejects b (O2)");
  EXPECT_EQ(won(Facts(2).Prefer(kProhibit, kB).Drop(kB, Stage::kProhibit, {2})), "rule r2 prohibits b (O2)");
  EXPECT_EQ(won(Facts(3).Prefer(kBest, kA).Drop(kC, Stage::kBest, {3}).Drop(kB, Stage::kBest, {3})),
            "rule r3 makes it best");
  EXPECT_EQ(won(Facts(2).Prefer(kWorst, kB).Drop(kB, Stage::kWorst, {2})), "rule r2 makes b (O2) worst");
  EXPECT_EQ(won(Facts(2).Prefer(kRequire, kA).Drop(kB, Stage::kRequire, {2})), "rule r2 requires it");
}

TEST(DecisionText, EachStageInTheWordsOfTheOneThatLost) {
  const auto lost = [](Facts facts) { return WhyDropped(facts.Left(kA).Select(kA).decision, kB); };
  EXPECT_EQ(lost(Facts(2).Prefer(kBetter, kA, kB).Drop(kB, Stage::kDominated, {2})),
            "rule r2 makes it worse than a (O1)");
  EXPECT_EQ(lost(Facts(2).Prefer(kReject, kB).Drop(kB, Stage::kReject, {2})), "rule r2 rejects it");
  EXPECT_EQ(lost(Facts(2).Prefer(kBest, kA).Drop(kB, Stage::kBest, {2})), "rule r2 makes a (O1) best");
  EXPECT_EQ(lost(Facts(2).Prefer(kWorst, kB).Drop(kB, Stage::kWorst, {2})), "rule r2 makes it worst");
  EXPECT_EQ(lost(Facts(2)), "");
}

TEST(DecisionText, TwoThatDominateEachOther) {
  const Facts facts = Facts()
                          .Prefer(kBetter, kA, kB)
                          .Prefer(kBetter, kB, kA)
                          .Drop(kB, Stage::kDominated, {3})
                          .Drop(kA, Stage::kDominated, {4})
                          .Left(kC)
                          .Select(kC);
  EXPECT_EQ(WhySelected(facts.decision),
            "b (O2) and a (O1) are each better than the other (rules r3 and r4), so both were dropped");
  EXPECT_EQ(WhyDropped(facts.decision, kA), "rule r4 makes it worse than b (O2)");
  EXPECT_EQ(
      WhyDecided(facts.decision),
      "b (O2) and a (O1) are each better than the other (rules r3 and r4), so both were dropped; proposed by rule "
      "r2");
}

TEST(DecisionText, WhatWouldHaveLostAnywayIsNoReason) {
  const Facts facts = Facts(2)
                          .Prefer(kReject, kB)
                          .Prefer(kBetter, kA, kB)
                          .Drop(kB, Stage::kReject, {2}, Decisive::kNo)
                          .Left(kA)
                          .Select(kA);
  EXPECT_EQ(WhySelected(facts.decision), "rule r2 rejects b (O2) (without that b (O2) would still lose)");
  EXPECT_EQ(WhyDropped(facts.decision, kB), "rule r2 rejects it; without that it would still lose");
}

TEST(DecisionText, SeveralThatEachSuffice) {
  const Facts facts = Facts(2)
                          .Prefer(kReject, kB)
                          .Prefer(kReject, kB)
                          .Prefer(kProhibit, kB)
                          .Drop(kB, Stage::kProhibit, {2, 3, 4})
                          .Left(kA)
                          .Select(kA);
  EXPECT_EQ(WhyDropped(facts.decision, kB), "rule r2 rejects it, rule r3 rejects it and rule r4 prohibits it");
  EXPECT_EQ(WhySelected(facts.decision), "rule r4 prohibits b (O2) (without that b (O2) would still lose)");
}

TEST(DecisionText, AReasonWithoutWhichTheSameWouldBeSelectedSaysSo) {
  EXPECT_EQ(WhySelected(Facts(1).Prefer(kRequire, kA).Left(kA).Select(kA).decision),
            "the only operator proposed, by rule r0; rule r1 requires it");
  EXPECT_EQ(WhySelected(Facts(2)
                            .Prefer(kRequire, kA)
                            .Prefer(kBetter, kA, kB)
                            .Drop(kB, Stage::kRequire, {2}, Decisive::kNo)
                            .Left(kA)
                            .Select(kA)
                            .decision),
            "rule r2 requires it (without that b (O2) would still lose)");
  EXPECT_EQ(WhyNothing(Facts(1).Prefer(kReject, kA).Prefer(kReject, kA).Drop(kA, Stage::kReject, {1, 2}).decision),
            "the only operator proposed was dropped: rule r1 rejects a (O1) (without that a (O1) would still lose)");
}

TEST(DecisionText, RulesThatAreNoLongerThereAreNotNamed) {
  Facts facts = Facts(2).Prefer(kReject, kB).Drop(kB, Stage::kReject, {2}).Left(kA).Select(kA);
  facts.decision.preferences[2].rule = "[excised]";
  EXPECT_EQ(WhySelected(facts.decision), "a rule that has been excised rejects b (O2)");
  facts.decision.preferences[2].rule = "|Memory System Recall|";
  EXPECT_EQ(WhySelected(facts.decision), "the architecture rejects b (O2)");
}

TEST(DecisionText, AChoiceByChance) {
  Facts facts = Facts(2).Prefer(kNumeric, kA, Decision::kNoOperator, 3).Left(kB, 0.25, 1).Left(kA, 0.75, 3).Select(kA);
  EXPECT_EQ(WhySelected(facts.decision),
            "chosen by chance, with a probability of 75 % (its value is 3), among 2 indifferent operators");
  facts.decision.policy = mind::Policy::kFirst;
  EXPECT_EQ(WhySelected(facts.decision), "the first of 2 indifferent operators");
  facts.decision.policy = mind::Policy::kLast;
  EXPECT_EQ(WhySelected(facts.decision), "the last of 2 indifferent operators");
  facts.decision.is_forced = true;
  EXPECT_EQ(WhySelected(facts.decision), "the command decide select had selected it");
}

TEST(DecisionText, ManyReasonsAreCounted) {
  Facts facts(1);
  facts.Left(kA).Select(kA);
  for (std::uint32_t i = 1; i <= 6; ++i) {
    facts.decision.operators.push_back({"O" + std::to_string(i + 1), ""});
    facts.Prefer(kReject, i).Drop(i, Stage::kReject, {i});
  }
  EXPECT_EQ(WhySelected(facts.decision),
            "rule r1 rejects O2; rule r2 rejects O3; rule r3 rejects O4; rule r4 rejects O5; 2 more were dropped");
}

TEST(DecisionText, EachImpasse) {
  EXPECT_EQ(WhyNothing(Facts().Left(kC).Left(kB).Left(kA).Impasse(mind::Impasse::kTie).decision),
            "no preference decides among a (O1), b (O2) and c (O3)");
  EXPECT_EQ(
      WhyNothing(Facts(2)
                     .Prefer(kBetter, kA, kB)
                     .Prefer(kBetter, kB, kA)
                     .Drop(kB, Stage::kDominated, {2})
                     .Drop(kA, Stage::kDominated, {3})
                     .Left(kB)
                     .Left(kA)
                     .Impasse(mind::Impasse::kConflict)
                     .decision),
      "each of a (O1) and b (O2) is worse than another one; rule r2 makes a (O1) better than b (O2); rule r3 makes "
      "b (O2) better than a (O1)");
  EXPECT_EQ(WhyNothing(Facts(2)
                           .Prefer(kRequire, kA)
                           .Prefer(kRequire, kB)
                           .Left(kB)
                           .Left(kA)
                           .Impasse(mind::Impasse::kConstraintFailure)
                           .decision),
            "rule r2 requires a (O1); rule r3 requires b (O2)");
  EXPECT_EQ(WhyNothing(Facts(1).Prefer(kProhibit, kA).Drop(kA, Stage::kProhibit, {1}).decision),
            "the only operator proposed was dropped: rule r1 prohibits a (O1)");
  EXPECT_EQ(WhyNothing(Decision()), "");
  EXPECT_EQ(WhyDecided(Decision()), "");
}

TEST(DecisionText, AConflictWithoutReasonsIsToldAsOne) {
  Decision decision;
  decision.impasse = mind::Impasse::kConflict;
  decision.operators = {{"O1", "seek"}, {"O2", "turn"}};
  decision.drops = {{0, mind::Stage::kDominated, mind::Decisive::kUnknown, 0, 0}};
  decision.left = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_NE(WhyDecided(decision).find("turn (O2)"), std::string::npos) << WhyDecided(decision);
}

}  // namespace
}  // namespace soarbox::wording
