// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::sim {

// The one test that every edit of rules passes before it reaches a running mind: a file that was saved, the text in the
// Edit panel, and a typed `sp`. A kernel excises a rule before it reads the new text, as Soar does; so what does not
// parse must not get there.

/// What is wrong with a whole file of rules that is to replace what runs, with lines. Leaves out the files that it
/// sources: they are edited, and vetted, by themselves.
std::vector<Diagnostic> VetRuleFile(const std::string& text, const std::filesystem::path& file);

/// What is wrong with a typed line that gives rules (sp, gp), with places in that line. Empty for other commands.
std::vector<Diagnostic> VetTypedRules(const std::string& line);

bool HasError(const std::vector<Diagnostic>& problems);

}  // namespace soarbox::sim
