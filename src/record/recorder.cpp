// SPDX-License-Identifier: BSD-2-Clause
#include "record/recorder.h"

#include <span>
#include <utility>

#include "sim/input_text.h"

namespace soarbox::record {

void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record) {
  record.tick = simulation.tick();
  record.state_hash = simulation.StateHash();
  record.inputs.clear();
  for (const sim::Input& input : simulation.LastInputs()) record.inputs.push_back(sim::WriteInput(input));
  record.scene = simulation.Snapshot();
  record.events = std::move(events);
  record.minds.clear();
  if (level == Level::kWorld) return;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    sim::MindReport report = simulation.Mind(i);
    if (report.percepts.empty() && report.decisions.empty() && report.details.empty() && report.commands.empty())
      continue;
    const auto texts = [](std::span<const std::string> lines) {
      return std::vector<std::string>(lines.begin(), lines.end());
    };
    record.minds.push_back({std::move(report.agent), texts(report.percepts), texts(report.decisions),
                            texts(report.details), texts(report.commands), texts(report.reasons),
                            texts(report.command_rules)});
  }
}

Recorder::Recorder(std::unique_ptr<Writer> writer, Level level)
    : writer_(std::move(writer)), level_(level), thread_([this] { Write(); }) {}

Recorder::~Recorder() {
  (void)Finish();  // Nobody is left to be told.
}

Result<void> Recorder::Take(const sim::Simulation& simulation, sim::EventList events) {
  if (is_told_) return {};
  TickRecord record;
  Observe(simulation, std::move(events), level_, record);
  return Take(std::move(record));
}

Result<void> Recorder::Take(TickRecord record) {
  if (is_told_) return {};
  // A run that is faster than the disk waits for it here.
  constexpr std::size_t kMostWaiting = 120;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < kMostWaiting || failure_; });
  if (failure_) {
    is_told_ = true;
    return *failure_;
  }
  waiting_.push_back(std::move(record));
  if (waiting_.size() == 1) changed_.notify_all();
  return {};
}

Result<void> Recorder::Finish() {
  if (!thread_.joinable()) return {};
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
  if (failure_ && !is_told_) return *failure_;
  return {};
}

/// The writing thread. Ticks that wait are taken all at once, so that the run is seldom disturbed.
void Recorder::Write() {
  std::deque<TickRecord> taken;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return !waiting_.empty() || is_over_; });
      if (waiting_.empty()) break;
      taken.swap(waiting_);
    }
    changed_.notify_all();
    for (const TickRecord& record : taken) {
      const Result<void> added = writer_->Add(record);
      if (added) continue;
      const std::lock_guard lock(mutex_);
      failure_ = added.error();
      break;
    }
    taken.clear();
    if (failure_) break;
  }
  changed_.notify_all();
  if (failure_) return;
  if (const Result<void> flushed = writer_->Flush(); !flushed) failure_ = flushed.error();
}

sim::MindDetail DetailOf(Level level) {
  switch (level) {
    case Level::kWorld:
      return sim::MindDetail::kNone;
    case Level::kDecisions:
      return sim::MindDetail::kDecisions;
    case Level::kAll:
      return sim::MindDetail::kAll;
  }
  return sim::MindDetail::kNone;
}

}  // namespace soarbox::record
