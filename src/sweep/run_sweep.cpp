// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/run_sweep.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>

#include "diagnostics/problem.h"
#include "mission/child_pool.h"
#include "sweep/one_run.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTries = 3;

struct Job {
  std::size_t variant = 0;
  std::uint64_t seed = 0;
  int tries = 0;
};

/// Runs in a child: loads the variant without a tick.
std::string Load(const ReadyVariant& variant, std::uint64_t seed) {
  mission::RunSpec run;
  run.mission = &variant.loaded.mission;
  run.scenario = variant.loaded.scenario;
  run.seed = seed;
  run.seconds = 0;
  run.errors_fail = true;
  return mission::ToJsonLine(mission::RunOnce(run));
}

/// The error for a variant that reports errors before its first tick.
Diagnostic FaultOf(const Spec& spec, const ReadyVariant& variant, const mission::RunResult& run) {
  std::string text = "variant '" + variant.variant.name + "' has an error before its first tick";
  for (const std::string& problem : run.problems) text += "\n  " + problem;
  return ProblemIn(spec.file.string(), std::move(text),
                   "correct it and give the same command again; rows that are there remain valid");
}

/// Whether the recording of a run exists, if the sweep requests one.
bool IsRecorded(const Spec& spec, const mission::RunResult& run, const fs::path& folder) {
  if (spec.record == "none" || (spec.record == "failed" && run.passed)) return true;
  std::error_code error;
  return !run.recording.empty() && fs::exists(folder / "recordings" / fs::path(run.recording).filename(), error);
}

}  // namespace

Result<void> TryVariants(const Spec& spec, const Plan& plan, const fs::path& folder, int jobs) {
  std::vector<Diagnostic> ignored;
  const std::map<std::string, Row> there = ReadRows(folder / "parts", ignored);
  std::deque<std::size_t> waiting;
  for (std::size_t variant = 0; variant < plan.variants.size(); ++variant) {
    const bool has_rows = std::ranges::any_of(
        spec.mission.seeds, [&](std::uint64_t seed) { return there.contains(KeyOf(plan, variant, seed)); });
    if (!has_rows && plan.variants[variant].variant.kernel.empty()) waiting.push_back(variant);
  }
  const int most = jobs > 0 ? jobs : mission::Processors();
  const std::uint64_t seed = spec.mission.seeds.front();
  mission::ChildPool pool(most);
  std::map<std::size_t, Diagnostic> faults;
  while (!waiting.empty() || !pool.IsIdle()) {
    while (!waiting.empty() && pool.HasRoom()) {
      const ReadyVariant& variant = plan.variants[waiting.front()];
      const Result<void> started = pool.Start(
          waiting.front(), [&] { return Load(variant, seed); }, mission::LimitsOf(variant.loaded, most));
      if (!started && pool.IsIdle()) return started.error();
      if (!started) break;
      waiting.pop_front();
    }
    std::optional<mission::ChildPool::Done> done = pool.Wait(0.2);
    if (!done) continue;
    const ReadyVariant& variant = plan.variants[done->id];
    const mission::RunResult run = mission::ResultOf(done->end, seed, mission::LimitsOf(variant.loaded, most));
    if (run.is_faulty) faults.emplace(done->id, FaultOf(spec, variant, run));
  }
  if (!faults.empty()) return faults.begin()->second;
  return {};
}

Result<Progress> RunSweep(const Spec& spec, const Plan& plan, const fs::path& folder, const SweepSettings& settings,
                          const std::function<bool(const Progress&)>& goes_on) {
  std::vector<Diagnostic> problems;
  const std::map<std::string, Row> there = ReadRows(folder / "parts", problems);
  Progress progress;
  std::deque<Job> waiting;
  // Seed by seed, so that the results can be compared if the sweep is stopped.
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
  // A remote kernel can have only one agent of a name, so it can serve only one run at a time.
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
    Row row = RowOf(plan, job.variant, job.seed, job.tries + 1, std::move(done->end),
                    mission::LimitsOf(plan.variants[job.variant].loaded, jobs));
    if ((row.result.outcome == "refused" || row.result.is_faulty) && !kernel.empty()) {
      // The other runs continue. No row is written, so the same command makes these runs when the kernel is available
      // and accepts the rules.
      const std::string& name = plan.variants[job.variant].variant.name;
      if (!told.contains(kernel)) {
        const bool has_problem = row.result.is_faulty && !row.result.problems.empty();
        progress.problems.push_back("variant '" + name +
                                    "' cannot run: " + (has_problem ? row.result.problems.front() : row.result.error));
        told.insert(kernel);
      }
      progress.left_out += 1 + std::erase_if(waiting, [&](const Job& each) { return kernel_of(each) == kernel; });
      continue;
    }
    if (row.result.outcome == "refused") {
      return ProblemIn(spec.file.string(),
                       "variant '" + plan.variants[job.variant].variant.name + "' cannot run: " + row.result.error);
    }
    if (row.result.is_faulty) return FaultOf(spec, plan.variants[job.variant], row.result);
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
