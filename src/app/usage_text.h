// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// A command line to copy, with its description.
struct UsageExample {
  std::string_view line, about;
};
/// Examples of a sub-command; "": of the program.
std::vector<UsageExample> ExamplesOf(std::string_view command);

/// An exit code and its meaning.
struct ExitStatus {
  std::string_view code, meaning;
};
/// Exit codes of a sub-command, in order.
std::vector<ExitStatus> ExitStatusesOf(std::string_view command);

/// Adds examples and exit codes to the help of the program and of its sub-commands.
void AddUsageTexts(CLI::App& program);

}  // namespace soarbox::app
