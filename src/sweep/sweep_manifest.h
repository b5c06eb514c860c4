// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// The manifest of a sweep as JSON, stored in `manifest.json`. It contains the version, build, commit, command line,
/// folder, host, system, time, seeds and the digest of the sweep's file. For each variant, it contains the digest, the
/// parameters and the SHA-256 of each file. Because of the time and the host, it differs between machines: do not
/// include it in anything that must be equal on all machines.
std::string ManifestOf(const Spec& spec, const Plan& plan, const std::vector<Row>& rows,
                       const std::filesystem::path& folder);

/// Reads the manifest of a sweep's folder; empty if there is none.
std::string ReadManifest(const std::filesystem::path& folder);
/// Writes the manifest into the folder.
Result<void> WriteManifest(const std::filesystem::path& folder, const std::string& manifest);

}  // namespace soarbox::sweep
