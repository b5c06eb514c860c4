// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "mission/check_sentences.h"
#include "mission/statistics.h"
#include "sweep/rows.h"
#include "sweep/tournament.h"

namespace soarbox::sweep {
namespace {

using mission::NumberText;

constexpr std::size_t kFewestPairs = 3;
constexpr std::size_t kFewSeeds = 10;
constexpr std::size_t kMostPairwise = 100;

/// The most important numbers, which are shown; the table contains all.
constexpr const char* kShown[] = {"distance", "commands", "failed_commands", "decisions", "firings",
                                  "rounds",   "hits",     "damage",          "alive",     "learned"};

std::string Percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100 * share)));
}

std::string Short(double number) {
  char text[32];
  // Prints large numbers without an exponent: 13430, not 1.343e+04.
  const bool is_large = std::abs(number) >= 1e4 && std::abs(number) < 1e9;
  std::snprintf(text, sizeof text, is_large ? "%.0f" : "%.4g", number);
  return text;
}

/// Formats a probability. Below 1e-12, its digits are rounding errors.
std::string Chance(double probability) {
  return probability < 1e-12 ? "below 1e-12" : Short(probability);
}

/// The values of a quantity by seed, for each variant.
struct Quantity {
  std::string name;
  std::vector<std::map<std::uint64_t, double>> by_variant;
};

std::vector<Quantity> Quantities(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Quantity> quantities;
  const std::size_t count = plan.variants.size();
  for (const Metric& metric : spec.metrics)
    quantities.push_back({metric.name, std::vector<std::map<std::uint64_t, double>>(count)});
  quantities.push_back({"seconds", std::vector<std::map<std::uint64_t, double>>(count)});
  for (const char* name : kShown) quantities.push_back({name, std::vector<std::map<std::uint64_t, double>>(count)});
  for (const Row& row : rows) {
    if (row.result.outcome != "ok") continue;
    for (std::size_t i = 0; i < spec.metrics.size() && i < row.metrics.size(); ++i)
      if (row.metrics[i]) quantities[i].by_variant[row.variant][row.seed] = *row.metrics[i];
    quantities[spec.metrics.size()].by_variant[row.variant][row.seed] = row.result.seconds;
    for (std::size_t i = spec.metrics.size() + 1; i < quantities.size(); ++i) {
      if (const std::optional<double> value = row.result.NumberOf(quantities[i].name))
        quantities[i].by_variant[row.variant][row.seed] = *value;
    }
  }
  return quantities;
}

/// Whether it has the same value in all runs.
bool IsConstant(const Quantity& quantity) {
  std::optional<double> first;
  for (const auto& values : quantity.by_variant) {
    for (const auto& [seed, value] : values) {
      if (first && *first != value) return false;
      first = value;
    }
  }
  return true;
}

std::vector<double> Values(const std::map<std::uint64_t, double>& by_seed) {
  std::vector<double> values;
  for (const auto& [seed, value] : by_seed) values.push_back(value);
  return values;
}

/// Whether two variants have equal numbers for a seed.
bool AreAlike(const std::vector<Quantity>& quantities, std::size_t a, std::size_t b, std::uint64_t seed) {
  return std::ranges::all_of(quantities, [&](const Quantity& quantity) {
    const auto one = quantity.by_variant[a].find(seed), other = quantity.by_variant[b].find(seed);
    const bool has_one = one != quantity.by_variant[a].end(), has_other = other != quantity.by_variant[b].end();
    return has_one == has_other && (!has_one || one->second == other->second);
  });
}

/// One comparison of a variant with the first one. All comparisons of a sweep are one family for Holm's correction.
struct Compared {
  std::string line;  ///< Without the result of the correction.
  double probability = 1, effect = 0;
  bool is_number = false;
  std::size_t pairs = 0;
};

std::optional<Compared> CompareNumbers(const Plan& plan, const Quantity& quantity, std::size_t a, std::size_t b) {
  std::vector<double> ones, others;
  for (const auto& [seed, value] : quantity.by_variant[b]) {
    const auto other = quantity.by_variant[a].find(seed);
    if (other == quantity.by_variant[a].end()) continue;
    ones.push_back(other->second);
    others.push_back(value);
  }
  const std::vector<double> differences = mission::PairedDifferences(ones, others);
  const auto more = std::ranges::count_if(differences, [](double d) { return d > 0; });
  if (differences.size() < kFewestPairs || std::ranges::all_of(differences, [](double d) { return d == 0; }))
    return std::nullopt;
  const mission::Interval interval = mission::StudentInterval(differences);
  const std::optional<double> effect = mission::PairedEffect(ones, others);
  Compared compared{{}, mission::StudentTest(differences), effect.value_or(0), true, differences.size()};
  const double mean = mission::Mean(differences);
  const bool is_less = mean < 0;
  compared.line = "  " + quantity.name + ": " + plan.variants[b].variant.name + " has " + Short(std::abs(mean)) +
                  (is_less ? " less than " : " more than ") + plan.variants[a].variant.name +
                  " (95 %: " + Short(is_less ? -interval.high : interval.low) + " to " +
                  Short(is_less ? -interval.low : interval.high) + "), more in " +
                  Percent(static_cast<double>(more) / static_cast<double>(differences.size())) + " % of " +
                  std::to_string(differences.size()) + " equal seeds; " +
                  (effect ? "d " + Short(*effect) : "no d, because all differences are equal") + ", Cliff's delta " +
                  Short(mission::CliffsDelta(ones, others));
  return compared;
}

