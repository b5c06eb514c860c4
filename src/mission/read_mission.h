// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "mission/mission.h"

namespace soarbox::mission {

/// Reads the checks of a text: of a scenario file ([mission] and [[check]]) or of a mission file, which names a
/// scenario on top. Everything that is wrong is added to the problems, with its line; names are not looked up
/// (check_names.h). docs/missions.md describes the language.
Mission ParseMission(std::string_view text, const std::filesystem::path& file, bool is_scenario_file,
                     std::vector<Diagnostic>& problems);

/// Reads the seeds, [[check]] and [[mistake]] of a file that has other content, too: a lesson, a sweep. Keys of the
/// whole that are not `known` are problems of `what` ("a lesson"), unless none is known.
Mission ParseChecksBeside(std::string_view text, const std::filesystem::path& file, std::vector<Diagnostic>& problems,
                          const std::string& what = {}, const std::vector<std::string_view>& known = {});

/// Checks that a run of this many seconds never looks at, or that cannot come true in it.
void CheckTimes(const Mission& mission, double seconds, std::vector<Diagnostic>& problems);

/// "1..20", "3", "1,4,7..9"; each once. Nothing if it is something else, or more than a million.
std::optional<std::vector<std::uint64_t>> ParseSeeds(std::string_view text);

}  // namespace soarbox::mission
