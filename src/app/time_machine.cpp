// SPDX-License-Identifier: BSD-2-Clause
#include "app/time_machine.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soarbox::app {

TimeMachine::TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings)
    : scenario_(std::move(scenario)), settings_(std::move(settings)) {
  settings_.soar.port = 0;  // The port belongs to the live run.
  // Panels look into any mind of the past; and one that is asked to note more later tells its goal stack anew.
  settings_.mind_detail = sim::MindDetail::kAll;
  histories_.push_back(std::make_unique<record::History>(header));
}

void TimeMachine::Add(const record::TickRecord& tick) {
  history().Add(tick);
  if (futures_) futures_->See(tick);
}

void TimeMachine::Seek(std::uint64_t tick) {
  if (empty()) return;
  tick = std::clamp(tick, first_tick(), last_tick());
  if (tick == last_tick()) return GoLive();
  if (shown_ == tick) return;
  shown_ = tick;
  trouble_.clear();
  // A world that is on its way to an earlier tick can go on; it never goes back.
  branch_.reset();
}

void TimeMachine::GoLive() {
  shown_.reset();
  branch_.reset();
  trouble_.clear();
}

const record::TickRecord* TimeMachine::Shown() {
  if (empty()) return nullptr;
  const Result<const record::TickRecord*> record = history().At(shown_tick());
  return record ? *record : nullptr;
}

void TimeMachine::Rebuild(double most_s) {
  if (!shown_ || !trouble_.empty()) return;
  if (branch_ == nullptr) {
    Result<std::unique_ptr<record::Branch>> begun = record::Branch::Begin(history(), scenario_, settings_, *shown_);
    if (!begun) {
      trouble_ = begun.error().message;
      return;
    }
    branch_ = std::move(*begun);
  }
  const auto begin = std::chrono::steady_clock::now();
  while (!branch_->IsThere() &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < most_s) {
    if (const Result<void> advanced = branch_->Advance(5); !advanced) {
      trouble_ = advanced.error().message;
      branch_.reset();
      return;
    }
  }
}

sim::Simulation* TimeMachine::past() {
  return branch_ != nullptr && branch_->IsThere() ? &branch_->simulation() : nullptr;
}

std::string TimeMachine::PastNote() const {
  if (!trouble_.empty()) return "The mind at this moment cannot be rebuilt: " + trouble_;
  const std::uint64_t at = branch_ != nullptr ? branch_->tick() : 0, goal = std::max<std::uint64_t>(1, shown_tick());
  return "Rebuilding the minds of this moment: " + std::to_string(100 * at / goal) + " %";
}

std::unique_ptr<sim::Simulation> TimeMachine::Resume() {
  if (past() == nullptr) return nullptr;
  const std::uint64_t tick = *shown_;
  std::unique_ptr<sim::Simulation> simulation = branch_->TakeSimulation();
  futures_.emplace(branch_->CompareFutures());
  branch_tick_ = tick;
  histories_.push_back(history().UpTo(tick));
  GoLive();
  return simulation;
}

}  // namespace soarbox::app
