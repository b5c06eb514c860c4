// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/aliases.h"
#include "cli/command.h"

namespace soarbox::cli {

/// The output of `help NAME`: usage, details, options, subcommands, aliases.
std::string HelpText(const CommandInfo& command, const AliasTable& aliases);

/// The reference of all commands as Markdown, for docs/.
std::string CommandReference();

}  // namespace soarbox::cli
