// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace soarbox::app {

/// Writes the candidates that a shell may offer for the last of these words, which follow `soarbox`. Each line is a
/// candidate, a tab, and its description. The last word may be empty. Lines that begin with a colon are instructions
/// for the shell:
///
///     :files .soar .lua    offer files with these extensions (none: all files), and folders
///     :folders             offer folders
///     :behind TEXT         the candidates begin after this part of the word
///     :open                add no blank after a candidate, because more may follow
///
/// packaging/completion contains the scripts for bash and zsh that call this.
void PrintCandidates(const CLI::App& program, std::vector<std::string> words, std::ostream& out);

}  // namespace soarbox::app
