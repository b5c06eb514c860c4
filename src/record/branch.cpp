// SPDX-License-Identifier: BSD-2-Clause
#include "record/branch.h"

#include <fmt/format.h>

#include <utility>

#include "diagnostics/problem.h"
#include "record/recorder.h"

namespace soarbox::record {
namespace {

constexpr std::uint64_t kTicksBetweenChecks = 30;

}  // namespace

Branch::Branch(TickSource& past, Rerun rerun, std::uint64_t tick)
    : past_(past),
      simulation_(std::move(rerun.simulation)),
      warnings_(std::move(rerun.warnings)),
      level_(past.header().level),
      goal_(tick),
      comparer_(past.header().step_s) {}

Result<std::unique_ptr<Branch>> Branch::Begin(TickSource& past, Result<Rerun> rerun, std::uint64_t tick) {
  if (!rerun) return rerun.error();
  std::unique_ptr<Branch> branch(new Branch(past, std::move(*rerun), tick));
  if (const Result<void> checked = branch->Check(); !checked) return checked.error();
  return branch;
}

Result<std::unique_ptr<Branch>> Branch::Begin(TickSource& past, const sim::Scenario& scenario,
                                              const sim::SimulationSettings& settings, std::uint64_t tick) {
  if (tick > past.last_tick()) return NotThere(past, tick);
  return Begin(past, Restart(past, scenario, settings, {.last_tick = tick}), tick);
}

Result<std::unique_ptr<Branch>> Branch::Begin(TickSource& past, const sim::DataFolders& data, std::uint64_t tick,
                                              int threads) {
  if (tick > past.last_tick()) return NotThere(past, tick);
  return Begin(past, Restart(past, data, {.last_tick = tick, .threads = threads}), tick);
}

Result<void> Branch::Advance(std::uint64_t most_ticks) {
  for (; most_ticks > 0 && tick_ < goal_; --most_ticks) {
    simulation_->Tick();
    ++tick_;
    if (const Result<void> checked = Check(); !checked) return checked;
  }
  return {};
}

/// Called after each tick.
Result<void> Branch::Check() {
  sim::EventList events = simulation_->TakeEvents();  // Drops the events: they were reported in the original run.
  for (std::size_t i = 0; i < simulation_->soar_agents(); ++i) {
    const sim::MindReport mind = simulation_->Mind(i);
    if (!mind.events.empty()) comparer_.Share(mind.agent, mind.events);
  }
  const bool is_goal = tick_ == goal_;
  if (!is_goal && tick_ % kTicksBetweenChecks != 0) return {};
  is_checked_ = is_goal;
  if (!past_.Holds(tick_)) return {};
  const Result<const TickRecord*> recorded = past_.At(tick_);
  if (!recorded) return recorded.error();
  TickRecord now;
  Observe(*simulation_, std::move(events), level_, now);
  const std::optional<Difference> difference = FirstDifference(**recorded, now, past_.header().own_kernel);
  if (!difference) return {};
  return ProblemIn(
      past_.name(),
      fmt::format("simulated again, the run has another state at tick {}: {}{} was {} and is {}", tick_,
                  difference->agent.empty() ? "" : difference->agent + "'s ", difference->element, difference->recorded,
                  difference->now),
      warnings_.empty() ? "`soarbox verify` reports the first tick that differs" : warnings_.front().message);
}

Futures Branch::CompareFutures() const {
  return {past_, comparer_};
}

void Futures::See(const TickRecord& now) {
  if (const TickRecord* then = Old(now.tick)) comparer_.See(*then, now);
}

const TickRecord* Futures::Old(std::uint64_t tick) {
  if (!old_.Holds(tick)) return nullptr;
  const Result<const TickRecord*> record = old_.At(tick);
  return record ? *record : nullptr;
}

}  // namespace soarbox::record
