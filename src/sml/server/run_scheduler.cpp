// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/run_scheduler.h"

#include <algorithm>
#include <utility>

#include "sml/server/client_log.h"
#include "sml/server/hosted_agent.h"
#include "sml/server/kernel_host.h"

namespace soarbox::server {

using namespace ::sml;
using kernel::Phase;
using kernel::RunUnit;
using kernel::StopReason;

namespace {

struct PhaseEvents {
  int before;
  int after;
};

PhaseEvents EventsOf(Phase phase) {
  const int index = static_cast<int>(phase);
  return {smlEVENT_BEFORE_INPUT_PHASE + index, smlEVENT_AFTER_INPUT_PHASE + index};
}

int PhaseNumber(const HostedAgent& hosted) {
  return static_cast<int>(hosted.agent().next_phase());
}

/// The interleave step if the request does not specify one: the run's own unit; a phase for runs without end.
RunUnit InterleaveOf(const cli::RunRequest& request, bool given) {
  if (given) return request.interleave;
  return request.unit == RunUnit::kForever ? RunUnit::kPhase : request.unit;
}

bool EndsAtStopPhase(const cli::RunRequest& request) {
  return request.unit == RunUnit::kDecision || request.unit == RunUnit::kForever;
}

/// Whether StepAlone can execute the run. It cannot execute runs until a goal is removed. The interleave step of a run
/// until output must be an output. The interleave step of any other run must be a decision or a phase.
bool CanStepAlone(const cli::RunRequest& request, RunUnit interleave) {
  if (request.until_goal_removed) return false;
  if (request.unit == RunUnit::kOutput) return interleave == RunUnit::kOutput;
  return EndsAtStopPhase(request) && (interleave == RunUnit::kDecision || interleave == RunUnit::kPhase);
}

}  // namespace

kernel::RunResult RunControl::Run(HostedAgent& addressed, const cli::RunRequest& request, bool interleave_given) {
  const bool timed = addressed.session().times().on();
  const auto began = timed ? cli::RunTimes::Clock::now() : cli::RunTimes::Clock::time_point();
  // Stop requests count from the moment when others can see that there is a run.
  addressed.ClearStop();
  if (!request.self_only) {
    for (HostedAgent* hosted : host_.agents()) hosted->ClearStop();
  }
  ++number_;
  stop_requests_ = host_.stop_requests();
  running_ = true;
  run_flags_ = (request.self_only ? sml_RUN_SELF : sml_RUN_ALL) |
               (request.update_world || request.self_only ? 0 : sml_DONT_UPDATE_WORLD);
  unit_ = request.unit;
  const kernel::AgentCounters& counters = std::as_const(addressed).agent().counters();
  const kernel::RunResult before{StopReason::kCompleted, counters.decision_cycles, counters.elaborations,
                                 counters.firings};

  host_.FireSystem(smlEVENT_SYSTEM_START);
  Begin(addressed, request);
  Rounds(request, InterleaveOf(request, interleave_given));
  if (EndsAtStopPhase(request)) {
    for (Runner& runner : runners_) MoveToStopPhase(runner);
  }
  kernel::RunResult result;
  for (Runner& runner : runners_) {
    EndInterrupted(runner);
    if (runner.hosted == &addressed) result.reason = runner.reason;
    Finish(runner, EndsAtStopPhase(request) || runner.active);
    if (ClientLog* const log = runner.hosted->log; log && !runner.hosted->doomed) log->Went(*runner.hosted);
  }
  if (host_.log) host_.log->Flush();
  if (request.until_goal_removed) addressed.agent().SetGoalToWatch({});
  running_ = false;
  if (!host_.system_stop_suppressed()) host_.FireSystem(smlEVENT_SYSTEM_STOP);

  result.decisions = counters.decision_cycles - before.decisions;
  result.elaborations = counters.elaborations - before.elaborations;
  result.firings = counters.firings - before.firings;
  if (timed) {
    const auto time = cli::RunTimes::Clock::now() - began;
    for (Runner& runner : runners_) {
      if (runner.hosted->session().times().on()) runner.hosted->session().times().AddRun(time);
    }
  }
  return result;
}

void RunControl::Begin(HostedAgent& addressed, const cli::RunRequest& request) {
  runners_.clear();
  const auto add = [&](HostedAgent& hosted) {
    Runner runner;
    runner.hosted = &hosted;
    runner.remaining = request.count;
    // The advance to the stop phase executes the last decision, so an agent that has not reached it needs one cycle
    // less.
    const kernel::Agent& agent = hosted.agent();
    if (request.unit == RunUnit::kDecision && runner.remaining > 0 &&
        agent.next_phase() != agent.settings().stop_phase) {
      --runner.remaining;
    }
    if (request.unit == RunUnit::kForever) runner.remaining = 1;
    runner.generation = agent.output().generation();
    runner.active = runner.remaining > 0;
    runners_.push_back(runner);
  };
  // A run of one agent does not access others, so its cost does not depend on their number.
  if (!request.self_only) {
    for (HostedAgent* hosted : host_.agents()) add(*hosted);
  }
  if (runners_.empty()) add(addressed);
  if (request.until_goal_removed && !addressed.agent().goals().empty()) {
    addressed.agent().SetGoalToWatch(addressed.agent().goals().bottom().id);
  }
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    HostedAgent& hosted = *runners_[i].hosted;
    hosted.last_run = number_;
    hosted.in_run = true;
    hosted.agent().ClearStopRequest();
    if (hosted.agent().halted()) {
      runners_[i].active = false;
      runners_[i].reason = StopReason::kHalted;
      continue;
    }
    hosted.PrepareRun();
    // As in Soar, the agent does not count as running while clients are informed of the run.
    is_told_ = false;
    hosted.FireRun(smlEVENT_BEFORE_RUN_STARTS, PhaseNumber(hosted));
    is_told_ = true;
    hosted.run_state = sml_RUNSTATE_RUNNING;
  }
}

