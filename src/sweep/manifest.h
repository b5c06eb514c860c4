// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// What the tables of a sweep were made from and with, as JSON: version, build, commit, command line, folder, host,
/// system, time, the digest of the sweep's file, seeds, and for each variant its digest, its parameters and the SHA-256
/// of each of its files. `manifest.json` holds it. It says when and where, so nothing that must be equal on each
/// machine may contain it.
std::string ManifestOf(const Spec& spec, const Plan& plan, const std::vector<Row>& rows,
                       const std::filesystem::path& folder);

/// The manifest of a sweep's folder; empty if there is none.
std::string ReadManifest(const std::filesystem::path& folder);
/// Writes it into the folder.
Result<void> WriteManifest(const std::filesystem::path& folder, const std::string& manifest);

}  // namespace soarbox::sweep
