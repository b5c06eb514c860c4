// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Options of `soarbox format`.
struct FormatOptions {
  std::vector<std::filesystem::path> files;  ///< Files of rules and folders.
  bool check = false;                        ///< Change nothing; print the names of the files that would change.
};
/// Formats files of rules in place. Returns an ExitCode: kProblems if `check` finds a file to be changed, or a file
/// cannot be read.
int FormatFiles(const FormatOptions& options);

/// Options of `soarbox datamap`.
struct DatamapOptions {
  std::filesystem::path rules;   ///< The file that loads the others.
  std::filesystem::path output;  ///< Empty: standard output.
};
/// Writes a VisualSoar project with a datamap. Returns an ExitCode.
int WriteDatamap(const DatamapOptions& options);

/// Returns names in a file of rules that the datamap of its project does not contain, and errors of the project itself.
std::vector<Diagnostic> DatamapProblems(const std::filesystem::path& file);

/// Runs a language server on standard input and output. Returns the process's exit code.
int ServeLanguage();

/// Runs a debug adapter on standard input and output.
int ServeDebugger();

/// Serves a coding assistant on standard input and output; file names are relative to this folder.
int ServeAssistant(const std::filesystem::path& folder);

}  // namespace soarbox::app
