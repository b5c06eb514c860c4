// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "record/format.h"
#include "record/header.h"
#include "sim/scenario.h"

namespace soarbox::record {

/// The block of a recording that holds its manifest, after the header. Programs that know no manifests skip it.
inline constexpr auto kManifestBlock = static_cast<BlockKind>(4);

/// What the program reports about its start.
struct Origin {
  std::string commit;                ///< Empty if the program was built outside of a repository.
  std::vector<std::string> command;  ///< The words of the command line. Empty: manifests name neither it nor the host.
};

/// Sets what manifests report. Call it before the first run; the process and those that it forks use it.
void SetOrigin(Origin origin);
const Origin& TheOrigin();

/// The name of this machine.
std::string HostName();
/// Operating system, its release and the processor's architecture: "Linux 6.1.0 x86_64".
std::string SystemText();
/// The current time in UTC: "2026-11-29T14:03:05Z".
std::string NowText();

/// What a run is made from and with, as JSON: version, build, commit, command line, folder, host, system, time, seed,
/// and the SHA-256 of each file that it may read.
///
/// It reports when and where, so nothing that must be equal on each machine may depend on it.
std::string ManifestOf(const sim::Scenario& scenario, const Header& header);

/// The manifest of a run that continues a recorded one: what made it is this program, now; its seed and files are those
/// of the manifest of the recorded one.
std::string ManifestOfBranch(const std::string& manifest, const std::string& build);

/// The manifest of a recording; empty if it has none, as those of earlier versions, or if it cannot be read.
std::string ManifestIn(const std::filesystem::path& recording);

/// The entries of a manifest as names and values. Values that are not texts are JSON. Empty if it is no JSON object.
std::vector<std::pair<std::string, std::string>> EntriesOf(const std::string& manifest);

}  // namespace soarbox::record
