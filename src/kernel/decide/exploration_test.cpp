// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/exploration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soarbox::kernel {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// Candidates with one numeric preference each; NaN: without one.
std::vector<Candidate> Make(std::initializer_list<double> numbers) {
  std::vector<Candidate> candidates;
  std::uint32_t n = 1;
  for (const double number : numbers) {
    candidates.push_back({Symbol(Symbol::Tag::kIdentifier, n++), PreferenceId{}, true, number, 1});
  }
  return candidates;
}

TEST(Exploration, SoftmaxChancesIgnoreWhatIsNotPositive) {
  EXPECT_THAT(SelectionChances(Make({3, 1, -2}), {}), ElementsAre(0.75, 0.25, 0));
  EXPECT_THAT(SelectionChances(Make({0, -1}), {}), ElementsAre(0.5, 0.5));
}

TEST(Exploration, BoltzmannAndEpsilonGreedyChancesAreTheReferences) {
  ExplorationSettings settings;
  settings.policy = ExplorationPolicy::kBoltzmann;
  ASSERT_TRUE(settings.SetTemperature(2));
  EXPECT_THAT(SelectionChances(Make({3, 1, 0}), settings),
              ElementsAre(DoubleNear(0.6285, 1e-4), DoubleNear(0.2312, 1e-4), DoubleNear(0.1402, 1e-4)));
  settings.policy = ExplorationPolicy::kEpsilonGreedy;
  ASSERT_TRUE(settings.SetEpsilon(0.3));
  EXPECT_THAT(SelectionChances(Make({3, 1, 0}), settings),
              ElementsAre(DoubleNear(0.8, 1e-9), DoubleNear(0.1, 1e-9), DoubleNear(0.1, 1e-9)));
}

TEST(Exploration, ChoosesInTheProportionOfTheChances) {
  RandomStream random(1);
  const auto candidates = Make({3, 1, -2});
  int counts[3] = {};
  for (int i = 0; i < 4000; ++i) ++counts[Choose(candidates, {}, random)];
  EXPECT_NEAR(counts[0], 3000, 150);
  EXPECT_NEAR(counts[1], 1000, 150);
  EXPECT_EQ(counts[2], 0);
}

TEST(Exploration, WithoutEpsilonExactTiesAreStillRandom) {
  ExplorationSettings settings;
  settings.policy = ExplorationPolicy::kEpsilonGreedy;
  ASSERT_TRUE(settings.SetEpsilon(0));
  RandomStream random(1);
  const auto candidates = Make({2, 1, 2});
  int counts[3] = {};
  for (int i = 0; i < 1000; ++i) ++counts[Choose(candidates, settings, random)];
  EXPECT_NEAR(counts[0], 500, 80);
  EXPECT_EQ(counts[1], 0);
}

TEST(Exploration, FirstAndLastDrawNothing) {
  ExplorationSettings settings;
  RandomStream random(1), untouched(1);
  settings.policy = ExplorationPolicy::kFirst;
  EXPECT_EQ(Choose(Make({1, 2, 3}), settings, random), 0u);
  settings.policy = ExplorationPolicy::kLast;
  EXPECT_EQ(Choose(Make({1, 2, 3}), settings, random), 2u);
  EXPECT_EQ(random.Next32(), untouched.Next32());
}

TEST(Exploration, MeanOrSumOfSeveralNumbers) {
  Candidate candidate{Symbol(Symbol::Tag::kIdentifier, 1), PreferenceId{}, true, 6, 3};
  ExplorationSettings settings;
  EXPECT_EQ(NumericValue(candidate, settings), 6);
  settings.average_numbers = true;
  EXPECT_EQ(NumericValue(candidate, settings), 2);
}

TEST(Exploration, ParametersKeepTheirRangesAndShrink) {
  ExplorationSettings settings;
  EXPECT_FALSE(settings.SetEpsilon(1.5));
  EXPECT_FALSE(settings.SetTemperature(0));
  EXPECT_FALSE(ExplorationSettings::SetRate(settings.epsilon, ReductionPolicy::kExponential, 1.5));
  ASSERT_TRUE(ExplorationSettings::SetRate(settings.temperature, ReductionPolicy::kLinear, 20));
  settings.temperature.reduction = ReductionPolicy::kLinear;
  settings.ReduceAutomatically();
  EXPECT_EQ(settings.temperature.value, 25) << "auto-reduce is off";
  settings.auto_reduce = true;
  settings.ReduceAutomatically();
  settings.ReduceAutomatically();
  EXPECT_EQ(settings.temperature.value, 0);
  EXPECT_EQ(settings.epsilon.value, 0.1) << "the exponential rate is 1";
}

}  // namespace
}  // namespace soarbox::kernel
