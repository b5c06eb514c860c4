// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "diagnostics/problem.h"
#include "mission/statistics.h"
#include "report/page.h"
#include "sweep/run_sweep.h"
#include "sweep/sweep_manifest.h"
#include "sweep/tournament.h"

namespace soarbox::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 20'000;
constexpr std::size_t kMostOutliers = 10;

using Values = std::map<std::uint64_t, double>;  // By seed.

Json IntervalOf(const std::vector<double>& values) {
  const mission::Interval interval = mission::StudentInterval(values);
  return Json{{"mean", mission::Mean(values)},
              {"low", interval.low},
              {"high", interval.high},
              {"median", mission::Median(values)},
              {"sd", mission::StandardDeviation(values)}};
}

/// All differences on a page are one family of comparisons: adds Holm's correction to their probabilities.
void CorrectDifferences(Json& metrics) {
  std::vector<Json*> differences;
  std::vector<double> probabilities;
  for (Json& metric : metrics) {
    for (Json& difference : metric["differences"]) {
      differences.push_back(&difference);
      probabilities.push_back(difference["probability"].get<double>());
    }
  }
  const std::vector<double> corrected = mission::Holm(probabilities);
  for (std::size_t i = 0; i < differences.size(); ++i) (*differences[i])["holm"] = corrected[i];
}

/// The agents of a tournament, best first.
Json StandingsOf(const sweep::Spec& spec, const std::vector<sweep::Row>& rows) {
  Json standings = Json::array();
  for (const sweep::Standing& each : sweep::Standings(spec, rows))
    standings.push_back(Json{{"agent", each.player},
                             {"rating", std::round(each.rating)},
                             {"low", std::round(each.rating_low)},
                             {"high", std::round(each.rating_high)},
                             {"games", each.games},
                             {"won", each.wins},
                             {"drawn", each.draws},
                             {"lost", each.losses},
                             {"place", std::round(each.place * 100) / 100},
                             {"points", std::round(each.points * 100) / 100}});
  return standings;
}

}  // namespace

