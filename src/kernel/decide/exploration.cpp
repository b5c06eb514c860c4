// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/exploration.h"

#include <algorithm>
#include <cmath>

namespace soarbox::kernel {
namespace {

double HighestValue(std::span<const Candidate> candidates, const ExplorationSettings& settings) {
  double highest = NumericValue(candidates.front(), settings);
  for (const Candidate& c : candidates.subspan(1)) highest = std::max(highest, NumericValue(c, settings));
  return highest;
}

std::size_t CountOf(std::span<const Candidate> candidates, const ExplorationSettings& settings, double value) {
  return static_cast<std::size_t>(std::count_if(
      candidates.begin(), candidates.end(), [&](const Candidate& c) { return NumericValue(c, settings) == value; }));
}

std::size_t ChooseUniformly(std::size_t count, RandomStream& random) {
  return random.Integer(static_cast<std::uint32_t>(count - 1));
}

/// The weight of a candidate under softmax and Boltzmann; candidates with a weight of 0 or less are never selected.
double Weight(const Candidate& candidate, const ExplorationSettings& settings, double highest) {
  const double value = NumericValue(candidate, settings);
  if (settings.policy == ExplorationPolicy::kSoftmax) return std::max(0.0, value);
  // Relative to the highest value, so that no exponential overflows.
  return std::exp((value - highest) / settings.temperature.value);
}

double TotalWeight(std::span<const Candidate> candidates, const ExplorationSettings& settings, double highest) {
  double total = 0;
  for (const Candidate& c : candidates) total += Weight(c, settings, highest);
  return total;
}

std::size_t ChooseByWeight(std::span<const Candidate> candidates, const ExplorationSettings& settings,
                           RandomStream& random) {
  const double highest = HighestValue(candidates, settings);
  const double total = TotalWeight(candidates, settings, highest);
  if (!(total > 0)) return ChooseUniformly(candidates.size(), random);
  const double drawn = random.Real(total);
  double sum = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double weight = Weight(candidates[i], settings, highest);
    if (weight <= 0) continue;
    sum += weight;
    last = i;
    if (drawn <= sum) return i;
  }
  return last;  // Rounding may leave the sum slightly below the drawn number.
}

std::size_t ChooseGreedily(std::span<const Candidate> candidates, const ExplorationSettings& settings,
                           RandomStream& random) {
  if (random.Real() < settings.epsilon.value) return ChooseUniformly(candidates.size(), random);
  const double highest = HighestValue(candidates, settings);
  const std::size_t ties = CountOf(candidates, settings, highest);
  std::size_t skip = ties > 1 ? ChooseUniformly(ties, random) : 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (NumericValue(candidates[i], settings) == highest && skip-- == 0) return i;
  }
  return 0;
}

}  // namespace

void ExplorationParameter::Reduce() {
  value = reduction == ReductionPolicy::kExponential ? value * exponential_rate : std::max(0.0, value - linear_rate);
}

bool ExplorationSettings::SetEpsilon(double value) {
  if (!(value >= 0 && value <= 1)) return false;
  epsilon.value = value;
  return true;
}

bool ExplorationSettings::SetTemperature(double value) {
  if (!(value > 0) || !std::isfinite(value)) return false;
  temperature.value = value;
  return true;
}

bool ExplorationSettings::SetRate(ExplorationParameter& parameter, ReductionPolicy policy, double rate) {
  const double most = policy == ReductionPolicy::kExponential ? 1 : HUGE_VAL;
  if (!(rate >= 0 && rate <= most)) return false;
  (policy == ReductionPolicy::kExponential ? parameter.exponential_rate : parameter.linear_rate) = rate;
  return true;
}

void ExplorationSettings::ReduceAutomatically() {
  if (!auto_reduce) return;
  epsilon.Reduce();
  temperature.Reduce();
}

double NumericValue(const Candidate& candidate, const ExplorationSettings& settings) {
  if (candidate.number_count == 0) return 0;
  return settings.average_numbers ? candidate.number_sum / candidate.number_count : candidate.number_sum;
}

std::size_t Choose(std::span<const Candidate> candidates, const ExplorationSettings& settings, RandomStream& random) {
  switch (settings.policy) {
    case ExplorationPolicy::kFirst:
      return 0;
    case ExplorationPolicy::kLast:
      return candidates.size() - 1;
    case ExplorationPolicy::kEpsilonGreedy:
      return ChooseGreedily(candidates, settings, random);
    case ExplorationPolicy::kSoftmax:
    case ExplorationPolicy::kBoltzmann:
      break;
  }
  return ChooseByWeight(candidates, settings, random);
}

std::vector<double> SelectionChances(std::span<const Candidate> candidates, const ExplorationSettings& settings) {
  std::vector<double> chances(candidates.size(), 0.0);
  if (candidates.empty()) return chances;
  const double equal = 1.0 / static_cast<double>(candidates.size());
  const double highest = HighestValue(candidates, settings);
  switch (settings.policy) {
    case ExplorationPolicy::kFirst:
      chances.front() = 1;
      break;
    case ExplorationPolicy::kLast:
      chances.back() = 1;
      break;
    case ExplorationPolicy::kEpsilonGreedy: {
      const double ties = static_cast<double>(CountOf(candidates, settings, highest));
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool is_top = NumericValue(candidates[i], settings) == highest;
        chances[i] = settings.epsilon.value * equal + (is_top ? (1 - settings.epsilon.value) / ties : 0);
      }
      break;
    }
    case ExplorationPolicy::kSoftmax:
    case ExplorationPolicy::kBoltzmann: {
      const double total = TotalWeight(candidates, settings, highest);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        chances[i] = total > 0 ? Weight(candidates[i], settings, highest) / total : equal;
      }
      break;
    }
  }
  return chances;
}

}  // namespace soarbox::kernel
