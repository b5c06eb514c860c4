// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_session.h"

#include <csignal>
#include <limits>

#include "app/exit_codes.h"

namespace soarbox::app {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void OnInterrupt(int) {
  g_interrupted = 1;
}

}  // namespace

void CatchInterrupts() {
  std::signal(SIGINT, &OnInterrupt);
  std::signal(SIGTERM, &OnInterrupt);
}

bool WasInterrupted() {
  return g_interrupted != 0;
}

RunSession::RunSession(std::unique_ptr<sim::Simulation> simulation, std::unique_ptr<EventPrinter> printer,
                       const RunOptions& options)
    : simulation_(std::move(simulation)),
      printer_(std::move(printer)),
      end_s_(options.seconds.value_or(std::numeric_limits<double>::infinity())),
      report_every_s_(options.report_s.value_or(0)) {
  PrintEvents();
}

void RunSession::Tick() {
  simulation_->Tick();
  PrintEvents();
  if (report_every_s_ > 0 && simulation_->time_s() >= next_report_s_) {
    printer_->Report(simulation_->Snapshot());
    next_report_s_ += report_every_s_;
  }
}

void RunSession::Idle() {
  simulation_->Idle();
  PrintEvents();
}

bool RunSession::IsOver() const {
  return WasInterrupted() || simulation_->time_s() >= end_s_;
}

int RunSession::Finish() {
  simulation_->Finish();
  PrintEvents();
  RunFooter footer;
  footer.ticks = simulation_->tick();
  footer.time_s = simulation_->time_s();
  footer.state_hash = simulation_->StateHash();
  footer.agents = simulation_->Snapshot().agents.size();
  footer.soar_agents = simulation_->soar_agents();
  footer.problems = problems_;
  printer_->End(footer);
  return problems_ == 0 ? kOk : kProblems;
}

void RunSession::PrintEvents() {
  for (const sim::Event& event : simulation_->TakeEvents()) {
    const bool is_problem =
        event.kind == sim::EventKind::kAgentFailed || event.kind == sim::EventKind::kMindFailed ||
        (event.kind == sim::EventKind::kDiagnostic && event.diagnostic.severity == Severity::kError);
    if (is_problem) ++problems_;
    printer_->Print(event);
  }
}

}  // namespace soarbox::app
