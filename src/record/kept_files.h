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

/// A file of a run, with its content at the beginning of the run.
struct KeptFile {
  std::uint32_t folder = 0;  ///< Index of its folder in Scenario::rule_folders; 0 is the scenario's own.
  std::string name;          ///< Path relative to that folder, with slashes.
  std::string content;
  friend bool operator==(const KeptFile&, const KeptFile&) = default;
};

/// The state of a scenario's files at one moment.
struct ScenarioFiles {
  std::uint64_t digest = 0;     ///< Digest of `files`, and of the script and definition, which may be in other folders.
  std::vector<KeptFile> files;  ///< Empty if they would take more than kMostKeptBytes.
};
inline constexpr std::size_t kMostKeptBytes = 16u << 20;

/// Reads the .lua, .soar and .toml files that a run of the scenario may read: those in its own folder and in the added
/// folders, with their subfolders; then images, models and sounds, as far as they fit. Files that come with the program
/// (the Lua library) are not included.
ScenarioFiles ReadScenarioFiles(const sim::Scenario& scenario);

/// Whether files have changed or disappeared since `then`. New files do not count.
bool HaveChanged(const sim::Scenario& scenario, std::uint64_t digest_then, const std::vector<KeptFile>& then);

/// A copy of the scenario that uses the kept files. They are written to a folder that is removed with the last copy of
/// the scenario. Fails if no files were kept, if a name would lead out of the folder, or if the folder cannot be
/// written.
Result<sim::Scenario> WithKeptFiles(const sim::Scenario& scenario, const std::vector<KeptFile>& files);

/// Sets the replacement rules of a recording in the scenario. Accepts only files in folders of the scenario, because
/// the recording may come from a stranger. Returns the agents whose rules are missing.
std::vector<std::string> ReplaceRulesAsRecorded(sim::Scenario& scenario, const Header& header);

/// Copies of folders, each with the folder that it replaces. The copies exist as long as `keeps` does.
struct RestoredFolders {
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> folders;
  std::shared_ptr<const void> keeps;
};
/// Restores the additional folders, as far as their files were kept.
Result<RestoredFolders> RestoreExtraFolders(const Header& header);

/// The scenario of a recording if it no longer exists on the disk, from its kept files.
Result<sim::Scenario> ScenarioFromKeptFiles(const Header& header, const sim::DataFolders& data);

}  // namespace soarbox::record
