// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soarbox::mission {

struct Interval {
  double low = 0, high = 0;
};

/// 95 % confidence interval of a rate, after Wilson: `good` of `all` runs. 0 to 1.
Interval WilsonInterval(std::size_t good, std::size_t all);

double Mean(std::span<const double> values);
double Median(std::span<const double> values);
/// Of a sample; 0 for fewer than two values.
double StandardDeviation(std::span<const double> values);
/// Student's t distribution with `freedom` degrees of freedom: the probability of a value below x (error about 1e-13),
/// and its inverse.
double StudentCdf(double x, std::size_t freedom);
double StudentQuantile(double probability, std::size_t freedom);
/// 95 % confidence interval of a mean after Student: unlike those from resampling it keeps its 5 % for few values.
Interval StudentInterval(std::span<const double> values);
/// The probability of a mean so far from 0, if the true one is 0 (Student's t test, two-sided; of differences of pairs
/// the paired one). 1 if nothing can be said: fewer than two values. Equal values other than 0 give 0.
double StudentTest(std::span<const double> differences);
/// Holm's correction: what each probability of a family of comparisons becomes, so that of all true equalities together
/// none is called a difference in 95 % of cases. In the order of the input.
std::vector<double> Holm(std::span<const double> probabilities);
/// Mean of the differences of pairs in units of their standard deviation (Cohen's d of pairs); 0 if there is none.
double PairedEffect(std::span<const double> differences);
/// Cliff's delta: how much likelier a value of b is above one of a than below it, -1 to 1.
double CliffsDelta(std::span<const double> a, std::span<const double> b);
/// The number of pairs that shows a difference of `effect` standard deviations in 80 % of cases (two-sided, 5 %). 0: no
/// number is enough.
std::size_t PairsFor(double effect);

/// The probability that pairs which differ would be so one-sided by chance (McNemar's exact test, two-sided).
double McNemar(std::size_t only_first, std::size_t only_second);

}  // namespace soarbox::mission
