// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sweep/rows.h"

namespace soarbox::sweep {

/// What the command knows of itself.
struct Origin {
  std::string version, commit;       ///< The commit is empty if the program was built outside of a repository.
  std::vector<std::string> command;  ///< The words of the command line.
};

/// What the tables of a sweep were made from and with, as JSON: version, build, commit, command line, folder, host,
/// system, time, the digest of the sweep's file, seeds, and for each variant its digest, its parameters and the SHA-256
/// of each of its files. `manifest.json` holds it. It says when and where, so nothing that must be equal on each
/// machine may contain it.
std::string ManifestOf(const Spec& spec, const Plan& plan, const std::vector<Row>& rows,
                       const std::filesystem::path& folder, const Origin& origin);

/// The manifest of a sweep's folder; empty if there is none.
std::string ReadManifest(const std::filesystem::path& folder);
/// Writes it into the folder.
Result<void> WriteManifest(const std::filesystem::path& folder, const std::string& manifest);

/// Its entries as names and values, for a table of a database: what is no text is JSON.
std::vector<std::pair<std::string, std::string>> EntriesOf(const std::string& manifest);

}  // namespace soarbox::sweep
