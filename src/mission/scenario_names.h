// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "mission/mission.h"
#include "sim/scenario.h"
#include "sim/scenario_file.h"

namespace soarbox::mission {

/// The names in a scenario file and its rules, which checks can refer to.
struct Cast {
  std::vector<std::string> agents, teams, items, things, waypoints, regions, ends;
  std::set<std::string> rules;       ///< Names of rules.
  std::set<std::string> rule_words;  ///< All words in the files of rules: operators, attributes, values.
  std::set<std::string> all_words;   ///< Also the words in scripts in the folder.
  bool has_script = false;           ///< A script builds the world; it may define further ends and percepts.
  /// The team of each agent in `agents`.
  std::vector<std::string> team_of;
};

/// Collects the names. Rules are read from all files of rules below the scenario's folder.
Cast CastOf(const sim::ScenarioFile& file);

/// Reports each name that does not exist, with a similar name.
void CheckNames(const Mission& mission, const Cast& cast, std::vector<Diagnostic>& problems);

/// Checks the missions in a .toml file for `soarbox check`. Returns false if the file is not a scenario as well.
/// `data`: folders of the scenarios that come with the program; null: they are not searched.
bool CheckMissionFile(const std::filesystem::path& file, const sim::DataFolders* data,
                      std::vector<Diagnostic>& problems);
/// Whether a text is a mission file, which names a scenario, and not a scenario file.
bool IsMissionText(std::string_view text);
/// Whether a text is a sweep file and not a mission.
bool IsSweepText(std::string_view text);
/// Whether a line of the text begins with `begin`.
bool HasLine(std::string_view text, std::string_view begin);

}  // namespace soarbox::mission
