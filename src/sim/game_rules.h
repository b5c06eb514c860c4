// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "explain/rule_text.h"

namespace soarbox::sim {

/// Whether rules are for a game of the program, such as TankSoar: they test at least two percepts or give commands that
/// bodies do not have, and one of the games has all of these. `library`: folder of the games' modules, `*Rules.lua`.
bool AreForGame(const std::vector<explain::RuleText>& rules, const std::filesystem::path& library);

}  // namespace soarbox::sim
