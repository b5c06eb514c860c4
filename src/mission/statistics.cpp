// SPDX-License-Identifier: BSD-2-Clause
#include "mission/statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace soarbox::mission {
namespace {

constexpr double kZ95 = 1.959963984540054;

/// The probability that Student's t is between -t and t. For an integer number of degrees of freedom, it is a finite
/// sum of powers of the cosine of an angle (Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.3 and
/// 26.7.4).
double StudentWithin(double t, std::size_t freedom) {
  const auto degrees = static_cast<double>(freedom);
  const double angle = std::atan2(std::abs(t), std::sqrt(degrees));
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const bool is_odd = freedom % 2 == 1;
  double sum = 0, term = is_odd ? cosine : 1;
  for (double below = is_odd ? 2 : 1; below < degrees; below += 2) {
    sum += term;
    term *= cosine * cosine * below / (below + 1);
  }
  return is_odd ? (angle + sine * sum) * 2 / std::numbers::pi : sine * sum;
}

/// Smaller differences of two numbers are rounding errors.
double RoundingOf(double a, double b) {
  return 1e-9 * std::max({1e-3, std::abs(a), std::abs(b)});
}

}  // namespace

Interval WilsonInterval(std::size_t good, std::size_t all) {
  if (all == 0) return {0, 1};
  const auto n = static_cast<double>(all);
  const double rate = static_cast<double>(good) / n, z2 = kZ95 * kZ95;
  const double center = (rate + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ95 / (1 + z2 / n) * std::sqrt(rate * (1 - rate) / n + z2 / (4 * n * n));
  return {good == 0 ? 0 : std::max(0.0, center - half), good == all ? 1 : std::min(1.0, center + half)};
}

double Mean(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double Median(std::span<const double> values) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

double StandardDeviation(std::span<const double> values) {
  if (values.size() < 2) return 0;
  const double mean = Mean(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

double StudentCdf(double x, std::size_t freedom) {
  const double beyond = (1 - StudentWithin(x, freedom)) / 2;
  return x > 0 ? 1 - beyond : beyond;
}

double StudentQuantile(double probability, std::size_t freedom) {
  if (probability < 0.5) return -StudentQuantile(1 - probability, freedom);
  double low = 0, high = 1;
  while (StudentCdf(high, freedom) < probability && high < 1e12) high *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (StudentCdf(middle, freedom) < probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

Interval StudentInterval(std::span<const double> values) {
  const double mean = Mean(values);
  if (values.size() < 2) return {mean, mean};
  const auto n = static_cast<double>(values.size());
  const double half = StudentQuantile(0.975, values.size() - 1) * StandardDeviation(values) / std::sqrt(n);
  return {mean - half, mean + half};
}

double StudentTest(std::span<const double> differences) {
  if (differences.size() < 2) return 1;
  const auto n = static_cast<double>(differences.size());
  const double mean = std::abs(Mean(differences)), error = StandardDeviation(differences) / std::sqrt(n);
  if (error <= 1e-12 * mean) return mean > 0 ? 0 : 1;
  return std::min(1.0, 2 * StudentCdf(-mean / error, differences.size() - 1));
}

std::vector<double> Holm(std::span<const double> probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return probabilities[i]; });
  std::vector<double> corrected(probabilities.size());
  double most = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    most = std::max(most, static_cast<double>(order.size() - rank) * probabilities[order[rank]]);
    corrected[order[rank]] = std::min(1.0, most);
  }
  return corrected;
}

std::vector<double> PairedDifferences(std::span<const double> a, std::span<const double> b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = b[i] - a[i];
    differences.push_back(std::abs(difference) < RoundingOf(a[i], b[i]) ? 0 : difference);
  }
  return differences;
}

std::optional<double> PairedEffect(std::span<const double> a, std::span<const double> b) {
  const std::vector<double> differences = PairedDifferences(a, b);
  double rounding = 0;
  for (std::size_t i = 0; i < a.size(); ++i) rounding = std::max(rounding, RoundingOf(a[i], b[i]));
  const double mean = Mean(differences), deviation = StandardDeviation(differences);
  if (deviation > rounding) return mean / deviation;
  return std::abs(mean) > rounding ? std::nullopt : std::optional<double>(0);
}

double CliffsDelta(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return 0;
  std::vector<double> sorted(a.begin(), a.end());
  std::ranges::sort(sorted);
  double sum = 0;
  for (const double value : b) {
    const auto below = std::ranges::lower_bound(sorted, value) - sorted.begin();
    const auto above = sorted.end() - std::ranges::upper_bound(sorted, value);
    sum += static_cast<double>(below - above);
  }
  return sum / static_cast<double>(a.size()) / static_cast<double>(b.size());
}

std::size_t PairsFor(double effect) {
  const double size = std::abs(effect);
  if (size < 1e-4) return 0;
  constexpr double kZ80 = 0.841621233572914;
  // The last term corrects for the estimated standard deviation.
  const double pairs = (kZ95 + kZ80) * (kZ95 + kZ80) / (size * size) + kZ95 * kZ95 / 2;
  return static_cast<std::size_t>(std::ceil(pairs));
}

double McNemar(std::size_t only_first, std::size_t only_second) {
  const std::size_t n = only_first + only_second, few = std::min(only_first, only_second);
  if (n == 0) return 1;
  double sum = 0;
  for (std::size_t k = 0; k <= few; ++k) {
    sum += std::exp(std::lgamma(static_cast<double>(n) + 1) - std::lgamma(static_cast<double>(k) + 1) -
                    std::lgamma(static_cast<double>(n - k) + 1) - static_cast<double>(n) * std::log(2.0));
  }
  return std::min(1.0, 2 * sum);
}

}  // namespace soarbox::mission
