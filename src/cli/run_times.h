// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "kernel/agent.h"

namespace soarbox::cli {

/// The duration of an agent's runs since init-soar, for `stats`.
///
/// Reading a clock in each phase would cost more than many phases. Therefore, only entire runs are measured by default,
/// with two clock reads per run. `soar timers on` also measures phases and decision cycles. With timers off, nothing is
/// measured. Times are wall-clock times; nothing that an agent does depends on them.
class RunTimes : public kernel::Observer {
 public:
  using Clock = std::chrono::steady_clock;

  explicit RunTimes(kernel::Agent& agent) : agent_(agent) {}
  ~RunTimes() override { agent_.RemoveObserver(*this); }
  RunTimes(const RunTimes&) = delete;
  RunTimes& operator=(const RunTimes&) = delete;

  bool on() const { return on_; }
  bool measures_phases() const { return measures_phases_; }
  /// Turns timers on, including those of phases, or off.
  void Switch(bool on);

  /// Adds the duration of a run. All agents of a run share it.
  void AddRun(Clock::duration time);

  double run_seconds() const { return Seconds(runs_); }
  double phase_seconds(kernel::Phase phase) const { return Seconds(phases_[static_cast<std::size_t>(phase)]); }
  double all_phases_seconds() const;
  /// The time in the agent: that of its phases if they are measured, else that of its runs.
  double kernel_seconds() const { return measures_phases_ ? all_phases_seconds() : run_seconds(); }
  double longest_cycle_seconds() const { return Seconds(longest_cycle_); }
  std::uint64_t longest_cycle() const { return longest_cycle_number_; }
  /// Drops measurements from before the last init-soar.
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