void RunControl::Rounds(const cli::RunRequest& request, RunUnit interleave) {
  const auto active = [](const Runner& runner) { return runner.active; };
  const bool alone = runners_.size() == 1 && CanStepAlone(request, interleave);
  for (int round = 0; std::any_of(runners_.begin(), runners_.end(), active); ++round) {
    if (alone) {
      StepAlone(runners_.front(), request, interleave);
      if (!runners_.front().active) return;
    }
    if (round % check_rate_ == 0) host_.FireSystem(smlEVENT_INTERRUPT_CHECK);
    host_.Pump();
    host_.FireSystem(smlEVENT_BEFORE_AGENTS_RUN_STEP);
    Round(request, interleave);
  }
}

void RunControl::StepAlone(Runner& runner, const cli::RunRequest& request, RunUnit interleave) {
  HostedAgent& hosted = *runner.hosted;
  kernel::Agent& agent = hosted.agent();
  const kernel::AgentCounters& counters = std::as_const(agent).counters();
  const RunUnit step = interleave == RunUnit::kPhase ? interleave : RunUnit::kDecision;
  while (runner.active) {
    if (hosted.doomed || hosted.ListensToSteps() || host_.ListensToRounds() || host_.PumpRequested()) return;
    const std::uint64_t cycles = counters.decision_cycles;
    const std::uint64_t most = request.unit == RunUnit::kOutput ? OutputsLeft(runner) : 1;
    const kernel::RunResult result = agent.Step(step, most);
    const bool cycle_ended = counters.decision_cycles != cycles;
    if (cycle_ended) AfterOutputPhase(runner);
    NoteEnd(runner, result);
    EndIfStopRequested(runner);
    if (result.decisions > 1) runner.idle_outputs += static_cast<int>(result.decisions) - 1;
    hosted.FlushPrint();
    if (runner.active) CountStep(runner, request, cycle_ended ? 1 : 0, !agent.in_middle_of_phase());
    // The effect of FireUpdates.
    runner.passed_output = runner.generated = false;
  }
  if (EndsAtStopPhase(request)) return;
  EndInterrupted(runner);
  Finish(runner, true);
}

/// The number of output phases without output until the agent's run ends.
std::uint64_t RunControl::OutputsLeft(const Runner& runner) {
  const int left = runner.hosted->agent().settings().max_nil_output_cycles - runner.idle_outputs;
  return runner.output_changed ? 1 : static_cast<std::uint64_t>(std::max(1, left));
}

void RunControl::Round(const cli::RunRequest& request, RunUnit interleave) {
  bool stop_all = false;
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    Runner& runner = runners_[i];
    if (!runner.active) continue;
    HostedAgent& hosted = *runner.hosted;
    if (hosted.doomed) {
      runner.active = false;
      continue;
    }
    const std::uint64_t cycles = hosted.agent().counters().decision_cycles;
    StepBracketed(runner, interleave);
    if (runner.active) {
      CountStep(runner, request, hosted.agent().counters().decision_cycles - cycles,
                !hosted.agent().in_middle_of_phase());
    }
    if (request.until_goal_removed && runner.reason == StopReason::kInterrupted) stop_all = true;
    if (!runner.active && !EndsAtStopPhase(request)) {
      EndInterrupted(runner);
      Finish(runner, true);
    }
  }
  if (stop_all) {
    for (Runner& runner : runners_) runner.active = false;
  }
  FireUpdates();
}

