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

/// The names in a scenario file and its rules: what checks may refer to.
struct Cast {
  std::vector<std::string> agents, teams, items, things, waypoints, regions, ends;
  std::set<std::string> rules;       ///< Names of rules.
  std::set<std::string> rule_words;  ///< All words in the files of rules: operators, attributes, values.
  std::set<std::string> all_words;   ///< Those, and the ones in scripts beside them.
  bool has_script = false;           ///< A script makes the world: it may reach ends, and make percepts, of its own.
  /// The team of each of `agents`.
  std::vector<std::string> team_of;
};

/// Reads the names. Rules are all files of rules below the scenario's folder.
Cast CastOf(const sim::ScenarioFile& file);

/// Adds a problem for each name that nothing knows, with what was probably meant.
void CheckNames(const Mission& mission, const Cast& cast, std::vector<Diagnostic>& problems);

/// Checks the checks of a .toml file for `soarbox check`; false if the file is not a scenario as well. `data`: where
/// the scenarios are that come with the program; none: they are not looked at.
bool CheckMissionFile(const std::filesystem::path& file, const sim::DataFolders* data,
                      std::vector<Diagnostic>& problems);
/// Whether this text is a mission file, which names a scenario, and not a scenario itself.
bool IsMissionText(std::string_view text);
/// Whether it has what a sweep has, and no mission.
bool IsSweepText(std::string_view text);
/// Whether a line begins with this.
bool HasLine(std::string_view text, std::string_view begin);

}  // namespace soarbox::mission
