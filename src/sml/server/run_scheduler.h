// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "cli/host.h"
#include "kernel/agent.h"

namespace soarbox::server {

class HostedAgent;
class KernelHost;

/// Runs agents: together in rounds of one interleave step each, or one alone. Fires the events of runs in the same
/// order as Soar.
///
/// A run of decisions ends before the stop phase (`soar stop-phase`): first each agent completes its number of cycles,
/// then agent by agent advances to that phase. A stop request ends the rounds, but the agents still advance to the stop
/// phase.
///
/// Phases are executed one by one only if a client listens to them; else an agent executes an entire interleave step at
/// once. Rounds are executed one by one only if a client listens to them, or if several agents take part.
class RunControl {
 public:
  explicit RunControl(KernelHost& host) : host_(host) {}

  /// `interleave_given`: the request specifies the interleave step. Otherwise, InterleaveOf chooses it.
  kernel::RunResult Run(HostedAgent& addressed, const cli::RunRequest& request, bool interleave_given);
  bool running() const { return running_; }
  /// Like running(), but false until clients have been informed that the run begins.
  bool tells_running() const { return running_ && is_told_; }
  /// The number of the current or the last run, from 1.
  std::uint64_t number() const { return number_; }

  /// Number of rounds between interrupt checks. Values below 1 count as 1.
  void SetInterruptCheckRate(int rate) { check_rate_ = rate < 1 ? 1 : rate; }

 private:
  struct Runner {
    HostedAgent* hosted = nullptr;
    std::uint64_t remaining = 0;   ///< Remaining units of the run; unused for a run without end.
    std::uint64_t generation = 0;  ///< That of the output link at the last output phase.
    int idle_outputs = 0;          ///< Number of consecutive output phases without a change.
    bool active = true;
    bool output_changed = false;  ///< Since the last unit of a run until output.
    bool passed_output = false;   ///< Since the last after-all-output-phases.
    bool generated = false;       ///< Since the last after-all-generated-output.
    bool interrupted = false;
    bool told_interrupt = false;
    kernel::StopReason reason = kernel::StopReason::kCompleted;
  };

  void Begin(HostedAgent& addressed, const cli::RunRequest& request);
  void Rounds(const cli::RunRequest& request, kernel::RunUnit interleave);
  void Round(const cli::RunRequest& request, kernel::RunUnit interleave);
  /// Executes the steps of a single agent without rounds, as long as no client listens to rounds or steps.
  void StepAlone(Runner& runner, const cli::RunRequest& request, kernel::RunUnit interleave);
  static std::uint64_t OutputsLeft(const Runner& runner);
  void EndIfStopRequested(Runner& runner);
  void MoveToStopPhase(Runner& runner);
  void StepBracketed(Runner& runner, kernel::RunUnit unit);
  void Step(Runner& runner, kernel::RunUnit unit);
  void StepPhase(Runner& runner, bool whole);
  bool StopRequested(const Runner& runner) const;
  static bool OutputRunIsServed(const Runner& runner);
  void AfterOutputPhase(Runner& runner);
  void CountStep(Runner& runner, const cli::RunRequest& request, std::uint64_t cycles, bool phase_ended);
  void NoteEnd(Runner& runner, const kernel::RunResult& result);
  void EndInterrupted(Runner& runner);
  void FireUpdates();
  void Finish(Runner& runner, bool tell);

  KernelHost& host_;
  std::atomic<bool> running_{false};
  std::atomic<bool> is_told_{true};
  kernel::RunUnit unit_ = kernel::RunUnit::kForever;  ///< The unit of the current run.
  std::uint64_t number_ = 0;
  int check_rate_ = 10;
  int run_flags_ = 0;
  std::uint64_t stop_requests_ = 0;
  std::vector<Runner> runners_;
};

}  // namespace soarbox::server