bool RunControl::StopRequested(const Runner& runner) const {
  return runner.hosted->StopRequested() || host_.stop_requests() != stop_requests_;
}

bool RunControl::OutputRunIsServed(const Runner& runner) {
  return runner.output_changed || runner.idle_outputs >= runner.hosted->agent().settings().max_nil_output_cycles;
}

void RunControl::CountStep(Runner& runner, const cli::RunRequest& request, std::uint64_t cycles, bool phase_ended) {
  switch (request.unit) {
    case RunUnit::kDecision:
      runner.remaining -= std::min(cycles, runner.remaining);
      break;
    case RunUnit::kPhase:
      runner.remaining -= phase_ended ? 1 : 0;
      break;
    case RunUnit::kElaboration:
      --runner.remaining;
      break;
    case RunUnit::kForever:
      break;
    case RunUnit::kOutput: {
      if (cycles == 0) break;
      if (!OutputRunIsServed(runner)) break;
      runner.output_changed = false;
      runner.passed_output = true;
      runner.idle_outputs = 0;
      --runner.remaining;
      break;
    }
  }
  if (runner.remaining == 0) runner.active = false;
}

void RunControl::MoveToStopPhase(Runner& runner) {
  HostedAgent& hosted = *runner.hosted;
  const bool ended = runner.reason != StopReason::kCompleted && !(runner.interrupted && !runner.told_interrupt);
  if (ended || hosted.doomed) return;
  while (hosted.agent().next_phase() != hosted.agent().settings().stop_phase) {
    StepBracketed(runner, RunUnit::kPhase);
    if (runner.reason != StopReason::kCompleted) return;
    if (hosted.doomed) return;
    FireUpdates();
  }
}

void RunControl::StepBracketed(Runner& runner, RunUnit unit) {
  HostedAgent& hosted = *runner.hosted;
  hosted.FireRun(smlEVENT_BEFORE_RUNNING, PhaseNumber(hosted));
  Step(runner, unit);
  EndIfStopRequested(runner);
  hosted.FlushPrint();
  hosted.FireRun(smlEVENT_AFTER_RUNNING, PhaseNumber(hosted));
}

void RunControl::EndIfStopRequested(Runner& runner) {
  HostedAgent& hosted = *runner.hosted;
  if (!StopRequested(runner) || hosted.doomed) return;
  runner.active = false;
  runner.interrupted = true;
  const bool arrived = hosted.agent().next_phase() == hosted.agent().settings().stop_phase;
  if (arrived) EndInterrupted(runner);
}

void RunControl::Step(Runner& runner, RunUnit unit) {
  HostedAgent& hosted = *runner.hosted;
  kernel::Agent& agent = hosted.agent();
  if (unit == RunUnit::kElaboration) {
    StepPhase(runner, false);
    return;
  }
  do {
    const std::uint64_t cycles = agent.counters().decision_cycles;
    if (hosted.ListensToPhases()) {
      StepPhase(runner, true);
    } else {
      const kernel::RunResult result = agent.Step(unit == RunUnit::kPhase ? unit : RunUnit::kDecision);
      if (agent.counters().decision_cycles != cycles) AfterOutputPhase(runner);
      NoteEnd(runner, result);
    }
    if (runner.reason != StopReason::kCompleted || hosted.doomed || unit == RunUnit::kPhase) return;
    const bool cycle_ended = agent.counters().decision_cycles != cycles;
    if (cycle_ended && (unit == RunUnit::kDecision || OutputRunIsServed(runner))) return;
  } while (!StopRequested(runner));
}