using Good = std::map<std::uint64_t, bool>;

std::optional<Compared> CompareRates(const Plan& plan, const std::string& what, const Good& first, const Good& second,
                                     std::size_t variant) {
  std::size_t only_first = 0, only_second = 0, both = 0;
  for (const auto& [seed, good] : second) {
    const auto other = first.find(seed);
    if (other == first.end()) continue;
    ++both;
    only_first += other->second && !good ? 1 : 0;
    only_second += good && !other->second ? 1 : 0;
  }
  if (both == 0) return std::nullopt;
  Compared compared;
  compared.probability = mission::McNemar(only_first, only_second);
  compared.pairs = both;
  compared.line = "  " + what + ": " + std::to_string(only_second) + " seeds with " +
                  plan.variants[variant].variant.name + " only, " + std::to_string(only_first) + " with " +
                  plan.variants.front().variant.name + " only";
  return compared;
}

/// Whether each check was true, by variant and seed.
std::vector<std::vector<Good>> GoodOf(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  std::vector<std::vector<Good>> good(spec.mission.checks.size(), std::vector<Good>(plan.variants.size()));
  for (const Row& row : rows) {
    if (row.result.outcome != "ok") continue;
    for (std::size_t i = 0; i < good.size() && i < row.result.checks.size(); ++i)
      if (row.result.checks[i].verdict.state != mission::State::kUndecided)
        good[i][row.variant][row.seed] = row.result.IsTrue(i);
  }
  return good;
}

void TellCompared(std::ostringstream& out, const std::vector<Compared>& family) {
  std::vector<double> probabilities;
  for (const Compared& each : family) probabilities.push_back(each.probability);
  const std::vector<double> corrected = mission::Holm(probabilities);
  for (std::size_t i = 0; i < family.size(); ++i) {
    const Compared& each = family[i];
    out << each.line << "; by chance with probability " << Chance(each.probability);
    if (family.size() > 1) out << ", " << Chance(corrected[i]) << " after Holm";
    if (corrected[i] >= 0.05) {
      out << "; that may be chance";
      const std::size_t pairs = each.is_number ? mission::PairsFor(each.effect) : 0;
      if (pairs > each.pairs && pairs < 100'000) out << " (" << pairs << " seeds would show this d, if it is one)";
    }
    out << '\n';
  }
}

/// Prints the first errors that runs of a variant reported, and their number.
void TellErrors(std::ostringstream& out, const Plan& plan, const std::vector<Row>& rows) {
  for (std::size_t v = 0; v < plan.variants.size(); ++v) {
    std::size_t count = 0;
    const Row* first = nullptr;
    for (const Row& row : rows) {
      if (row.variant != v || !row.result.has_errors) continue;
      if (count++ == 0) first = &row;
    }
    if (first == nullptr) continue;
    out << plan.variants[v].variant.name << ": " << count << (count == 1 ? " run" : " runs")
        << " reported errors, and failed; seed " << first->seed << ":\n";
    for (const std::string& problem : first->result.problems) out << "  " << problem << '\n';
  }
}

/// Prints the numbers that are equal in all runs.
void TellConstants(std::ostringstream& out, const std::vector<Quantity>& constants) {
  if (constants.empty()) return;
  out << "the same in all runs:";
  const char* separator = " ";
  for (const Quantity& quantity : constants) {
    for (const auto& values : quantity.by_variant) {
      if (values.empty()) continue;
      out << separator << quantity.name << ' ' << Short(values.begin()->second);
      separator = ", ";
      break;
    }
  }
  out << '\n';
}

}  // namespace

