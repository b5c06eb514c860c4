// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/command.h"

namespace soarbox::cli {

/// Replaces all rules of the agent by those of an image and initialises it (`load rete-network`; `source` of a file
/// named .soarx). `file` is as typed. Nothing changes if the image is not good. Counts into a source command that is
/// under way.
bool LoadRuleImage(CommandCall& call, const std::string& file);

/// Writes the image of the agent's rules; refused while there are justifications.
bool SaveRuleImage(CommandCall& call, const std::string& file);

}  // namespace soarbox::cli
