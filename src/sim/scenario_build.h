// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "sim/arena.h"
#include "sim/minds.h"
#include "sim/scenario.h"
#include "sim/scenario_file.h"

namespace soarbox::sim {

/// The objects that a scenario file is added to.
struct ScenarioBuild {
  world::World& world;
  Arena& arena;
  Minds& minds;
  const Scenario& scenario;
};

/// Adds the content of the file to the world, agents last. Fails at the first agent that cannot be created.
Result<void> BuildScenario(const ScenarioFile& file, ScenarioBuild& build);

/// Checks the end conditions and goals of a scenario file.
class ScenarioEnd {
 public:
  ScenarioEnd(const ScenarioFile& file, const world::World& world, const Arena& arena);

  /// Call it once per tick. Returns the name of a condition that was reached in this tick, or an empty string.
  std::string Check();
  bool IsOver() const { return over_; }

 private:
  bool Holds(const ScenarioFile::Condition& condition) const;
  bool Carries(world::EntityId agent, const std::string& thing) const;

  std::vector<ScenarioFile::Condition> waiting_;
  const world::World& world_;
  const Arena& arena_;
  bool over_ = false;
};

}  // namespace soarbox::sim
