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
  std::filesystem::path file;                ///< The .vsa or .vsa.json itself.
  std::vector<std::filesystem::path> rules;  ///< That are there, in the order of the layout.
  Datamap datamap;
};

/// Whether a file's name is that of a project.
bool IsVisualSoarProject(const std::filesystem::path& file);
/// The project of a folder, or of one of the four above it; of two formats the newer. Empty if there is none.
std::filesystem::path FindVisualSoarProject(const std::filesystem::path& folder);
/// The file that loads all rules of a project, which lies beside it and has its name. Empty if there is none.
std::filesystem::path RootOfProject(const std::filesystem::path& project);

/// Reads both formats: text, with a .dm file that holds the datamap, and JSON (format 6). Files outside of the
/// project's folder are left out. What makes no sense is an error with its line; what is dispensable is left out and
/// added to `problems`.
Result<VisualSoarProject> ReadVisualSoar(const std::filesystem::path& file, std::vector<Diagnostic>& problems);

}  // namespace soarbox::language
