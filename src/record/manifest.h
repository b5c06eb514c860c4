// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "record/file_format.h"
#include "record/header.h"
#include "sim/scenario.h"

namespace soarbox::record {

/// The block of a recording that contains its manifest, after the header. Readers that do not support manifests skip
/// it.
inline constexpr auto kManifestBlock = static_cast<BlockKind>(4);

/// How the program was built and started.
struct Origin {
  std::string commit;                ///< Commit of the source; empty if the program was built outside a repository.
  std::vector<std::string> command;  ///< The words of the command line. If empty, manifests contain neither command
                                     ///< line nor host.
};

/// Sets the origin that manifests report. Call it before the first run. Forked processes inherit it.
void SetOrigin(Origin origin);
const Origin& TheOrigin();

/// The name of this machine.
std::string HostName();
/// Operating system, its release and the architecture of the processor: "Linux 6.1.0 x86_64".
std::string SystemText();
/// The current time in UTC: "2026-11-29T14:03:05Z".
std::string NowText();

/// The manifest of a run as JSON: version, build, commit, command line, folder, host, system, time, seed, and the
/// SHA-256 of each file that the run may read.
///
/// It contains date and host, so nothing that must be equal on all machines may depend on it.
std::string ManifestOf(const sim::Scenario& scenario, const Header& header);

/// The manifest of a run that continues a recorded one. Program, host and time are the present ones; seed and files
/// come from the recording's manifest.
std::string ManifestOfBranch(const std::string& manifest, const std::string& build);

/// The manifest of a recording; empty if it has none, or if it cannot be read.
std::string ManifestIn(const std::filesystem::path& recording);

/// The entries of a manifest as names and values. Values that are not strings are JSON. Empty if the manifest is not a
/// JSON object.
std::vector<std::pair<std::string, std::string>> EntriesOf(const std::string& manifest);

}  // namespace soarbox::record
