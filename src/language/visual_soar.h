// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "language/datamap.h"

namespace soarbox::language {

/// A project of VisualSoar: the files of its layout and its datamap.
struct VisualSoarProject {
  std::filesystem::path file;                ///< The .vsa or .vsa.json file.
  std::vector<std::filesystem::path> rules;  ///< The existing files, in the order of the layout.
  Datamap datamap;
};

/// Whether a file has the name of a project file.
bool IsVisualSoarProject(const std::filesystem::path& file);
/// The project of a folder, or of one of the four folders above it. If a folder has projects in both formats, one in
/// JSON. Empty if there is none.
std::filesystem::path FindVisualSoarProject(const std::filesystem::path& folder);
/// The file that loads all rules of a project. It is in the same folder and has the same name. Empty if there is none.
std::filesystem::path RootOfProject(const std::filesystem::path& project);

/// Reads both formats: text, with a .dm file that contains the datamap, and JSON (format 6). Files outside the
/// project's folder, and files that do not exist, are skipped with a warning in `problems`. Fails if the file is
/// invalid; for the text format, the error has a line number.
Result<VisualSoarProject> ReadVisualSoar(const std::filesystem::path& file, std::vector<Diagnostic>& problems);

}  // namespace soarbox::language
