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

/// What a scenario's files are at a moment.
struct ScenarioFiles {
  std::uint64_t digest = 0;     ///< Of all that is said below, and of the script and definition wherever they are.
  std::vector<KeptFile> files;  ///< Empty if they would take more than kMostKeptBytes.
};
inline constexpr std::size_t kMostKeptBytes = 16u << 20;

/// Reads the .lua, .soar and .toml files that a run of the scenario may read: those in its own folder and in the
/// folders added to it, with what is below them. What comes with the program (the Lua library) is not among them.
ScenarioFiles ReadScenarioFiles(const sim::Scenario& scenario);

/// Whether files have changed or gone since `then`. Further files beside them change nothing.
bool HaveChanged(const sim::Scenario& scenario, std::uint64_t digest_then, const std::vector<KeptFile>& then);

/// The scenario with its files as they were kept: written into a folder of their own, which goes when the last copy of
/// the scenario does. Fails if nothing is kept, if a name would lead out of the folder, or if it cannot be written.
Result<sim::Scenario> WithKeptFiles(const sim::Scenario& scenario, const std::vector<KeptFile>& files);

/// Puts the rules that a recording says took the place of others into the scenario, as far as they are in folders that
/// the scenario has: a recording may be a stranger's. Returns the agents whose rules are not there.
std::vector<std::string> ReplaceRulesAsRecorded(sim::Scenario& scenario, const Header& header);

/// Copies of folders, each with the one that it stands in for, and what must live as long as they are used.
struct RestoredFolders {
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> folders;
  std::shared_ptr<const void> keeps;
};
/// The folders that were given besides the scenario's own, as far as their files are kept; likewise.
Result<RestoredFolders> RestoreExtraFolders(const Header& header);

/// The scenario of a recording that is there no more, from what the recording keeps of it; likewise.
Result<sim::Scenario> ScenarioFromKeptFiles(const Header& header, const sim::DataFolders& data);

}  // namespace soarbox::record
