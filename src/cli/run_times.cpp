// SPDX-License-Identifier: BSD-2-Clause
#include "cli/run_times.h"

namespace soarbox::cli {

void RunTimes::Switch(bool on) {
  on_ = measures_phases_ = on;
  phase_began_ = cycle_began_ = Clock::now();
  if (on)
    agent_.AddObserver(*this, kernel::Mask(kernel::Event::kPhase));
  else
    agent_.RemoveObserver(*this);
}

void RunTimes::Refresh() {
  const std::uint64_t inits = agent_.counters().inits;
  if (inits == inits_) return;
  inits_ = inits;
  runs_ = longest_cycle_ = Clock::duration();
  phases_ = {};
  longest_cycle_number_ = 0;
}

void RunTimes::AddRun(Clock::duration time) {
  Refresh();
  runs_ += time;
}

double RunTimes::all_phases_seconds() const {
  Clock::duration sum{};
  for (const Clock::duration phase : phases_) sum += phase;
  return Seconds(sum);
}

void RunTimes::OnPhaseEnd(const kernel::Agent&, kernel::Phase phase) {
  Refresh();
  phases_[static_cast<std::size_t>(phase)] += Clock::now() - phase_began_;
}

void RunTimes::OnDecisionCycleEnd(const kernel::Agent& agent) {
  const Clock::duration time = Clock::now() - cycle_began_;
  if (time <= longest_cycle_) return;
  longest_cycle_ = time;
  longest_cycle_number_ = agent.counters().decision_cycles;
}

}  // namespace soarbox::cli
