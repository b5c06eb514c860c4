// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <new>
#include <string>
#include <string_view>

#include "kernel/agent.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/observer.h"

namespace soarbox::kernel {

struct AgentCore;

/// The decision cycle (input, propose, decide, apply, output) as a state machine that can stop between any two
/// elaborations. Stores the next phase, counts cycles, and ends runs.
class RunControl {
 public:
  explicit RunControl(AgentCore& core) : core_(core) {}

  RunResult Run(RunUnit unit, std::uint64_t count);
  RunResult Step(RunUnit unit, std::uint64_t most = 1);
  RunResult RunToPhase(Phase phase);

  Phase phase() const { return phase_; }
  bool in_middle() const { return in_middle_; }
  bool halted() const { return halted_; }
  bool running() const { return running_; }

  /// Callable from any thread.
  void RequestStop(std::string_view reason);
  void ClearStop();

  /// (halt): the run ends after the current elaboration.
  void Halt() { halt_requested_ = true; }
  /// (interrupt): the run ends after its phase, or after its elaboration if it counts elaborations.
  void InterruptByAction() { rule_interrupt_ = action_interrupt_ = running_; }
  /// Like InterruptByAction, on behalf of learning. `why` is reported as the reason.
  void InterruptAfterPhase(std::string_view why) {
    rule_interrupt_ = running_;
    action_interrupt_ = false;
    interrupt_reason_ = why;
  }
  /// Reports which rules with interrupts have new matches. A current run ends after its phase.
  void TellInterrupts();
  /// The goal stack is at its limit: the run ends as if halted, but the agent may run again.
  void GoalStackLimit();
  void WatchGoal(Symbol goal);
  void GoalRemoved(Symbol goal) {
    if (goal == watched_goal_) InterruptAfterPhase("Stopped due to substate (goal) retraction.");
  }
  void Clear();
  /// Memory ran out in the middle of a change. The agent counts as running from now on, so that no call changes it.
  void BreakDown() { broken_ = running_ = halted_ = true; }
  bool broken() const { return broken_; }
  /// Throws std::bad_alloc, which ends the current run, if the agent broke down. This happens if a rule's action or an
  /// observer used up the memory. The matches no longer exist, so the run cannot continue.
  void StopIfBroken() const {
    if (broken_) throw std::bad_alloc();
  }

 private:
  /// Runs one elaboration, or an entire phase that has none. Returns true if a phase ended.
  bool Advance();
  void InputPhase();
  /// Returns true if nothing needs the individual elements of the input: no observer, no module, and no match that
  /// waits for its retraction.
  bool InputIsUnheard() const;
  void DecidePhase();
  void OutputPhase();
  bool ElaboratePhase(bool apply);
  void BeginPhase();
  void EndPhase(Phase next);
  /// Called after each elaboration and phase: handles requested halts and interrupts. Returns true if the run must end.
  bool CheckStop() {
    const bool due = halt_requested_ | goal_stack_limit_ | rule_interrupt_ | stop_.load(std::memory_order_relaxed);
    return due && Stop();
  }
  [[gnu::noinline]] bool Stop();
  struct Start {
    std::uint64_t decisions, elaborations, firings;
  };
  Start Begin();
  RunResult Finish(const Start& start);
  bool MustEnd() const { return halted_ || ended_; }
  /// Runs one decision. Returns true if the next one would change nothing without new input.
  bool RunOneDecision();
  bool IsIdle(std::uint64_t changes_before, std::uint64_t elaborations_before) const;
  void CountIdle(std::uint64_t decisions);
  void RunOneOutput();

  AgentCore& core_;
  Phase phase_ = Phase::kInput;
  bool in_middle_ = false;
  bool running_ = false;
  bool broken_ = false;
  bool halted_ = false;
  bool halt_requested_ = false;
  bool rule_interrupt_ = false;    ///< Requested by a rule's match or by (interrupt).
  bool action_interrupt_ = false;  ///< The last request came from an action.
  bool by_elaboration_ = false;    ///< This run ends after one elaboration.
  bool by_phase_ = false;          ///< This run counts phases, or has no limit.
  bool goal_stack_limit_ = false;
  bool limit_reached_ = false;   ///< The goal stack limit was reached in this run.
  bool ended_ = false;           ///< This run was interrupted.
  bool output_changed_ = false;  ///< Set by the last output phase.
  Symbol watched_goal_;
  std::uint64_t cycle_wme_changes_ = 0, cycle_firings_ = 0;
  std::chrono::steady_clock::time_point cycle_began_;
  std::atomic<bool> stop_{false};
  std::mutex reason_mutex_;
  std::string reason_;
  std::string interrupt_reason_;  ///< Set by InterruptAfterPhase; empty for other requests.
};

}  // namespace soarbox::kernel
