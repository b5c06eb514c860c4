// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "app/event_printer.h"
#include "app/run_options.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// One run under way: the simulation and what is told about it. The headless loop and the window's loop drive it.
class RunSession {
 public:
  RunSession(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<EventPrinter> printer,
             const RunOptions& options);

  /// Advances one tick and prints what happened.
  void Tick();
  /// Serves debuggers while paused, and prints what they caused.
  void Idle();
  /// True once the asked-for time has passed or the user has asked to stop (Ctrl-C).
  bool IsOver() const;
  /// Runs the clean-up, prints the footer and returns the exit code.
  int Finish();

  sim::Simulation& simulation() { return *simulation_; }

 private:
  void PrintEvents();

  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<EventPrinter> printer_;
  double end_s_;           ///< Simulated time to stop at; infinite if none.
  double report_every_s_;  ///< 0: never.
  double next_report_s_ = 0;
  std::size_t problems_ = 0;
};

/// Makes Ctrl-C end the run at the next tick instead of killing the process. Idempotent.
void CatchInterrupts();
bool WasInterrupted();

}  // namespace soarbox::app
