// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <string_view>

namespace soarbox::app {

/// What `soarbox help` was asked for.
struct HelpOptions {
  std::string command;          ///< Empty: the whole program.
  bool man = false;             ///< As a manual page.
  bool markdown = false;        ///< All sub-commands as one page in Markdown.
  std::filesystem::path pages;  ///< Write all manual pages into this folder; empty: print one help.
};

/// The manual page of a sub-command, or of the program itself, in the language of man(7): what the help says, and no
/// more.
std::string ManualPage(const CLI::App& program, const CLI::App& command, std::string_view version);

/// Carries out `soarbox help`; returns an ExitCode.
int Help(const CLI::App& program, const HelpOptions& options, std::string_view version);

}  // namespace soarbox::app
