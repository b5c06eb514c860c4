// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/run_control.h"

#include <algorithm>
#include <utility>

#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {

// Phases --------------------------------------------------------------------------------------------------------------

void RunControl::BeginPhase() {
  core_.observers.Notify(Event::kPhase, [&](Observer& o) { o.OnPhaseBegin(core_.agent, phase_); });
}

namespace {

void CountPhase(AgentCore& core) {
  AgentCounters& counters = core.counters;
  ++counters.phases;
  const std::uint64_t size = core.memory.wme_count();
  counters.wm_size_sum += size;
  counters.wm_size_maximum = std::max(counters.wm_size_maximum, size);
}

}  // namespace

void RunControl::EndPhase(Phase next) {
  const Phase ended = phase_;
  in_middle_ = false;
  phase_ = next;
  CountPhase(core_);
  core_.observers.Notify(Event::kPhase, [&](Observer& o) { o.OnPhaseEnd(core_.agent, ended); });
  StopIfBroken();
  if (next == Phase::kInput) core_.SweepSymbols();
  core_.CheckAfterPhase();
}

void RunControl::InputPhase() {
  AgentCounters& counters = core_.counters;
  cycle_wme_changes_ = counters.wme_additions + counters.wme_removals;
  cycle_firings_ = counters.firings;
  if (core_.settings.max_decision_time_us > 0) cycle_began_ = std::chrono::steady_clock::now();
  core_.observers.Notify(Event::kPhase, [&](Observer& o) { o.OnDecisionCycleBegin(core_.agent); });
  BeginPhase();
  if (core_.modules.Wants(ModuleHook::kInput)) core_.modules.Input();
  core_.input.Apply(InputIsUnheard());
  core_.elaboration.ApplyBufferedChanges();
  EndPhase(Phase::kPropose);
}

bool RunControl::InputIsUnheard() const {
  if (core_.observers.Wants(Event::kWme) || core_.modules.Wants(ModuleHook::kFlush) ||
      core_.modules.Wants(ModuleHook::kAttributes)) {
    return false;
  }
  for (GoalLevel level = 0; level <= core_.goals.depth(); ++level) {
    if (core_.rete.matches().HasRetractions(level)) return false;
  }
  return true;
}

bool RunControl::ElaboratePhase(bool apply) {
  Elaboration& elaboration = core_.elaboration;
  Elaboration::Next next = Elaboration::Next::kElaborate;
  if (!in_middle_) {
    in_middle_ = true;
    BeginPhase();
    elaboration.BeginPhase();
    next = elaboration.Determine(apply);
  }
  if (next == Elaboration::Next::kElaborate) {
    elaboration.Run(apply);
    if (core_.modules.Wants(ModuleHook::kAfterElaboration)) core_.modules.AfterElaboration();
    next = elaboration.Determine(apply);
  }
  if (next == Elaboration::Next::kElaborate) return false;
  EndPhase(apply ? Phase::kOutput : Phase::kDecide);
  return true;
}

void RunControl::DecidePhase() {
  BeginPhase();
  ++core_.counters.decision_phases;
  core_.decision.Decide();
  // States may have been removed at the end of the propose phase. Frees here, not in the next elaboration, what they
  // held.
  core_.elaboration.ApplyWorkingMemoryChanges();
  if (core_.observers.Wants(Event::kDecision)) {
    const GoalInfo info = core_.descriptions.Describe(core_.goals.bottom());
    const std::uint64_t number = core_.counters.decision_phases;
    core_.observers.Notify(Event::kDecision, [&](Observer& o) { o.OnDecision(core_.agent, info, number); });
  }
  if (core_.modules.Wants(ModuleHook::kAfterDecision)) core_.modules.AfterDecision();
  EndPhase(Phase::kApply);
}

void RunControl::OutputPhase() {
  BeginPhase();
  output_changed_ = core_.output.Collect();
  if (output_changed_) core_.observers.Notify(Event::kOutput, [&](Observer& o) { o.OnOutput(core_.agent); });
  if (core_.modules.Wants(ModuleHook::kOutput)) core_.modules.Output(output_changed_);
  if (core_.modules.Wants(ModuleHook::kOutputEnd)) core_.modules.OutputEnd();
  AgentCounters& counters = core_.counters;
  ++counters.decision_cycles;
  const std::uint64_t changes = counters.wme_additions + counters.wme_removals - cycle_wme_changes_;
  if (changes > counters.max_wme_changes) {
    counters.max_wme_changes = changes;
    counters.max_wme_changes_cycle = counters.decision_cycles;
  }
  if (counters.firings - cycle_firings_ > counters.max_firings) {
    counters.max_firings = counters.firings - cycle_firings_;
    counters.max_firings_cycle = counters.decision_cycles;
  }
  EndPhase(Phase::kInput);
  core_.observers.Notify(Event::kPhase, [&](Observer& o) { o.OnDecisionCycleEnd(core_.agent); });
  const std::int64_t limit = core_.settings.max_decision_time_us;
  if (limit > 0) {
    const auto spent = std::chrono::steady_clock::now() - cycle_began_;
    if (std::chrono::duration_cast<std::chrono::microseconds>(spent).count() > limit) {
      core_.observers.Warn(WarningKind::kMaxDecisionTime, "the decision cycle took longer than max-dc-time");
      RequestStop("max-dc-time");
    }
  }
}

