// SPDX-License-Identifier: BSD-2-Clause
#include "record/recorder.h"

#include <utility>

#include "sim/input_text.h"

namespace soarbox::record {

namespace {

void ObserveWorld(const sim::Simulation& simulation, sim::EventList events, TickRecord& record) {
  record.tick = simulation.tick();
  record.state_hash = simulation.StateHash();
  record.inputs.clear();
  for (const sim::Input& input : simulation.LastInputs()) record.inputs.push_back(sim::WriteInput(input));
  simulation.Snapshot(record.scene);
  record.events = std::move(events);
  record.minds.clear();
}

/// Adds what a mind did, in words, if it did anything that this level tells.
void AddMind(const std::string& agent, const sim::MindNotes& notes, Level level, TickRecord& record) {
  sim::MindWords words = notes.Words(level == Level::kAll);
  if (words.percepts.empty() && words.decisions.empty() && words.details.empty() && words.commands.empty()) return;
  record.minds.push_back({agent, std::move(words.percepts), std::move(words.decisions), std::move(words.details),
                          std::move(words.commands), std::move(words.reasons), std::move(words.command_rules)});
}

}  // namespace

void Observe(const sim::Simulation& simulation, sim::EventList events, Level level, TickRecord& record) {
  ObserveWorld(simulation, std::move(events), record);
  if (level == Level::kWorld) return;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const sim::MindNotes& notes = simulation.NotesOfMind(i);
    if (!notes.empty()) AddMind(simulation.AgentOfMind(i), notes, level, record);
  }
}

Recorder::Recorder(std::unique_ptr<Writer> writer, Level level)
    : writer_(std::move(writer)), level_(level), thread_([this] { Write(); }) {}

Recorder::~Recorder() {
  (void)Finish();  // Nobody is left to be told.
}

void KeepLevel(TickRecord& record, Level level) {
  if (level == Level::kAll) return;
  if (level == Level::kWorld) record.minds.clear();
  for (MindRecord& mind : record.minds) mind.details.clear();
  std::erase_if(record.minds, [](const MindRecord& mind) {
    return mind.percepts.empty() && mind.decisions.empty() && mind.commands.empty();
  });
}

NotedTick Recorder::Blank() {
  const std::lock_guard lock(mutex_);
  if (written_.empty()) return {};
  NotedTick tick = std::move(written_.back());
  written_.pop_back();
  return tick;
}

Result<void> Recorder::Take(const sim::Simulation& simulation, sim::EventList events, const TickRecord* seen) {
  if (is_told_) return {};
  NotedTick tick = Blank();
  if (seen != nullptr) {
    tick.record.tick = seen->tick;
    tick.record.state_hash = seen->state_hash;
    tick.record.inputs = seen->inputs;
    tick.record.scene = seen->scene;
    tick.record.events = std::move(events);
    tick.record.minds.clear();
  } else {
    ObserveWorld(simulation, std::move(events), tick.record);
  }
  tick.mind_count = 0;
  for (std::size_t i = 0; level_ != Level::kWorld && i < simulation.soar_agents(); ++i) {
    const sim::MindNotes& notes = simulation.NotesOfMind(i);
    if (notes.empty()) continue;
    if (tick.mind_count == tick.minds.size()) tick.minds.emplace_back();
    NotedTick::Mind& mind = tick.minds[tick.mind_count++];
    mind.agent = simulation.AgentOfMind(i);
    mind.notes = notes;
  }
  return Push(std::move(tick));
}

Result<void> Recorder::Take(TickRecord record) {
  if (is_told_) return {};
  NotedTick tick;
  tick.record = std::move(record);
  return Push(std::move(tick));
}

Result<void> Recorder::Push(NotedTick tick) {
  // A run that is faster than the disk waits for it here.
  constexpr std::size_t kMostWaiting = 120;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < kMostWaiting || failure_; });
  if (failure_) {
    is_told_ = true;
    return *failure_;
  }
  waiting_.push_back(std::move(tick));
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
  std::deque<NotedTick> taken;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return !waiting_.empty() || is_over_; });
      if (waiting_.empty()) break;
      taken.swap(waiting_);
    }
    changed_.notify_all();
    for (NotedTick& tick : taken) {
      for (std::size_t i = 0; i < tick.mind_count; ++i)
        AddMind(tick.minds[i].agent, tick.minds[i].notes, level_, tick.record);
      const Result<void> added = writer_->Add(tick.record);
      if (added) continue;
      const std::lock_guard lock(mutex_);
      failure_ = added.error();
      break;
    }
    if (failure_) break;
    // Words are given back here, so that the run's thread need not.
    for (NotedTick& tick : taken) {
      tick.record.minds.clear();
      tick.record.events.clear();
    }
    constexpr std::size_t kMostBlank = 8;
    const std::lock_guard lock(mutex_);
    for (; !taken.empty(); taken.pop_front())
      if (written_.size() < kMostBlank) written_.push_back(std::move(taken.front()));
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
