// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/preference_semantics.h"

#include <gtest/gtest.h>

namespace soarbox::kernel {
namespace {

constexpr Symbol O(std::uint32_t n) {
  return {Symbol::Tag::kIdentifier, n};
}
using enum PreferenceType;

class PreferenceSemanticsTest : public testing::Test {
 protected:
  void Add(PreferenceType type, std::uint32_t value, std::uint32_t referent = 0) {
    list_.push_back({type, O(value), referent == 0 ? Symbol{} : O(referent), 0, PreferenceId{}});
  }
  void AddNumber(std::uint32_t value, double number) {
    list_.push_back({kNumericIndifferent, O(value), {}, number, PreferenceId{}});
  }
  void Propose(std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t value : values) Add(kAcceptable, value);
  }
  /// The impasse and the numbers of the candidates, in order.
  std::pair<ImpasseType, std::vector<std::uint32_t>> Decide(Symbol forced = {}) {
    const auto outcome = semantics_.Decide(list_, forced);
    std::vector<std::uint32_t> numbers;
    for (const Candidate& c : outcome.candidates) numbers.push_back(c.value.index());
    return {outcome.impasse, numbers};
  }
  static std::pair<ImpasseType, std::vector<std::uint32_t>> Is(ImpasseType impasse,
                                                               std::vector<std::uint32_t> numbers) {
    return {impasse, std::move(numbers)};
  }

  std::vector<SlotPreference> list_;
  PreferenceSemantics semantics_;
};

TEST_F(PreferenceSemanticsTest, NothingProposedIsNoCandidateAndNoImpasseOfItsOwn) {
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {}));
}

TEST_F(PreferenceSemanticsTest, OneCandidateWinsHoweverOftenItIsProposed) {
  Propose({1, 1});
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {1}));
}

TEST_F(PreferenceSemanticsTest, UnrelatedCandidatesTieNewestFirst) {
  Propose({1, 2, 3});
  EXPECT_EQ(Decide(), Is(ImpasseType::kTie, {3, 2, 1}));
}

TEST_F(PreferenceSemanticsTest, RejectAndProhibitRemove) {
  Propose({1, 2, 3});
  Add(kReject, 1);
  Add(kProhibit, 3);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {2}));
}

TEST_F(PreferenceSemanticsTest, RequireWinsOverABestOneAndAReject) {
  Propose({1, 2});
  Add(kBest, 1);
  Add(kRequire, 2);
  Add(kReject, 2);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {2}));
}

TEST_F(PreferenceSemanticsTest, TwoRequiredOrARequiredProhibitedOneFailTheConstraint) {
  Add(kRequire, 1);
  Add(kProhibit, 1);
  EXPECT_EQ(Decide(), Is(ImpasseType::kConstraintFailure, {1}));
  list_.clear();
  Add(kRequire, 1);
  Add(kRequire, 2);
  EXPECT_EQ(Decide(), Is(ImpasseType::kConstraintFailure, {2, 1}));
}

TEST_F(PreferenceSemanticsTest, BetterAndWorseInARowLeaveTheTop) {
  Propose({1, 2, 3});
  Add(kBetter, 1, 2);
  Add(kWorse, 3, 2);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {1}));
}

TEST_F(PreferenceSemanticsTest, ACycleConflictsUnlessAnUnrelatedCandidateExists) {
  Propose({1, 2});
  Add(kBetter, 1, 2);
  Add(kBetter, 2, 1);
  EXPECT_EQ(Decide(), Is(ImpasseType::kConflict, {2, 1}));
  Propose({3});
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {3}));
}

TEST_F(PreferenceSemanticsTest, ARejectedCandidateDominatesNobody) {
  Propose({1, 2});
  Add(kBetter, 1, 2);
  Add(kReject, 1);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {2}));
}

TEST_F(PreferenceSemanticsTest, BestKeepsAndWorstDropsUnlessAllAreWorst) {
  Propose({1, 2, 3});
  Add(kBest, 1);
  Add(kBest, 3);
  Add(kWorst, 3);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {1}));
  Add(kWorst, 1);
  EXPECT_EQ(Decide(), Is(ImpasseType::kTie, {3, 1}));
}

TEST_F(PreferenceSemanticsTest, IndifferenceMustCoverEveryPair) {
  Propose({1, 2, 3});
  Add(kUnaryIndifferent, 1);
  AddNumber(2, 0.5);
  EXPECT_EQ(Decide().first, ImpasseType::kTie);
  Add(kBinaryIndifferent, 3, 1);
  EXPECT_EQ(Decide().first, ImpasseType::kTie);
  Add(kBinaryIndifferent, 2, 3);
  EXPECT_EQ(Decide(), Is(ImpasseType::kNone, {3, 2, 1}));
}

TEST_F(PreferenceSemanticsTest, NumbersAreCollectedPerCandidate) {
  Propose({1, 2});
  AddNumber(1, 2);
  AddNumber(1, 4);
  Add(kUnaryIndifferent, 2);
  const auto outcome = semantics_.Decide(list_);
  EXPECT_EQ(outcome.impasse, ImpasseType::kNone);
  EXPECT_FALSE(outcome.candidates[0].is_numeric);
  EXPECT_EQ(outcome.candidates[1].number_sum, 6);
  EXPECT_EQ(outcome.candidates[1].number_count, 2u);
}

TEST_F(PreferenceSemanticsTest, ABinaryIndifferentPreferenceCountsAsANumberThatAddsNothing) {
  Propose({1, 2});
  AddNumber(1, 3);
  AddNumber(2, 1);
  Add(kBinaryIndifferent, 1, 2);
  const auto outcome = semantics_.Decide(list_);
  EXPECT_EQ(outcome.candidates[1].number_sum, 3);
  EXPECT_EQ(outcome.candidates[1].number_count, 2u);
  EXPECT_EQ(outcome.candidates[0].number_count, 1u);
}

TEST_F(PreferenceSemanticsTest, AForcedProposalWinsAtOnceAndAnUnproposedOneIsIgnored) {
  Propose({1, 2});
  EXPECT_EQ(Decide(O(1)), Is(ImpasseType::kNone, {1}));
  EXPECT_EQ(Decide(O(9)).first, ImpasseType::kTie);
}

}  // namespace
}  // namespace soarbox::kernel