bool RunControl::Advance() {
  switch (phase_) {
    case Phase::kInput:
      InputPhase();
      return true;
    case Phase::kPropose:
      return ElaboratePhase(false);
    case Phase::kDecide:
      DecidePhase();
      return true;
    case Phase::kApply:
      return ElaboratePhase(true);
    case Phase::kOutput:
      break;
  }
  OutputPhase();
  return true;
}

// Stopping ------------------------------------------------------------------------------------------------------------

void RunControl::RequestStop(std::string_view reason) {
  {
    const std::lock_guard<std::mutex> lock(reason_mutex_);
    reason_ = reason;
  }
  stop_.store(true, std::memory_order_relaxed);
}

void RunControl::ClearStop() {
  stop_.store(false, std::memory_order_relaxed);
}

void RunControl::TellInterrupts() {
  for (const std::uint32_t rule : core_.rete.matches().TakeInterrupting()) {
    const auto id = static_cast<ProductionId>(rule);
    const std::uint32_t count = ++core_.interrupts[id];
    core_.observers.Notify(Event::kRun, [&](Observer& o) { o.OnRuleInterrupt(core_.agent, id, count); });
    rule_interrupt_ = running_;
    action_interrupt_ = false;
  }
}

void RunControl::GoalStackLimit() {
  goal_stack_limit_ = true;
  core_.observers.Warn(WarningKind::kGoalStackLimit, "Goal stack depth exceeded");
}

void RunControl::WatchGoal(Symbol goal) {
  watched_goal_ = goal;
}

bool RunControl::Stop() {
  if (halt_requested_ && core_.goals.depth() >= static_cast<std::size_t>(core_.settings.max_goal_depth)) {
    // As in Soar 9.6.3, the reported reason is then the depth, and the agent may run again.
    halt_requested_ = false;
    goal_stack_limit_ = true;
  }
  if (halt_requested_) {
    halt_requested_ = false;
    halted_ = true;
    if (in_middle_) CountPhase(core_);  // The phase will not end regularly.
    if (core_.modules.Wants(ModuleHook::kHalt)) core_.modules.Halted();
    core_.observers.Notify(Event::kRun, [&](Observer& o) { o.OnHalt(core_.agent); });
    return true;
  }
  if (goal_stack_limit_) {
    goal_stack_limit_ = false;
    ended_ = limit_reached_ = true;
    if (core_.modules.Wants(ModuleHook::kHalt)) core_.modules.Halted();
    core_.observers.Notify(Event::kRun, [&](Observer& o) { o.OnInterrupt(core_.agent, "goal stack limit"); });
    return true;
  }
  if (rule_interrupt_ && (!in_middle_ || by_elaboration_)) {
    rule_interrupt_ = false;
    ended_ = true;
    const std::string why = std::exchange(interrupt_reason_, {});
    const std::string_view reason = !why.empty()         ? std::string_view(why)
                                    : !action_interrupt_ ? ":interrupt"
                                    : by_phase_          ? "(interrupt), by phases"
                                                         : "(interrupt)";
    core_.observers.Notify(Event::kRun, [&](Observer& o) { o.OnInterrupt(core_.agent, reason); });
    return true;
  }
  if (stop_.load(std::memory_order_relaxed)) {
    std::string reason;
    {
      const std::lock_guard<std::mutex> lock(reason_mutex_);
      reason = reason_;
    }
    ClearStop();
    ended_ = true;
    core_.observers.Notify(Event::kRun, [&](Observer& o) { o.OnInterrupt(core_.agent, reason); });
    return true;
  }
  return false;
}

// Running -------------------------------------------------------------------------------------------------------------

RunControl::Start RunControl::Begin() {
  if (core_.rules_changed) core_.OfferRules();
  running_ = true;
  ended_ = limit_reached_ = rule_interrupt_ = by_elaboration_ = by_phase_ = false;
  return {core_.counters.decision_cycles, core_.counters.elaborations, core_.counters.firings};
}

RunResult RunControl::Finish(const Start& start) {
  running_ = false;
  RunResult result;
  result.reason = halted_          ? StopReason::kHalted
                  : limit_reached_ ? StopReason::kLimit
                  : ended_         ? StopReason::kInterrupted
                                   : StopReason::kCompleted;
  result.decisions = core_.counters.decision_cycles - start.decisions;
  result.elaborations = core_.counters.elaborations - start.elaborations;
  result.firings = core_.counters.firings - start.firings;
  return result;
}

