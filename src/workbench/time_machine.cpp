// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/time_machine.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace soarbox::workbench {

TimeMachine::TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings)
    : scenario_(std::move(scenario)), settings_(std::move(settings)) {
  settings_.soar.port = 0;  // The port belongs to the live run.
  // Panels look into any mind of the past; and one that is asked to note more later tells its goal stack anew.
  settings_.mind_detail = sim::MindDetail::kAll;
  histories_.push_back(std::make_unique<record::History>(header));
}

TimeMachine::TimeMachine(record::TickSource& recording, const sim::DataFolders& data, std::uint64_t first,
                         std::uint64_t last)
    : recording_(&recording), data_(data), first_(first), last_(last), shown_(first) {}

void TimeMachine::Add(const record::TickRecord& tick) {
  history().Add(tick);
  if (futures_) futures_->See(tick);
}

void TimeMachine::Seek(std::uint64_t tick) {
  if (empty()) return;
  tick = std::clamp(tick, first_tick(), last_tick());
  if (recording_ == nullptr && tick == last_tick()) return GoLive();
  if (shown_ == tick) return;
  shown_ = tick;
  if (recording_ != nullptr) {
    // That it cannot be simulated again stays so. A world of it goes on with what is shown; it never goes back.
    if (branch_ != nullptr && (branch_->tick() > tick || std::exchange(is_spoilt_, false))) branch_.reset();
    return;
  }
  trouble_.clear();
  branch_.reset();
}

void TimeMachine::GoLive() {
  if (recording_ != nullptr) return Seek(last_);
  shown_.reset();
  branch_.reset();
  trouble_.clear();
}

const record::TickRecord* TimeMachine::Shown() {
  return empty() ? nullptr : At(shown_tick());
}

const record::TickRecord* TimeMachine::At(std::uint64_t tick) {
  record::TickSource& timeline = recording_ != nullptr ? *recording_ : history();
  const Result<const record::TickRecord*> record = timeline.At(tick);
  return record ? *record : nullptr;
}

Result<std::unique_ptr<record::Branch>> TimeMachine::Begin() {
  if (recording_ == nullptr) return record::Branch::Begin(history(), scenario_, settings_, *shown_);
  // It goes on with what is shown, up to the end.
  Result<std::unique_ptr<record::Branch>> begun = record::Branch::Begin(*recording_, data_, recording_->last_tick());
  if (begun && !std::exchange(has_warned_, true)) warnings_ = (*begun)->warnings();
  return begun;
}

void TimeMachine::Rebuild(double most_s) {
  if (!shown_ || !trouble_.empty()) return;
  if (branch_ == nullptr) {
    Result<std::unique_ptr<record::Branch>> begun = Begin();
    if (!begun) {
      trouble_ = begun.error().message;
      return;
    }
    branch_ = std::move(*begun);
  }
  const auto begin = std::chrono::steady_clock::now();
  constexpr std::uint64_t kAtOnce = 5;
  while (branch_->tick() < *shown_ &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < most_s) {
    const std::uint64_t ticks = std::min(kAtOnce, *shown_ - branch_->tick());
    if (const Result<void> advanced = branch_->Advance(ticks); !advanced) {
      trouble_ = advanced.error().message;
      branch_.reset();
      return;
    }
  }
}

sim::Simulation* TimeMachine::past() {
  const bool is_there =
      branch_ != nullptr && shown_ && branch_->tick() == *shown_ && (recording_ != nullptr || branch_->IsThere());
  return is_there ? &branch_->simulation() : nullptr;
}

std::string TimeMachine::PastNote() const {
  if (!trouble_.empty()) return "The mind at this moment cannot be rebuilt: " + trouble_;
  const std::uint64_t at = branch_ != nullptr ? branch_->tick() : 0, goal = std::max<std::uint64_t>(1, shown_tick());
  return "Rebuilding the minds of this moment: " + std::to_string(100 * at / goal) + " %";
}

std::vector<record::TickInputs> TimeMachine::Inputs() const {
  Result<std::vector<record::TickInputs>> inputs = history().Inputs();
  return inputs ? std::move(*inputs) : std::vector<record::TickInputs>();
}

std::unique_ptr<sim::Simulation> TimeMachine::Resume() {
  if (past() == nullptr || recording_ != nullptr) return nullptr;
  const std::uint64_t tick = *shown_;
  std::unique_ptr<sim::Simulation> simulation = branch_->TakeSimulation();
  futures_.emplace(branch_->CompareFutures());
  branch_tick_ = tick;
  if (const record::TickRecord* record = Shown()) branch_record_ = *record;
  histories_.push_back(history().UpTo(tick));
  GoLive();
  return simulation;
}

}  // namespace soarbox::workbench
