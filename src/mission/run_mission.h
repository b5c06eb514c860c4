// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "mission/account.h"
#include "mission/evaluator.h"
#include "mission/mission.h"
#include "sim/scenario.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

/// The settings of one run of a mission.
struct RunSpec {
  const Mission* mission = nullptr;
  sim::Scenario scenario;
  std::uint64_t seed = 1;
  double seconds = 60;
  bool empty_minds = false;         ///< No mind has rules. A check that passes then tests nothing.
  bool to_the_end = false;          ///< Continue after all checks are decided, for metrics.
  std::filesystem::path recording;  ///< If the run fails, it is repeated and recorded in this file; empty: not
                                    ///< recorded.
  bool record_always = false;       ///< Also record a run that passes.
  std::string kernel;               ///< HOST:PORT of a remote kernel; empty: our own kernel.
  bool ends_endless = false;        ///< End the run when rules fire endlessly; the outcome is then "endless".
  AccountSettings account;          ///< If the run fails, explain what went wrong in these rules.
  std::vector<Check> measured;      ///< Further checks for metrics.
  /// An error in rules, scripts or files fails the run, unless a check tests problems.
  bool errors_fail = false;
};

/// The result of a check, in words.
struct CheckResult {
  Verdict verdict;
  std::string expected;              ///< "scout should be at gate by 30 s"
  std::vector<std::string> reasons;  ///< Why the agent did not do it, line by line.
};

/// The result of one run.
struct RunResult {
  std::string outcome = "ok";  ///< "ok", "refused" (see `error`), "crashed", "hung", "endless" (see ends_endless).
  std::string error;           ///< Why the outcome is not "ok".
  std::uint64_t seed = 1;
  bool passed = false;
  double seconds = 0;  ///< Simulated duration.
  std::uint64_t ticks = 0;
  std::uint64_t state_hash = 0;
  std::vector<CheckResult> checks;        ///< Results of the checks, followed by those of the mistakes.
  std::vector<std::size_t> idle_checks;   ///< Indices of checks that are true before any agent acts.
  std::map<std::string, double> numbers;  ///< Metrics of every run: "distance", "decisions".
  std::string recording;                  ///< The recording that was kept; empty: none.
  std::vector<sim::Finding> account;      ///< What went wrong, the cause first, if it was requested.
  std::vector<std::string> problems;      ///< The first errors and warnings, with file and line; each once.
  bool has_errors = false;                ///< An error was reported, and no check tests problems.
  bool is_faulty = false;                 ///< An error was reported before the first tick, for example rules that
                                          ///< cannot be read.
  double cpu_s = 0, peak_mb = 0;

  bool IsTrue(std::size_t check) const { return check < checks.size() && checks[check].verdict.state == State::kTrue; }
  bool IsUndecided() const;
  /// Whether it passed or a check failed; undecided checks do not matter then.
  bool IsJudged() const;
  /// A number of the run: 0 if the event never occurred; nothing if the minds' kernel does not report it.
  std::optional<double> NumberOf(const std::string& name) const;
};

/// Called with the facts after the set-up (tick 0) and after each tick, for metrics of a sweep.
using OnFacts = std::function<void(const TickFacts&)>;

/// Whether a check tests problems. Problems then do not fail the run by themselves.
bool AsksForProblems(const Mission& mission);

/// Runs a mission in this process. If it cannot run, the result contains the reason.
RunResult RunOnce(const RunSpec& spec, const OnFacts& on_facts = {});

/// Conversion for passing a result between processes.
std::string ToJsonLine(const RunResult& result);
Result<RunResult> FromJsonLine(const std::string& line);

/// Explains why an agent with this mind did not do what the check requires, at this moment of a run.
std::vector<std::string> ReasonsFor(const Check& check, const std::string& agent, sim::Simulation& simulation);

}  // namespace soarbox::mission
