// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/run_sweep.h"

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/problem.h"
#include "mission/child_pool.h"
#include "mission/conditions.h"
#include "mission/gather_facts.h"
#include "record/header.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kMostTries = 3;

struct Job {
  std::size_t variant = 0;
  std::uint64_t seed = 0;
  int tries = 0;
};

/// Follows the sweep's own metrics through a run.
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
      // A zero would say that there was nothing of it; here nobody could tell.
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
  /// Whether this agent has such a number at all: one without a mind takes no decisions, one without a weapon has no
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

/// In a child: one run, and its metrics in front of its result.
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

/// Whether there is a recording of it, if the sweep asks for one.
bool IsRecorded(const Spec& spec, const mission::RunResult& run, const fs::path& folder) {
  if (spec.record == "none" || (spec.record == "failed" && run.passed)) return true;
  std::error_code error;
  return !run.recording.empty() && fs::exists(folder / "recordings" / fs::path(run.recording).filename(), error);
}

Row RowOf(const Plan& plan, const Job& job, mission::ChildEnd end, const mission::ChildLimits& limits) {
  Row row;
  row.key = KeyOf(plan, job.variant, job.seed);
  row.build = record::BuildId();
  row.host = HostName();
  row.variant = job.variant;
  row.seed = job.seed;
  row.tries = job.tries + 1;
  if (const std::size_t line = end.output.find('\n'); line != std::string::npos) {
    const Json metrics = Json::parse(end.output.substr(0, line), nullptr, false);
    if (metrics.is_array())
      for (const Json& metric : metrics)
        row.metrics.push_back(metric.is_number() ? std::optional<double>(metric.get<double>()) : std::nullopt);
    end.output.erase(0, line + 1);
  }
  row.result = mission::ResultOf(end, job.seed, limits);
  return row;
}

}  // namespace

Result<Progress> RunSweep(const Spec& spec, const Plan& plan, const fs::path& folder, const SweepSettings& settings,
                          const std::function<bool(const Progress&)>& goes_on) {
  std::vector<Diagnostic> problems;
  const std::map<std::string, Row> there = ReadRows(folder / "parts", problems);
  Progress progress;
  std::deque<Job> waiting;
  // Seed by seed, so that what is there when it is stopped can be compared.
  for (const std::uint64_t seed : spec.mission.seeds) {
    for (std::size_t variant = 0; variant < plan.variants.size(); ++variant) {
      const std::size_t number = progress.planned++;
      const auto known = there.find(KeyOf(plan, variant, seed));
      const bool is_done =
          known != there.end() &&
          (known->second.result.outcome == "ok" ? IsRecorded(spec, known->second.result, folder) : !settings.retry);
      if (is_done) {
        ++progress.there_before;
      } else if (number % settings.tasks == settings.task) {
        waiting.push_back({variant, seed, 0});
      }
    }
  }
  if (waiting.empty()) return progress;
  Result<std::unique_ptr<RowWriter>> writer = RowWriter::Create(folder / "parts");
  if (!writer) return writer.error();
  const int jobs = settings.jobs > 0 ? settings.jobs : mission::Processors();
  mission::ChildPool pool(jobs);
  std::vector<Job> running;
  const auto kernel_of = [&plan](const Job& job) { return plan.variants[job.variant].variant.kernel; };
  // A kernel elsewhere has one agent of a name, so it serves one run at a time.
  std::set<std::string> busy, told;
  while ((!waiting.empty() || !pool.IsIdle()) && goes_on(progress)) {
    while (pool.HasRoom()) {
      const auto next = std::find_if(waiting.begin(), waiting.end(),
                                     [&](const Job& each) { return !busy.contains(kernel_of(each)); });
      if (next == waiting.end()) break;
      const Job job = *next;
      const ReadyVariant& variant = plan.variants[job.variant];
      const fs::path recording =
          folder / "recordings" / (variant.variant.name + "-" + std::to_string(job.seed) + ".soarrec");
      const Result<void> started = pool.Start(
          running.size(), [&] { return Work(spec, variant, job.seed, recording); },
          mission::LimitsOf(variant.loaded, jobs));
      if (!started && pool.IsIdle()) return started.error();
      if (!started) break;
      running.push_back(job);
      waiting.erase(next);
      if (!variant.variant.kernel.empty()) busy.insert(variant.variant.kernel);
    }
    std::optional<mission::ChildPool::Done> done = pool.Wait(0.2);
    if (!done) continue;
    const Job job = running[done->id];
    const std::string kernel = kernel_of(job);
    busy.erase(kernel);
    Row row = RowOf(plan, job, std::move(done->end), mission::LimitsOf(plan.variants[job.variant].loaded, jobs));
    if (row.result.outcome == "refused" && !kernel.empty()) {
      // The others do without it. No row is written: the same command makes these runs when the kernel is there.
      const std::string& name = plan.variants[job.variant].variant.name;
      if (!told.contains(kernel)) {
        progress.problems.push_back("variant '" + name + "' cannot run: " + row.result.error);
        told.insert(kernel);
      }
      progress.left_out += 1 + std::erase_if(waiting, [&](const Job& each) { return kernel_of(each) == kernel; });
      continue;
    }
    if (row.result.outcome == "refused") {
      return ProblemIn(spec.file.string(),
                       "variant '" + plan.variants[job.variant].variant.name + "' cannot run: " + row.result.error);
    }
    if (row.result.is_faulty) {
      const std::string& name = plan.variants[job.variant].variant.name;
      std::string text = "variant '" + name + "' has an error before its first tick";
      for (const std::string& problem : row.result.problems) text += "\n  " + problem;
      return ProblemIn(spec.file.string(), std::move(text),
                       "correct it and give the same command again; runs of other variants that were made stay");
    }
    if (row.result.outcome != "ok" && row.tries < kMostTries) {
      waiting.push_back({job.variant, job.seed, row.tries});
      continue;
    }
    if (const Result<void> added = (*writer)->Add(row); !added) return added.error();
    ++progress.done;
    progress.failed += row.result.outcome == "ok" ? 0 : 1;
  }
  if (const Result<void> flushed = (*writer)->Flush(); !flushed) return flushed.error();
  return progress;
}

std::vector<Row> RowsOf(const Spec& spec, const Plan& plan, const fs::path& folder, std::vector<Diagnostic>& problems) {
  const std::map<std::string, Row> there = ReadRows(folder / "parts", problems);
  std::vector<Row> rows;
  for (std::size_t variant = 0; variant < plan.variants.size(); ++variant) {
    for (const std::uint64_t seed : spec.mission.seeds) {
      if (const auto at = there.find(KeyOf(plan, variant, seed)); at != there.end()) {
        rows.push_back(at->second);
        rows.back().variant = variant;
      }
    }
  }
  return rows;
}

}  // namespace soarbox::sweep
