// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "diagnostics/diagnostic.h"

namespace soarbox::app {

/// What was wrong with a command line that `program` has just refused, in the words of this project: which sub-command,
/// option or value, and what was probably meant.
Diagnostic ExplainUsage(const CLI::App& program, const CLI::ParseError& error);

/// A long option with one dash, which would be read as a row of short ones: -headless would ask for help.
std::optional<Diagnostic> FindSingleDash(const CLI::App& program, int argc, const char* const* argv);

/// An option without its value before another option, which would be taken for that value: --record --headless.
std::optional<Diagnostic> FindMissingValue(const CLI::App& program, int argc, const char* const* argv);

/// Checks of options' values whose refusals read as sentences.
CLI::Validator NumberIn(double least, double most);
CLI::Validator WholeNumber();

}  // namespace soarbox::app
