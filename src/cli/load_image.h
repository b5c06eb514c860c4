// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/command.h"

namespace soarbox::cli {

/// Replaces all rules of the agent by those of an image and initialises it (`load rete-network`, or `source` of a file
/// named .soarx). `file` is as typed. A bad image changes nothing. The rules count in the source command that is
/// running, if any.
bool LoadRuleImage(CommandCall& call, const std::string& file);

/// Writes the image of the agent's rules; refused while there are justifications.
bool SaveRuleImage(CommandCall& call, const std::string& file);

}  // namespace soarbox::cli
