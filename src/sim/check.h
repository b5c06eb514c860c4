// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"
#include "sim/scenario.h"

namespace soarbox::sim {

/// Checks files of rules, Lua and scenario files without running them: what does not parse, and what is likely a slip:
/// attributes that nothing writes, commands that no body knows, operators that are proposed and never applied. A folder
/// means the files in it. Problems come in the order of the files.
/// `check_toml` checks what else .toml files hold, and says whether a file is a scenario at all.
using CheckToml = std::function<bool(const std::filesystem::path& file, std::vector<Diagnostic>& problems)>;
/// `library`: the folder of the Lua library, for what scripts load from it; without it, calls of functions are checked
/// only in scripts that need nothing of it.
std::vector<Diagnostic> CheckFiles(const std::vector<std::filesystem::path>& files, const CheckToml& check_toml = {},
                                   const std::filesystem::path& library = {});

/// What is wrong with a text of rules, with lines and columns. Messages call the text `name`.
std::vector<Diagnostic> CheckRuleText(const std::string& text, const std::string& name);
/// What is not an error in a rule file and the files that it sources, but likely a mistake: what our own kernel warns
/// of. For kernels that do not warn. `folders`: what the files may read.
std::vector<Diagnostic> WarningsOfRules(const std::filesystem::path& rules,
                                        const std::vector<std::filesystem::path>& folders);

/// The rules of a file as they were read; those that have errors are left out.
std::vector<explain::RuleText> RulesOf(const std::filesystem::path& file);

/// What the rules of a file may test and give besides the vocabulary: what the files of its folder make, and the places
/// of its scenario.
explain::KnownWords WordsAround(const std::filesystem::path& rules);

/// What is wrong with a Lua script, as with a text of rules.
std::vector<Diagnostic> CheckScriptText(const std::string& text, const std::string& name);

}  // namespace soarbox::sim
