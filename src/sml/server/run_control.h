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

/// Lets agents run: together in rounds of one interleave step each, or one alone. Fires the events of runs in the order
/// in which Soar does.
///
/// A run of decisions ends where the stop phase begins (`soar stop-phase`): each agent first completes its number of
/// cycles, and then, agent by agent, moves on to that phase. A request to stop ends the rounds; the way to the stop
/// phase is still gone.
///
/// Phases are stepped one by one only if somebody listens to them; else an agent takes the whole interleave step at
/// once. Rounds are gone through only if somebody listens to them, or if they give turns to more than one agent.
class RunControl {
 public:
  explicit RunControl(KernelHost& host) : host_(host) {}

  /// `interleave` as in the request, unless the request leaves it open (see InterleaveOf).
  kernel::RunResult Run(HostedAgent& addressed, const cli::RunRequest& request, bool interleave_given);
  bool running() const { return running_; }
  /// The same as clients hear it: false while they are told that the run begins.
  bool tells_running() const { return running_ && is_told_; }
  /// Of the run that is under way, or of the last one; from 1.
  std::uint64_t number() const { return number_; }

  /// Elaborations between interrupt checks. Values below 1 count as 1.
  void SetInterruptCheckRate(int rate) { check_rate_ = rate < 1 ? 1 : rate; }

 private:
  struct Runner {
    HostedAgent* hosted = nullptr;
    std::uint64_t remaining = 0;   ///< Units of the run that are left; unused for a run without end.
    std::uint64_t generation = 0;  ///< Of the output link, at the last output phase.
    int idle_outputs = 0;          ///< Output phases without a change, in a row.
    bool active = true;
    bool output_changed = false;  ///< Since the last unit of a run until output was done.
    bool passed_output = false;   ///< Since the last after-all-output-phases.
    bool generated = false;       ///< Since the last after-all-generated-output.
    bool interrupted = false;
    bool told_interrupt = false;
    kernel::StopReason reason = kernel::StopReason::kCompleted;
  };

  void Begin(HostedAgent& addressed, const cli::RunRequest& request);
  void Rounds(const cli::RunRequest& request, kernel::RunUnit interleave);
  void Round(const cli::RunRequest& request, kernel::RunUnit interleave);
  /// The rounds of an agent that runs alone while nobody listens to rounds: only its steps are left of them.
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
  kernel::RunUnit unit_ = kernel::RunUnit::kForever;  ///< Of the run that is under way.
  std::uint64_t number_ = 0;
  int check_rate_ = 10;
  int run_flags_ = 0;
  std::uint64_t stop_requests_ = 0;
  std::vector<Runner> runners_;
};

}  // namespace soarbox::server
