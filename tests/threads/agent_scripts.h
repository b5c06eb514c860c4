// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Command lines for one agent. `!tick` is a tick of a small world: a new value on the input link, a run to output, and
/// the completion of the commands.
struct AgentScript {
  std::string name;
  std::filesystem::path folder;  ///< The folder to which file names are relative.
  std::vector<std::string> lines;
};

/// Agents of our own: operators, impasses of all kinds, input and output, random choice, retraction.
std::vector<AgentScript> LocalScripts();

/// The cases of a golden folder: their command lines, without those that only their driver understands. Empty if the
/// folder does not exist.
std::vector<AgentScript> GoldenScripts(const std::filesystem::path& folder);

/// The benchmark agents, each for some decisions. Empty if the folder does not exist.
std::vector<AgentScript> BenchmarkScripts(const std::filesystem::path& folder, int decisions);
