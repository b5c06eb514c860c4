// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "diagnostics/diagnostic.h"

namespace soarbox::app {

/// Explains a command line that `program` has just rejected: the sub-command, option or value, and what was probably
/// meant.
Diagnostic ExplainUsage(const CLI::App& program, const CLI::ParseError& error);

/// Finds a long option with one dash, which would be parsed as several short ones: -headless would request help.
std::optional<Diagnostic> FindSingleDash(const CLI::App& program, int argc, const char* const* argv);

/// Finds an option without its value before another option, which would be parsed as that value: --record --headless.
std::optional<Diagnostic> FindMissingValue(const CLI::App& program, int argc, const char* const* argv);

/// Checks of options' values; their messages are sentences.
CLI::Validator NumberIn(double least, double most);
CLI::Validator WholeNumber();

}  // namespace soarbox::app
