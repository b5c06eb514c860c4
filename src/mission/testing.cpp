// SPDX-License-Identifier: BSD-2-Clause
#include "mission/testing.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace soarbox::mission {
namespace {

constexpr std::uint64_t kLeastMemory = std::uint64_t{2} << 30;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;  // They reserve more address space than exists.
#else
constexpr bool kLimitsMemory = true;
#endif

}  // namespace

bool MissionOutcome::HasBroken() const {
  return std::any_of(runs.begin(), runs.end(), [](const RunResult& run) {
    return run.outcome == "crashed" || run.outcome == "hung" || run.IsUndecided();
  });
}

bool MissionOutcome::IsRefused() const {
  return std::any_of(runs.begin(), runs.end(), [](const RunResult& run) { return run.outcome == "refused"; });
}

std::size_t NeededOf(const Mission& mission, const MissionOutcome& outcome, std::size_t check) {
  const Check& asked = mission.checks[check];
  if (asked.marker) return 0;
  if (!asked.pass) return outcome.needed;
  // If the number of seeds differs from that of the mission, the same fraction must pass.
  const std::size_t seeds = std::max<std::size_t>(1, mission.seeds.size());
  return static_cast<std::size_t>(*asked.pass) * outcome.runs.size() / seeds;
}

bool MissionOutcome::Passed(const Mission& mission) const {
  if (passed < needed || IsRefused()) return false;
  for (std::size_t i = 0; i < mission.checks.size(); ++i)
    if (mission.checks[i].pass && check_true[i] < NeededOf(mission, *this, i)) return false;
  return true;
}

bool MissionOutcome::IsOpen(const Mission& mission) const {
  if (!IsInterrupted() || IsRefused() || Passed(mission)) return false;
  // Too many runs have failed for the missing ones to change the result.
  const std::size_t missing = asked - runs.size();
  if (passed + missing < needed) return false;
  for (std::size_t i = 0; i < mission.checks.size(); ++i) {
    if (mission.checks[i].marker || !mission.checks[i].pass) continue;
    const std::size_t all = NeededOf(mission, *this, i) * asked / std::max<std::size_t>(1, runs.size());
    if (check_true[i] + missing < all) return false;
  }
  return true;
}

std::vector<std::uint64_t> SeedsOf(const Mission& mission, const TestSettings& settings) {
  if (!settings.seeds.empty()) return settings.seeds;
  return mission.seeds.empty() ? std::vector<std::uint64_t>{1} : mission.seeds;
}

ChildLimits LimitsOf(const LoadedMission& loaded, int jobs) {
  ChildLimits limits;
  limits.cpu_s = loaded.mission.wall_s.value_or(60 + 5 * loaded.seconds);
  if (kLimitsMemory) {
    const auto bytes =
        static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGE_SIZE));
    limits.memory_bytes = std::max(kLeastMemory, bytes / static_cast<std::uint64_t>(std::max(1, jobs)));
  }
  return limits;
}

RunResult ResultOf(const ChildEnd& end, std::uint64_t seed, const ChildLimits& limits) {
  RunResult result;
  if (end.is_whole) {
    if (Result<RunResult> read = FromJsonLine(end.output)) {
      result = std::move(*read);
    } else {
      result.outcome = "crashed";
      result.error = read.error().message;
    }
  } else if (end.hung) {
    result.outcome = "hung";
    result.error = "it took more than " + std::to_string(static_cast<int>(limits.cpu_s)) +
                   " s of processor time; wall = SECONDS in the mission sets another limit";
  } else {
    result.outcome = "crashed";
    result.error = end.signal != 0 ? std::string("its process ended by signal ") + std::to_string(end.signal) + " (" +
                                         strsignal(end.signal) + ")"
                                   : "its process ended without an answer; perhaps its memory ran out";
  }
  result.seed = seed;
  result.cpu_s = end.cpu_s;
  result.peak_mb = end.peak_mb;
  return result;
}

Result<MissionOutcome> TestMission(const LoadedMission& loaded, const TestSettings& settings,
                                   const std::function<void(const RunResult&)>& on_run,
                                   const std::function<bool()>& goes_on) {
  const auto begin = std::chrono::steady_clock::now();
  const Mission& mission = loaded.mission;
  const std::vector<std::uint64_t> seeds = SeedsOf(mission, settings);
  const int jobs = settings.jobs > 0 ? settings.jobs : Processors();
  const ChildLimits limits = LimitsOf(loaded, jobs);
  ChildPool pool(jobs);
  std::vector<RunResult> results(seeds.size());
  std::vector<bool> is_done(seeds.size());
  std::size_t next = 0;
  while ((next < seeds.size() || !pool.IsIdle()) && goes_on()) {
    while (next < seeds.size() && pool.HasRoom()) {
      RunSpec spec;
      spec.mission = &mission;
      spec.scenario = loaded.scenario;
      spec.seed = seeds[next];
      spec.seconds = loaded.seconds;
      spec.empty_minds = settings.empty_minds;
      spec.ends_endless = settings.ends_endless;
      spec.errors_fail = settings.errors_fail;
      spec.account = settings.account;
      if (!settings.keep.empty())
        spec.recording = settings.keep / (mission.name + "-" + std::to_string(seeds[next]) + ".soarrec");
      const Result<void> started = pool.Start(
          next, [&spec] { return ToJsonLine(RunOnce(spec)); }, limits);
      if (!started && pool.IsIdle()) return started.error();
      if (!started) break;
      ++next;
    }
    const std::optional<ChildPool::Done> done = pool.Wait(0.2);
    if (!done) continue;
    results[done->id] = ResultOf(done->end, seeds[done->id], limits);
    is_done[done->id] = true;
    on_run(results[done->id]);
  }
  MissionOutcome outcome;
  outcome.asked = seeds.size();
  outcome.needed =
      std::min(seeds.size(), static_cast<std::size_t>(mission.pass.value_or(static_cast<int>(seeds.size()))));
  // For other seeds than the mission's, the same fraction must pass.
  if (!settings.seeds.empty() && mission.pass && !mission.seeds.empty())
    outcome.needed =
        (seeds.size() * static_cast<std::size_t>(*mission.pass) + mission.seeds.size() - 1) / mission.seeds.size();
  outcome.check_true.resize(mission.checks.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!is_done[i]) continue;
    outcome.passed += results[i].outcome == "ok" && results[i].passed ? 1 : 0;
    for (std::size_t check = 0; check < mission.checks.size(); ++check)
      outcome.check_true[check] += results[i].IsTrue(check) ? 1 : 0;
    outcome.runs.push_back(std::move(results[i]));
  }
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace soarbox::mission