Result<std::string> SweepData(const fs::path& folder, const sim::DataFolders& data) {
  fs::path place = folder;
  if (place.filename().empty()) place = place.parent_path();
  // The folder contains everything that its rows depend on, even if it was moved.
  std::vector<Diagnostic> problems;
  const sweep::Spec spec = sweep::ReadSpec(sweep::KeptSpec(place), problems, true);
  if (!problems.empty()) return problems.front();
  const Result<sweep::Plan> plan = sweep::MakePlan(spec, place, data, sweep::Sources::kTrust);
  if (!plan) return plan.error();
  const std::vector<sweep::Row> rows = sweep::RowsOf(spec, *plan, place, problems);
  if (rows.empty()) return ProblemIn(folder, "this sweep has no runs yet", "soarbox sweep makes them");
  Json made{{"kind", "sweep"},
            {"title", place.stem().string() + ": " + std::to_string(rows.size()) + " runs"},
            {"command", "soarbox run " + sweep::ShellWord(plan->variants.front().argument)}};
  made["build"] = rows.front().build;
  if (Json manifest = Json::parse(sweep::ReadManifest(place), nullptr, false); manifest.is_object())
    made["manifest"] = std::move(manifest);
  Json names = Json::array(), variants = Json::array(), summary = Json::array();
  const std::size_t count = plan->variants.size();
  std::vector<std::string> numbers;
  std::map<std::string, std::vector<Values>> by_number;
  const auto add = [&](const std::string& name, const sweep::Row& row, double value) {
    auto& values = by_number[name];
    if (values.empty()) {
      values.resize(count);
      numbers.push_back(name);
    }
    values[row.variant][row.seed] = value;
  };
  std::vector<std::size_t> passed(count), judged(count), ok(count), broken(count);
  const std::vector<std::size_t> none(spec.mission.checks.size());
  std::vector<std::vector<std::size_t>> checks(count, none), decided(count, none);
  // A remote kernel may not report what a check needs. Such a run neither passes nor fails.
  const auto is_judged = [](const sweep::Row& row) { return row.result.IsJudged() || !row.result.IsUndecided(); };
  for (const sweep::Row& row : rows) {
    if (row.result.outcome != "ok") {
      ++broken[row.variant];
      continue;
    }
    ++ok[row.variant];
    judged[row.variant] += is_judged(row) ? 1 : 0;
    passed[row.variant] += is_judged(row) && row.result.passed ? 1 : 0;
    for (std::size_t i = 0; i < none.size() && i < row.result.checks.size(); ++i) {
      decided[row.variant][i] += row.result.checks[i].verdict.state == mission::State::kUndecided ? 0 : 1;
      checks[row.variant][i] += row.result.IsTrue(i) ? 1 : 0;
    }
    for (std::size_t i = 0; i < spec.metrics.size() && i < row.metrics.size(); ++i)
      if (row.metrics[i]) add(spec.metrics[i].name, row, *row.metrics[i]);
    add("seconds", row, row.result.seconds);
    for (const auto& [name, value] : row.result.numbers)
      if (row.result.NumberOf(name)) add(name, row, value);
  }
  for (std::size_t v = 0; v < count; ++v) {
    const mission::Interval interval = mission::WilsonInterval(passed[v], judged[v]);
    Json& variant = variants.emplace_back(Json{{"name", plan->variants[v].variant.name},
                                               {"runs", ok[v]},
                                               {"broken", broken[v]},
                                               {"judged", judged[v]},
                                               {"passed", passed[v]},
                                               {"low", interval.low},
                                               {"high", interval.high}});
    Json& shares = variant["checks"] = Json::array();
    for (std::size_t i = 0; i < spec.mission.checks.size(); ++i) {
      const mission::Interval each = mission::WilsonInterval(checks[v][i], decided[v][i]);
      shares.push_back(Json{{"true", checks[v][i]}, {"of", decided[v][i]}, {"low", each.low}, {"high", each.high}});
    }
  }
  Json check_names = Json::array();
  for (const mission::Check& check : spec.mission.checks) check_names.push_back(check.name);
  std::ostringstream verdict;
  if (!spec.mission.checks.empty() && count > 0 && judged[0] > 0)
    verdict << plan->variants[0].variant.name << " passes in " << passed[0] << " of " << judged[0] << " runs";
  Json metrics = Json::array();
  Json outliers = Json::array();
  for (const std::string& name : numbers) {
    const std::vector<Values>& values = by_number[name];
    std::vector<double> all;
    Json by_variant = Json::array();
    for (std::size_t v = 0; v < count; ++v) {
      std::vector<double> of;
      for (const auto& [seed, value] : values[v]) of.push_back(value);
      all.insert(all.end(), of.begin(), of.end());
      Json stats = of.empty() ? Json::object() : IntervalOf(of);
      stats["values"] = of;
      by_variant.push_back(std::move(stats));
    }
    if (std::adjacent_find(all.begin(), all.end(), std::not_equal_to<>()) == all.end()) continue;
    Json differences = Json::array();
    for (std::size_t v = 1; v < count; ++v) {
      std::vector<double> of_base, of_variant;  // On equal seeds.
      for (const auto& [seed, value] : values[v]) {
        const auto other = values[0].find(seed);
        if (other == values[0].end()) continue;
        of_base.push_back(other->second);
        of_variant.push_back(value);
      }
      const std::vector<double> paired = mission::PairedDifferences(of_base, of_variant);
      if (paired.size() < 2) continue;
      Json difference = IntervalOf(paired);
      difference["variant"] = plan->variants[v].variant.name;
      difference["pairs"] = paired.size();
      difference["probability"] = mission::StudentTest(paired);
      if (const std::optional<double> effect = mission::PairedEffect(of_base, of_variant)) difference["d"] = *effect;
      std::vector<double> ones, others;
      for (const auto& [seed, value] : values[0]) ones.push_back(value);
      for (const auto& [seed, value] : values[v]) others.push_back(value);
      difference["delta"] = mission::CliffsDelta(ones, others);
      difference["values"] = paired;
      differences.push_back(std::move(difference));
    }
    metrics.push_back(
        Json{{"name", name}, {"variants", std::move(by_variant)}, {"differences", std::move(differences)}});
    // Runs that are at least three standard deviations from the median of their variant.
    for (std::size_t v = 0; v < count; ++v) {
      std::vector<double> of;
      for (const auto& [seed, value] : values[v]) of.push_back(value);
      const double median = mission::Median(of), spread = mission::StandardDeviation(of);
      if (spread <= 0) continue;
      for (const auto& [seed, value] : values[v]) {
        const double away = std::abs(value - median) / spread;
        if (away < 3) continue;
        outliers.push_back(Json{{"away", away},
                                {"variant", plan->variants[v].variant.name},
                                {"seed", seed},
                                {"what", name},
                                {"value", value},
                                {"median", median},
                                {"command", "soarbox run " + sweep::ShellWord(plan->variants[v].argument) + " --seed " +
                                                std::to_string(seed)}});
      }
    }
  }
  std::stable_sort(outliers.begin(), outliers.end(),
                   [](const Json& a, const Json& b) { return a["away"] > b["away"]; });
  Json few = Json::array();
  std::set<std::string> told;
  for (const Json& outlier : outliers) {
    if (few.size() < kMostOutliers && told.insert(outlier["command"].get<std::string>()).second) few.push_back(outlier);
  }
  std::istringstream lines(sweep::Summary(spec, *plan, rows));
  for (std::string line; std::getline(lines, line);) summary.push_back(Json{{"text", line}});
  Json table = Json::array(), failed = Json::array();
  const std::size_t points = spec.seatings.empty() ? 0 : spec.seatings.front().size();
  for (const sweep::Row& row : rows) {
    if (table.size() >= kMostRows) break;
    Json cells = Json::array({plan->variants[row.variant].variant.name, row.seed, row.result.outcome,
                              is_judged(row) ? Json(row.result.passed) : Json("undecided"),
                              std::round(row.result.seconds * 100) / 100});
    for (const char* name : {"distance", "commands", "decisions", "hits", "alive"}) {
      const std::optional<double> value = row.result.NumberOf(name);
      cells.push_back(value ? Json(std::round(*value * 100) / 100) : Json(""));
    }
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t at = spec.metrics.size() - points + i;
      cells.push_back(at < row.metrics.size() && row.metrics[at] ? Json(*row.metrics[at]) : Json(""));
    }
    table.push_back(std::move(cells));
    if (row.result.outcome != "ok")
      failed.push_back(Json{{"variant", plan->variants[row.variant].variant.name},
                            {"seed", row.seed},
                            {"outcome", row.result.outcome},
                            {"error", row.result.error}});
  }
  if (const bool is_tournament = !spec.players.empty(); is_tournament) {
    made["standings"] = StandingsOf(spec, rows);
    const Json& best = made["standings"].front();
    verdict << best["agent"].get<std::string>() << " is ahead, with a rating of " << best["rating"].get<double>();
  }
  CorrectDifferences(metrics);
  made["verdict"] = verdict.str();
  made["variants"] = std::move(variants);
  made["check_names"] = std::move(check_names);
  made["metrics"] = std::move(metrics);
  made["outliers"] = std::move(few);
  made["summary"] = std::move(summary);
  made["columns"] = Json::array(
      {"variant", "seed", "outcome", "passed", "seconds", "distance", "commands", "decisions", "hits", "alive"});
  for (std::size_t i = spec.metrics.size() - points; i < spec.metrics.size(); ++i)
    made["columns"].push_back(spec.metrics[i].name);
  made["rows"] = std::move(table);
  made["failed"] = std::move(failed);
  return made.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace soarbox::report
