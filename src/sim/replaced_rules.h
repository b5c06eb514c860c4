// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::world {
class World;
}

namespace soarbox::sim {

/// Replaces the rules of agents by files. Each word is "NAME=FILE". The file's folder is added to the scenario's
/// folders of rules, so that files that it sources are found. An error says what is wrong with the word.
Result<void> ReplaceRules(Scenario& scenario, const std::vector<std::string>& words);

/// Fails if rules were to be replaced for a name that no agent has.
Result<void> CheckReplacements(const Scenario& scenario, const world::World& world);

}  // namespace soarbox::sim
