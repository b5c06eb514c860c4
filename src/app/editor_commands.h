// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::app {

/// What `soarbox format` was asked for.
struct FormatOptions {
  std::vector<std::filesystem::path> files;  ///< Files of rules and folders.
  bool check = false;                        ///< Change nothing; name what would be changed.
};
/// Lays files of rules out, in place. Returns an ExitCode: kProblems if `check` finds any, or one cannot be read.
int FormatFiles(const FormatOptions& options);

/// What `soarbox datamap` was asked for.
struct DatamapOptions {
  std::filesystem::path rules;   ///< The file that loads the others.
  std::filesystem::path output;  ///< Empty: standard output.
};
/// Writes a project of VisualSoar with a datamap. Returns an ExitCode.
int WriteDatamap(const DatamapOptions& options);

/// The file that loads all rules of a project of VisualSoar; other files stay as they are. Fails if the project cannot
/// be read, or has no such file.
Result<std::filesystem::path> RulesOfProject(const std::filesystem::path& file);
/// What the datamap of the project that a file of rules belongs to does not know, and what is wrong with a project.
std::vector<Diagnostic> DatamapProblems(const std::filesystem::path& file);

/// Serves an editor on standard input and output. Returns the process's exit code.
int ServeLanguage();

/// Serves an editor's debugger on standard input and output.
int ServeDebugger();

/// Serves a coding assistant on standard input and output; files are named below this folder.
int ServeAssistant(const std::filesystem::path& folder);

}  // namespace soarbox::app
