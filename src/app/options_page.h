// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace soarbox::app {

/// docs/options.md: all sub-commands with their arguments, defaults, examples and exit codes, in Markdown. It contains
/// the same text as the help and the manual pages.
std::string OptionsPage(const CLI::App& program);

}  // namespace soarbox::app
