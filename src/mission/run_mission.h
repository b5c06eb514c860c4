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

/// What one run of a mission is made with.
struct RunSpec {
  const Mission* mission = nullptr;
  sim::Scenario scenario;
  std::uint64_t seed = 1;
  double seconds = 60;
  bool empty_minds = false;         ///< No mind has any rule: what passes so tests nothing.
  bool to_the_end = false;          ///< Goes on when all is decided, for metrics.
  std::filesystem::path recording;  ///< A run that fails is made again and recorded here; empty: not.
  bool record_always = false;       ///< Also one that passes.
  std::string kernel;               ///< HOST:PORT of a kernel elsewhere; empty: our own.
  bool ends_endless = false;        ///< Ends when rules fire without end; the outcome is then "endless".
  AccountSettings account;          ///< Of a run that fails: what it says of one file of rules.
  std::vector<Check> measured;      ///< What metrics look at besides the checks.
  /// An error of rules, scripts or files fails the run, unless a check asks for problems.
  bool errors_fail = false;
};

/// How a check ended, in words.
struct CheckResult {
  Verdict verdict;
  std::string expected;              ///< "scout should be at gate by 30 s"
  std::vector<std::string> reasons;  ///< Why the agent did not: lines of the account of its mind.
};

/// One run and what came of it.
struct RunResult {
  std::string outcome = "ok";  ///< "ok", "refused" (error), "crashed", "hung", "endless" (see ends_endless).
  std::string error;           ///< Why it is not ok.
  std::uint64_t seed = 1;
  bool passed = false;
  double seconds = 0;  ///< Simulated.
  std::uint64_t ticks = 0;
  std::uint64_t state_hash = 0;
  std::vector<CheckResult> checks;        ///< As the mission's checks, and behind them its mistakes.
  std::vector<std::size_t> idle_checks;   ///< Checks that hold before anybody acts.
  std::map<std::string, double> numbers;  ///< Metrics that every run has: "distance", "decisions".
  std::string recording;                  ///< The file that was kept; empty: none.
  std::vector<sim::Finding> account;      ///< If it was asked for.
  std::vector<std::string> problems;      ///< The first errors and warnings, with file and line; each once.
  bool has_errors = false;                ///< It reported an error, and no check is about that.
  bool is_faulty = false;                 ///< There was an error before the first tick: rules that cannot be read.
  double cpu_s = 0, peak_mb = 0;

  bool IsTrue(std::size_t check) const { return check < checks.size() && checks[check].verdict.state == State::kTrue; }
  bool IsUndecided() const;
  /// True if it passed, or a check failed: those that are undecided do not matter.
  bool IsJudged() const;
  /// A number of the run: 0 if nothing of it happened, none if the minds' kernel does not tell.
  std::optional<double> NumberOf(const std::string& name) const;
};

/// Called after each tick with the simulation and its facts, for the metrics of a sweep.
using OnFacts = std::function<void(const TickFacts&)>;

/// Whether a check asks for problems to be there, or not: then they are judged by it and are no fault of the run.
bool AsksForProblems(const Mission& mission);

/// Runs it in this process. If it cannot run, the result says why.
RunResult RunOnce(const RunSpec& spec, const OnFacts& on_facts = {});

/// For handing a result from process to process.
std::string ToJsonLine(const RunResult& result);
Result<RunResult> FromJsonLine(const std::string& line);

/// Why an agent with this mind did not do what the check asks, looked up at this moment of a run.
std::vector<std::string> ReasonsFor(const Check& check, const std::string& agent, sim::Simulation& simulation);

}  // namespace soarbox::mission
