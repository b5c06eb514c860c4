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

/// The folders that come with the program: scenarios/ and media/ (the Lua library is media/scripts).
struct DataFolders {
  std::filesystem::path scenarios;
  std::filesystem::path media;
};

/// A world to run: a script that sets it up, and the folders in which scripts and rules are searched for, in order.
/// Immutable after FindScenario.
struct Scenario {
  std::string name;
  std::filesystem::path script;
  std::vector<std::filesystem::path> script_folders;
  std::vector<std::filesystem::path> rule_folders;
  /// Folders with the thesis' own rules, which its kinds of agents use by default.
  std::vector<std::filesystem::path> fallback_rule_folders;
  std::filesystem::path definition;  ///< A scenario file (TOML) that also adds to the world; empty: none.
  /// Replacements for the rules of agents (--rules): agent's name, file.
  std::vector<std::pair<std::string, std::filesystem::path>> replaced_rules;
  std::filesystem::path rules;  ///< The rules for "RULES" in the definition; empty: none.
  /// Pairs of a copy and the original folder, for a recorded run that is created again from copies of its files.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> stand_ins;
  std::shared_ptr<const void> keeps;  ///< Keeps the copies alive.

  /// The replacement for an agent's rules; null if there is none. "eater" also applies to "eater-1", the first of
  /// several.
  const std::filesystem::path* ReplacementFor(std::string_view agent) const;
  /// The original path of a file of the scenario. Returns the file itself if its folder is not a copy.
  std::filesystem::path Original(const std::filesystem::path& file) const;
};

/// Finds a scenario: a folder that contains scenario.toml or Sandbox.lua, a scenario file (.toml), a Lua file, a file
/// of rules (.soar: one agent in a simple world), or the name of a scenario that comes with the program. The `extra`
/// folders are searched after the scenario's own. Errors say what was searched for and suggest similar names.
Result<Scenario> FindScenario(std::string_view argument, const DataFolders& data,
                              const std::vector<std::filesystem::path>& extra = {});

/// Names of the scenarios that come with the program.
std::vector<std::string> ListScenarios(const DataFolders& data);
/// A one-line description of such a scenario: from its file, or the first comment of its script.
std::string DescribeScenario(const std::string& name, const DataFolders& data);

/// The file `name` in the first folder that contains it, ignoring case. Empty if there is none, and for names that lead
/// out of the folders: absolute paths, paths with "..", and links to other places.
std::filesystem::path FindInFolders(std::string_view name, const std::vector<std::filesystem::path>& folders);

}  // namespace soarbox::sim