void RunControl::StepPhase(Runner& runner, bool whole) {
  HostedAgent& hosted = *runner.hosted;
  kernel::Agent& agent = hosted.agent();
  const Phase phase = agent.next_phase();
  const PhaseEvents events = EventsOf(phase);
  const int number = static_cast<int>(phase);
  const std::uint64_t cycles = agent.counters().decision_cycles;
  if (!agent.in_middle_of_phase()) {
    if (phase == Phase::kInput) hosted.FireRun(smlEVENT_BEFORE_DECISION_CYCLE, number);
    hosted.FirePhase(events.before, smlEVENT_BEFORE_PHASE_EXECUTED, number);
  }
  const kernel::RunResult result = agent.Step(whole ? RunUnit::kPhase : RunUnit::kElaboration);
  const bool ended = !agent.in_middle_of_phase() && (agent.next_phase() != phase);
  if (ended) {
    hosted.DeliverOutput();
    hosted.FirePhase(events.after, smlEVENT_AFTER_PHASE_EXECUTED, number);
  }
  if (agent.counters().decision_cycles != cycles) {
    AfterOutputPhase(runner);
    hosted.FlushPrint();
    hosted.FireRun(smlEVENT_AFTER_DECISION_CYCLE, static_cast<int>(Phase::kOutput));
  }
  NoteEnd(runner, result);
}

void RunControl::AfterOutputPhase(Runner& runner) {
  // In runs until output, an agent has passed when its run ends.
  if (unit_ != RunUnit::kOutput) runner.passed_output = true;
  if (ClientLog* const log = runner.hosted->log) log->Went(*runner.hosted);
  runner.hosted->DeliverOutput();
  const kernel::OutputLink& output = std::as_const(*runner.hosted).agent().output();
  const auto added = [](const kernel::OutputChange& change) { return change.added; };
  const bool changed = output.generation() != runner.generation;
  runner.generation = output.generation();
  // Changes that only remove elements do not count as output.
  if (changed && std::any_of(output.changes().begin(), output.changes().end(), added)) {
    runner.generated = true;
    runner.output_changed = true;
    runner.idle_outputs = 0;
  } else {
    ++runner.idle_outputs;
  }
}

void RunControl::NoteEnd(Runner& runner, const kernel::RunResult& result) {
  if (result.reason == StopReason::kCompleted) return;
  HostedAgent& hosted = *runner.hosted;
  runner.reason = result.reason;
  runner.active = false;
  runner.interrupted = result.reason != StopReason::kHalted;
  runner.told_interrupt = true;
  hosted.FireRun(smlEVENT_AFTER_INTERRUPT, PhaseNumber(hosted));
  if (result.reason == StopReason::kHalted) hosted.FireRun(smlEVENT_AFTER_HALTED, PhaseNumber(hosted));
}

void RunControl::EndInterrupted(Runner& runner) {
  if (!runner.interrupted || runner.told_interrupt) return;
  runner.told_interrupt = true;
  HostedAgent& hosted = *runner.hosted;
  hosted.FireRun(smlEVENT_AFTER_INTERRUPT, PhaseNumber(hosted));
  hosted.session().stream().Print("Interrupt received.");
}

void RunControl::FireUpdates() {
  bool any_passed = false;
  for (const Runner& runner : runners_) {
    any_passed = any_passed || runner.passed_output;
    if (runner.active && !runner.passed_output) return;
  }
  if (!any_passed) return;
  for (Runner& runner : runners_) runner.passed_output = false;
  host_.FireUpdate(smlEVENT_AFTER_ALL_OUTPUT_PHASES, run_flags_);
  for (const Runner& runner : runners_) {
    if (runner.active && !runner.generated) return;
  }
  for (Runner& runner : runners_) runner.generated = false;
  host_.FireUpdate(smlEVENT_AFTER_ALL_GENERATED_OUTPUT, run_flags_);
}

void RunControl::Finish(Runner& runner, bool tell) {
  HostedAgent& hosted = *runner.hosted;
  if (!hosted.in_run) return;
  hosted.in_run = false;
  if (runner.reason == StopReason::kHalted) {
    hosted.run_state = sml_RUNSTATE_HALTED;
    hosted.last_result = sml_RUN_ERROR;
  } else if (runner.interrupted) {
    // Runs that end because a rule interrupts or a client stops them have other results.
    hosted.run_state = sml_RUNSTATE_INTERRUPTED;
    hosted.last_result =
        runner.reason == StopReason::kInterrupted ? sml_RUN_INTERRUPTED : sml_RUN_COMPLETED_AND_INTERRUPTED;
  } else {
    hosted.run_state = sml_RUNSTATE_STOPPED;
    hosted.last_result = sml_RUN_COMPLETED;
  }
  hosted.input().Tidy();
  if (tell && !hosted.doomed) {
    hosted.FlushPrint();
    hosted.FireRun(smlEVENT_AFTER_RUN_ENDS, PhaseNumber(hosted));
    hosted.FlushXmlTrace();
  }
}

}  // namespace soarbox::server
