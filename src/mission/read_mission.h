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

/// Parses the checks in a text: a scenario file ([mission] and [[check]]) or a mission file, which names a scenario at
/// the top. Adds all errors with their lines to `problems`. Does not check whether names exist (see CheckNames in
/// scenario_names.h). docs/missions.md describes the language.
Mission ParseMission(std::string_view text, const std::filesystem::path& file, bool is_scenario_file,
                     std::vector<Diagnostic>& problems);

/// Parses the seeds, [[check]] and [[mistake]] of a file with other contents, such as a lesson or a sweep. Reports
/// top-level keys that are not in `known` as errors of `what` ("a lesson"), unless `known` is empty.
Mission ParseChecksBeside(std::string_view text, const std::filesystem::path& file, std::vector<Diagnostic>& problems,
                          const std::string& what = {}, const std::vector<std::string_view>& known = {});

/// Reports checks that a run of this duration never evaluates, or that cannot become true in it.
void CheckTimes(const Mission& mission, double seconds, std::vector<Diagnostic>& problems);

/// Parses "1..20", "3" or "1,4,7..9"; each seed once. Returns nothing if the text is invalid or contains more than a
/// million seeds.
std::optional<std::vector<std::uint64_t>> ParseSeeds(std::string_view text);

}  // namespace soarbox::mission
