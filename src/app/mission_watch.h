// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mission/evaluator.h"
#include "mission/gather_facts.h"
#include "mission/test_missions.h"
#include "sim/mind_log.h"
#include "sim/run_event.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// Follows the checks of a mission through a run and reports them as events of the run, with the word "check": windows
/// show these events, and recordings keep them. It only looks: the run is the same without it.
class MissionWatch {
 public:
  /// The mission of this scenario: the lesson's, its own [[check]] tables, or those of the mission.toml beside it.
  /// Null if it has none, or one that cannot be used, which is told.
  static std::unique_ptr<MissionWatch> Of(const sim::Scenario& scenario, const std::filesystem::path& lesson,
                                          const sim::DataFolders& data);

  /// How much minds are to note at least.
  sim::MindDetail LeastDetail() const;
  /// A run begins: follows this simulation from now on. Adds an event for each check.
  void Begin(sim::Simulation& simulation, sim::EventList& events);
  /// The run goes on from an earlier moment: keeps what was decided, and decides nothing more until a run begins.
  void Leave() { simulation_ = nullptr; }
  /// After a tick, with its events: adds what was decided.
  void See(sim::EventList& events);

 private:
  explicit MissionWatch(mission::LoadedMission loaded);
  void Tell(std::size_t check, sim::EventList& events);

  mission::LoadedMission loaded_;
  mission::Wants wants_;
  sim::Simulation* simulation_ = nullptr;
  std::unique_ptr<mission::FactGatherer> gatherer_;
  std::unique_ptr<mission::Evaluator> evaluator_;
  std::vector<mission::State> told_;
  std::uint64_t seen_tick_ = 0;
  bool is_over_ = false;
};

}  // namespace soarbox::app
