// SPDX-License-Identifier: BSD-2-Clause
#include "record/recorder.h"

#include <span>

#include "sim/input_text.h"

namespace soarbox::record {

void Observe(const sim::Simulation& simulation, const sim::EventList& events, Level level, TickRecord& record) {
  record.tick = simulation.tick();
  record.state_hash = simulation.StateHash();
  record.inputs.clear();
  for (const sim::Input& input : simulation.LastInputs()) record.inputs.push_back(sim::WriteInput(input));
  record.scene = simulation.Snapshot();
  record.events = events;
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
                            texts(report.details), texts(report.commands)});
  }
}

Result<void> Recorder::Take(const sim::Simulation& simulation, const sim::EventList& events) {
  if (failed_) return {};
  Observe(simulation, events, level_, record_);
  return Take(record_);
}

Result<void> Recorder::Take(const TickRecord& record) {
  if (failed_) return {};
  Result<void> added = writer_->Add(record);
  failed_ = !added;
  return added;
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
