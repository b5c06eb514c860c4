// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/tokens.h"
#include "diagnostics/result.h"
#include "kernel/agent.h"

/// Images of an agent's rules (`save rete-network`, `load rete-network`, files named .soarx).
///
/// An image is text: a first line, then the rules in the order of loading, each with its conditions in match order and
/// all digits of its numbers. Loading it takes as long as sourcing the rules.
namespace soarbox::cli {

/// The first line of an image.
inline constexpr std::string_view kImageStart = "# The rules of a Soar agent, written by 'save rete-network'.\n";

/// Reads the text of an image. Returns the text of each rule between its braces, or the first error, with its place.
Result<std::vector<Word>> ReadRuleImage(std::string_view text, const std::string& file, const kernel::Agent& agent);

/// Adds a rule that ReadRuleImage returned for this agent.
kernel::LoadOutcome AddImageRule(kernel::Agent& agent, const Word& rule, const std::string& file);

/// Replaces all rules of the agent by those of an image and initialises it (`load rete-network`, or `source` of a file
/// named .soarx). `file` is as typed. An invalid image changes nothing. The rules are counted in the running source
/// command, if there is one.
bool LoadRuleImage(CommandCall& call, const std::string& file);

/// Writes the image of the agent's rules. Refused while there are justifications.
bool SaveRuleImage(CommandCall& call, const std::string& file);

}  // namespace soarbox::cli
