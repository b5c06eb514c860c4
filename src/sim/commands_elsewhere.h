// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::sim {

class Simulation;

/// Carries out a command line for an agent in another kernel; returns what it printed.
using CommandsElsewhere = std::function<Result<std::string>(const std::string& agent, const std::string& line)>;

/// Redirects the command lines for the agents of a simulation (Simulation::Command and Submit) to `elsewhere`, because
/// its agents mirror those of another kernel. Redirected lines are not inputs of the simulation. Their output is
/// reported as the answer. An empty function ends the redirection, as does the end of the simulation.
void SendCommandsElsewhere(const Simulation& simulation, CommandsElsewhere elsewhere);

/// Whether command lines are redirected: the simulation mirrors the agents of another kernel.
bool SendsCommandsElsewhere(const Simulation& simulation);

}  // namespace soarbox::sim
