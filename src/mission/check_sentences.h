// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "mission/mission.h"
#include "sim/findings.h"

namespace soarbox::mission {

/// Formats a number for people: "3", "0.5", "12.25".
std::string NumberText(double number);
using sim::SecondsText;

/// "be at gate", "say move-to ^waypoint north", "have a health of at least 30".
std::string Infinitive(const Condition& condition);
/// Negates an infinitive: "it did not say move-to", "it was not at gate", "it was carried".
std::string Denied(std::string_view infinitive);
/// The agents of a check: "scout", "blue", "anna or bert", "all of blue in one tick".
std::string Whom(const Check& check);
/// The requirement of a check: "scout should be at gate by 30 s". `who` replaces the agents of the check. `mission`
/// provides the names of other checks.
std::string Expectation(const Check& check, std::string_view who, const Mission& mission);
/// The text for a check that must be true in a number of the mission's runs and was not true in this one.
std::string OverSeeds(int runs);

}  // namespace soarbox::mission
