// SPDX-License-Identifier: BSD-2-Clause
#include "app/mission_watch.h"

#include <iostream>
#include <optional>
#include <utility>

#include "app/lesson.h"
#include "mission/check_news.h"

namespace soarbox::app {

namespace fs = std::filesystem;

std::unique_ptr<MissionWatch> MissionWatch::Of(const sim::Scenario& scenario, const fs::path& lesson,
                                               const sim::DataFolders& data) {
  if (scenario.definition.empty() || !scenario.rules.empty()) return nullptr;
  std::vector<Diagnostic> problems;
  mission::LoadedMission loaded;
  const fs::path folder = scenario.definition.parent_path();
  const fs::path taught = lesson.empty() ? LessonOf(folder, data) : lesson;
  if (!taught.empty()) {
    std::optional<Lesson> read = ReadLesson(taught, data, problems);
    if (read) loaded = std::move(read->loaded);
  } else if (const fs::path file = mission::MissionFileOf(scenario); !file.empty()) {
    loaded = mission::LoadMission(file, data, problems);
  } else {
    return nullptr;
  }
  for (Diagnostic& problem : problems) {
    problem.severity = Severity::kWarning;  // The world runs anyway.
    std::cerr << Format(problem);
  }
  if (!problems.empty() || loaded.mission.checks.empty()) return nullptr;
  // Ignores the known mistakes of a lesson: only grading reports them.
  loaded.mission.mistakes.clear();
  return std::unique_ptr<MissionWatch>(new MissionWatch(std::move(loaded)));
}

MissionWatch::MissionWatch(mission::LoadedMission loaded)
    : loaded_(std::move(loaded)), wants_(mission::WantsOf(loaded_.mission)) {}

void MissionWatch::Begin(sim::Simulation& simulation, sim::EventList& events) {
  simulation_ = &simulation;
  bool tells_all = true;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const auto inspector = simulation.Inspect(simulation.AgentOfMind(i));
    tells_all &= inspector == nullptr || inspector->TellsAll();
  }
  gatherer_ = std::make_unique<mission::FactGatherer>(simulation, wants_);
  evaluator_ = std::make_unique<mission::Evaluator>(loaded_.mission, tells_all);
  told_.assign(loaded_.mission.checks.size(), mission::State::kOpen);
  is_over_ = false;
  seen_tick_ = simulation.tick();
  evaluator_->Feed(gatherer_->Gather(events));
  for (std::size_t i = 0; i < told_.size(); ++i) Tell(i, events);
}

sim::MindDetail MissionWatch::LeastDetail() const {
  if (wants_.firings) return sim::MindDetail::kAll;
  return wants_.notes || wants_.insight ? sim::MindDetail::kDecisions : sim::MindDetail::kNone;
}

void MissionWatch::See(sim::EventList& events) {
  if (simulation_ == nullptr || is_over_ || simulation_->tick() == seen_tick_) return;
  seen_tick_ = simulation_->tick();
  evaluator_->Feed(gatherer_->Gather(events));
  if (simulation_->time_s() >= loaded_.seconds - 1e-6 || simulation_->HasEnded()) {
    is_over_ = true;
    evaluator_->Finish();
  }
  for (std::size_t i = 0; i < told_.size(); ++i) {
    const mission::State state = evaluator_->verdicts()[i].state;
    if (state == told_[i]) continue;
    told_[i] = state;
    Tell(i, events);
  }
}

void MissionWatch::Tell(std::size_t check, sim::EventList& events) {
  events.push_back(mission::CheckNews(loaded_.mission, check, evaluator_->verdicts()[check], simulation_->tick(),
                                      simulation_->time_s()));
}

}  // namespace soarbox::app
