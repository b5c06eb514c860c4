// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::sim {

class Simulation;

/// Carries out a command line for an agent in another kernel; returns what it printed.
using CommandsElsewhere = std::function<Result<std::string>(const std::string& agent, const std::string& line)>;

/// From now on command lines for the agents of a simulation, those of Command and Submit, go elsewhere: its agents
/// follow those of another kernel. They are no inputs of the simulation; what they came to is reported as their answer.
/// An empty function ends that, and so does the end of the simulation.
void SendCommandsElsewhere(const Simulation& simulation, CommandsElsewhere elsewhere);

/// Whether they do: the simulation shows the agents of another kernel as they are now.
bool SendsCommandsElsewhere(const Simulation& simulation);

}  // namespace soarbox::sim
