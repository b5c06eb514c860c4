// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::app {

/// A command line to copy, and what it does.
struct UsageExample {
  std::string_view line, about;
};
/// Of a sub-command; of "" of the whole program.
std::vector<UsageExample> ExamplesOf(std::string_view command);

/// A number that a command ends with, and what it means.
struct ExitStatus {
  std::string_view code, meaning;
};
/// Of a sub-command, in order.
std::vector<ExitStatus> ExitStatusesOf(std::string_view command);

/// Ends the help of the program and of its sub-commands with their examples and exit statuses.
void AddUsageTexts(CLI::App& program);

}  // namespace soarbox::app
