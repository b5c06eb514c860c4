// SPDX-License-Identifier: BSD-2-Clause
#include "record/recorder.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "sim/input_text.h"

namespace soarbox::record {

namespace {

void ObserveWorld(const sim::Simulation& simulation, sim::EventList events, world::HungThings hung,
                  TickRecord& record) {
  record.tick = simulation.tick();
  record.state_hash = simulation.StateHash();
  record.inputs.clear();
  for (const sim::Input& input : simulation.LastInputs()) record.inputs.push_back(sim::WriteInput(input));
  simulation.Snapshot(record.scene, hung);
  record.events = std::move(events);
}

/// Copies what minds did, for this level. Reuses the memory of existing records.
void ObserveMinds(const sim::Simulation& simulation, Level level, std::vector<MindRecord>& minds) {
  std::size_t count = 0;
  for (std::size_t i = 0; level != Level::kWorld && i < simulation.soar_agents(); ++i) {
    const sim::MindReport report = simulation.Mind(i);
    if (report.events.empty()) continue;
    if (count == minds.size()) minds.emplace_back();
    MindRecord& mind = minds[count++];
    mind.agent = report.agent;
    mind.events = report.events;
  }
  minds.resize(count);
}

}  // namespace

void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record) {
  ObserveWorld(simulation, std::move(events), world::HungThings::kPlaced, record);
  ObserveMinds(simulation, level, record.minds);
  KeepLevel(record, level);
}

Recorder::Recorder(std::unique_ptr<Writer> writer, Level level, std::size_t records)
    : writer_(std::move(writer)), level_(level), unused_(records) {
  try {
    thread_ = std::thread([this] { Write(); });
  } catch (const std::system_error&) {
    // There are too many threads, or the platform has no threads.
  }
}

Recorder::~Recorder() {
  (void)Finish();  // There is no caller to report an error to.
}

void KeepLevel(TickRecord& record, Level level) {
  if (level == Level::kAll) return;
  if (level == Level::kWorld) record.minds.clear();
  for (MindRecord& mind : record.minds) mind.events.DropDetails();
  std::erase_if(record.minds, [](const MindRecord& mind) { return mind.events.empty(); });
}

/// Returns a record to fill in, which is not in use. Waits until there is one; after a failure, there may be none.
TickRecord& Recorder::Blank() {
  if (blank_) return *blank_;
  std::unique_lock lock(mutex_);
  if (written_.empty() && unused_ == 0 && !failure_) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    is_waited_for_ = true;
    has_room_.wait(lock, [&] { return !written_.empty() || failure_; });
    is_waited_for_ = false;
    ++waits_.ticks;
    waits_.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }
  if (written_.empty()) {
    blank_.emplace();
    if (unused_ > 0) --unused_;
    return *blank_;
  }
  // The record that was used last is the most likely to be in a cache of the processor.
  blank_.emplace(std::move(written_.back()));
  written_.pop_back();
  return *blank_;
}

Result<void> Recorder::Take(const sim::Simulation& simulation, sim::EventList events, const TickRecord* seen) {
  if (is_told_) return {};
  TickRecord& tick = Blank();
  if (seen != nullptr) {
    tick.tick = seen->tick;
    tick.state_hash = seen->state_hash;
    tick.inputs = seen->inputs;
    tick.scene = seen->scene;
    tick.events = std::move(events);
  } else {
    // The file stores the bones on which things hang, not the positions of these things.
    ObserveWorld(simulation, std::move(events), world::HungThings::kNotPlaced, tick);
  }
  ObserveMinds(simulation, level_, tick.minds);
  return Push();
}

Result<void> Recorder::Take(TickRecord record) {
  if (is_told_) return {};
  Blank() = std::move(record);
  return Push();
}

/// Passes the record that was filled in to the writing thread.
Result<void> Recorder::Push() {
  if (!thread_.joinable()) Write(*blank_);
  const std::lock_guard lock(mutex_);
  if (failure_) {
    is_told_ = true;
    return *failure_;
  }
  if (!thread_.joinable()) {
    written_.push_back(std::move(*blank_));
    blank_.reset();
    return {};
  }
  waiting_.push_back(std::move(*blank_));
  blank_.reset();
  if (waiting_.size() == 1) has_work_.notify_one();
  return {};
}

Result<void> Recorder::Finish() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(is_over_, true)) return {};
  }
  if (thread_.joinable()) {
    has_work_.notify_one();
    thread_.join();
  } else {
    Flush();
  }
  if (failure_ && !is_told_) return *failure_;
  return {};
}

/// Writes one tick, and clears it so that its memory can be reused.
void Recorder::Write(TickRecord& tick) {
  // A window records more details of the selected agent than its recording should contain.
  KeepLevel(tick, level_);
  const Result<void> added = writer_->AddAndSwap(tick);
  if (added) return tick.events.clear();
  const std::lock_guard lock(mutex_);
  failure_ = added.error();
}

void Recorder::Flush() {
  if (failure_) return;
  Result<void> done = writer_->Flush();
  if (done && waits_.ticks > 0) done = writer_->AddWaits(waits_);
  if (!done) failure_ = done.error();
}

/// The writing thread. It takes all waiting ticks at once, so that it rarely locks, and returns each as soon as it is
/// written.
void Recorder::Write() {
  std::deque<TickRecord> taken;
  std::unique_lock lock(mutex_);
  while (true) {
    has_work_.wait(lock, [&] { return !waiting_.empty() || is_over_; });
    if (waiting_.empty()) break;
    taken.swap(waiting_);
    for (; !taken.empty() && !failure_; taken.pop_front()) {
      lock.unlock();
      // Cleared here, so that the run's thread does not have to.
      Write(taken.front());
      lock.lock();
      written_.push_back(std::move(taken.front()));
      if (is_waited_for_) has_room_.notify_one();
    }
    if (failure_) break;
  }
  if (is_waited_for_) has_room_.notify_one();
  lock.unlock();
  Flush();
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
