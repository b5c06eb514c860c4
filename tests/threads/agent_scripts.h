// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Command lines for one agent. `!tick` is a tick of a small world: a new value on the input link, a run to output, and
/// the answers to the commands that came.
struct AgentScript {
  std::string name;
  std::filesystem::path folder;  ///< Where file names start from.
  std::vector<std::string> lines;
};

/// Agents of our own: operators, impasses of all kinds, input and output, chance, retraction.
std::vector<AgentScript> LocalScripts();

/// The cases of a golden folder: their command lines, without those that only their driver understands. Empty if the
/// folder is not there.
std::vector<AgentScript> GoldenScripts(const std::filesystem::path& folder);

/// The benchmark agents, each for some decisions. Empty if the folder is not there.
std::vector<AgentScript> BenchmarkScripts(const std::filesystem::path& folder, int decisions);
