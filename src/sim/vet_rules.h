// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::sim {

// The check that every edit of rules must pass before it reaches a running mind: a saved file, the text in the Edit
// panel, and a typed `sp`. Like Soar, a kernel excises a rule before it parses the new text. Therefore it must never
// get a text that does not parse.

/// The errors of a file of rules that is to replace the running one, with lines. Files that it sources are not checked,
/// because they are edited and checked separately.
std::vector<Diagnostic> VetRuleFile(const std::string& text, const std::filesystem::path& file);

/// The errors of a typed command that contains rules (sp, gp), with positions in its line. Empty for other commands.
std::vector<Diagnostic> VetTypedRules(const std::string& line);

bool HasError(const std::vector<Diagnostic>& problems);

}  // namespace soarbox::sim