std::string Summary(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  std::ostringstream out;
  if (!spec.players.empty()) {
    const auto is_broken = [](const Row& row) { return row.result.outcome != "ok"; };
    out << TournamentTable(spec, rows);
    if (const auto broken = std::ranges::count_if(rows, is_broken); broken > 0)
      out << broken << " games" << kCrashedOrHung << " and do not count\n";
    return std::move(out).str();
  }
  std::vector<std::map<std::uint64_t, bool>> passed(plan.variants.size());
  std::vector<std::map<std::uint64_t, std::uint64_t>> hashes(plan.variants.size());
  std::vector<std::size_t> broken(plan.variants.size());
  for (const Row& row : rows) {
    if (row.result.outcome == "ok") {
      if (row.result.IsJudged() || !row.result.IsUndecided()) passed[row.variant][row.seed] = row.result.passed;
      hashes[row.variant][row.seed] = row.result.state_hash;
    } else {
      ++broken[row.variant];
    }
  }
  const bool has_checks = !spec.mission.checks.empty();
  for (std::size_t v = 0; v < plan.variants.size(); ++v) {
    const auto good = static_cast<std::size_t>(
        std::count_if(passed[v].begin(), passed[v].end(), [](const auto& run) { return run.second; }));
    out << plan.variants[v].variant.name << ": " << hashes[v].size() << " runs";
    if (broken[v] > 0) out << ", " << broken[v] << kCrashedOrHung;
    if (hashes[v].size() > passed[v].size())
      out << ", " << hashes[v].size() - passed[v].size()
          << " undecided: their kernel does not say what a check asks for";
    if (has_checks && !passed[v].empty()) {
      const mission::Interval interval = mission::WilsonInterval(good, passed[v].size());
      out << ", " << good << " passed: " << Percent(static_cast<double>(good) / static_cast<double>(passed[v].size()))
          << " % (95 %: " << Percent(interval.low) << " to " << Percent(interval.high) << " %)";
    }
    out << '\n';
  }
  TellErrors(out, plan, rows);
  std::vector<Quantity> quantities = Quantities(spec, plan, rows), constants;
  const auto varying = std::stable_partition(quantities.begin(), quantities.end(), IsConstant);
  constants.assign(quantities.begin(), varying);
  quantities.erase(quantities.begin(), varying);
  for (const Quantity& quantity : quantities) {
    for (std::size_t v = 0; v < plan.variants.size(); ++v) {
      const std::vector<double> values = Values(quantity.by_variant[v]);
      if (values.empty()) continue;
      const mission::Interval interval = mission::StudentInterval(values);
      out << "  " << quantity.name << ", " << plan.variants[v].variant.name << ": mean " << Short(mission::Mean(values))
          << " (95 %: " << Short(interval.low) << " to " << Short(interval.high) << "), median "
          << Short(mission::Median(values)) << '\n';
    }
  }
  TellConstants(out, constants);
  const std::size_t seeds = hashes.empty() ? 0 : hashes.front().size();
  if (seeds > 1 && seeds < kFewSeeds)
    out << "these are few seeds: the intervals hold only if the numbers are distributed normally, and small "
           "differences are not found\n";
  if (plan.variants.size() < 2) return out.str();
  std::vector<Compared> family;
  std::ostringstream alike_lines;
  const std::vector<std::vector<Good>> good = GoodOf(spec, plan, rows);
  for (std::size_t v = 1; v < plan.variants.size(); ++v) {
    std::size_t only_first = 0, only_second = 0, equal = 0, alike = 0, both = 0;
    for (const auto& [seed, good] : passed[v]) {
      const auto other = passed.front().find(seed);
      if (other == passed.front().end()) continue;
      ++both;
      only_first += other->second && !good ? 1 : 0;
      only_second += good && !other->second ? 1 : 0;
      equal += hashes[v][seed] == hashes.front()[seed] ? 1 : 0;
      alike += AreAlike(quantities, 0, v, seed) ? 1 : 0;
    }
    const std::string &name = plan.variants[v].variant.name, &base = plan.variants.front().variant.name;
    if (both > 0 && equal == both && only_first == 0 && only_second == 0) {
      alike_lines << "  " << name << " never differs from " << base << ": does its change reach the agents?\n";
      continue;
    }
    if (both > 0 && alike == both && only_first == 0 && only_second == 0) {
      alike_lines << "  " << name << " and " << base
                  << " have the same numbers on each seed; does its change matter in these runs?\n";
      continue;
    }
    const auto add = [&](std::optional<Compared> compared) {
      if (compared) family.push_back(std::move(*compared));
    };
    if (has_checks) add(CompareRates(plan, "passed", passed.front(), passed[v], v));
    for (std::size_t i = 0; i < good.size() && good.size() > 1; ++i)
      add(CompareRates(plan, "check \"" + spec.mission.checks[i].name + "\"", good[i].front(), good[i][v], v));
    for (const Quantity& quantity : quantities) add(CompareNumbers(plan, quantity, 0, v));
  }
  // Variants that differ from the first one may be equal to each other.
  for (std::size_t a = 1; a < plan.variants.size() && plan.variants.size() <= kMostPairwise; ++a) {
    for (std::size_t b = a + 1; b < plan.variants.size(); ++b) {
      if (hashes[a].empty() || hashes[a].size() != hashes[b].size() || passed[a] != passed[b]) continue;
      const bool is_alike =
          std::ranges::all_of(hashes[a], [&](const auto& run) { return AreAlike(quantities, a, b, run.first); });
      if (is_alike)
        alike_lines << "  " << plan.variants[a].variant.name << " and " << plan.variants[b].variant.name
                    << " have the same numbers on each seed\n";
    }
  }
  out << "differences from " << plan.variants.front().variant.name << ", on equal seeds";
  if (family.size() > 1)
    out << " (" << family.size() << " comparisons, corrected after Holm; d: mean difference in standard deviations)";
  out << ":\n" << alike_lines.str();
  TellCompared(out, family);
  return out.str();
}

}  // namespace soarbox::sweep
