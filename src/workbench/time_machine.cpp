// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/time_machine.h"

#include <algorithm>
#include <utility>

namespace soarbox::workbench {
namespace {

/// The settings for simulating a live run again.
sim::SimulationSettings ForThePast(sim::SimulationSettings settings) {
  settings.soar.port = 0;  // The port belongs to the live run.
  // Panels can inspect any mind of the past. If the detail of a mind were increased later, its goal stack would be
  // reported again.
  settings.mind_detail = sim::MindDetail::kAll;
  return settings;
}

}  // namespace

TimeMachine::TimeMachine(const record::Header& header, sim::Scenario scenario, sim::SimulationSettings settings)
    : rebuilt_(RebuiltWorld::Way::kToOneTick,
               [this, scenario = std::move(scenario), settings = ForThePast(std::move(settings))](std::uint64_t tick) {
                 return record::Branch::Begin(history(), scenario, settings, tick);
               }) {
  histories_.push_back(std::make_unique<record::History>(header));
}

TimeMachine::TimeMachine(record::TickSource& recording, const sim::DataFolders& data, std::uint64_t first,
                         std::uint64_t last)
    : recording_(&recording),
      first_(first),
      last_(last),
      shown_(first),
      rebuilt_(RebuiltWorld::Way::kOnward, [this, data](std::uint64_t) {
        // The branch can continue to the end of the recording, whatever tick is requested first.
        auto begun = record::Branch::Begin(*recording_, data, recording_->last_tick());
        if (begun && !std::exchange(has_warned_, true)) warnings_ = (*begun)->warnings();
        return begun;
      }) {
  rebuilt_.Aim(first);
}

void TimeMachine::Add(const record::TickRecord& tick) {
  history().Add(tick);
  if (parting_) parting_->futures.See(tick);
}

void TimeMachine::Seek(std::uint64_t tick) {
  if (empty()) return;
  tick = std::clamp(tick, first_tick(), last_tick());
  if (recording_ == nullptr && tick == last_tick()) return GoLive();
  if (shown_ == tick) return;
  shown_ = tick;
  rebuilt_.Aim(tick);
}

void TimeMachine::GoLive() {
  if (recording_ != nullptr) return Seek(last_);
  shown_.reset();
  rebuilt_.GiveUp();
}

const record::TickRecord* TimeMachine::Shown() {
  return empty() ? nullptr : At(shown_tick());
}

const record::TickRecord* TimeMachine::At(std::uint64_t tick) {
  const Result<const record::TickRecord*> record = timeline().At(tick);
  return record ? *record : nullptr;
}

std::unique_ptr<sim::Simulation> TimeMachine::Resume() {
  if (rebuilt_.world() == nullptr || recording_ != nullptr) return nullptr;
  const std::uint64_t tick = *shown_;
  const std::uint32_t number = parting_ ? parting_->number + 1 : 1;
  const record::TickRecord* const shown = Shown();
  record::TickRecord record = shown != nullptr ? *shown : record::TickRecord();
  const std::unique_ptr<record::Branch> branch = rebuilt_.Take();
  std::unique_ptr<sim::Simulation> simulation = branch->TakeSimulation();
  record::Futures futures = branch->CompareFutures();
  histories_.push_back(history().UpTo(tick));
  Result<std::vector<record::TickInputs>> inputs = history().Inputs();
  parting_.reset();  // Futures contain references, so they cannot be assigned.
  parting_.emplace(Parting{number, tick, std::move(record),
                           inputs ? std::move(*inputs) : std::vector<record::TickInputs>(), std::move(futures)});
  GoLive();
  return simulation;
}

}  // namespace soarbox::workbench
