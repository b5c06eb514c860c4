// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/one_run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mission/conditions.h"
#include "mission/gather_facts.h"
#include "record/header.h"
#include "record/manifest.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Evaluates the sweep's own metrics during a run.
class MetricWatch {
 public:
  explicit MetricWatch(const Spec& spec)
      : spec_(spec),
        last_(spec.metrics.size()),
        most_(spec.metrics.size()),
        sum_(spec.metrics.size()),
        is_measured_(spec.metrics.size()) {}

  void See(const mission::TickFacts& facts) {
    ++ticks_;
    for (std::size_t i = 0; i < spec_.metrics.size(); ++i) {
      const Metric& metric = spec_.metrics[i];
      if (metric.of == Metric::Of::kTimeOf) continue;
      double sum = 0;
      for (const mission::AgentFacts& agent : facts.agents) {
        const auto& names = metric.asked.agents;
        const bool is_named = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
          return mission::MatchesPattern(name, agent.name);
        });
        if (!is_named && (metric.asked.team.empty() || metric.asked.team != agent.team)) continue;
        is_measured_[i] = is_measured_[i] || Has(agent, *metric.asked.conditions.front().row);
        sum += mission::LookAt(metric.asked.conditions.front(), &agent, nullptr, facts, {}).value;
      }
      last_[i] = sum;
      most_[i] = ticks_ == 1 ? sum : std::max(most_[i], sum);
      sum_[i] += sum;
    }
  }

  std::vector<std::optional<double>> Values(const mission::RunResult& run) const {
    std::vector<std::optional<double>> values;
    for (std::size_t i = 0; i < spec_.metrics.size(); ++i) {
      const Metric& metric = spec_.metrics[i];
      // If the kernel does not report the number, it must not be 0.
      const bool is_told = metric.of == Metric::Of::kTimeOf || metric.asked.conditions.empty() ||
                           metric.asked.conditions.front().row->source == mission::Source::kWorld ||
                           run.numbers.contains("firings");
      if (metric.of != Metric::Of::kTimeOf && (!is_measured_[i] || !is_told)) {
        values.emplace_back(std::nullopt);
        continue;
      }
      switch (metric.of) {
        case Metric::Of::kTimeOf:
          values.push_back(run.IsTrue(spec_.metrics[i].check)
                               ? std::optional<double>(run.checks[spec_.metrics[i].check].verdict.time_s)
                               : std::nullopt);
          break;
        case Metric::Of::kAtEnd:
          values.emplace_back(last_[i]);
          break;
        case Metric::Of::kMax:
          values.emplace_back(most_[i]);
          break;
        case Metric::Of::kMean:
          values.emplace_back(ticks_ > 0 ? sum_[i] / ticks_ : 0);
          break;
      }
    }
    return values;
  }

 private:
  /// Whether an agent has such a number: an agent without a mind makes no decisions, one without a weapon has no
  /// rounds, and only games have scores.
  static bool Has(const mission::AgentFacts& agent, const mission::KeyRow& row) {
    if (row.key == mission::Key::kScore) return agent.score.has_value();
    if (row.key == mission::Key::kAmmunition) return agent.ammunition.has_value();
    return row.source == mission::Source::kWorld || agent.has_mind;
  }

  const Spec& spec_;
  std::vector<double> last_, most_, sum_;
  std::vector<bool> is_measured_;
  double ticks_ = 0;
};

}  // namespace

std::string Work(const Spec& spec, const ReadyVariant& variant, std::uint64_t seed, const fs::path& recording) {
  mission::RunSpec run;
  run.mission = &variant.loaded.mission;
  run.scenario = variant.loaded.scenario;
  run.seed = seed;
  run.seconds = variant.loaded.seconds;
  run.to_the_end = true;
  run.kernel = variant.variant.kernel;
  run.errors_fail = true;
  for (const Metric& metric : spec.metrics)
    if (metric.of != Metric::Of::kTimeOf) run.measured.push_back(metric.asked);
  if (spec.record != "none") run.recording = recording;
  run.record_always = spec.record == "all";
  MetricWatch watch(spec);
  const mission::RunResult result =
      mission::RunOnce(run, [&watch](const mission::TickFacts& facts) { watch.See(facts); });
  Json metrics = Json::array();
  for (const std::optional<double>& value : watch.Values(result))
    metrics.push_back(value ? Json(*value) : Json(nullptr));
  return metrics.dump() + "\n" + mission::ToJsonLine(result);
}

Row RowOf(const Plan& plan, std::size_t variant, std::uint64_t seed, int tries, mission::ChildEnd end,
          const mission::ChildLimits& limits) {
  Row row;
  row.key = KeyOf(plan, variant, seed);
  row.build = record::BuildId();
  row.host = record::HostName();
  row.variant = variant;
  row.seed = seed;
  row.tries = tries;
  if (const std::size_t line = end.output.find('\n'); line != std::string::npos) {
    const Json metrics = Json::parse(end.output.substr(0, line), nullptr, false);
    if (metrics.is_array())
      for (const Json& metric : metrics)
        row.metrics.push_back(metric.is_number() ? std::optional<double>(metric.get<double>()) : std::nullopt);
    end.output.erase(0, line + 1);
  }
  row.result = mission::ResultOf(end, seed, limits);
  return row;
}

}  // namespace soarbox::sweep
