// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "kernel/agent.h"

namespace soarbox::cli {

/// How long an agent's runs took since init-soar, for `stats`.
///
/// A clock in each phase would cost more than many phases, so at first only whole runs are measured, with two looks at
/// the clock per run. After `soar timers on`, phases and decision cycles are measured too. With timers off, nothing is
/// measured. The times are those of the wall clock, and nothing that an agent does depends on them.
class RunTimes : public kernel::Observer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RunTimes(kernel::Agent& agent) : agent_(agent) {}
  ~RunTimes() override { agent_.RemoveObserver(*this); }
  RunTimes(const RunTimes&) = delete;
  RunTimes& operator=(const RunTimes&) = delete;

  bool on() const { return on_; }
  bool measures_phases() const { return measures_phases_; }
  /// On also measures phases.
  void Switch(bool on);

  /// A run of this agent has ended. All agents of a run share its time.
  void AddRun(Clock::duration time);

  double run_seconds() const { return Seconds(runs_); }
  double phase_seconds(kernel::Phase phase) const { return Seconds(phases_[static_cast<std::size_t>(phase)]); }
  double all_phases_seconds() const;
  /// The time within the agent: its phases if they are measured, else its runs.
  double kernel_seconds() const { return measures_phases_ ? all_phases_seconds() : run_seconds(); }
  double longest_cycle_seconds() const { return Seconds(longest_cycle_); }
  std::uint64_t longest_cycle() const { return longest_cycle_number_; }
  /// Forgets what was measured before the last init-soar.
  void Refresh();

  void OnPhaseBegin(const kernel::Agent&, kernel::Phase) override { phase_began_ = Clock::now(); }
  void OnPhaseEnd(const kernel::Agent&, kernel::Phase phase) override;
  void OnDecisionCycleBegin(const kernel::Agent&) override { cycle_began_ = Clock::now(); }
  void OnDecisionCycleEnd(const kernel::Agent& agent) override;

 private:
  static double Seconds(Clock::duration time) { return std::chrono::duration<double>(time).count(); }

  kernel::Agent& agent_;
  bool on_ = true;
  bool measures_phases_ = false;
  std::uint64_t inits_ = 0;
  Clock::duration runs_{};
  std::array<Clock::duration, 5> phases_{};
  Clock::time_point phase_began_, cycle_began_;
  Clock::duration longest_cycle_{};
  std::uint64_t longest_cycle_number_ = 0;
};

}  // namespace soarbox::cli
