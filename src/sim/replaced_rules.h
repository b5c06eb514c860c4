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

/// Puts files of rules in the place of those that agents would have, each "NAME=FILE". The file's folder is then one of
/// the scenario's folders of rules, so that what it sources is found. Errors name what is wrong with the word.
Result<void> ReplaceRules(Scenario& scenario, const std::vector<std::string>& words);

/// An error if there is no agent of a name whose rules were to be replaced.
Result<void> CheckReplacements(const Scenario& scenario, const world::World& world);

}  // namespace soarbox::sim
