// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::sim {

/// What comes with the program: scenarios/ and media/ (the Lua library is media/scripts).
struct DataFolders {
  std::filesystem::path scenarios;
  std::filesystem::path media;
};

/// A world to run: a script that sets it up, and the folders in which scripts and rules are looked for, in order.
/// Immutable once found.
struct Scenario {
  std::string name;
  std::filesystem::path script;
  std::vector<std::filesystem::path> script_folders;
  std::vector<std::filesystem::path> rule_folders;
};

/// Finds a scenario: a folder that holds Sandbox.lua, a Lua file, or the name of a scenario that comes with the
/// program. `extra` folders are searched after the scenario's own. Errors say what was looked for and name near-misses.
Result<Scenario> FindScenario(std::string_view argument, const DataFolders& data,
                              const std::vector<std::filesystem::path>& extra = {});

/// The scenarios that come with the program, by name.
std::vector<std::string> ListScenarios(const DataFolders& data);

/// The file `name` in the first folder that has it, spelt like this or with other capitals. Empty if none has.
std::filesystem::path FindInFolders(std::string_view name, const std::vector<std::filesystem::path>& folders);

}  // namespace soarbox::sim
