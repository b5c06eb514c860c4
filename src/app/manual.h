// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <string_view>

namespace soarbox::app {

/// Options of `soarbox help`.
struct HelpOptions {
  std::string command;          ///< Empty: the program itself.
  bool man = false;             ///< As a manual page.
  bool markdown = false;        ///< All sub-commands as one page in Markdown.
  std::filesystem::path pages;  ///< Write all manual pages into this folder; empty: print one help.
};

/// The manual page of a sub-command or of the program in the format of man(7). It contains the same text as the help.
std::string ManualPage(const CLI::App& program, const CLI::App& command, std::string_view version);

/// Executes `soarbox help`; returns an ExitCode.
int Help(const CLI::App& program, const HelpOptions& options, std::string_view version);

}  // namespace soarbox::app
