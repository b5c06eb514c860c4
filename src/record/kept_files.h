// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::record {

struct Header;

/// A file that a run was made from, as it was when the run began.
struct KeptFile {
  std::uint32_t folder = 0;  ///< Which of Scenario::rule_folders it lies in; 0 is the scenario's own.
  std::string name;          ///< From there, with slashes.
  std::string content;
  friend bool operator==(const KeptFile&, const KeptFile&) = default;
};

/// The state of a scenario's files at one moment.
struct ScenarioFiles {
  std::uint64_t digest = 0;     ///< Of everything below, and of the script and definition wherever they are.
  std::vector<KeptFile> files;  ///< Empty if they would take more than kMostKeptBytes.
};
inline constexpr std::size_t kMostKeptBytes = 16u << 20;

/// Reads the .lua, .soar and .toml files that a run of the scenario may read: those in its own folder and in the added
/// folders, with their subfolders; then images, models and sounds, as far as they fit. Files that come with the program
/// (the Lua library) are not included.
ScenarioFiles ReadScenarioFiles(const sim::Scenario& scenario);

/// Whether files have changed or disappeared since `then`. New files do not count.
bool HaveChanged(const sim::Scenario& scenario, std::uint64_t digest_then, const std::vector<KeptFile>& then);

/// The scenario with its kept files, written into a folder that is removed with the last copy of the scenario. Fails if
/// nothing is kept, if a name would lead out of the folder, or if the folder cannot be written.
Result<sim::Scenario> WithKeptFiles(const sim::Scenario& scenario, const std::vector<KeptFile>& files);

/// Puts the replacement rules named in a recording into the scenario, but only from folders of the scenario: the
/// recording may come from a stranger. Returns the agents whose rules are missing.
std::vector<std::string> ReplaceRulesAsRecorded(sim::Scenario& scenario, const Header& header);

/// Copies of folders, each with the folder that it replaces, and what must live as long as they are used.
struct RestoredFolders {
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> folders;
  std::shared_ptr<const void> keeps;
};
/// The extra folders besides the scenario's own, as far as their files are kept; likewise.
Result<RestoredFolders> RestoreExtraFolders(const Header& header);

/// The scenario of a recording if it no longer exists, from what the recording keeps of it; likewise.
Result<sim::Scenario> ScenarioFromKeptFiles(const Header& header, const sim::DataFolders& data);

}  // namespace soarbox::record
