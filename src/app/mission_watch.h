// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mission/evaluator.h"
#include "mission/gather_facts.h"
#include "mission/testing.h"
#include "sim/run_event.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// Evaluates the checks of a mission during a run and reports them as events with the word "check". Windows show these
/// events and recordings contain them. It only observes: the run is the same without it.
class MissionWatch {
 public:
  /// Returns the mission of this scenario: the lesson's, the scenario's own [[check]] tables, or those of the
  /// mission.toml next to it. Null if there is none, or if it cannot be used, which is reported.
  static std::unique_ptr<MissionWatch> Of(const sim::Scenario& scenario, const std::filesystem::path& lesson,
                                          const sim::DataFolders& data);

  /// The minimum level of detail that minds must record.
  sim::MindDetail LeastDetail() const;
  /// Starts evaluating this simulation. Adds an event for each check.
  void Begin(sim::Simulation& simulation, sim::EventList& events);
  /// The run continues from an earlier moment: keeps all results, and decides nothing more until the next Begin().
  void Leave() { simulation_ = nullptr; }
  /// Call it after a tick, with its events: adds the checks that were decided.
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