bool RunControl::RunOneDecision() {
  const AgentCounters& counters = core_.counters;
  const std::uint64_t elaborations = counters.elaborations;
  const bool whole = phase_ == Phase::kInput && !in_middle_;
  std::uint64_t changes = 0;
  do {
    Advance();
    if (CheckStop()) return false;
    if (phase_ == Phase::kPropose && !in_middle_) changes = counters.wme_additions + counters.wme_removals;
  } while (phase_ != Phase::kInput || in_middle_);
  return whole && IsIdle(changes, elaborations);
}

// If a decision began with the input phase and changed nothing after it, the next one cannot differ: all slots and
// goals were checked, and no random choice was made.
bool RunControl::IsIdle(std::uint64_t changes_before, std::uint64_t elaborations_before) const {
  const AgentCounters& counters = core_.counters;
  const auto wants = [&](auto... hooks) { return (core_.modules.Wants(hooks) || ...); };
  constexpr EventMask kEachDecision = Event::kPhase | Event::kElaboration | Event::kDecisionTrace;
  return counters.elaborations == elaborations_before &&
         counters.wme_additions + counters.wme_removals == changes_before && !output_changed_ &&
         (core_.observers.mask() & kEachDecision) == 0 &&
         !wants(ModuleHook::kInput, ModuleHook::kAfterDecision, ModuleHook::kOutput, ModuleHook::kOutputEnd) &&
         !core_.exploration.auto_reduce && core_.settings.max_decision_time_us <= 0 &&
         core_.settings.max_elaborations > 0;
}

/// Counts decisions as if they had been executed: each ends all phases.
void RunControl::CountIdle(std::uint64_t decisions) {
  AgentCounters& counters = core_.counters;
  constexpr std::uint64_t kPhases = 5;
  counters.decision_phases += decisions;
  counters.decision_cycles += decisions;
  counters.phases += kPhases * decisions;
  counters.wm_size_sum += kPhases * decisions * core_.memory.wme_count();
}

void RunControl::RunOneOutput() {
  for (int idle = 0; idle < std::max(1, core_.settings.max_nil_output_cycles); ++idle) {
    RunOneDecision();
    if (MustEnd() || output_changed_) return;
  }
}

RunResult RunControl::Step(RunUnit unit, std::uint64_t most) {
  if (running_ || halted_) {
    RunResult refused;
    refused.reason = halted_ ? StopReason::kHalted : StopReason::kInterrupted;
    return refused;
  }
  const Start start = Begin();
  by_phase_ = unit == RunUnit::kPhase || unit == RunUnit::kForever;
  switch (unit) {
    case RunUnit::kElaboration:
      by_elaboration_ = true;
      Advance();
      CheckStop();
      break;
    case RunUnit::kPhase:
      while (!Advance()) {
        if (CheckStop()) return Finish(start);
      }
      CheckStop();
      break;
    case RunUnit::kDecision:
      if (RunOneDecision() && most > 1) CountIdle(most - 1);
      break;
    case RunUnit::kOutput:
      RunOneOutput();
      break;
    case RunUnit::kForever:
      do {
        RunOneDecision();
      } while (!MustEnd());
      break;
  }
  return Finish(start);
}

RunResult RunControl::RunToPhase(Phase phase) {
  if (running_ || halted_) return Step(RunUnit::kPhase);
  const Start start = Begin();
  while (phase_ != phase || in_middle_) {
    Advance();
    if (CheckStop()) break;
  }
  return Finish(start);
}

RunResult RunControl::Run(RunUnit unit, std::uint64_t count) {
  if (running_ || halted_) return Step(unit);
  RunResult total;
  const auto add = [&](const RunResult& part) {
    total.reason = part.reason;
    total.decisions += part.decisions;
    total.elaborations += part.elaborations;
    total.firings += part.firings;
    return part.reason == StopReason::kCompleted;
  };
  if (unit == RunUnit::kForever) {
    add(Step(RunUnit::kForever));
    return total;
  }
  if (unit != RunUnit::kDecision) {
    while (count-- > 0 && add(Step(unit))) {
    }
    return total;
  }
  // A decision run ends before the stop phase; a run that begins there executes one full cycle.
  const Phase stop = core_.settings.stop_phase;
  for (; count > 0; --count) {
    if (phase_ == stop && !in_middle_ && !add(Step(RunUnit::kPhase))) return total;
    if (!add(RunToPhase(stop))) return total;
  }
  return total;
}

void RunControl::Clear() {
  phase_ = Phase::kInput;
  in_middle_ = false;
  halted_ = halt_requested_ = goal_stack_limit_ = ended_ = output_changed_ = rule_interrupt_ = false;
  watched_goal_ = Symbol();
  ClearStop();
}

}  // namespace soarbox::kernel
