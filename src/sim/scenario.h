// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
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
  /// Where the thesis' own rules are, for its kinds of agents when nobody names rules.
  std::vector<std::filesystem::path> fallback_rule_folders;
  std::filesystem::path definition;  ///< A scenario file (TOML) that also fills the world; empty: none.
  /// Rules that replace those that agents would have (--rules): agent's name, file.
  std::vector<std::pair<std::string, std::filesystem::path>> replaced_rules;
  std::filesystem::path rules;  ///< Rules that replace "RULES" in the definition; empty: none.
  /// Folders that stand in for others, each with the other: a recorded run is made again from copies of its files.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> stand_ins;
  std::shared_ptr<const void> keeps;  ///< What must live as long as this does: such copies.

  /// The rules that replace an agent's own; null if none do. "eater" also means the first of several, "eater-1".
  const std::filesystem::path* ReplacementFor(std::string_view agent) const;
  /// Where a file of the scenario belongs; the file itself if its folder stands in for no other.
  std::filesystem::path Original(const std::filesystem::path& file) const;
};

/// Finds a scenario: a folder that holds scenario.toml or Sandbox.lua, a scenario file (.toml), a Lua file, a file of
/// rules (.soar: one agent in a world of its own), or the name of a scenario that comes with the program. `extra`
/// folders are searched after the scenario's own. Errors say what was looked for and name near-misses.
Result<Scenario> FindScenario(std::string_view argument, const DataFolders& data,
                              const std::vector<std::filesystem::path>& extra = {});

/// The scenarios that come with the program, by name.
std::vector<std::string> ListScenarios(const DataFolders& data);
/// One line about such a scenario: its file's description, or the first comment of its script.
std::string DescribeScenario(const std::string& name, const DataFolders& data);

/// The file `name` in the first folder that has it, spelt like this or with other capitals. Empty if none has, and for
/// names that lead out of the folders: absolute ones, those with "..", and links to places outside.
std::filesystem::path FindInFolders(std::string_view name, const std::vector<std::filesystem::path>& folders);

}  // namespace soarbox::sim
