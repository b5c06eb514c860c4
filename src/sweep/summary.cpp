// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "mission/sentences.h"
#include "mission/statistics.h"
#include "sweep/rows.h"
#include "sweep/tournament.h"

namespace soarbox::sweep {
namespace {

using mission::NumberText;

constexpr std::size_t kMostDifferences = 12;
constexpr std::size_t kFewestPairs = 5;

/// The numbers that a reader compares first; the table has all.
constexpr const char* kShown[] = {"distance", "commands", "failed_commands", "decisions", "firings",
                                  "rounds",   "hits",     "damage",          "alive",     "learned"};

std::string Percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100 * share)));
}

std::string Short(double number) {
  char text[32];
  // Large numbers as people write them: 13430, not 1.343e+04.
  const bool is_large = std::abs(number) >= 1e4 && std::abs(number) < 1e9;
  std::snprintf(text, sizeof text, is_large ? "%.0f" : "%.4g", number);
  return text;
}

/// The values of one quantity by seed, for each variant.
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
  // What is the same number in every run tells nothing.
  std::erase_if(quantities, [&](const Quantity& quantity) {
    std::optional<double> first;
    for (const auto& values : quantity.by_variant) {
      for (const auto& [seed, value] : values) {
        if (first && *first != value) return false;
        first = value;
      }
    }
    return true;
  });
  return quantities;
}

std::vector<double> Values(const std::map<std::uint64_t, double>& by_seed) {
  std::vector<double> values;
  for (const auto& [seed, value] : by_seed) values.push_back(value);
  return values;
}

/// Whether all numbers of two variants are the same with a seed.
bool AreAlike(const std::vector<Quantity>& quantities, std::size_t a, std::size_t b, std::uint64_t seed) {
  return std::ranges::all_of(quantities, [&](const Quantity& quantity) {
    const auto one = quantity.by_variant[a].find(seed), other = quantity.by_variant[b].find(seed);
    const bool has_one = one != quantity.by_variant[a].end(), has_other = other != quantity.by_variant[b].end();
    return has_one == has_other && (!has_one || one->second == other->second);
  });
}

void TellDifference(std::ostringstream& out, const Plan& plan, const Quantity& quantity, std::size_t a, std::size_t b) {
  std::vector<double> differences;
  std::size_t more = 0;
  for (const auto& [seed, value] : quantity.by_variant[b]) {
    const auto other = quantity.by_variant[a].find(seed);
    if (other == quantity.by_variant[a].end()) continue;
    differences.push_back(value - other->second);
    more += differences.back() > 0 ? 1 : 0;
  }
  if (differences.size() < kFewestPairs) return;
  const mission::Interval interval = mission::BootstrapInterval(differences);
  out << "  " << quantity.name << ": " << plan.variants[b].variant.name << " has " << Short(mission::Mean(differences))
      << " more than " << plan.variants[a].variant.name << " (95 %: " << Short(interval.low) << " to "
      << Short(interval.high) << "), more in "
      << Percent(static_cast<double>(more) / static_cast<double>(differences.size())) << " % of " << differences.size()
      << " equal seeds" << (interval.low > 0 || interval.high < 0 ? "" : "; that may be chance") << '\n';
}

}  // namespace

std::string Summary(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  std::ostringstream out;
  if (!spec.players.empty()) {
    const auto is_broken = [](const Row& row) { return row.result.outcome != "ok"; };
    out << TournamentTable(spec, rows);
    if (const auto broken = std::ranges::count_if(rows, is_broken); broken > 0)
      out << broken << " games crashed or hung and do not count\n";
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
    if (broken[v] > 0) out << ", " << broken[v] << " crashed or hung";
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
  const std::vector<Quantity> quantities = Quantities(spec, plan, rows);
  for (const Quantity& quantity : quantities) {
    for (std::size_t v = 0; v < plan.variants.size(); ++v) {
      const std::vector<double> values = Values(quantity.by_variant[v]);
      if (values.empty()) continue;
      const mission::Interval interval = mission::BootstrapInterval(values);
      out << "  " << quantity.name << ", " << plan.variants[v].variant.name << ": mean " << Short(mission::Mean(values))
          << " (95 %: " << Short(interval.low) << " to " << Short(interval.high) << "), median "
          << Short(mission::Median(values)) << '\n';
    }
  }
  if (plan.variants.size() < 2) return out.str();
  out << "differences from " << plan.variants.front().variant.name << ", on equal seeds:\n";
  std::size_t told = 0;
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
    if (both > 0 && equal == both && only_first == 0 && only_second == 0) {
      out << "  " << plan.variants[v].variant.name << " never differs from " << plan.variants.front().variant.name
          << ": does what it changes reach the agents?\n";
      continue;
    }
    if (both > 0 && alike == both && only_first == 0 && only_second == 0) {
      out << "  " << plan.variants[v].variant.name << " and " << plan.variants.front().variant.name
          << " have the same numbers on each seed; does what it changes matter in these runs?\n";
      continue;
    }
    if (has_checks && both > 0) {
      out << "  passed: " << only_second << " seeds with " << plan.variants[v].variant.name << " only, " << only_first
          << " with " << plan.variants.front().variant.name << " only; by chance with probability "
          << Short(mission::McNemar(only_first, only_second)) << '\n';
    }
    for (const Quantity& quantity : quantities) {
      if (told++ < kMostDifferences * plan.variants.size()) TellDifference(out, plan, quantity, 0, v);
    }
  }
  return out.str();
}

}  // namespace soarbox::sweep
