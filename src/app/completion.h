// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace soarbox::app {

/// Writes what a shell may offer for the last of these words, which stand behind `soarbox`: one candidate a line, and
/// behind a tab what it is. The last word may be empty. Lines that begin with a colon tell the shell what it knows
/// better:
///
///     :files .soar .lua    offer files with these extensions (none: all files), and folders
///     :folders             offer folders
///     :behind TEXT         what is offered begins behind this part of the word
///     :open                put no blank behind a candidate: more may follow
///
/// packaging/completion holds what asks for this in bash and zsh.
void PrintCandidates(const CLI::App& program, std::vector<std::string> words, std::ostream& out);

}  // namespace soarbox::app
